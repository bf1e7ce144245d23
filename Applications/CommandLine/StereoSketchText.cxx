#include "ScreenFrame.h"
#include "StereoSketch.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace hasp
{
namespace
{

double Degrees(double opposite, double distance)
{
  return std::atan2(opposite, distance) * 180.0 / std::numbers::pi;
}

/// How far a point's two pictures on the screen lie apart, and as an angle for the viewer.
std::string DisparityText(const StereoSketch& sketch, const glm::dvec3& point, const char* name)
{
  const ScreenFrame frame(sketch.rig.screen);
  const double eyes = frame.Of(sketch.rig.head.position).z, z = frame.Of(point).z;
  char text[160];
  if (z >= eyes)
    std::snprintf(text, sizeof text, "%s %.0f mm in front of the screen: behind the eyes", name, z);
  else
  {
    const double mm = ScreenDisparityMm(sketch.rig, point);
    std::snprintf(text, sizeof text, "%s %.0f mm %s the screen: disparity %.1f mm, %.2f degrees",
      name, std::abs(z), z > 0.0 ? "in front of" : "behind", mm, Degrees(mm, eyes));
  }
  return text;
}

} // namespace

std::string StereoSketchText(const StereoSketch& sketch)
{
  ValidateStereoRig(sketch.rig);
  const StereoScreen& screen = sketch.rig.screen;
  const ScreenFrame frame(screen);
  const glm::dvec3 head = frame.Of(sketch.rig.head.position);
  char text[300];
  std::snprintf(text, sizeof text,
    "screen %.0f x %.0f mm, seen under %.1f x %.1f degrees; eyes %.1f mm apart, %.0f mm in front "
    "of "
    "it",
    screen.widthMm, screen.heightMm, 2.0 * Degrees(0.5 * screen.widthMm, head.z),
    2.0 * Degrees(0.5 * screen.heightMm, head.z), sketch.rig.head.eyeSeparationMm, head.z);
  std::string lines = sketch.title + "\n" + text;
  if (!sketch.content)
    return lines;
  const auto nearer = [&](const glm::dvec3& a, const glm::dvec3& b)
  { return frame.Of(a).z > frame.Of(b).z; };
  const auto [near, far] =
    std::minmax_element(sketch.content->begin(), sketch.content->end(), nearer);
  return lines + "\n" + DisparityText(sketch, *near, "nearest") + "\n" +
         DisparityText(sketch, *far, "farthest");
}

} // namespace hasp
