#include "FragmentCrop.h"

#include "Distance/Coverage.h"
#include "Distance/CoverageDistance.h"
#include "Distance/GridSolid.h"
#include "Distance/KeptGrid.h"
#include "Distance/ScanMargin.h"
#include "Distance/SharpContour.h"
#include "Grid/ParallelFor.h"
#include "Grid/ProgressPart.h"
#include "Grid/Stopwatch.h"

#include <glm/common.hpp>

#include <algorithm>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{

/// For each row of the crop: f(number of its first sample in the crop, in the scan).
template <typename F>
void ForEachRow(const FragmentCrop& crop, const GridGeometry& scan, const F& f)
{
  const glm::ivec3 dims = crop.geometry.dims;
  ParallelFor(0, std::int64_t(dims.y) * dims.z, 64,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t row = begin; row < end; ++row)
      {
        const std::size_t y = crop.first.y + row % dims.y, z = crop.first.z + row / dims.y;
        f(std::size_t(row) * dims.x, (z * scan.dims.y + y) * scan.dims.x + crop.first.x);
      }
    });
}

/// The crop's own samples, and which of them are the fragment's bone.
template <typename T>
struct CroppedBone
{
  std::vector<T> samples;
  std::vector<std::uint8_t> keep;
};

template <typename T>
CroppedBone<T> CropBone(const GridView<const T>& grey, double isovalue, const FragmentCrop& crop)
{
  CroppedBone<T> bone{ std::vector<T>(crop.keep.size()),
    std::vector<std::uint8_t>(crop.keep.size()) };
  ForEachRow(crop, grey.geometry,
    [&](std::size_t own, std::size_t scanned)
    {
      for (int i = 0; i < crop.geometry.dims.x; ++i)
      {
        const T value = grey.data[scanned + i];
        bone.samples[own + i] = value;
        bone.keep[own + i] = crop.keep[own + i] && double(value) >= isovalue;
      }
    });
  return bone;
}

/// What of a crop holds bone of the fragment, with a sample more on each side: the grid of its
/// models stays where it is, to the last bit, when the label is painted on air. Nothing: no bone.
template <typename T>
std::optional<FragmentCrop> CropToBone(
  const GridView<const T>& grey, double isovalue, const FragmentCrop& crop)
{
  const glm::ivec3 dims = crop.geometry.dims;
  const auto [first, last] = KeptRange(dims, CropBone(grey, isovalue, crop).keep);
  if (first.x > last.x)
    return std::nullopt;
  FragmentCrop bone{ crop.label, glm::max(first - 1, 0), crop.geometry, {} };
  bone.geometry.dims = glm::min(last + 1, dims - 1) - bone.first + 1;
  bone.keep.resize(bone.geometry.Size());
  ForEachRow(bone, crop.geometry,
    [&](std::size_t own, std::size_t cropped)
    { std::copy_n(&crop.keep[cropped], bone.geometry.dims.x, &bone.keep[own]); });
  bone.first += crop.first;
  bone.geometry.origin = grey.geometry.IndexToWorld(glm::dvec3(bone.first));
  return bone;
}

template <typename Error>
[[noreturn]] void Refuse(std::uint16_t label, const auto&... parts)
{
  std::ostringstream text;
  text << "label " << label << ": ";
  (text << ... << parts);
  throw Error(text.str());
}

/// Shares of voxels on the grid of a fragment's own.
struct FragmentCoverage
{
  GridGeometry geometry;
  std::vector<float> shares;
};

/// Beyond KeptGrid's own margin: what a distance map needs more.
double MapMarginMm(const FragmentSettings& settings)
{
  return std::max(0.0, settings.rangeMm - KeptGridMarginSteps * settings.spacingMm);
}

void CheckSamples(
  std::uint16_t label, const GridGeometry& grid, double marginMm, const FragmentSettings& settings)
{
  const glm::dvec3 dims =
    glm::dvec3(grid.dims) + 2.0 * (marginMm > 0.0 ? marginMm / settings.spacingMm + 2.0 : 0.0);
  const double samples = dims.x * dims.y * dims.z;
  if (!(samples <= double(settings.mostSamples)))
    Refuse<std::invalid_argument>(label, "its grid would have ", samples, " samples, at most ",
      settings.mostSamples, " are allowed; choose a larger spacingMm (now ", settings.spacingMm,
      " mm) or split the label");
}

