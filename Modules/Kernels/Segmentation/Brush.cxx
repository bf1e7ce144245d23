#include "Segmentation/Brush.h"

#include "Grid/ParallelFor.h"
#include "Segmentation/NearVoxels.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

/// A piece of the line, in mm along the grid's axes from its first voxel.
struct Segment
{
  glm::dvec3 from, to;
};

double DistanceTo(const Segment& segment, const glm::dvec3& point)
{
  const glm::dvec3 way = segment.to - segment.from, off = point - segment.from;
  const double length2 = glm::dot(way, way);
  const double share = length2 > 0.0 ? std::clamp(glm::dot(off, way) / length2, 0.0, 1.0) : 0.0;
  return glm::length(off - share * way);
}

/// Whether the segment meets the closed box, `slack` mm larger.
bool Meets(const Segment& segment, const glm::dvec3& middle, const glm::dvec3& half, double slack)
{
  double enter = 0.0, leave = 1.0;
  for (int a = 0; a < 3; ++a)
  {
    const double low = middle[a] - half[a] - slack - segment.from[a];
    const double high = middle[a] + half[a] + slack - segment.from[a];
    const double way = segment.to[a] - segment.from[a];
    if (way == 0.0)
    {
      if (low > 0.0 || high < 0.0)
        return false;
      continue;
    }
    enter = std::max(enter, std::min(low / way, high / way));
    leave = std::min(leave, std::max(low / way, high / way));
  }
  return enter <= leave;
}

/// Halves boxes until a segment covers all of one or none comes near it.
class StrokeFiller
{
public:
  StrokeFiller(const GridGeometry& grid, std::vector<Segment> segments, double radius)
    : Grid(grid),
      Segments(std::move(segments)),
      Radius(radius * (1.0 + 1e-9)),
      // A ball around the middle of a voxel that holds all of it is marked wherever the line goes
      // through the voxel.
      Thin(radius < 0.5 * glm::length(grid.spacing))
  {
    double most = radius;
    for (const Segment& s : this->Segments)
      for (int a = 0; a < 3; ++a)
        most = std::max(
          { most, std::abs(s.from[a]), std::abs(s.to[a]), grid.spacing[a] * grid.dims[a] });
    this->Slack = 1e-12 * most; // far above what is rounded, far below a voxel
  }

  /// In no order.
  VoxelRuns Fill(const VoxelBox& box) const
  {
    VoxelRuns runs;
    std::vector<const Segment*> all;
    for (const Segment& segment : this->Segments)
      all.push_back(&segment);
    this->Fill(box, all, runs);
    return runs;
  }

private:
  void Fill(const VoxelBox& box, const std::vector<const Segment*>& from, VoxelRuns& runs) const
  {
    const glm::ivec3 size = box.Size();
    const bool single = size == glm::ivec3(1);
    // Of the voxels' centres, and of the voxels themselves.
    const glm::dvec3 middle = 0.5 * this->Grid.spacing * glm::dvec3(box.low + box.high - 1);
    const double reach = 0.5 * glm::length(this->Grid.spacing * glm::dvec3(size - 1));
    const glm::dvec3 half = 0.5 * this->Grid.spacing * glm::dvec3(size);
    const double slack = single ? 0.0 : this->Slack;
    std::vector<const Segment*> near;
    for (const Segment* segment : from)
    {
      const double away = DistanceTo(*segment, middle);
      if (away + reach + slack <= this->Radius ||
          (single && this->Thin && Meets(*segment, middle, half, this->Slack)))
        return this->Emit(box, runs);
      if (!single && (away - reach - slack <= this->Radius ||
                       (this->Thin && Meets(*segment, middle, half, 2.0 * this->Slack))))
        near.push_back(segment);
    }
    if (near.empty())
      return;
    const glm::dvec3 length = this->Grid.spacing * glm::dvec3(size);
    int axis = -1; // the longest that has voxels to share out
    for (int a = 0; a < 3; ++a)
      if (size[a] > 1 && (axis < 0 || length[a] > length[axis]))
        axis = a;
    VoxelBox low = box, high = box;
    low.high[axis] = high.low[axis] = box.low[axis] + size[axis] / 2;
    this->Fill(low, near, runs);
    this->Fill(high, near, runs);
  }

