#include "TrialBody.h"

#include "Grid/AnalyticVolumes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace hasp
{
namespace
{

class Draw
{
public:
  explicit Draw(std::uint64_t seed) : Engine(seed) {}
  double In(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Engine);
  }
  glm::dvec3 InBox(double half)
  {
    const double x = this->In(-half, half), y = this->In(-half, half);
    return { x, y, this->In(-half, half) };
  }

private:
  std::mt19937_64 Engine;
};

} // namespace

TrialBody::TrialBody(int samples, const TrialShape& shape)
  : Shape(shape),
    Grid{ glm::ivec3(samples), glm::dvec3(-0.5 * (samples - 1)), glm::dvec3(1.0), glm::dmat3(1.0) }
{
  const double f = shape.perBump / shape.radius;
  const auto distance = [=](const glm::dvec3& p)
  {
    return glm::length(p) - shape.radius -
           shape.bump * std::sin(f * p.x + 1.0) * std::sin(1.25 * f * p.y) *
             std::sin(1.125 * f * p.z + 2.0);
  };
  this->Samples = SampleAnalytic<float>({ "bumpy ball", distance, 1.0 }, this->Grid, 1.0, 0.0);
  this->BakedMap =
    std::make_shared<DistanceMap>(this->View(), DistanceMapSettings{ .reference = true });
}

std::shared_ptr<const PointShell> TrialBody::Shell(int points, std::uint32_t seed) const
{
  return PointShell::OfSurface(this->View(), glm::dvec3(0.0), { .points = points, .seed = seed });
}

std::shared_ptr<const PointShell> TrialBody::FittingShell(int points) const
{
  const auto same = this->Shell(points);
  std::vector<SurfacePoint> turned;
  for (const ContactPoints& run : UpTo(*same, same->Levels() - 1))
    for (std::uint32_t n = 0; n < run.count; ++n)
      if (run.x[n] != ContactPoints::FarAway)
        turned.push_back(
          { { run.x[n], run.y[n], run.z[n] }, { -run.nx[n], -run.ny[n], -run.nz[n] } });
  return PointShell::OfPoints(turned, same->SurfaceArea(), glm::dvec3(0.0), { .points = points });
}

TrialShape BumpyShape(int samples)
{
  return { 0.3 * samples, 0.006 * samples, 6.0 };
}

std::vector<ContactPoints> UpTo(const PointShell& shell, int last)
{
  std::vector<ContactPoints> runs;
  for (int level = 0; level <= last; ++level)
  {
    runs.push_back(shell.Level(level));
    runs.back().area = static_cast<float>(shell.SurfaceArea() / shell.LevelEnd(last));
  }
  return runs;
}

std::vector<RigidPose> FitPoses(int count, std::uint64_t seed)
{
  std::vector<RigidPose> poses;
  Draw draw(seed);
  for (int n = 0; n < count; ++n)
  {
    const double far = draw.In(0.3, 1.0);
    const glm::dvec3 way = far * glm::normalize(draw.InBox(1.0));
    poses.push_back({ way, TurnBy(draw.InBox(0.02)) });
  }
  return poses;
}

std::vector<RigidPose> PressPoses(int count, double radius, std::uint64_t seed)
{
  std::vector<RigidPose> poses;
  Draw draw(seed);
  for (int n = 0; n < count; ++n)
  {
    const double apart = 2.0 * radius - draw.In(0.2, 1.0);
    const glm::dvec3 way = apart * glm::normalize(draw.InBox(1.0));
    poses.push_back({ way, TurnBy(draw.InBox(2.0)) });
  }
  return poses;
}

double WrenchError(const Wrench& wrench, const Wrench& truth, double radius)
{
  const double size = std::max(glm::length(truth.force), 1e-12);
  return WorseOf(glm::length(wrench.force - truth.force) / size,
    glm::length(wrench.torque - truth.torque) / (size * radius));
}

double WorseOf(double a, double b)
{
  return a >= b || std::isnan(a) ? a : b; // std::max would lose a NaN, and an error with it
}

std::string IdAt(const std::string& id, int figure, int plain)
{
  return figure == plain ? id : std::string(id).append("@").append(std::to_string(figure));
}

} // namespace hasp
