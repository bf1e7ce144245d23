#include "StereoHmd.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

double Span(double one, double other, const char* name)
{
  const double span = one + other;
  if (!(span > 0.0) || !std::isfinite(span))
    throw std::invalid_argument(std::string("head-mounted display: ") + name + " add up to " +
                                std::to_string(span) + " (tangents), must be > 0");
  return span;
}

void RequireHead(const StereoHead& head)
{
  if (!std::isfinite(glm::length(head.position)))
    throw std::invalid_argument("head-mounted display: the head's position is not finite");
  const double cosine = glm::dot(glm::normalize(head.right), glm::normalize(head.up));
  if (!(std::abs(cosine) <= 1e-6))
    throw std::invalid_argument("head-mounted display: cosine between the head's right and up is " +
                                std::to_string(cosine) + ", must be 0");
  if (!(head.eyeSeparationMm >= 0.0) || !std::isfinite(head.eyeSeparationMm))
    throw std::invalid_argument("head-mounted display: eye separation is " +
                                std::to_string(head.eyeSeparationMm) + " mm, must be >= 0");
}

} // namespace

EyeView ViewOfHmdEye(const StereoHmd& hmd, const StereoHead& head, StereoEye eye)
{
  RequireHead(head);
  const FieldOfView& field = hmd.fields[eye == StereoEye::Right];
  const double across = Span(field.left, field.right, "left and right");
  const double along = Span(field.up, field.down, "up and down");
  EyeView view;
  view.viewUp = glm::normalize(head.up);
  view.position = EyePosition(head, eye);
  view.focalPoint = view.position - 500.0 * glm::cross(glm::normalize(head.right), view.viewUp);
  view.viewAngleDegrees = 2.0 * std::atan(0.5 * along) * 180.0 / std::numbers::pi;
  view.windowCenter = { (field.right - field.left) / across, (field.up - field.down) / along };
  view.aspect = across / along;
  return view;
}

} // namespace hasp