  void Emit(const VoxelBox& box, VoxelRuns& runs) const
  {
    const GridView<const Label> at{ nullptr, this->Grid };
    for (int k = box.low.z; k < box.high.z; ++k)
      for (int j = box.low.y; j < box.high.y; ++j)
        runs.push_back({ at.Offset(box.low.x, j, k), std::uint32_t(box.high.x - box.low.x) });
  }

  GridGeometry Grid;
  std::vector<Segment> Segments;
  double Radius;
  bool Thin;
  double Slack = 0.0;
};

/// Puts runs that are apart in order and joins neighbours of a row.
VoxelRuns Ordered(VoxelRuns runs, std::uint64_t width)
{
  std::sort(runs.begin(), runs.end(),
    [](const VoxelRun& a, const VoxelRun& b) { return a.first < b.first; });
  VoxelRuns joined;
  for (const VoxelRun& run : runs)
    if (!joined.empty() && joined.back().first + joined.back().length == run.first &&
        run.first % width != 0)
      joined.back().length += run.length;
    else
      joined.push_back(run);
  return joined;
}

std::vector<Segment> SegmentsOf(const GridGeometry& geometry, std::span<const glm::dvec3> points)
{
  const auto onAxes = [&](const glm::dvec3& p)
  { return glm::transpose(geometry.direction) * (p - geometry.origin); };
  std::vector<Segment> segments;
  for (std::size_t n = 1; n < points.size(); ++n)
    if (points[n] != points[n - 1])
      segments.push_back({ onAxes(points[n - 1]), onAxes(points[n]) });
  if (segments.empty())
    segments.push_back({ onAxes(points[0]), onAxes(points[0]) });
  return segments;
}

void CheckStroke(const GridGeometry& geometry, std::span<const glm::dvec3> points, double radiusMm)
{
  geometry.Validate();
  if (!(radiusMm > 0.0 && std::isfinite(radiusMm)))
    throw std::invalid_argument(
      "brush: radius is " + std::to_string(radiusMm) + " mm, must be > 0 and finite");
  if (points.empty())
    throw std::invalid_argument("brush: a stroke needs at least one point");
  constexpr double most = 1e6;
  for (std::size_t n = 0; n < points.size(); ++n)
    for (int a = 0; a < 3; ++a)
      if (!(std::abs(points[n][a] - geometry.origin[a]) <= most))
        throw std::invalid_argument("brush: point " + std::to_string(n + 1) +
                                    " is not a number or more than 1e6 mm from the scan's origin");
}

/// Where voxels can be marked.
VoxelBox BoxOfStroke(
  const GridGeometry& geometry, const std::vector<Segment>& segments, double radiusMm)
{
  glm::dvec3 low(HUGE_VAL), high(-HUGE_VAL);
  for (const Segment& s : segments)
  {
    low = glm::min(low, glm::min(s.from, s.to));
    high = glm::max(high, glm::max(s.from, s.to));
  }
  const glm::dvec3 dims(geometry.dims);
  // Two voxels more than the radius: half a voxel for the line itself, and what is rounded.
  return { glm::ivec3(glm::clamp((low - radiusMm) / geometry.spacing - 2.0, glm::dvec3(0), dims)),
    glm::ivec3(glm::clamp((high + radiusMm) / geometry.spacing + 3.0, glm::dvec3(0), dims)) };
}

VoxelRuns Joined(std::vector<VoxelRuns> pieces)
{
  VoxelRuns all;
  for (const VoxelRuns& piece : pieces)
    all.insert(all.end(), piece.begin(), piece.end());
  return all;
}

void CheckRuns(std::span<const VoxelRun> runs, const GridGeometry& geometry)
{
  const std::uint64_t voxels = geometry.Size();
  for (const VoxelRun& run : runs)
    if (run.first >= voxels || run.length > voxels - run.first)
      throw std::invalid_argument("voxels up to " + std::to_string(run.first + run.length) +
                                  " do not lie in a grid of " + std::to_string(voxels));
}

