#pragma once
#include "StereoRig.h"
#include "vtkHaspRenderingStereoModule.h" // for export macro

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <optional>

/// What the lenses of a head-mounted display do to its panel, and where the panel must show what so
/// that the viewer sees the picture. Plain values and pure functions; any thread.
///
/// Points are those of one eye's picture, from its middle, x right, y up, in **half heights**: the
/// corners are at (+-aspect, +-1), where aspect is width / height as the eye would see the picture
/// without a lens, whatever its pixels.
namespace hasp
{

/// A point of the panel at p is seen at c + s (p - c) (1 + k1 r^2 + k2 r^4 + k3 r^6), r = |p - c|.
struct LensModel
{
  glm::dvec3 coefficients{ 0.0 };      ///< k1, k2, k3; finite
  std::array<glm::dvec2, 2> centers{}; ///< c of the left and the right eye, half heights
  glm::dvec3 colorScale{ 1.0 };        ///< s of red, green and blue, > 0: chromatic aberration
};

/// Throws std::invalid_argument, with the value and the legal range, unless all is finite, scales
/// are > 0, and the lens does not fold over: r (1 + k1 r^2 + ...) must grow all the way to the
/// corner of either eye's picture that is farthest from its centre.
VTKHASPRENDERINGSTEREO_EXPORT void ValidateLens(const LensModel& lens, double aspect);

/// Where a point of the panel is seen; `channel` 0, 1, 2 for red, green, blue.
VTKHASPRENDERINGSTEREO_EXPORT glm::dvec2 SeenThroughLens(
  const LensModel& lens, StereoEye eye, int channel, glm::dvec2 panel);

/// The reverse: which point of the panel is seen there, to 1e-12 half heights. None if it is
/// farther than a valid lens shows of a picture of this aspect.
VTKHASPRENDERINGSTEREO_EXPORT std::optional<glm::dvec2> PanelBehindLens(
  const LensModel& lens, StereoEye eye, int channel, glm::dvec2 seen, double aspect);

} // namespace hasp
