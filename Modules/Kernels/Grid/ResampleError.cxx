#include "Grid/ParallelFor.h"
#include "Grid/ShiftedSlice.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{
namespace
{

constexpr int GapsJudged = 12;           ///< those with the widest bridges
constexpr int SlicesPerGap = 8;          ///< measured ones, the nearest to the gap
constexpr int EdgesPerSlice = 600;       ///< of those, evenly chosen
constexpr int SamplesPerSlice = 40000;   ///< looked at to find them
constexpr int SlicesForShift = 32;       ///< judged for moves within the slice
constexpr double StrongQuantile = 0.995; ///< of all gradients ...
constexpr double StrongShare = 0.5;      ///< ... a strong edge has at least so much

/// A measured sample with a strong gradient: the surface of its own value goes through it.
struct Edge
{
  int i = 0, j = 0;      ///< in its slice
  double value = 0.0;    ///< what is measured there
  glm::dvec3 gradient{}; ///< per mm along row, column, normal
};

/// Two measured slices that stand for the ones around a made slice, for a third between them.
struct Bridge
{
  int slice = 0; ///< that is left out
  int below = 0, above = 0;
  double scale = 1.0; ///< >= 1: the real bridge is so much longer
};

template <typename T>
class ErrorMeter
{
public:
  ErrorMeter(const ResamplePlan& p, const T* samples) : plan(p), data(samples)
  {
    for (int k = 0; k < p.record.slicesMeasured; ++k)
    {
      this->slices.emplace_back(p, samples, k);
      if (this->slices.back().Part() != glm::dvec2(0.0))
        this->moved.push_back(k);
    }
    this->strong = this->StrongGradient();
  }

  /// Displacements at the made slices of one gap, mm.
  std::vector<double> AcrossGap(const SliceRecipe& made) const;
  /// Displacements by moves within the slices, mm.
  std::vector<double> WithinSlices() const;
  /// Slices that moved by no whole number of samples.
  const std::vector<int>& Moved() const { return this->moved; }

private:
  bool EdgeAt(int k, int i, int j, Edge& edge) const;
  std::vector<Edge> EdgesOf(int k) const;
  double StrongGradient() const;
  std::vector<Bridge> BridgesFor(const SliceRecipe& made) const;
  bool Predict(const Bridge& bridge, const BetweenSlices<T>& between, const glm::dvec2& at,
    double height, double& value) const;
  bool Displacement(const Bridge& bridge, const Edge& edge, double& mm) const;

  const ResamplePlan& plan;
  const T* data;
  std::vector<ShiftedSlice<T>> slices;
  std::vector<int> moved;
  double strong = 0.0;
};

int Stride(const glm::ivec2& dims, int samples)
{
  return std::max(
    1, static_cast<int>(std::ceil(std::sqrt(double(dims.x) * dims.y / double(samples)))));
}

/// Pooled over threads' slots in their order, so that the result is the same with any number.
template <typename Judge>
std::vector<double> Pool(int count, const Judge& judge)
{
  std::vector<std::vector<double>> slots(count);
  ParallelFor(0, count, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
        slots[n] = judge(static_cast<int>(n));
    });
  std::vector<double> all;
  for (const auto& slot : slots)
    all.insert(all.end(), slot.begin(), slot.end());
  return all;
}

