#pragma once
#include "Distance/ImplicitSolid.h"
#include "Planning/PlateRecipe.h"

#include <optional>
#include <vector>

namespace hasp
{

/// The middle line of a plate on bone, in straight pieces of at most a sixth of the plate's width.
struct PlatePath
{
  std::vector<glm::dvec3> places; ///< on the surface within 0.001 mm, two at least
  std::vector<glm::dvec3>
    normals; ///< of the piece after each place but the last: unit, upright on it (MeanNormal)

  /// The piece nearest to a point.
  std::size_t Nearest(const glm::dvec3& point) const;
  /// How far a point is from the middle line, seen along the normal of the piece over or under
  /// which it lies within reachMm; infinite if there is none.
  double Across(const glm::dvec3& point, double reachMm) const;
};

/// What is upright on the plate as a whole, unit: a scan's surface has steps, across which its own
/// normals lean by ten degrees and more. The mean direction of the plate's outer face within half
/// a width of a place on the middle line that runs `along`, with `up` roughly upright on it.
glm::dvec3 MeanNormal(const ImplicitSolid& surface, const PlateRecipe& recipe, const glm::dvec3& at,
  const glm::dvec3& along, const glm::dvec3& up);

/// The nearest place of a solid's surface, by steps along its gradient; none where they do not end
/// within 0.001 mm of it.
std::optional<glm::dvec3> OnSurface(const ImplicitSolid& surface, const glm::dvec3& point);

/// A landmark or a screw's point laid on bone. Throws std::runtime_error "plate: NAME is D mm from
/// bone, must be within 3" if it is farther.
glm::dvec3 LaidOnBone(const ImplicitSolid& bone, const std::string& name, const glm::dvec3& point);

/// A centripetal Catmull-Rom curve (Yuksel et al. 2011: without loops and cusps) through the
/// recipe's landmarks, each laid on the surface, and laid on it itself. Throws std::runtime_error,
/// naming the landmarks, if one is over 3 mm from bone, two come to lie on one place, or the curve
/// between two leaves bone by over half the plate's width, or comes to lie out of reach.
PlatePath MakePlatePath(const ImplicitSolid& surface, const PlateRecipe& recipe);

} // namespace hasp
