#include "Haptics/DistanceMap.h"
#include "Grid/ParallelFor.h"
#include "Grid/Stopwatch.h"
#include "Grid/Trilinear.h"
#include "Haptics/DistanceMapBlocks.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{

using WorkingView = DistanceMapView<std::int16_t>;
constexpr int Side = WorkingView::Side, Row = WorkingView::Row;
constexpr std::int32_t OutsideBrick = 0, InsideBrick = 1; ///< shared by all blocks out of the band
constexpr float Steps = 32767.0F;

double RangeFor(const GridGeometry& geometry, const DistanceMapSettings& settings)
{
  geometry.Validate();
  const glm::ivec3 dims = geometry.dims;
  if (std::min({ dims.x, dims.y, dims.z }) < 2)
    throw std::invalid_argument("DistanceMap: the grid has " + std::to_string(dims.x) + " x " +
                                std::to_string(dims.y) + " x " + std::to_string(dims.z) +
                                " samples; each axis must have at least 2");
  const glm::dvec3 s = geometry.spacing;
  const double smallest = std::min({ s.x, s.y, s.z }), largest = std::max({ s.x, s.y, s.z });
  const double range =
    settings.rangeMm == 0.0 ? std::max(16.0 * smallest, largest) : settings.rangeMm;
  if (!(std::isfinite(range) && range >= 0.5 * largest))
    throw std::invalid_argument("DistanceMap: a range of " + std::to_string(range) +
                                " mm; it must be finite and at least half the largest spacing, " +
                                std::to_string(0.5 * largest) + " mm, or 0 for the default");
  if (!std::isfinite(settings.origin.x + settings.origin.y + settings.origin.z))
    throw std::invalid_argument("DistanceMap: the body's origin must be finite");
  return range;
}

void StoreMost(std::atomic<float>& most, float value)
{
  for (float seen = most.load(); seen < value && !most.compare_exchange_weak(seen, value);)
  {
  }
}

/// Calls row(y, z) for each row of blocks, on all threads, layer after layer with progress between
/// `from` and `to`.
template <typename RowFunction>
void OverBlockRows(const glm::ivec3& blocks, const ProgressFunction& progress, double from,
  double to, const RowFunction& row)
{
  for (int z = 0; z < blocks.z; ++z)
  {
    ReportProgress(progress, from + (to - from) * z / blocks.z);
    ParallelFor(0, blocks.y, 2,
      [&](std::int64_t first, std::int64_t end)
      {
        for (int y = static_cast<int>(first); y < end; ++y)
          row(y, z);
      });
  }
}

/// Samples past the grid's last repeat it: they are read with weight 0 at most.
template <typename T, typename Convert>
void FillBrick(const Counted& counted, const glm::ivec3& block, T* brick, const Convert& convert)
{
  const glm::ivec3 last = counted.Grid.geometry.dims - 1;
  for (int k = 0; k < Row; ++k)
    for (int j = 0; j < Row; ++j)
      for (int i = 0; i < Row; ++i)
      {
        const glm::ivec3 p = glm::min(block * Side + glm::ivec3(i, j, k), last);
        *brick++ = convert(counted(p.x, p.y, p.z));
      }
  *brick = T(0);
}

} // namespace

struct DistanceMap::Internals
{
  GridGeometry geometry;
  double range = 0.0, milliseconds = 0.0;
  glm::dvec3 origin{ 0.0 };
  bool hasReference = false;
  float steepest = 0.0F;
  glm::ivec3 blocks{ 0 };
  std::vector<std::int16_t> samples;
  std::vector<float> reference;
  std::vector<std::int32_t> firstSample;
  std::vector<MinMaxBlocks::Range> unclamped;

  std::size_t BlockIndex(int x, int y, int z) const
  {
    return (static_cast<std::size_t>(z) * this->blocks.y + y) * this->blocks.x + x;
  }
  void ReadBlocks(const Counted& counted, const ProgressFunction& progress);
  void PlaceBricks();
  void FillBricks(const Counted& counted, const ProgressFunction& progress);
  template <typename T>
  DistanceMapView<T> ViewOf(const std::vector<T>& bricks, double mmPerStep) const;
};

