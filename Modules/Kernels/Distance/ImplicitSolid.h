#pragma once
#include <glm/vec3.hpp>

#include <cstdint>
#include <limits>
#include <memory>

namespace hasp
{

/// A solid as a function of the place: signed distance or a bound of it, mm, world, NEGATIVE
/// INSIDE. It changes by no more than one mm a mm (1-Lipschitz): a ball of radius |value| around a
/// place holds no surface, which is how all that is lazy leaves out what is far.
///
/// Its surface is made of faces, each smooth: a plane of a box, a cylinder's side, the isosurface
/// of a grid. Where two meet there may be a crease; a contour that keeps edges finds it from the
/// faces themselves, continued beyond it (FaceAt).
///
/// Immutable, shared by all trees that it is in. Threads: any; no memory is taken, nothing throws
/// once it is made.
class ImplicitSolid
{
public:
  struct Sample
  {
    double value;        ///< mm
    glm::dvec3 gradient; ///< of value, per mm: out of the solid; 0 where there is none
    std::uint32_t face;  ///< that the value is of, in [0, Faces())
  };
  /// Outside of it the value is above 0. Infinite along an axis without an end.
  struct Box
  {
    glm::dvec3 low{ -std::numeric_limits<double>::infinity() };
    glm::dvec3 high{ std::numeric_limits<double>::infinity() };
  };

  virtual ~ImplicitSolid() = default;
  virtual double At(const glm::dvec3& world) const noexcept = 0;
  virtual Sample SampleAt(const glm::dvec3& world) const noexcept = 0;
  /// One face alone, continued smoothly beyond its edges: on the face the same as SampleAt.
  virtual Sample FaceAt(std::uint32_t face, const glm::dvec3& world) const noexcept = 0;
  virtual std::uint32_t Faces() const noexcept = 0;
  virtual Box Bounds() const noexcept = 0;
};

using SolidPointer = std::shared_ptr<const ImplicitSolid>;

} // namespace hasp
