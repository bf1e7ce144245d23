#include "Studies/RoughPlane.h"

#include "Studies/SeededShare.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

constexpr std::uint64_t WaveCount = 24;

void Require(bool holds, const char* name, double value, const char* range)
{
  if (!holds || !std::isfinite(value))
    throw std::invalid_argument("fracture face: " + std::string(name) + " is " +
                                std::to_string(value) + ", must be " + range);
}

} // namespace

RoughPlane::RoughPlane(const FractureFace& face) : Face(face)
{
  for (int a = 0; a < 3; ++a)
    Require(true, "point", face.point[a], "finite");
  const double length = glm::length(face.outward);
  Require(std::abs(length - 1.0) < 1e-6, "the length of outward", length, "1");
  Require(face.roughMm >= 0.0 && face.roughMm <= 10.0, "roughMm", face.roughMm, "in [0, 10]");
  Require(face.shortestMm > 0.0, "shortestMm", face.shortestMm, "> 0");
  Require(face.longestMm >= face.shortestMm, "longestMm", face.longestMm, ">= shortestMm");
  const glm::dvec3 away =
    std::abs(face.outward.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  this->U = glm::normalize(glm::cross(face.outward, away));
  this->V = glm::cross(face.outward, this->U);
  if (face.roughMm == 0.0)
    return;
  double squares = 0.0;
  for (std::uint64_t n = 0; n < WaveCount; ++n)
  {
    const double length = face.shortestMm * std::pow(face.longestMm / face.shortestMm,
                                              (double(n) + 0.5) / double(WaveCount));
    const double way = glm::pi<double>() * SeededShare(face.seed, 2 * n);
    const double number = glm::two_pi<double>() / length;
    this->Waves.push_back({ number * glm::dvec2(std::cos(way), std::sin(way)),
      glm::two_pi<double>() * SeededShare(face.seed, 2 * n + 1), length });
    squares += 0.5 * length * length;
  }
  double slope = 0.0;
  for (Wave& wave : this->Waves)
  {
    wave.mm *= face.roughMm / std::sqrt(squares);
    this->Most += wave.mm;
    slope += wave.mm * glm::length(wave.number);
  }
  this->SteepestWay = std::hypot(1.0, slope);
}

glm::dvec2 RoughPlane::OnPlane(const glm::dvec3& point) const
{
  const glm::dvec3 off = point - this->Face.point;
  return { glm::dot(off, this->U), glm::dot(off, this->V) };
}

double RoughPlane::PlaneMm(const glm::dvec3& point) const
{
  return glm::dot(point - this->Face.point, this->Face.outward);
}

double RoughPlane::HeightMm(const glm::dvec3& point) const
{
  const glm::dvec2 at = this->OnPlane(point);
  double height = 0.0;
  for (const Wave& wave : this->Waves)
    height += wave.mm * std::cos(glm::dot(wave.number, at) + wave.phase);
  return height;
}

RoughPlane::Foot RoughPlane::FootOf(const glm::dvec3& point) const
{
  const glm::dvec2 at = this->OnPlane(point);
  double height = 0.0;
  glm::dvec2 slope(0.0);
  for (const Wave& wave : this->Waves)
  {
    const double angle = glm::dot(wave.number, at) + wave.phase;
    height += wave.mm * std::cos(angle);
    slope -= wave.mm * std::sin(angle) * wave.number;
  }
  const glm::dvec3 up = this->Face.outward - slope.x * this->U - slope.y * this->V;
  const double steep = glm::length(up);
  return { (this->PlaneMm(point) - height) / steep, up / steep };
}

} // namespace hasp