FragmentCoverage CoverFragment(const AnyGridView& grey, double isovalue, const FragmentCrop& crop,
  const FragmentSettings& settings, double marginMm, const ProgressFunction& progress)
{
  const auto cover = [&]<typename T>(const GridView<const T>& view)
  {
    const std::optional<FragmentCrop> part = CropToBone(view, isovalue, crop);
    if (!part)
      Refuse<std::runtime_error>(crop.label, "none of its ",
        std::count(crop.keep.begin(), crop.keep.end(), 1),
        " voxels is bone, grey value >= ", isovalue,
        "; choose a lower isovalue, or remove the label");
    const CroppedBone<T> bone = CropBone(view, isovalue, *part);
    const auto [first, last] = KeptRange(part->geometry.dims, bone.keep);
    FragmentCoverage coverage{ KeptGrid(part->geometry, first, last, settings.spacingMm), {} };
    CheckSamples(crop.label, coverage.geometry, marginMm, settings);
    const GridView<const T> cropped{ bone.samples.data(), part->geometry };
    coverage.shares =
      Coverage(cropped, coverage.geometry, { .isovalue = isovalue, .keep = bone.keep }, progress);
    return coverage;
  };
  FragmentCoverage coverage = std::visit(cover, grey);
  // What decides of each sample's sign.
  if (std::none_of(
        coverage.shares.begin(), coverage.shares.end(), [](float share) { return share > 0.5F; }))
    Refuse<std::runtime_error>(crop.label, "its bone is thinner than the spacing of ",
      settings.spacingMm, " mm; choose a smaller spacingMm, or remove the label");
  return coverage;
}

std::shared_ptr<const TriangleMesh> MakeSurface(const FragmentCrop& crop, const GridGeometry& grid,
  const std::shared_ptr<const std::vector<float>>& distances, const ProgressFunction& progress)
{
  TriangleMesh mesh = SharpContour(*MakeGridSolid(distances, grid), grid, {}, nullptr, progress);
  if (mesh.triangles.empty())
    Refuse<std::runtime_error>(crop.label, "its bone is thinner than the spacing of ",
      grid.spacing.x, " mm; choose a smaller spacingMm, or remove the label");
  return std::make_shared<const TriangleMesh>(std::move(mesh));
}

std::shared_ptr<const DistanceMap> MakeMap(const FragmentCoverage& near,
  const FragmentSettings& settings, const glm::dvec3& origin, BakedFragment& baked,
  const ProgressFunction& progress)
{
  const double margin = MapMarginMm(settings);
  const GridGeometry grid = GeometryWithMargin(near.geometry, margin);
  baked.samples += grid.Size();
  const std::vector<float> distances = CoverageDistance(
    grid, CoverageWithMargin(near.geometry, near.shares, margin), PartOf(progress, 0.0, 0.9));
  return std::make_shared<const DistanceMap>(GridView<const float>{ distances.data(), grid },
    DistanceMapSettings{ .rangeMm = settings.rangeMm, .origin = origin },
    PartOf(progress, 0.9, 1.0));
}

} // namespace

FragmentCrop CropLabel(
  const GridView<const std::uint16_t>& labels, std::uint16_t label, const LabelExtent& extent)
{
  const GridGeometry& scan = labels.geometry;
  FragmentCrop crop;
  crop.label = label;
  crop.first = glm::max(extent.low - 1, 0);
  crop.geometry = scan;
  crop.geometry.dims = glm::min(extent.high + 1, scan.dims - 1) - crop.first + 1;
  crop.geometry.origin = scan.IndexToWorld(glm::dvec3(crop.first));
  crop.keep.resize(crop.geometry.Size());
  ForEachRow(crop, scan,
    [&](std::size_t own, std::size_t scanned)
    {
      for (int i = 0; i < crop.geometry.dims.x; ++i)
        crop.keep[own + i] = labels.data[scanned + i] == label;
    });
  return crop;
}

BakedFragment BakeFragment(const AnyGridView& grey, double isovalue, const FragmentCrop& crop,
  const FragmentSettings& settings, const FragmentWants& wants, const glm::dvec3& origin,
  const ProgressFunction& progress)
{
  BakedFragment baked;
  baked.model.origin = origin;
  const double margin = wants.map ? MapMarginMm(settings) : 0.0;
  // Shares of the time, for progress: distances far from the surface are most of it.
  const double covered = wants.map ? 0.2 : 0.4, mapped = wants.map ? 0.7 : covered,
               banded = mapped + 0.4 * (1.0 - mapped), contoured = wants.shell ? 0.9 : 1.0;
  Stopwatch time;
  auto lap = [&, before = 0.0](FragmentModelKind kind) mutable
  {
    const double now = time.Milliseconds();
    baked.milliseconds[kind] += now - before;
    before = now;
  };
  const FragmentCoverage near =
    CoverFragment(grey, isovalue, crop, settings, margin, PartOf(progress, 0.0, covered));
  baked.samples += near.geometry.Size();
  if (wants.map)
  {
    baked.model.map = MakeMap(near, settings, origin, baked, PartOf(progress, covered, mapped));
    lap(MapKind);
  }
  if (!wants.shell && !wants.surface)
    return baked;
  const auto distances = std::make_shared<const std::vector<float>>(
    CoverageDistanceBand(near.geometry, near.shares, PartOf(progress, mapped, banded)));
  if (wants.surface)
  {
    baked.model.surface =
      MakeSurface(crop, near.geometry, distances, PartOf(progress, banded, contoured));
    lap(SurfaceKind);
  }
  if (wants.shell)
  {
    baked.model.shell = PointShell::OfSurface({ distances->data(), near.geometry }, origin,
      { .points = settings.shellPoints }, PartOf(progress, contoured, 1.0));
    lap(ShellKind);
  }
  return baked;
}

} // namespace hasp
