#include "Segmentation/VoxelGraph.h"

#include "Grid/ParallelFor.h"
#include "Segmentation/CrackDepth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{

constexpr std::int64_t spansAPiece = 8192;

void Check(const EdgeWeightSettings& settings)
{
  if (!(settings.beta >= 0.0 && settings.beta <= 1e12))
    throw std::invalid_argument(
      "beta is " + std::to_string(settings.beta) + ", must be in [0, 1e12]");
  if (!(settings.crack >= 0.0 && settings.crack <= 1.0))
    throw std::invalid_argument(
      "crack is " + std::to_string(settings.crack) + ", must be in [0, 1]");
  if (!(settings.floor > 0.0 && settings.floor <= 1.0))
    throw std::invalid_argument(
      "the least weight is " + std::to_string(settings.floor) + ", must be in (0, 1]");
}

/// Area of the face over the way between centres, of each axis; the largest is 1.
glm::dvec3 Conductances(const glm::dvec3& spacing)
{
  const glm::dvec3 shape = 1.0 / (spacing * spacing); // times the volume, which all share
  return shape / std::max({ shape.x, shape.y, shape.z });
}

/// Half of a difference, so that none overflows: finite samples lie up to 7e38 apart.
float HalfStep(float a, float b)
{
  return std::abs(0.5F * a - 0.5F * b);
}

/// The quantile that scales differences. Differences go into bins an eighth of a power of two wide,
/// so that no pass needs their range: what comes out is the upper end of a bin.
class DifferenceScale
{
public:
  void Add(float difference)
  {
    if (difference == 0.0F)
      return;
    int exponent = 0;
    const float mantissa = std::frexp(difference, &exponent); // [0.5, 1)
    const int bin = (exponent + 160) * 8 + static_cast<int>((mantissa - 0.5F) * 16.0F);
    ++counts[static_cast<std::size_t>(std::clamp(bin, 0, bins - 1))];
  }
  void Add(const DifferenceScale& other)
  {
    for (std::size_t bin = 0; bin < counts.size(); ++bin)
      counts[bin] += other.counts[bin];
  }
  /// 1 where all are equal: any scale does.
  double Quantile(double share, std::int64_t links) const
  {
    auto above = static_cast<std::int64_t>((1.0 - share) * static_cast<double>(links));
    for (int bin = bins - 1; bin >= 0; --bin)
    {
      above -= counts[static_cast<std::size_t>(bin)];
      if (above < 0)
        return std::ldexp(0.5 + (bin % 8 + 1) / 16.0, bin / 8 - 160);
    }
    return 1.0;
  }

private:
  static constexpr int bins = 300 * 8;
  std::vector<std::int64_t> counts = std::vector<std::int64_t>(bins);
};

} // namespace

VoxelGraph::VoxelGraph(const AnyGridView& grid, GridView<const Label> labels, Label label,
  const EdgeWeightSettings& settings, const ProgressFunction& progress)
  : geometry(GeometryOf(grid))
{
  Check(settings);
  geometry.Validate();
  if (geometry.dims != labels.geometry.dims)
    throw std::invalid_argument("the label map must be as large as the scan");
  FindRuns(labels, label, progress);
  FindSpans();
  ReportProgress(progress, 0.6);

  // Samples in the order of nodes: links are then differences within one array.
  std::vector<float> samples(static_cast<std::size_t>(nodes));
  const std::int64_t rows = static_cast<std::int64_t>(geometry.dims.y) * geometry.dims.z;
  std::visit(
    [&](const auto& view)
    {
      ParallelFor(0, rows, 256,
        [&](std::int64_t first, std::int64_t last)
        {
          for (std::int64_t row = first; row < last; ++row)
            for (std::int32_t r = rowRuns[row]; r < rowRuns[row + 1]; ++r)
              for (std::int32_t n = 0; n < runs[r].count; ++n)
                samples[runs[r].first + n] =
                  static_cast<float>(view.data[row * geometry.dims.x + runs[r].x + n]);
        });
    },
    grid);
  if (std::any_of(samples.begin(), samples.end(), [](float v) { return !std::isfinite(v); }))
    throw std::invalid_argument("a sample of the bone is not a finite number");

  for (std::vector<float>& weights : along)
    weights.assign(static_cast<std::size_t>(nodes) + 2, 0.0F);
  const auto forEachLink = [&](std::int64_t first, std::int64_t last, auto visit)
  {
    for (std::int64_t s = first; s < last; ++s)
    {
      const Span& span = spans[s];
      for (std::int32_t n = span.first; n < span.first + span.count; ++n)
        for (int axis = 0; axis < 3; ++axis)
        {
          const bool inRun = n + 1 < span.first + span.count || span.joined != 0;
          const std::int32_t on = axis > 0 ? span.above[axis - 1] : (inRun ? 1 : 0);
          if (on != 0)
            visit(axis, n, n + on);
        }
    }
  };
  const auto pieces = static_cast<std::int64_t>(spans.size() + spansAPiece - 1) / spansAPiece;
  std::vector<DifferenceScale> scales(static_cast<std::size_t>(pieces));
  std::vector<std::int64_t> links(static_cast<std::size_t>(pieces));
  const auto count = static_cast<std::int64_t>(spans.size());
  ParallelFor(0, count, spansAPiece,
    [&](std::int64_t first, std::int64_t last)
    {
      const auto piece = static_cast<std::size_t>(first / spansAPiece);
      forEachLink(first, last,
        [&](int, std::int32_t n, std::int32_t m)
        {
          scales[piece].Add(HalfStep(samples[m], samples[n]));
          ++links[piece];
        });
    });
  DifferenceScale all;
  std::int64_t allLinks = 0;
  for (std::size_t piece = 0; piece < scales.size(); ++piece)
  {
    all.Add(scales[piece]);
    allLinks += links[piece];
  }
  ReportProgress(progress, 0.7);
  const double scale = all.Quantile(0.999, allLinks);
  std::vector<float> depths;
  if (settings.crack > 0.0)
    depths = CrackDepths(*this, grid, samples);
  ReportProgress(progress, 0.9);
  const glm::dvec3 conductances = Conductances(geometry.spacing);
  ParallelFor(0, count, spansAPiece,
    [&](std::int64_t first, std::int64_t last)
    {
      forEachLink(first, last,
        [&](int axis, std::int32_t n, std::int32_t m)
        {
          const double step = HalfStep(samples[m], samples[n]) / scale;
          const double depth =
            depths.empty() ? 0.0 : std::max(depths[n], depths[m]) / settings.crack;
          const double weight =
            settings.floor +
            (1.0 - settings.floor) * std::exp(-settings.beta * step * step - depth * depth);
          along[axis][n + 1] = static_cast<float>(weight * conductances[axis]);
        });
    });
  ReportProgress(progress, 1.0);
}

