#include "Light/PathTracer.h"
#include "Light/LampLight.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{

constexpr double Pi = glm::pi<double>();

void Require(bool condition, const char* what, double value, const char* range)
{
  if (!condition)
    throw std::invalid_argument(
      std::string("PathTracer: ") + what + " " + std::to_string(value) + " must be " + range);
}

float Largest(const glm::vec3& v)
{
  return std::max({ v.r, v.g, v.b });
}

} // namespace

void PathTracerSettings::Validate() const
{
  Require(this->bounces >= 1 && this->bounces <= 64, "bounces", this->bounces, "1 to 64");
  Require(
    this->rouletteFrom >= 1, "first bounce of Russian roulette", this->rouletteFrom, "at least 1");
}

/// A path under way.
template <typename Points>
struct PathTracer<Points>::Path
{
  glm::vec3 radiance{ 0.0F }, share{ 1.0F }; ///< of what comes next, that reaches the eye
  glm::dvec3 direction{ 0.0 }; ///< of its last ray, from the surface; its way may have no length
  int rays = 0;
};

template <typename Points>
PathTracer<Points>::PathTracer(const LitScene& scene, const PathTracerSettings& settings)
  : Scene(&scene),
    Settings(settings),
    Dark(!(scene.Surroundings().Brightest() > 0.0))
{
  settings.Validate();
}

template <typename Points>
double PathTracer<Points>::BrightestSample() const
{
  double direct = this->Scene->Surroundings().Samples() ? this->Scene->Surroundings().Total() / Pi
                                                        : this->Scene->Surroundings().Brightest();
  for (const LitLamp& lamp : this->Scene->Lamps())
    direct += Largest(lamp.color) / std::max(1e-30, double(lamp.attenuation.x));
  // By its bright places and by the lobe: two samples, each weighted.
  return this->Settings.bounces * 2.0 * direct;
}

template <typename Points>
void PathTracer<Points>::Lamps(const LitHit& hit, const SurfaceScattering::At& at, Path& path) const
{
  for (const LitLamp& lamp : this->Scene->Lamps())
    path.radiance += path.share * LampRadiance(*this->Scene, lamp, hit, at, true, path.rays);
}

/// The environment by its bright places.
template <typename Points>
void PathTracer<Points>::Surroundings(const LitHit& hit, const SurfaceScattering::At& at,
  const Environment& far, Points& points, Path& path) const
{
  const EnvironmentSample sample = far.Sample(points.Next());
  if (!(sample.density > 0.0) || !(glm::dot(sample.direction, hit.normal) > 0.0))
    return;
  const glm::vec3 given = at.Evaluate(sample.direction);
  if (!(Largest(given) > 0.0F))
    return;
  ++path.rays;
  if (this->Scene->OccludedFrom(hit, sample.direction))
    return;
  // L f cos / density, weighted density / (density + the lobe's).
  const double both = sample.density + at.Density(sample.direction);
  path.radiance += path.share * given * glm::vec3(glm::dvec3(sample.radiance) / both);
}

/// On by the surface's lobe: the next surface, or nothing where the path ends.
template <typename Points>
std::optional<LitHit> PathTracer<Points>::Scatter(const LitHit& hit,
  const SurfaceScattering::At& at, const Environment& far, bool weighted, Points& points,
  int bounce, Path& path) const
{
  const glm::dvec2 point = points.Next();
  const double choice = this->Scene->Scattering(hit.body).Diffuse() ? 0.0 : points.Next1();
  const ScatterSample sample = at.Sample(choice, point);
  path.share *= sample.weight;
  if (!(Largest(path.share) > 0.0F) || !(glm::dot(sample.direction, hit.normal) > 0.0))
    return std::nullopt;
  if (bounce >= this->Settings.rouletteFrom)
  {
    const float stays = std::min(1.0F, Largest(path.share));
    if (stays < 1.0F)
    {
      if (!(points.Next1() < stays))
        return std::nullopt;
      path.share /= stays;
    }
  }
  const bool last = bounce >= this->Settings.bounces;
  if (last && this->Dark)
    return std::nullopt;
  ++path.rays;
  path.direction = sample.direction;
  if (!last)
    if (auto next = this->Scene->TraceFrom(hit, sample.direction))
      return next;
  if (this->Dark || (last && this->Scene->OccludedFrom(hit, sample.direction)))
    return std::nullopt;
  const glm::vec3 light = far.Radiance(sample.direction);
  const double density = weighted ? Largest(light) / far.Total() : 0.0; // far.Density's
  const double weight = sample.density / (sample.density + density);
  path.radiance += path.share * light * static_cast<float>(weight);
  return std::nullopt;
}

template <typename Points>
void PathTracer<Points>::Walk(
  LitHit hit, glm::dvec3 towardsEye, Points& points, int bounce, Path& path) const
{
  for (;; ++bounce)
  {
    const SurfaceScattering::At at(
      this->Scene->Scattering(hit.body), hit.albedo, hit.shading, towardsEye);
    this->Lamps(hit, at, path);
    const Environment& far = this->Scene->Surroundings();
    if (far.Samples())
      this->Surroundings(hit, at, far, points, path);
    const std::optional<LitHit> next =
      this->Scatter(hit, at, far, far.Samples(), points, bounce, path);
    if (!next)
      return;
    towardsEye = -path.direction;
    hit = *next;
  }
}

template <typename Points>
PathSample PathTracer<Points>::Radiance(
  const LitHit& hit, const glm::dvec3& towardsEye, Points& points) const
{
  Path path;
  path.radiance = this->Scene->Bodies()[hit.body].glow;
  this->Walk(hit, towardsEye, points, 1, path);
  return { path.radiance, path.rays };
}

template <typename Points>
PathSample PathTracer<Points>::Incoming(
  const glm::dvec3& origin, const glm::dvec3& direction, Points& points) const
{
  const auto hit = this->Scene->Trace(origin, direction);
  if (!hit)
    return { this->Scene->Surroundings().Radiance(direction), 1 };
  PathSample sample = this->Radiance(*hit, -direction, points);
  ++sample.rays;
  return sample;
}

template <typename Points>
PathSample PathTracer<Points>::WhiteRadiance(
  const LitHit& hit, Points& points, const Environment* far) const
{
  static const SurfaceScattering white({ glm::vec3(1.0F) });
  const SurfaceScattering::At at(white, glm::vec3(1.0F), hit.shading, hit.shading);
  const Environment& first = far ? *far : this->Scene->Surroundings();
  const bool weighted = !far && first.Samples();
  Path path;
  if (weighted)
    this->Surroundings(hit, at, first, points, path);
  if (const std::optional<LitHit> next = this->Scatter(hit, at, first, weighted, points, 1, path))
    this->Walk(*next, -path.direction, points, 2, path);
  return { path.radiance, path.rays };
}

template class PathTracer<SobolSequence>;
template class PathTracer<RandomSequence>;

} // namespace hasp
