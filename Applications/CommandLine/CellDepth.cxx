#include "CellDepth.h"

#include "Evaluation/TrilinearTruth.h"
#include "Grid/ParallelFor.h"
#include "Grid/Trilinear.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace hasp
{
namespace
{

constexpr double Grazing = 0.2;
constexpr double OtherSheet = 0.25; // voxels
constexpr double Aside = 1e-4;      // voxels: no float ray of a large volume is better
constexpr double Rounding = 1e-6;   // of the largest corner: a dozen float operations
constexpr double Small = 1e-4;      // voxels: such errors need no excuse

/// What is shown, against what the ray truly meets for one isovalue.
bool Agree(
  const std::optional<glm::dvec3>& hit, const std::optional<glm::dvec3>& shown, double voxel)
{
  if (!hit || !shown)
    return !hit && !shown;
  return glm::length(*hit - *shown) <= OtherSheet * voxel;
}

std::optional<glm::dvec3> FirstHit(
  const DepthTruth& truth, double isovalue, const glm::dvec3& origin, const glm::dvec3& direction)
{
  const auto hit = FirstTrilinearHit(truth.grid, isovalue, origin, direction);
  return hit ? std::optional(hit->position) : std::nullopt;
}

/// The largest |corner - isovalue| of the cell at a place in the world: what float values there are
/// rounded by.
double ScaleAt(const DepthTruth& truth, const glm::dvec3& place)
{
  const GridGeometry& g = GeometryOf(truth.grid);
  const glm::ivec3 cell =
    glm::clamp(glm::ivec3(glm::floor(g.WorldToIndex(place))), glm::ivec3(0), g.Cells() - 1);
  double scale = 0.0;
  for (const double c :
    std::visit([&](const auto& view) { return CellCorners(view, cell); }, truth.grid))
    if (std::isfinite(c))
      scale = std::max(scale, std::abs(c - truth.isovalue));
  return scale;
}

/// What ray n meets at isovalues a rounding apart, and what the rays beside it meet.
std::array<std::optional<glm::dvec3>, DepthTruth::Beside + 2> Nearby(
  const DepthTruth& truth, std::size_t n, const glm::dvec3& place)
{
  std::array<std::optional<glm::dvec3>, DepthTruth::Beside + 2> hits;
  const auto& beside = truth.HitsBeside(n);
  const auto rest = std::copy(beside.begin(), beside.end(), hits.begin());
  const WorldRay& ray = truth.rays[n];
  const double rounding = Rounding * ScaleAt(truth, place);
  rest[0] = FirstHit(truth, truth.isovalue - rounding, ray.origin, ray.direction);
  rest[1] = FirstHit(truth, truth.isovalue + rounding, ray.origin, ray.direction);
  return hits;
}

bool RightNearby(const DepthTruth& truth, std::size_t n, const glm::dvec3& place,
  const std::optional<glm::dvec3>& shown, double voxel)
{
  const auto nearby = Nearby(truth, n, place);
  return std::any_of(nearby.begin(), nearby.end(),
    [&](const std::optional<glm::dvec3>& other) { return Agree(other, shown, voxel); });
}

/// How many times a step of 1e-4 voxel aside, or a rounding, is magnified along the ray; infinite
/// at an edge of what is seen.
double Condition(const DepthTruth& truth, const DepthTruth::Hit& hit, std::size_t n, double voxel)
{
  double largest = 0.0;
  for (const auto& other : Nearby(truth, n, hit.position))
  {
    if (!other)
      return HUGE_VAL;
    largest = std::max(largest,
      std::abs(glm::dot(*other - hit.position, truth.rays[n].direction)) / (Aside * voxel));
  }
  return largest;
}

} // namespace

DepthTruth::DepthTruth(const AnyGridView& grid_, double isovalue_, std::vector<WorldRay> rays_)
  : grid(grid_),
    isovalue(static_cast<float>(isovalue_)),
    rays(std::move(rays_)),
    hits(rays.size())
{
  ParallelFor(0, std::int64_t(rays.size()), 256,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
        if (const auto hit = FirstTrilinearHit(grid, isovalue, rays[n].origin, rays[n].direction))
          hits[n] = Hit{ hit->position, hit->gradient };
    });
}