void DistanceMap::Internals::ReadBlocks(const Counted& counted, const ProgressFunction& progress)
{
  std::atomic<float> steepestSquared{ 0.0F };
  const auto row = [&](int y, int z)
  {
    float most = 0.0F;
    for (int x = 0; x < this->blocks.x; ++x)
    {
      const BlockFacts facts = FactsOf(counted, { x, y, z });
      this->unclamped[this->BlockIndex(x, y, z)] = facts.range;
      most = std::max(most, facts.slopeSquared);
    }
    StoreMost(steepestSquared, most);
  };
  OverBlockRows(this->blocks, progress, 0.0, 0.6, row);
  this->steepest = std::sqrt(steepestSquared.load());
}

void DistanceMap::Internals::PlaceBricks()
{
  const auto range = static_cast<float>(this->range);
  // Kernels address samples by bytes in 32 bits.
  constexpr std::int64_t most =
    std::numeric_limits<std::int32_t>::max() /
    (WorkingView::BrickSamples * static_cast<std::int64_t>(sizeof(std::int16_t)));
  std::int64_t bricks = 2;
  for (std::size_t b = 0; b < this->unclamped.size(); ++b)
  {
    const MinMaxBlocks::Range r = this->unclamped[b];
    const std::int64_t brick = r.min >= range    ? OutsideBrick
                               : r.max <= -range ? InsideBrick
                                                 : bricks++;
    if (bricks > most)
      throw std::runtime_error(
        "DistanceMap: more than " + std::to_string(most) +
        " blocks lie within the range; take a smaller range or a coarser grid");
    this->firstSample[b] = static_cast<std::int32_t>(brick * WorkingView::BrickSamples);
  }
  const std::size_t size = static_cast<std::size_t>(bricks) * WorkingView::BrickSamples;
  const auto fill = [&](auto& samples, auto outside)
  {
    samples.resize(size);
    std::fill_n(samples.begin(), WorkingView::BrickSamples, outside);
    std::fill_n(samples.begin() + WorkingView::BrickSamples, WorkingView::BrickSamples, -outside);
  };
  fill(this->samples, static_cast<std::int16_t>(Steps));
  if (this->hasReference)
    fill(this->reference, range);
}

void DistanceMap::Internals::FillBricks(const Counted& counted, const ProgressFunction& progress)
{
  const auto range = static_cast<float>(this->range);
  const float perMm = Steps / range;
  const auto clamped = [&](float d) { return std::clamp(d, -range, range); };
  const auto row = [&](int y, int z)
  {
    for (int x = 0; x < this->blocks.x; ++x)
    {
      const std::int32_t first = this->firstSample[this->BlockIndex(x, y, z)];
      if (first < 2 * WorkingView::BrickSamples)
        continue;
      FillBrick(counted, { x, y, z }, &this->samples[first],
        [&](float d) { return static_cast<std::int16_t>(std::lrint(clamped(d) * perMm)); });
      if (this->hasReference)
        FillBrick(counted, { x, y, z }, &this->reference[first], clamped);
    }
  };
  OverBlockRows(this->blocks, progress, 0.6, 1.0, row);
}

template <typename T>
DistanceMapView<T> DistanceMap::Internals::ViewOf(
  const std::vector<T>& bricks, double mmPerStep) const
{
  DistanceMapView<T> view;
  view.samples = bricks.data();
  view.firstSample = this->firstSample.data();
  view.blocks = this->blocks;
  view.last = this->geometry.dims - 1;
  view.mmPerStep = static_cast<float>(mmPerStep);
  view.rangeMm = static_cast<float>(this->range);
  view.unclamped = this->unclamped.data();
  const glm::dmat3 gradient{ this->geometry.GradientToWorld({ 1, 0, 0 }),
    this->geometry.GradientToWorld({ 0, 1, 0 }), this->geometry.GradientToWorld({ 0, 0, 1 }) };
  view.toIndex = glm::transpose(gradient);
  view.indexOfOrigin = this->geometry.WorldToIndex(this->origin);
  view.gradientToBody = gradient;
  view.steepest = this->steepest;
  return view;
}

