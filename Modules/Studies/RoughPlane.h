#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace hasp
{

/// A surface along which bone breaks: a plane with a band-limited height field on it.
struct FractureFace
{
  glm::dvec3 point{ 0.0 };             ///< of the plane, world mm
  glm::dvec3 outward{ 0.0, 0.0, 1.0 }; ///< unit; the piece lies behind
  double roughMm = 1.1;                ///< height, root mean square over the whole plane, [0, 10]
  double shortestMm = 4.0;             ///< wavelengths there are, > 0
  double longestMm = 16.0;             ///< >= shortestMm
  std::uint64_t seed = 1;              ///< the same seed gives the same heights
};

/// height(u, v) = sum of 24 waves a_i cos(k_i . (u, v) + phase_i): directions and phases at random,
/// lengths evenly over their logarithm, each wave as high as it is long. Immutable; any thread.
class RoughPlane
{
public:
  /// Throws std::invalid_argument with the field's name, value and legal range.
  explicit RoughPlane(const FractureFace& face);

  struct Foot
  {
    double mm; ///< to the surface, NEGATIVE BEHIND IT; exact in sign, in size to first order
    glm::dvec3 outward; ///< unit normal of the surface there
  };
  Foot FootOf(const glm::dvec3& point) const;

  /// To the plane without its heights, mm: the surface lies within MostMm of it.
  double PlaneMm(const glm::dvec3& point) const;
  /// No height is larger in size, mm.
  double MostMm() const { return this->Most; }
  /// Way up over way along the normal is no larger anywhere, >= 1.
  double Steepest() const { return this->SteepestWay; }
  /// Above the plane at the point's foot on it, mm.
  double HeightMm(const glm::dvec3& point) const;

private:
  struct Wave
  {
    glm::dvec2 number; ///< radians / mm
    double phase, mm;
  };
  glm::dvec2 OnPlane(const glm::dvec3& point) const;

  FractureFace Face;
  glm::dvec3 U, V;
  double Most = 0.0, SteepestWay = 1.0;
  std::vector<Wave> Waves;
};

} // namespace hasp
