#pragma once
#include "Grid/GridGeometry.h"
#include "Planning/GuideRecipe.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hasp
{

/// Where a guide may be: the working grid (its z is the withdrawal direction) and the region around
/// the landmarks. Any thread; immutable.
class GuideFrame
{
public:
  /// The recipe must be valid, and its directions unit. `keep` marks the samples of `ct` that are
  /// bone: the grid of a filled outline reaches as high as bone does inside it. Throws
  /// std::invalid_argument if the grid would exceed 2e8 voxels.
  GuideFrame(const GuideRecipe& recipe, const GridGeometry& ct, std::span<const std::uint8_t> keep);

  const GridGeometry& Grid() const { return this->Working; }

  /// Distance to the region's surface, mm, negative inside: a tube around the landmarks, or for a
  /// filled outline the prism around their polygon, not deeper than half a width below the lowest.
  double Region(const glm::dvec3& world) const;

  /// Distance to a slot or hole, mm, negative inside; both run right through.
  double Slot(const GuideSlot& slot, const glm::dvec3& world) const;
  static double Hole(const GuideHole& hole, const glm::dvec3& world);

private:
  const GuideRecipe& Recipe;
  GridGeometry Working;
  std::vector<glm::dvec2> Polygon; ///< landmarks across the withdrawal direction
  double Deepest = 0.0;            ///< along it, mm
};

} // namespace hasp