const std::array<std::optional<glm::dvec3>, DepthTruth::Beside>& DepthTruth::HitsBeside(
  std::size_t n) const
{
  const auto [found, fresh] = this->Found.try_emplace(n);
  if (!fresh)
    return found->second;
  const GridGeometry& g = GeometryOf(this->grid);
  const WorldRay& ray = this->rays[n];
  const glm::dvec3 any =
    std::abs(ray.direction.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(ray.direction, any));
  const glm::dvec3 v = glm::cross(ray.direction, u);
  for (int side = 0; side < Beside; ++side)
  {
    const double angle = glm::two_pi<double>() * side / Beside;
    const glm::dvec3 way = std::cos(angle) * u + std::sin(angle) * v;
    const double voxels = glm::length(g.WorldToIndex(g.origin + way));
    found->second[side] =
      FirstHit(*this, this->isovalue, ray.origin + Aside / voxels * way, ray.direction);
  }
  return found->second;
}

std::vector<WorldRay> PixelRays(const IsosurfaceView& view)
{
  std::vector<WorldRay> rays;
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x)
    {
      const auto [origin, direction] = view.Ray(x, y);
      rays.push_back({ origin, direction });
    }
  return rays;
}

namespace
{

double Facing(const DepthTruth::Hit& hit, const WorldRay& ray)
{
  const double steepness = glm::length(hit.gradient);
  return steepness > 0.0 ? std::abs(glm::dot(hit.gradient, ray.direction)) / steepness : 0.0;
}

} // namespace

DepthTruth::DepthTruth(const IsosurfaceView& view)
  : DepthTruth(ViewImage(view.image), view.isovalue, PixelRays(view))
{
}

namespace
{

DepthErrors Measure(const DepthTruth& truth, const SurfacePoints& shown, bool excuses)
{
  const glm::dvec3& s = GeometryOf(truth.grid).spacing;
  const double voxel = std::min({ s.x, s.y, s.z });
  DepthErrors result;
  std::vector<double> errors;
  double squares = 0.0;
  for (std::size_t n = 0; n < truth.hits.size(); ++n)
  {
    const auto& hit = truth.hits[n];
    result.surface += hit.has_value();
    if (!hit && !shown[n])
      continue;
    const double error = hit && shown[n] ? glm::length(*shown[n] - hit->position) / voxel : 1.0;
    if (error > OtherSheet)
    {
      const glm::dvec3 place = shown[n] ? *shown[n] : hit->position;
      if (excuses && RightNearby(truth, n, place, shown[n], voxel))
        ++result.tangent;
      else
        ++(hit ? result.missed : result.invented);
      continue;
    }
    result.maxAll = std::max(result.maxAll, error);
    if (Facing(*hit, truth.rays[n]) < Grazing ||
        (excuses && error > Small && Condition(truth, *hit, n, voxel) > 1.0 / Grazing))
      continue;
    errors.push_back(error);
    squares += error * error;
    if (error < result.max)
      continue;
    result.max = error;
    result.maxAt = n;
  }
  if (errors.empty())
    return result;
  const auto p99 = errors.begin() + std::ptrdiff_t(0.99 * double(errors.size() - 1));
  std::nth_element(errors.begin(), p99, errors.end());
  result.p99 = *p99;
  result.rms = std::sqrt(squares / double(errors.size()));
  return result;
}

} // namespace

DepthErrors MeasureDepth(const DepthTruth& truth, const SurfacePoints& shown)
{
  return Measure(truth, shown, true);
}

DepthErrors MeasureRival(const DepthTruth& truth, const SurfacePoints& shown)
{
  return Measure(truth, shown, false);
}

std::string DepthErrors::Text() const
{
  return std::to_string(this->surface) + " rays meet the surface, " + std::to_string(this->missed) +
         " missed, " + std::to_string(this->invented) + " invented, " +
         std::to_string(this->tangent) + " tangent";
}

} // namespace hasp
