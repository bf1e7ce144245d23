#include "StereoRig.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

/// The screen's axes, unit length; normal points at the viewer.
struct Frame
{
  glm::dvec3 right, up, normal;
};

Frame FrameOf(const StereoScreen& screen)
{
  const glm::dvec3 right = glm::normalize(screen.right);
  const glm::dvec3 up = glm::normalize(screen.up);
  return { right, up, glm::cross(right, up) };
}

double DistanceToScreen(const StereoScreen& screen, const glm::dvec3& point)
{
  return glm::dot(point - screen.center, FrameOf(screen).normal);
}

void RequirePositive(double value, const char* name)
{
  if (!(value > 0.0) || !std::isfinite(value))
    throw std::invalid_argument(
      std::string("stereo rig: ") + name + " is " + std::to_string(value) + ", must be > 0");
}

} // namespace

glm::dvec3 EyePosition(const StereoHead& head, StereoEye eye)
{
  const double side = eye == StereoEye::Left ? -0.5 : 0.5;
  return head.position + side * head.eyeSeparationMm * glm::normalize(head.right);
}

void ValidateStereoRig(const StereoRig& rig)
{
  RequirePositive(rig.screen.widthMm, "screen width (mm)");
  RequirePositive(rig.screen.heightMm, "screen height (mm)");
  RequirePositive(glm::length(rig.screen.right), "length of the screen's right");
  RequirePositive(glm::length(rig.screen.up), "length of the screen's up");
  RequirePositive(glm::length(rig.head.right), "length of the head's right");
  if (!(rig.head.eyeSeparationMm >= 0.0) || !std::isfinite(rig.head.eyeSeparationMm))
    throw std::invalid_argument("stereo rig: eye separation is " +
                                std::to_string(rig.head.eyeSeparationMm) + " mm, must be >= 0");
  const double cosine = glm::dot(glm::normalize(rig.screen.right), glm::normalize(rig.screen.up));
  if (!(std::abs(cosine) <= 1e-6))
    throw std::invalid_argument("stereo rig: cosine between the screen's right and up is " +
                                std::to_string(cosine) +
                                ", must be 0: give two edges of a rectangle");
  for (const StereoEye eye : { StereoEye::Left, StereoEye::Right })
  {
    const double distance = DistanceToScreen(rig.screen, EyePosition(rig.head, eye));
    if (!(distance > 0.0) || !std::isfinite(distance))
      throw std::invalid_argument(
        std::string("stereo rig: the ") + (eye == StereoEye::Left ? "left" : "right") + " eye is " +
        std::to_string(distance) + " mm in front of the screen, must be > 0");
  }
}

EyeView ViewOfEye(const StereoRig& rig, StereoEye eye)
{
  ValidateStereoRig(rig);
  const Frame frame = FrameOf(rig.screen);
  const glm::dvec3 position = EyePosition(rig.head, eye);
  const double distance = DistanceToScreen(rig.screen, position);
  const glm::dvec3 toCenter = rig.screen.center - position;
  EyeView view;
  view.position = position;
  view.focalPoint = position - distance * frame.normal;
  view.viewUp = frame.up;
  view.viewAngleDegrees =
    2.0 * std::atan(0.5 * rig.screen.heightMm / distance) * 180.0 / std::numbers::pi;
  view.windowCenter = { glm::dot(toCenter, frame.right) / (0.5 * rig.screen.widthMm),
    glm::dot(toCenter, frame.up) / (0.5 * rig.screen.heightMm) };
  view.aspect = rig.screen.widthMm / rig.screen.heightMm;
  return view;
}

glm::dvec3 PointOnScreen(const EyeView& view, glm::dvec2 device)
{
  const glm::dvec3 axis = view.focalPoint - view.position;
  const glm::dvec3 right = glm::normalize(glm::cross(axis, view.viewUp));
  const double half =
    glm::length(axis) * std::tan(0.5 * view.viewAngleDegrees * std::numbers::pi / 180.0);
  const glm::dvec2 off = half * glm::dvec2(view.aspect, 1.0) * (device + view.windowCenter);
  return view.focalPoint + off.x * right + off.y * view.viewUp;
}

StereoRig TransformStereoRig(const StereoRig& rig, const glm::dmat4& map)
{
  for (int column = 0; column < 4; ++column)
    if (!(std::abs(map[column][3] - (column == 3)) <= 1e-9))
      throw std::invalid_argument(
        "stereo rig: the transform's lowest row is not (0, 0, 0, 1); is it "
        "transposed?");
  const glm::dmat3 linear(map);
  const double determinant = glm::determinant(linear);
  if (!(determinant > 0.0) || !std::isfinite(determinant))
    throw std::invalid_argument("stereo rig: the transform's determinant is " +
                                std::to_string(determinant) + ", must be > 0 (no mirror)");
  const double scale = std::cbrt(determinant);
  const glm::dmat3 product = glm::transpose(linear) * linear; // scale^2 times identity
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      if (std::abs(product[column][row] / (scale * scale) - (row == column)) > 1e-6)
        throw std::invalid_argument(
          "stereo rig: the transform shears or scales unevenly; give a rotation, one scale and a "
          "translation");
  const auto point = [&](const glm::dvec3& p) { return glm::dvec3(map * glm::dvec4(p, 1.0)); };
  StereoRig result;
  result.screen = { point(rig.screen.center), linear * rig.screen.right, linear * rig.screen.up,
    scale * rig.screen.widthMm, scale * rig.screen.heightMm };
  result.head = { point(rig.head.position), linear * rig.head.right,
    scale * rig.head.eyeSeparationMm, linear * rig.head.up };
  return result;
}

glm::dvec2 ProjectToScreen(const StereoRig& rig, StereoEye eye, const glm::dvec3& point)
{
  ValidateStereoRig(rig);
  const Frame frame = FrameOf(rig.screen);
  const glm::dvec3 position = EyePosition(rig.head, eye);
  const double eyeHeight = DistanceToScreen(rig.screen, position);
  const double toPoint = eyeHeight - DistanceToScreen(rig.screen, point);
  if (!(toPoint > 0.0))
    throw std::invalid_argument("stereo rig: the point is " + std::to_string(-toPoint) +
                                " mm behind the eye, must be in front of it");
  const glm::dvec3 hit = position + (point - position) * (eyeHeight / toPoint) - rig.screen.center;
  return { glm::dot(hit, frame.right) / (0.5 * rig.screen.widthMm),
    glm::dot(hit, frame.up) / (0.5 * rig.screen.heightMm) };
}

double ScreenDisparityMm(const StereoRig& rig, const glm::dvec3& point)
{
  return 0.5 * rig.screen.widthMm *
         (ProjectToScreen(rig, StereoEye::Right, point).x -
           ProjectToScreen(rig, StereoEye::Left, point).x);
}

} // namespace hasp
