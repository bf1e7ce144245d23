#include "ScreenFrame.h"
#include "StereoSketch.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace hasp
{
namespace
{

constexpr double MostDegrees = 1.5; ///< that most people fuse

double Degrees(double opposite, double distance)
{
  return std::atan2(opposite, distance) * 180.0 / std::numbers::pi;
}

/// Where a point lies and, for two eyes, how far its two pictures on the screen lie apart, also as
/// an angle for the viewer.
std::string DepthText(const StereoSketch& sketch, const glm::dvec3& point, const char* name)
{
  const ScreenFrame frame(sketch.rig.screen);
  const double eyes = frame.Of(sketch.rig.head.position).z, z = frame.Of(point).z;
  char text[160];
  std::snprintf(text, sizeof text, "%s %.0f mm %s the screen", name, std::abs(z),
    z > 0.0 ? "in front of" : "behind");
  const std::string place = text;
  if (z >= eyes)
    return place + ": behind the eyes";
  if (!NeedsSecondEye(sketch.layout))
    return place;
  const double mm = ScreenDisparityMm(sketch.rig, point);
  const double degrees = Degrees(mm, eyes);
  std::snprintf(text, sizeof text, ": disparity %.1f mm, %.2f degrees%s", mm, degrees,
    std::abs(degrees) > MostDegrees ? ": TOO FAR APART, most people see it double" : "");
  return place + text;
}

/// Between the directions in which the middles of two edges are seen, half the size away.
double SeenUnder(const glm::dvec3& eye, const glm::dvec3& edge)
{
  const glm::dvec3 a = edge - eye, b = -edge - eye;
  return Degrees(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

std::string EyesText(const StereoSketch& sketch)
{
  const StereoHead& head = sketch.rig.head;
  const glm::dvec3 at = ScreenFrame(sketch.rig.screen).Of(EyesOf(sketch).front().position);
  const double distance = ScreenFrame(sketch.rig.screen).Of(head.position).z;
  char text[160];
  if (sketch.layout == StereoLayout::Mono)
    std::snprintf(text, sizeof text, "one eye, %.0f mm in front of it", at.z);
  else if (!NeedsSecondEye(sketch.layout))
    std::snprintf(text, sizeof text, "the %s eye of two %.1f mm apart, %.0f mm in front of it",
      StereoLayoutName(sketch.layout), head.eyeSeparationMm, at.z);
  else
    std::snprintf(text, sizeof text,
      "eyes %.1f mm apart (red: left, blue: right), %.0f mm in front of it", head.eyeSeparationMm,
      distance);
  return text;
}

} // namespace

std::vector<SketchedEye> EyesOf(const StereoSketch& sketch)
{
  const StereoHead& head = sketch.rig.head;
  const SketchedEye left{ SketchedEye::Left, EyePosition(head, StereoEye::Left) },
    right{ SketchedEye::Right, EyePosition(head, StereoEye::Right) };
  switch (sketch.layout)
  {
    case StereoLayout::Mono:
      return { { SketchedEye::Between, head.position } };
    case StereoLayout::Left:
      return { left };
    case StereoLayout::Right:
      return { right };
    default:
      return { left, right };
  }
}

std::string StereoSketchText(const StereoSketch& sketch)
{
  ValidateStereoRig(sketch.rig);
  const StereoScreen& screen = sketch.rig.screen;
  const ScreenFrame frame(screen);
  const std::vector<SketchedEye> eyes = EyesOf(sketch);
  const glm::dvec3 viewer =
    frame.Of(0.5 * (eyes.front().position + eyes.back().position)); // between two
  char text[300];
  std::snprintf(text, sizeof text, "screen %.0f x %.0f mm, seen under %.1f x %.1f degrees; ",
    screen.widthMm, screen.heightMm, SeenUnder(viewer, { 0.5 * screen.widthMm, 0, 0 }),
    SeenUnder(viewer, { 0, 0.5 * screen.heightMm, 0 }));
  const std::string lines = sketch.title + "\n" + text + EyesText(sketch);
  if (!sketch.content)
    return lines + "\nnothing is shown";
  const auto nearer = [&](const glm::dvec3& a, const glm::dvec3& b)
  { return frame.Of(a).z > frame.Of(b).z; };
  const auto [near, far] =
    std::minmax_element(sketch.content->begin(), sketch.content->end(), nearer);
  const std::string box = sketch.contentIsVolume ? "box of the volume: " : "";
  return lines + "\n" + box + DepthText(sketch, *near, "nearest") + "\n" + box +
         DepthText(sketch, *far, "farthest");
}

} // namespace hasp