VoxelGraph::VoxelGraph(const GridGeometry& box, const std::vector<std::array<float, 3>>& weights)
  : geometry(box)
{
  geometry.Validate();
  if (weights.size() != geometry.Size())
    throw std::invalid_argument("three weights a voxel are needed");
  const std::vector<Label> all(weights.size(), 1);
  FindRuns({ all.data(), geometry }, 1, {});
  FindSpans();
  for (int axis = 0; axis < 3; ++axis)
    along[axis].assign(weights.size() + 2, 0.0F);
  for (const Span& span : spans)
    for (std::int32_t n = span.first; n < span.first + span.count; ++n)
    {
      if (n + 1 < span.first + span.count || span.joined != 0)
        along[0][n + 1] = weights[n][0];
      for (int axis = 1; axis < 3; ++axis)
        if (span.above[axis - 1] != 0)
          along[axis][n + 1] = weights[n][axis];
    }
}

VoxelGraph::VoxelGraph(
  const VoxelGraph& whole, std::vector<Run> part, std::vector<std::int32_t> partRows)
  : geometry(whole.geometry),
    runs(std::move(part)),
    rowRuns(std::move(partRows))
{
  std::vector<std::int32_t> from;
  from.reserve(runs.size());
  for (Run& run : runs)
  {
    from.push_back(run.first);
    run.first = static_cast<std::int32_t>(nodes);
    nodes += run.count;
  }
  FindSpans();
  for (std::vector<float>& weights : along)
    weights.assign(static_cast<std::size_t>(nodes) + 2, 0.0F);
  std::size_t r = 0;
  for (const Span& span : spans)
  {
    while (span.first >= runs[r].first + runs[r].count)
      ++r;
    const std::int32_t way = from[r] - runs[r].first;
    const auto copy = [&](int axis, std::int32_t count) {
      std::copy_n(
        whole.Along(axis) + span.first + way, count, along[axis].begin() + 1 + span.first);
    };
    copy(0, span.count - 1 + span.joined);
    for (int axis = 1; axis < 3; ++axis)
      if (span.above[axis - 1] != 0)
        copy(axis, span.count);
  }
}

VoxelGraph::VoxelGraph(const VoxelGraph& like, std::array<std::vector<float>, 3> weights)
  : geometry(like.geometry),
    nodes(like.nodes),
    runs(like.runs),
    rowRuns(like.rowRuns),
    spans(like.spans)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (weights[axis].size() != static_cast<std::size_t>(nodes) + 2)
      throw std::invalid_argument("a weight a voxel and axis is needed, and two more");
    along[axis] = std::move(weights[axis]);
  }
}

