#pragma once
#include <glm/vec3.hpp>

#include <string>

namespace hasp
{

/// The cut of a saw: a finite blade, and the bone that it turns to dust.
///
/// The blade is the box of widthMm x depthMm x kerfMm around `point`: widthMm along `along`,
/// depthMm along cross(normal, along), kerfMm along `normal`. Bone inside it is lost; the bone on
/// either side stays, and what lies beyond the box's ends is not cut. World = patient LPS of the
/// scan, mm. A plain value.
struct Osteotomy
{
  glm::dvec3 point{ 0.0 };            ///< middle of the blade
  glm::dvec3 normal{ 1.0, 0.0, 0.0 }; ///< of the blade's plane; unit
  glm::dvec3 along{ 0.0, 1.0, 0.0 };  ///< in the plane; unit
  double widthMm = 60.0;              ///< (0, 500]
  double depthMm = 60.0;              ///< (0, 500]
  double kerfMm = 1.0;                ///< (0, 5]; saws of this surgery: 0.5 to 1.25

  bool operator==(const Osteotomy&) const noexcept = default;
};

/// Throws std::invalid_argument unless every number is finite and in its range (points within 4,000
/// mm of the origin), both directions are unit within 1e-3 and upright on each other within 1e-3.
/// The message begins with `subject`, names the key, its value and the legal range. Any thread.
void ValidateOsteotomy(const Osteotomy& cut, const std::string& subject = "osteotomy");

} // namespace hasp