double Quantile(std::vector<double>& values, double share)
{
  if (values.empty())
    return 0.0;
  const auto at = values.begin() +
                  static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

template <typename T>
bool ErrorMeter<T>::EdgeAt(int k, int i, int j, Edge& edge) const
{
  const glm::ivec2& dims = this->plan.stack.dims;
  const glm::dvec2& spacing = this->plan.stack.spacing;
  const T* p = this->data + (static_cast<std::size_t>(k) * dims.y + j) * dims.x + i;
  const int down = std::max(k - 1, 0), up = std::min(k + 1, this->plan.record.slicesMeasured - 1);
  const glm::dvec2 at = this->plan.shifts[k] + glm::dvec2(i, j);
  double low = 0.0, high = 0.0;
  if (!this->slices[down].Sample(at, low) || !this->slices[up].Sample(at, high))
    return false;
  const std::vector<double>& heights = this->plan.measures.heights;
  edge = { i, j, double(p[0]),
    { (double(p[1]) - p[-1]) / (2.0 * spacing.x),
      (double(p[dims.x]) - p[-dims.x]) / (2.0 * spacing.y),
      (high - low) / (heights[up] - heights[down]) } };
  return true;
}

template <typename T>
double ErrorMeter<T>::StrongGradient() const
{
  const glm::ivec2& dims = this->plan.stack.dims;
  const int stride = Stride(dims, SamplesPerSlice / 4);
  std::vector<double> all = Pool(this->plan.record.slicesMeasured,
    [&](int k)
    {
      std::vector<double> found;
      Edge edge;
      for (int j = 1; j < dims.y - 1; j += stride)
        for (int i = 1; i < dims.x - 1; i += stride)
          if (this->EdgeAt(k, i, j, edge))
            found.push_back(glm::length(edge.gradient));
      return found;
    });
  return StrongShare * Quantile(all, StrongQuantile);
}

template <typename T>
std::vector<Edge> ErrorMeter<T>::EdgesOf(int k) const
{
  std::vector<Edge> edges;
  const glm::ivec2& dims = this->plan.stack.dims;
  const int stride = Stride(dims, SamplesPerSlice);
  Edge edge;
  for (int j = 1; j < dims.y - 1; j += stride)
    for (int i = 1; i < dims.x - 1; i += stride)
      if (this->EdgeAt(k, i, j, edge) && glm::length(edge.gradient) >= this->strong &&
          this->strong > 0.0)
        edges.push_back(edge);
  if (edges.size() <= EdgesPerSlice)
    return edges;
  std::vector<Edge> some;
  for (int n = 0; n < EdgesPerSlice; ++n)
    some.push_back(edges[n * edges.size() / EdgesPerSlice]);
  return some;
}

/// Measured slices near the gap, each with two others as far below and above as the made slice has
/// them; or, where the stack has none so far, with the ones nearest to that.
template <typename T>
std::vector<Bridge> ErrorMeter<T>::BridgesFor(const SliceRecipe& made) const
{
  const std::vector<double>& heights = this->plan.measures.heights;
  const double whole = heights[made.above] - heights[made.below];
  const double down = made.share * whole, up = whole - down;
  const int count = static_cast<int>(heights.size());
  const auto nearest = [&](double height, int first, int last)
  {
    int best = first;
    for (int n = first; n <= last; ++n)
      if (std::abs(heights[n] - height) < std::abs(heights[best] - height))
        best = n;
    return best;
  };
  std::vector<std::pair<double, Bridge>> found; // by how much worse than a near one of its length
  for (int k = 1; k + 1 < count; ++k)
  {
    Bridge b{ k, nearest(heights[k] - down, 0, k - 1), nearest(heights[k] + up, k + 1, count - 1) };
    const double length = heights[b.above] - heights[b.below];
    b.scale = std::max(1.0, whole / length);
    const double off =
      std::abs(heights[k] - heights[b.below] - down) + std::abs(heights[b.above] - heights[k] - up);
    const double away = std::abs(heights[k] - heights[made.below] - down);
    // A bridge of another length by a tenth is as good as one as much farther away as ten stacks.
    found.push_back({ (off > 0.1 * whole ? 10.0 * heights.back() + off : 0.0) + away, b });
  }
  std::sort(found.begin(), found.end(),
    [](const auto& a, const auto& b)
    { return a.first != b.first ? a.first < b.first : a.second.slice < b.second.slice; });
  std::vector<Bridge> bridges;
  for (const auto& [worse, bridge] : found)
    if (bridges.size() < SlicesPerGap)
      bridges.push_back(bridge);
  return bridges;
}

/// The volume as it would be with the slice between left out.
template <typename T>
bool ErrorMeter<T>::Predict(const Bridge& bridge, const BetweenSlices<T>& between,
  const glm::dvec2& at, double height, double& value) const
{
  const std::vector<double>& heights = this->plan.measures.heights;
  const double t =
    (height - heights[bridge.below]) / (heights[bridge.above] - heights[bridge.below]);
  double low = 0.0, high = 0.0;
  if (!this->slices[bridge.below].Sample(at, low) || !this->slices[bridge.above].Sample(at, high))
    return false;
  value = between.At(at, t, low, high);
  return true;
}

/// How far along the gradient the predicted surface of the sample's value is. One that is not found
/// within the bridge counts as far as was looked. False if the slices do not reach far enough.
template <typename T>
bool ErrorMeter<T>::Displacement(const Bridge& bridge, const Edge& edge, double& mm) const
{
  const std::vector<double>& heights = this->plan.measures.heights;
  const double low = heights[bridge.below], high = heights[bridge.above];
  const double height = heights[bridge.slice];
  const glm::dvec2 at = this->plan.shifts[bridge.slice] + glm::dvec2(edge.i, edge.j);
  const BetweenSlices<T> between(this->plan, this->data, bridge.below, bridge.above);
  double value = 0.0;
  if (!this->Predict(bridge, between, at, height, value))
    return false;
  double before = value - edge.value;
  if (before == 0.0)
  {
    mm = 0.0;
    return true;
  }
  // Too bright here: the surface is where it is darker, against the gradient.
  const glm::dvec3 way = glm::normalize(edge.gradient) * (before > 0.0 ? -1.0 : 1.0);
  const glm::dvec2& spacing = this->plan.stack.spacing;
  const double step = 0.25 * std::min(spacing.x, spacing.y), farthest = high - low;
  for (double s = step; s <= farthest; s += step)
  {
    const double z = height + s * way.z;
    if (z < low || z > high)
    {
      mm = (s - step) * bridge.scale;
      return true;
    }
    if (!this->Predict(bridge, between, at + s * glm::dvec2(way) / spacing, z, value))
      return false;
    const double now = value - edge.value;
    if ((now > 0.0) != (before > 0.0))
    {
      mm = (s - step * now / (now - before)) * bridge.scale;
      return true;
    }
    before = now;
  }
  mm = farthest * bridge.scale;
  return true;
}

template <typename T>
std::vector<double> ErrorMeter<T>::AcrossGap(const SliceRecipe& made) const
{
  const std::vector<Bridge> bridges = this->BridgesFor(made);
  return Pool(static_cast<int>(bridges.size()),
    [&](int n)
    {
      std::vector<double> found;
      double mm = 0.0;
      for (const Edge& edge : this->EdgesOf(bridges[n].slice))
        if (this->Displacement(bridges[n], edge, mm))
          found.push_back(mm);
      return found;
    });
}

/// Leaving a sample out and predicting it from its neighbours in the row gives h^2 f'' / 2; a move
/// by the share t of a sample gives t (1 - t) h^2 f'' / 2: the ratio is t (1 - t).
template <typename T>
std::vector<double> ErrorMeter<T>::WithinSlices() const
{
  const int count = std::min(static_cast<int>(this->moved.size()), SlicesForShift);
  const int width = this->plan.stack.dims.x;
  return Pool(count,
    [&](int n)
    {
      const int k = this->moved[n * this->moved.size() / count];
      const glm::dvec2 part = this->slices[k].Part(), factor = part * (1.0 - part);
      std::vector<double> found;
      for (const Edge& e : this->EdgesOf(k))
      {
        const T* p =
          this->data + (static_cast<std::size_t>(k) * this->plan.stack.dims.y + e.j) * width + e.i;
        const double offX = 0.5 * (double(p[-1]) + p[1]) - p[0];
        const double offY = 0.5 * (double(p[-width]) + p[width]) - p[0];
        found.push_back(std::abs(factor.x * offX + factor.y * offY) / glm::length(e.gradient));
      }
      return found;
    });
}

/// The made slice of each gap that is farthest from measured ones; the widest gaps first.
std::vector<SliceRecipe> GapsOf(const ResamplePlan& plan)
{
  const std::vector<double>& heights = plan.measures.heights;
  const auto reach = [&](const SliceRecipe& r) // interpolation errs by a product of ways
  {
    const double whole = heights[r.above] - heights[r.below];
    return r.share * (1.0 - r.share) * whole * whole;
  };
  std::vector<SliceRecipe> gaps;
  for (const SliceRecipe& recipe : plan.slices)
  {
    if (recipe.share == 0.0)
      continue;
    if (gaps.empty() || gaps.back().below != recipe.below)
      gaps.push_back(recipe);
    else if (reach(recipe) > reach(gaps.back()))
      gaps.back() = recipe;
  }
  std::stable_sort(gaps.begin(), gaps.end(),
    [&](const SliceRecipe& a, const SliceRecipe& b) { return reach(a) > reach(b); });
  gaps.resize(std::min<std::size_t>(gaps.size(), GapsJudged));
  return gaps;
}

} // namespace

