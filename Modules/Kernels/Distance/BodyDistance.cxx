#include "Distance/BodyDistance.h"

#include "Distance/Coverage.h"
#include "Distance/CoverageDistance.h"
#include "Distance/MeshCoverage.h"
#include "Grid/ParallelFor.h"
#include "Grid/ProgressPart.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr double BandSpacings = 16.0; // DistanceMap's own default
constexpr double CoverageShare = 0.4; // of the time, for progress

/// A box; empty while low > high.
struct Extent
{
  glm::dvec3 low{ std::numeric_limits<double>::infinity() };
  glm::dvec3 high{ -std::numeric_limits<double>::infinity() };

  void Take(const glm::dvec3& point)
  {
    this->low = glm::min(this->low, point);
    this->high = glm::max(this->high, point);
  }
  bool Empty() const { return !(this->low.x <= this->high.x); }
};

void RequireNotNegative(double value, const char* name)
{
  if (!(value >= 0.0) || !std::isfinite(value))
    throw std::invalid_argument(std::string("body distance: ") + name + " is " +
                                std::to_string(value) + " mm; it must be 0 or more, and finite");
}

void Check(const BodyDistanceSettings& settings)
{
  RequireNotNegative(settings.spacingMm, "the spacing");
  RequireNotNegative(settings.bandMm, "the band");
}

/// Samples `spacing` apart that hold `box` (mm along `axes`, about `origin`) and the band.
GridGeometry GridAround(const Extent& box, const glm::dvec3& origin, const glm::dmat3& axes,
  double spacing, const BodyDistanceSettings& settings)
{
  const double band = settings.bandMm > 0.0 ? settings.bandMm : BandSpacings * spacing;
  const glm::dvec3 low = box.low - band - spacing;
  const glm::dvec3 steps = glm::ceil((box.high + band + spacing - low) / spacing);
  const glm::dvec3 counts = steps + 1.0;
  const double samples = counts.x * counts.y * counts.z;
  if (!(samples <= double(settings.mostSamples)))
  {
    // The band counts in spacings by default: cubic in them, and this is on the safe side.
    const double coarser = spacing * std::cbrt(samples / double(settings.mostSamples)) * 1.05;
    throw std::invalid_argument("body distance: the grid would have " + std::to_string(counts.x) +
                                " x " + std::to_string(counts.y) + " x " +
                                std::to_string(counts.z) + " samples, more than " +
                                std::to_string(settings.mostSamples) + "; with a spacing of " +
                                std::to_string(coarser) + " mm it would do");
  }
  GridGeometry grid;
  grid.dims = glm::ivec3(counts);
  grid.spacing = glm::dvec3(spacing);
  grid.direction = axes;
  grid.origin = origin + axes * low;
  return grid;
}

/// Of the samples inside, in index coordinates; one more on each side, where the surface may lie.
template <typename T>
Extent InsideExtent(const GridView<const T>& view, double isovalue)
{
  const glm::ivec3 dims = view.geometry.dims;
  std::vector<Extent> slices(static_cast<std::size_t>(dims.z));
  ParallelFor(0, dims.z, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t k = first; k < last; ++k)
        for (int j = 0; j < dims.y; ++j)
          for (int i = 0; i < dims.x; ++i)
            if (double(view(i, j, static_cast<int>(k))) >= isovalue)
              slices[static_cast<std::size_t>(k)].Take({ i, j, double(k) });
    });
  Extent box;
  for (const Extent& slice : slices)
    if (!slice.Empty())
    {
      box.Take(slice.low);
      box.Take(slice.high);
    }
  box.low = glm::max(box.low - 1.0, glm::dvec3(0.0));
  box.high = glm::min(box.high + 1.0, glm::dvec3(dims - 1));
  return box;
}

BodyDistance Measure(
  const GridGeometry& grid, std::vector<float> coverage, const ProgressFunction& progress)
{
  if (std::all_of(coverage.begin(), coverage.end(), [](float share) { return share == 0.0F; }))
    throw std::invalid_argument("body distance: nothing is inside; is the isovalue beyond the "
                                "values, or the body thinner than the spacing of " +
                                std::to_string(grid.spacing.x) + " mm?");
  return { grid, CoverageDistance(grid, coverage, PartOf(progress, CoverageShare, 1.0)) };
}

} // namespace

BodyDistance DistanceOfVolume(const AnyGridView& volume, double isovalue,
  const BodyDistanceSettings& settings, const ProgressFunction& progress)
{
  Check(settings);
  const GridGeometry& source = GeometryOf(volume);
  source.Validate();
  if (!std::isfinite(isovalue))
    throw std::invalid_argument("body distance: the isovalue must be finite");
  const double smallest = std::min({ source.spacing.x, source.spacing.y, source.spacing.z });
  const double spacing = settings.spacingMm > 0.0 ? settings.spacingMm : smallest;
  ReportProgress(progress, 0.0);
  Extent box = std::visit([&](const auto& view) { return InsideExtent(view, isovalue); }, volume);
  if (box.Empty())
    throw std::invalid_argument("body distance: no sample is " + std::to_string(isovalue) +
                                " or more; choose an isovalue within the values of the volume");
  box.low *= source.spacing;
  box.high *= source.spacing;
  const GridGeometry grid = GridAround(box, source.origin, source.direction, spacing, settings);
  return Measure(grid,
    Coverage(volume, grid, { .isovalue = isovalue }, PartOf(progress, 0.0, CoverageShare)),
    progress);
}

BodyDistance DistanceOfMesh(
  const TriangleMesh& mesh, const BodyDistanceSettings& settings, const ProgressFunction& progress)
{
  Check(settings);
  Extent box;
  for (const glm::uvec3& t : mesh.triangles)
    for (int corner = 0; corner < 3; ++corner)
      if (t[corner] < mesh.points.size())
        box.Take(mesh.points[t[corner]]);
  if (box.Empty())
    throw std::invalid_argument("body distance: the mesh has no triangles");
  const glm::dvec3 sides = box.high - box.low;
  const double longest = std::max({ sides.x, sides.y, sides.z });
  if (!(longest > 0.0) || !std::isfinite(longest))
    throw std::invalid_argument("body distance: the mesh is a point, or not finite");
  const double spacing = settings.spacingMm > 0.0 ? settings.spacingMm : longest / 96.0;
  const GridGeometry grid = GridAround(box, glm::dvec3(0.0), glm::dmat3(1.0), spacing, settings);
  return Measure(grid, MeshCoverage(mesh, grid, 4, PartOf(progress, 0.0, CoverageShare)), progress);
}

} // namespace hasp
