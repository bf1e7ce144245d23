#include "GuideBone.h"

#include "Distance/Coverage.h"
#include "Distance/CoverageDistance.h"
#include "Distance/EuclideanDistance.h"
#include "Grid/ParallelFor.h"
#include "Grid/Trilinear.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace hasp
{

namespace
{
constexpr float DeepMm = 1000.0F; // in a shadow without an end

template <typename T>
bool IsBone(const GridView<const T>& ct, const std::vector<std::uint8_t>& keep, double isovalue,
  const glm::dvec3& world)
{
  const GridGeometry& g = ct.geometry;
  const auto at = LocateCell(g, g.WorldToIndex(world));
  if (!at)
    return false;
  const glm::ivec3 nearest = at->cell + glm::ivec3(glm::round(at->local));
  return TrilinearValue(CellCorners(ct, at->cell), at->local) >= isovalue &&
         keep[ct.Offset(nearest.x, nearest.y, nearest.z)];
}

/// Of the places half a spacing apart along a ray, how far the first one in bone is.
template <typename T>
std::optional<double> FirstInBone(const GridView<const T>& ct,
  const std::vector<std::uint8_t>& keep, double isovalue, const glm::dvec3& from,
  const glm::dvec3& direction, double lengthMm)
{
  const glm::dvec3& spacing = ct.geometry.spacing;
  const double step = 0.5 * std::min({ spacing.x, spacing.y, spacing.z });
  for (double t = 0.0; t < lengthMm; t += step)
    if (IsBone(ct, keep, isovalue, from + t * direction))
      return t;
  return std::nullopt;
}

/// Whether kept bone lies above a point of the working grid's top, along the withdrawal direction.
template <typename T>
bool BoneAbove(const GridView<const T>& ct, const std::vector<std::uint8_t>& keep, double isovalue,
  const glm::dvec3& from, const glm::dvec3& up)
{
  const GridGeometry& g = ct.geometry;
  const glm::dvec3 size = glm::dvec3(g.dims) * g.spacing;
  const glm::dvec3 middle = g.IndexToWorld(0.5 * glm::dvec3(g.Cells()));
  const double end = glm::dot(middle - from, up) + 0.5 * glm::length(size);
  return FirstInBone(ct, keep, isovalue, from, up, end).has_value();
}

/// Of each column of the grid, the distance across to the shadow of what lies above the grid.
std::vector<float> ShadowFromAbove(const AnyGridView& ct, const std::vector<std::uint8_t>& keep,
  double isovalue, const GridGeometry& grid)
{
  GridGeometry top = grid;
  top.dims.z = 1;
  top.origin = grid.IndexToWorld({ 0, 0, grid.dims.z - 1 });
  std::vector<std::uint8_t> blocked(top.Size());
  std::visit(
    [&](const auto& view)
    {
      ParallelFor(0, std::int64_t(blocked.size()), 64,
        [&](std::int64_t first, std::int64_t last)
        {
          for (std::int64_t n = first; n < last; ++n)
            blocked[n] = BoneAbove(view, keep, isovalue,
              top.IndexToWorld({ n % top.dims.x, n / top.dims.x, 0 }), top.direction[2]);
        });
    },
    ct);
  return SignedEuclideanDistance(top, blocked);
}
} // namespace

std::optional<double> WayToBone(const AnyGridView& ct, const std::vector<std::uint8_t>& keep,
  double isovalue, const glm::dvec3& from, const glm::dvec3& direction, double lengthMm)
{
  constexpr int halvings = 30;
  return std::visit(
    [&](const auto& view) -> std::optional<double>
    {
      const glm::dvec3& spacing = view.geometry.spacing;
      const auto first = FirstInBone(view, keep, isovalue, from, direction, lengthMm);
      if (!first || *first == 0.0)
        return first;
      double in = *first, out = in - 0.5 * std::min({ spacing.x, spacing.y, spacing.z });
      for (int n = 0; n < halvings; ++n)
      {
        const double middle = 0.5 * (in + out);
        (IsBone(view, keep, isovalue, from + middle * direction) ? in : out) = middle;
      }
      return in;
    },
    ct);
}

GuideDistances DistanceToBone(const AnyGridView& ct, const std::vector<std::uint8_t>& keep,
  double isovalue, const GridGeometry& grid, const ProgressFunction& progress)
{
  CoverageSettings settings;
  settings.isovalue = isovalue;
  settings.keep = keep;
  const auto half = [&](double from)
  { return [&progress, from](double share) { return !progress || progress(from + 0.5 * share); }; };
  const std::vector<float> coverage = Coverage(ct, grid, settings, half(0.0));
  return std::make_shared<const std::vector<float>>(CoverageDistance(grid, coverage, half(0.5)));
}

GuideDistances BlockUndercuts(const std::vector<float>& distances, const AnyGridView& ct,
  const std::vector<std::uint8_t>& keep, double isovalue, const GridGeometry& grid,
  const ProgressFunction& progress)
{
  std::vector<float> least = ShadowFromAbove(ct, keep, isovalue, grid);
  for (float& value : least)
    value = std::max(value, -DeepMm);
  const std::int64_t slice = std::int64_t(least.size()), columns = 1 << 12;
  std::vector<float> blocked(distances.size());
  for (std::int64_t k = grid.dims.z - 1; k >= 0; --k)
  {
    if (k % 16 == 0)
      ReportProgress(progress, 1.0 - double(k) / double(grid.dims.z));
    ParallelFor(0, slice, columns,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
          blocked[k * slice + n] = least[n] = std::min(least[n], distances[k * slice + n]);
      });
  }
  return std::make_shared<const std::vector<float>>(std::move(blocked));
}

} // namespace hasp