template <typename T>
void MeasureResamplingError(const ResamplePlan& plan, const T* samples, ResampleRecord& record)
{
  const std::vector<SliceRecipe> gaps = GapsOf(plan);
  record.errorKnown = true;
  record.edgesJudged = 0;
  record.error50 = record.error95 = 0.0;
  if (gaps.empty() && record.farthestMove == 0.0)
    return;
  const ErrorMeter<T> meter(plan, samples);
  double across50 = 0.0, across95 = 0.0;
  const auto judge = [&](std::vector<double> found, double& half, double& most)
  {
    record.edgesJudged += static_cast<int>(found.size());
    record.errorKnown = record.errorKnown && !found.empty();
    half = std::max(half, Quantile(found, 0.5));
    most = std::max(most, Quantile(found, 0.95));
  };
  for (SliceRecipe gap : gaps) // the worst gap is what the volume is judged by
    for (int side = 0; side < 2; ++side)
    {
      judge(meter.AcrossGap(gap), across50, across95);
      gap.share = 1.0 - gap.share; // a place that near the other end errs as much
    }
  if (!meter.Moved().empty())
    judge(meter.WithinSlices(), record.error50, record.error95);
  record.error50 += across50; // both happen to a made slice of a tilted stack
  record.error95 += across95;
}

template void MeasureResamplingError(const ResamplePlan&, const std::int16_t*, ResampleRecord&);
template void MeasureResamplingError(const ResamplePlan&, const float*, ResampleRecord&);

} // namespace hasp