/// Those of the voxels that keep(offset) keeps.
template <typename Keep>
VoxelRuns Kept(std::span<const VoxelRun> runs, Keep&& keep)
{
  VoxelRuns kept;
  for (const VoxelRun& run : runs)
    for (std::uint64_t v = run.first, end = run.first + run.length, begin = v; v < end; begin = v)
    {
      for (; v < end && keep(v);)
        ++v;
      if (v > begin)
        kept.push_back({ begin, std::uint32_t(v - begin) });
      for (; v < end && !keep(v);)
        ++v;
    }
  return kept;
}

} // namespace

std::uint64_t CountVoxels(std::span<const VoxelRun> runs)
{
  std::uint64_t sum = 0;
  for (const VoxelRun& run : runs)
    sum += run.length;
  return sum;
}

VoxelBox BoxOfVoxels(const glm::ivec3& dims, std::span<const VoxelRun> runs)
{
  VoxelBox box{ dims, glm::ivec3(0) };
  const auto nx = static_cast<std::uint64_t>(dims.x);
  for (const VoxelRun& run : runs)
  {
    const std::uint64_t row = run.first / nx;
    const glm::ivec3 at(
      int(run.first % nx), int(row % std::uint64_t(dims.y)), int(row / std::uint64_t(dims.y)));
    box.low = glm::min(box.low, at);
    box.high = glm::max(box.high, at + glm::ivec3(int(run.length), 1, 1));
  }
  return runs.empty() ? VoxelBox{} : box;
}

VoxelRuns RasterizeStroke(const GridGeometry& geometry, std::span<const glm::dvec3> points,
  double radiusMm, const ProgressFunction& progress)
{
  CheckStroke(geometry, points, radiusMm);
  std::vector<Segment> segments = SegmentsOf(geometry, points);
  const VoxelBox box = BoxOfStroke(geometry, segments, radiusMm);
  ReportProgress(progress, 0.0);
  if (box.Empty())
    return {};
  const StrokeFiller filler(geometry, std::move(segments), radiusMm);
  constexpr int slab = 8, group = 8 * slab; // slices
  std::vector<VoxelRuns> pieces(static_cast<std::size_t>((box.Size().z + slab - 1) / slab));
  for (int from = box.low.z; from < box.high.z; from += group)
  {
    ReportProgress(progress, double(from - box.low.z) / box.Size().z);
    ParallelFor(from, std::min(from + group, box.high.z), slab,
      [&](std::int64_t first, std::int64_t last)
      {
        VoxelBox part = box;
        part.low.z = static_cast<int>(first);
        part.high.z = static_cast<int>(last);
        pieces[static_cast<std::size_t>(part.low.z - box.low.z) / slab] =
          Ordered(filler.Fill(part), static_cast<std::uint64_t>(geometry.dims.x));
      });
  }
  ReportProgress(progress, 1.0);
  return Joined(std::move(pieces));
}

VoxelRuns KeepInMask(std::span<const VoxelRun> runs, GridView<const std::uint8_t> mask)
{
  CheckRuns(runs, mask.geometry);
  return Kept(runs, [&](std::uint64_t voxel) { return mask.data[voxel] != 0; });
}

VoxelRuns KeepSurfaceLayer(std::span<const VoxelRun> runs, GridView<const Label> labels,
  double depthMm, const ProgressFunction& progress)
{
  CheckRuns(runs, labels.geometry);
  const glm::ivec3 steps = StepsWithin(labels.geometry.spacing, depthMm, "brush: depth");
  const VoxelBox box = BoxOfVoxels(labels.geometry.dims, runs);
  if (box.Empty())
    return {};
  const BoxMask nothing = MaskOf(
    labels, box.Grown(steps).In(labels.geometry.dims), [](Label label) { return label == 0; });
  const BoxMask layer = Dilated(nothing, box, labels.geometry.spacing, depthMm, progress);
  const auto nx = static_cast<std::uint64_t>(labels.geometry.dims.x);
  const auto ny = static_cast<std::uint64_t>(labels.geometry.dims.y);
  return Kept(runs,
    [&](std::uint64_t voxel)
    {
      return labels.data[voxel] != 0 &&
             layer.At(int(voxel % nx), int(voxel / nx % ny), int(voxel / (nx * ny)));
    });
}

} // namespace hasp
