#include "Reduction/FitBody.h"

#include <glm/matrix.hpp>

#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
void CheckSettings(const FitBodySettings& s)
{
  const auto check = [](const char* name, double value, bool legal, const char* range)
  {
    if (!legal)
      throw std::invalid_argument(std::string("fit body: ") + name + " is " +
                                  std::to_string(value) + ", must be in " + range);
  };
  check("pointMm2", s.pointMm2, s.pointMm2 >= 0.01 && s.pointMm2 <= 100.0, "[0.01, 100]");
  check(
    "mostPoints", s.mostPoints, s.mostPoints >= 64 && s.mostPoints <= 1'000'000, "[64, 1000000]");
  check("smoothMm", s.smoothMm, s.smoothMm > 0.0 && s.smoothMm <= 20.0, "(0, 20]");
  check("flatness", s.flatness, s.flatness > 0.0 && s.flatness < 1.0, "(0, 1)");
  check("smoothPointMm2", s.smoothPointMm2, s.smoothPointMm2 >= 0.01 && s.smoothPointMm2 <= 100.0,
    "[0.01, 100]");
}

const DistanceMap& Required(const DistanceMap* map, const PointShell* shell)
{
  if (map == nullptr || shell == nullptr)
    throw std::invalid_argument("fit body: it needs a distance map and a pointshell, both of them");
  if (shell->Levels() == 0)
    throw std::invalid_argument("fit body: its pointshell has no points: the fragment is empty");
  return *map;
}

constexpr double PointBoxMm = 4.0;
constexpr double LeastSlope = 0.3; // a shorter gradient is that of a middle, and points anywhere
} // namespace

FitBody::FitBody(std::shared_ptr<const DistanceMap> map, std::shared_ptr<const PointShell> shell,
  const FitBodySettings& settings)
  : Map(std::move(map)),
    MapOrigin(0.0),
    Range(Required(this->Map.get(), shell.get()).RangeMm()),
    Area(shell->SurfaceArea()),
    Radius(shell->Radius())
{
  CheckSettings(settings);
  this->MapOrigin = this->Map->Geometry().IndexToWorld(glm::dvec3(this->Map->View().indexOfOrigin));
  for (int level = 0; level < shell->Levels(); ++level)
  {
    if (level > 0 && shell->LevelEnd(level) > std::uint32_t(settings.mostPoints))
      break;
    const ContactPoints points = shell->Level(level);
    for (std::uint32_t n = 0; n < points.count; ++n)
      if (points.x[n] < 0.5F * ContactPoints::FarAway)
        this->Shell.push_back({ { points.x[n], points.y[n], points.z[n] },
          { points.nx[n], points.ny[n], points.nz[n] } });
    this->LevelEnds.push_back(this->Shell.size());
  }
  for (const OrientedPoint& p : this->Shell)
  {
    if (this->Map->At(this->MapOrigin + p.place).mm >= this->Range)
      throw std::invalid_argument("fit body: its pointshell reaches beyond its distance map: bake "
                                  "both of one fragment, with one origin");
    this->Middle += p.place / double(this->Shell.size());
  }
  for (const OrientedPoint& p : this->Shell)
    this->SpreadOut += glm::outerProduct(p.place - this->Middle, p.place - this->Middle) /
                       double(this->Shell.size());
  this->Boxes = std::make_shared<const PointBoxes>(this->Shell, PointBoxMm);
  this->SmoothOnes =
    std::make_shared<const SmoothPoints>(this->Shell, this->Area / double(this->Shell.size()),
      settings.smoothMm, settings.flatness, settings.smoothPointMm2);
}

std::optional<FitBody::Foot> FitBody::FootOf(const glm::dvec3& place) const noexcept
{
  const DistanceMap::Sample sample = this->Map->At(this->MapOrigin + place);
  const double slope = glm::length(sample.gradient);
  if (sample.mm >= this->Range || !(slope > LeastSlope))
    return std::nullopt;
  return Foot{ sample.mm, sample.gradient / slope };
}

std::span<const OrientedPoint> FitBody::Points(std::size_t most) const noexcept
{
  std::size_t count = this->LevelEnds.front();
  for (const std::size_t end : this->LevelEnds)
    if (end <= most)
      count = end;
  return { this->Shell.data(), count };
}

} // namespace hasp