DistanceMap::DistanceMap(const GridView<const float>& distances,
  const DistanceMapSettings& settings, const ProgressFunction& progress)
  : Inside(std::make_unique<Internals>())
{
  const Stopwatch stopwatch;
  Internals& in = *this->Inside;
  in.range = RangeFor(distances.geometry, settings);
  in.geometry = distances.geometry;
  in.origin = settings.origin;
  in.hasReference = settings.reference;
  in.blocks = (in.geometry.Cells() + Side - 1) / Side;
  const std::size_t count = static_cast<std::size_t>(in.blocks.x) * in.blocks.y * in.blocks.z;
  in.unclamped.resize(count);
  in.firstSample.resize(count);
  const Counted counted(distances, static_cast<float>(in.range));
  in.ReadBlocks(counted, progress);
  in.PlaceBricks();
  in.FillBricks(counted, progress);
  ReportProgress(progress, 1.0);
  in.milliseconds = stopwatch.Milliseconds();
}

DistanceMap::~DistanceMap() = default;

DistanceMapView<std::int16_t> DistanceMap::View() const noexcept
{
  return this->Inside->ViewOf(this->Inside->samples, this->Inside->range / Steps);
}

DistanceMapView<float> DistanceMap::Reference() const
{
  if (!this->Inside->hasReference)
    throw std::runtime_error("DistanceMap: made without a reference; ask for it in the settings");
  return this->Inside->ViewOf(this->Inside->reference, 1.0);
}

const GridGeometry& DistanceMap::Geometry() const noexcept
{
  return this->Inside->geometry;
}

double DistanceMap::RangeMm() const noexcept
{
  return this->Inside->range;
}

double DistanceMap::SmallestSpacing() const noexcept
{
  const glm::dvec3 s = this->Inside->geometry.spacing;
  return std::min({ s.x, s.y, s.z });
}

DistanceMap::Sample DistanceMap::At(const glm::dvec3& world) const noexcept
{
  const Internals& in = *this->Inside;
  const auto found = LocateCell(in.geometry, in.geometry.WorldToIndex(world));
  if (!found)
    return { in.range, glm::dvec3(0.0) };
  const glm::ivec3 block = found->cell / Side, cell = found->cell - block * Side;
  const std::int32_t first = in.firstSample[in.BlockIndex(block.x, block.y, block.z)];
  if (first == OutsideBrick * WorkingView::BrickSamples)
    return { in.range, glm::dvec3(0.0) }; // as its samples say, all of them
  const std::int16_t* p = &in.samples[first + (cell.z * Row + cell.y) * Row + cell.x];
  std::array<double, 8> corners{};
  for (int c = 0; c < 8; ++c)
    corners[c] = p[(c & 1) + (c >> 1 & 1) * Row + (c >> 2) * WorkingView::Slice];
  const double mm = in.range / Steps;
  return { mm * TrilinearValue(corners, found->local),
    in.geometry.GradientToWorld(mm * TrilinearGradient(corners, found->local)) };
}

void DistanceMap::ListResources(ResourceList& list) const
{
  const Internals& in = *this->Inside;
  list.push_back({ "distance map",
    in.samples.size() * sizeof(std::int16_t) + in.firstSample.size() * sizeof(std::int32_t) +
      in.unclamped.size() * sizeof(MinMaxBlocks::Range),
    in.milliseconds, "a body to touch" });
  list.push_back({ "distance map, float", in.reference.size() * sizeof(float), 0.0,
    in.hasReference ? "asked for" : "no reference was asked for" });
}

} // namespace hasp