/// Rows are counted first and filled then, both on all cores.
void VoxelGraph::FindRuns(
  GridView<const Label> labels, Label label, const ProgressFunction& progress)
{
  const glm::ivec3 dims = geometry.dims;
  const std::int64_t rows = static_cast<std::int64_t>(dims.y) * dims.z;
  std::vector<std::int32_t> rowNodes(static_cast<std::size_t>(rows) + 1);
  rowRuns.assign(static_cast<std::size_t>(rows) + 1, 0);
  const auto forEachRun = [&](std::int64_t row, auto visit)
  {
    const Label* voxel = labels.data + row * dims.x;
    for (int x = 0; x < dims.x;)
    {
      const Label* start = std::find(voxel + x, voxel + dims.x, label);
      const Label* end = std::find_if(start, voxel + dims.x, [&](Label l) { return l != label; });
      if (start != end)
        visit(static_cast<std::int32_t>(start - voxel), static_cast<std::int32_t>(end - start));
      x = static_cast<int>(end - voxel);
    }
  };
  ParallelFor(0, rows, 256,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t row = first; row < last; ++row)
        forEachRun(row,
          [&](std::int32_t, std::int32_t count)
          {
            ++rowRuns[row + 1];
            rowNodes[row + 1] += count;
          });
    });
  ReportProgress(progress, 0.2);
  for (std::int64_t row = 0; row < rows; ++row)
  {
    nodes += rowNodes[row + 1];
    if (nodes > std::numeric_limits<std::int32_t>::max() - 2)
      throw std::invalid_argument("the label has more voxels than a graph can hold, 2^31 - 2");
    rowNodes[row + 1] += rowNodes[row];
    rowRuns[row + 1] += rowRuns[row];
  }
  runs.resize(static_cast<std::size_t>(rowRuns.back()));
  ParallelFor(0, rows, 256,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t row = first; row < last; ++row)
      {
        std::int32_t node = rowNodes[row];
        std::int32_t run = rowRuns[row];
        forEachRun(row,
          [&](std::int32_t x, std::int32_t count)
          {
            runs[run++] = { node, count, x };
            node += count;
          });
      }
    });
  ReportProgress(progress, 0.4);
}

/// A run is cut wherever one of the four rows beside it begins or ends a run of its own.
void VoxelGraph::FindSpans()
{
  const glm::ivec3 dims = geometry.dims;
  const auto spansOfRow = [&](int j, int k, std::vector<Span>& out)
  {
    const std::int64_t row = static_cast<std::int64_t>(k) * dims.y + j;
    // Rows beside, in the order above y, above z, below y, below z; -1 outside the grid.
    const std::int64_t beside[4] = { j + 1 < dims.y ? row + 1 : -1,
      k + 1 < dims.z ? row + dims.y : -1, j > 0 ? row - 1 : -1, k > 0 ? row - dims.y : -1 };
    std::int32_t at[4] = {};
    for (int b = 0; b < 4; ++b)
      at[b] = beside[b] < 0 ? 0 : rowRuns[beside[b]];
    for (std::int32_t r = rowRuns[row]; r < rowRuns[row + 1]; ++r)
    {
      const Run& run = runs[r];
      for (std::int32_t x = run.x, end = run.x + run.count; x < end;)
      {
        std::int32_t next = end;
        std::int32_t step[4] = {};
        for (int b = 0; b < 4; ++b)
        {
          if (beside[b] < 0)
            continue;
          const std::int32_t last = rowRuns[beside[b] + 1];
          while (at[b] < last && runs[at[b]].x + runs[at[b]].count <= x)
            ++at[b];
          if (at[b] == last)
            continue;
          const Run& other = runs[at[b]];
          const bool there = other.x <= x;
          next = std::min(next, there ? other.x + other.count : other.x);
          if (there)
            step[b] = (other.first + x - other.x) - (run.first + x - run.x);
        }
        out.push_back({ run.first + x - run.x, next - x, { step[0], step[1] }, { step[2], step[3] },
          next < end ? 1 : 0 });
        x = next;
      }
    }
  };
  std::vector<std::vector<Span>> slices(static_cast<std::size_t>(dims.z));
  ParallelFor(0, dims.z, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t k = first; k < last; ++k)
        for (int j = 0; j < dims.y; ++j)
          spansOfRow(j, static_cast<int>(k), slices[k]);
    });
  std::size_t all = 0;
  for (const std::vector<Span>& slice : slices)
    all += slice.size();
  spans.reserve(all);
  for (const std::vector<Span>& slice : slices)
    spans.insert(spans.end(), slice.begin(), slice.end());
}

std::int32_t VoxelGraph::NodeAt(int i, int j, int k) const
{
  const glm::ivec3 dims = geometry.dims;
  if (i < 0 || j < 0 || k < 0 || i >= dims.x || j >= dims.y || k >= dims.z)
    return -1;
  const std::int64_t row = static_cast<std::int64_t>(k) * dims.y + j;
  const auto first = runs.begin() + rowRuns[row];
  const auto after = std::upper_bound(
    first, runs.begin() + rowRuns[row + 1], i, [](int x, const Run& run) { return x < run.x; });
  if (after == first)
    return -1;
  const Run& run = *(after - 1);
  return i < run.x + run.count ? run.first + i - run.x : -1;
}

std::size_t VoxelGraph::Bytes() const
{
  std::size_t bytes = runs.capacity() * sizeof(Run) + rowRuns.capacity() * sizeof(std::int32_t) +
                      spans.capacity() * sizeof(Span);
  for (const std::vector<float>& weights : along)
    bytes += weights.capacity() * sizeof(float);
  return bytes;
}

} // namespace hasp
