#pragma once
#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>

namespace hasp
{

/// Faces this close to each other are one: of those that tie, the one with the lowest number is
/// named, so that the noise of the last digits chooses nothing. mm.
inline constexpr double SolidTieMm = 1e-9;

/// A solid as a function of the place: signed distance or a bound of it, mm, world, NEGATIVE
/// INSIDE. It changes by no more than Steepness() mm a mm: a ball of radius |value| / Steepness()
/// around a place holds no surface, which is how all that is lazy leaves out what is far.
///
/// Its surface is made of faces, each smooth: a plane of a box, a cylinder's side, the isosurface
/// of a grid. Where two meet there may be a crease; a contour that keeps edges finds it from the
/// faces themselves, continued beyond it (FaceAt). Not all of them need to be on the surface.
///
/// Immutable, shared by all trees that it is in. Threads: any; no memory is taken, nothing throws
/// once it is made. A place that is not finite gives a value without meaning, and a face that
/// exists.
class ImplicitSolid
{
public:
  struct Sample
  {
    double value;        ///< mm
    glm::dvec3 gradient; ///< of value, per mm: out of the solid; 0 where there is none
    std::uint32_t face;  ///< that the value is of, in [0, Faces())
  };
  /// Infinite along an axis without an end. Empty (low > high) is allowed.
  struct Box
  {
    glm::dvec3 low{ -std::numeric_limits<double>::infinity() };
    glm::dvec3 high{ std::numeric_limits<double>::infinity() };

    /// How far a place lies outside along the axis where that is most, mm; negative inside.
    double Excess(const glm::dvec3& world) const
    {
      const glm::dvec3 out = glm::max(this->low - world, world - this->high);
      return std::max({ out.x, out.y, out.z });
    }
  };

  virtual ~ImplicitSolid() = default;
  virtual double At(const glm::dvec3& world) const noexcept = 0;
  virtual Sample SampleAt(const glm::dvec3& world) const noexcept = 0;
  /// One face alone, continued smoothly beyond its edges. Of the face that SampleAt names it is the
  /// same as SampleAt, within 1e-8 mm, wherever that is: an offset of the solid has faces, too.
  virtual Sample FaceAt(std::uint32_t face, const glm::dvec3& world) const noexcept = 0;
  virtual std::uint32_t Faces() const noexcept = 0;
  /// At(x) >= Bounds().Excess(x) everywhere: what is far need not be asked.
  virtual Box Bounds() const noexcept = 0;
  /// 1, but for what is interpolated between samples: at most the square root of 3.
  virtual double Steepness() const noexcept { return 1.0; }
};

using SolidPointer = std::shared_ptr<const ImplicitSolid>;

} // namespace hasp
