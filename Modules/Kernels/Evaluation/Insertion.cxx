#include "Evaluation/Insertion.h"

#include "Evaluation/BonePieces.h"
#include "Evaluation/SurfaceDistance.h"
#include "Grid/MinMaxBlocks.h"
#include "Grid/ParallelFor.h"
#include "Grid/Trilinear.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

namespace hasp
{

namespace
{
/// Part of a ray in bone, mm along it.
struct Stay
{
  double from, to;
};

/// Rays through a volume, in index coordinates.
template <typename T>
class Walk
{
public:
  Walk(const GridView<const T>& volume, const AnyGridView& any, double isovalue,
    const glm::dvec3& direction)
    : Volume(volume),
      Blocks(any),
      Isovalue(isovalue),
      Direction(volume.geometry.WorldToIndex(volume.geometry.origin + direction)),
      StepMm(0.5 * std::min({ volume.geometry.spacing.x, volume.geometry.spacing.y,
                     volume.geometry.spacing.z }))
  {
  }

  /// The first piece of the ray in bone, from `fromMm` on.
  std::optional<Stay> Next(const glm::dvec3& world, double fromMm) const
  {
    const glm::dvec3 origin = this->Volume.geometry.WorldToIndex(world);
    auto [t, end] = this->Range(origin);
    t = std::max(t, fromMm);
    std::optional<Stay> stay;
    while (t <= end)
    {
      const glm::dvec3 index = origin + t * this->Direction;
      if (!stay)
        if (const double out = this->LeaveEmptyBlock(origin, index); out > t)
        {
          t = out;
          continue;
        }
      const auto value = SampleTrilinear(this->Volume, index);
      const bool bone = value && *value >= this->Isovalue;
      if (stay && !bone)
        return stay;
      if (bone)
        stay = Stay{ stay ? stay->from : t, t };
      t += this->StepMm;
    }
    return stay;
  }

  double Step() const { return this->StepMm; }

private:
  /// Of t in the volume.
  std::pair<double, double> Range(const glm::dvec3& origin) const
  {
    double from = 0.0, to = std::numeric_limits<double>::max();
    if (this->Blocks.Count() == 0)
      return { 1.0, 0.0 }; // an axis of one sample: no cells
    for (int a = 0; a < 3; ++a)
    {
      const double last = this->Volume.geometry.dims[a] - 1;
      if (this->Direction[a] == 0.0)
      {
        if (!(origin[a] >= 0.0 && origin[a] <= last))
          return { 1.0, 0.0 };
        continue;
      }
      const double t0 = -origin[a] / this->Direction[a];
      const double t1 = (last - origin[a]) / this->Direction[a];
      from = std::max(from, std::min(t0, t1));
      to = std::min(to, std::max(t0, t1));
    }
    return { from, to };
  }

  /// t behind the block of `index` if there is no bone in it, else 0.
  double LeaveEmptyBlock(const glm::dvec3& origin, const glm::dvec3& index) const
  {
    const glm::ivec3 last = this->Blocks.Blocks() - 1;
    const glm::ivec3 block =
      glm::clamp(glm::ivec3(index) / MinMaxBlocks::Side, glm::ivec3(0), last);
    const std::size_t n = (std::size_t(block.z) * (last.y + 1) + block.y) * (last.x + 1) + block.x;
    if (this->Blocks.Data()[n].max >= this->Isovalue)
      return 0.0;
    double out = std::numeric_limits<double>::max();
    for (int a = 0; a < 3; ++a)
      if (this->Direction[a] != 0.0)
      {
        const int wall = (block[a] + (this->Direction[a] > 0.0 ? 1 : 0)) * MinMaxBlocks::Side;
        out = std::min(out, (wall - origin[a]) / this->Direction[a]);
      }
    return out + 1e-6 * this->StepMm; // behind it, not on it
  }

  GridView<const T> Volume;
  MinMaxBlocks Blocks;
  double Isovalue;
  glm::dvec3 Direction; ///< index units a mm
  double StepMm;
};

struct Way
{
  const MeshSample* sample;
  Stay stay;
};

/// Ways that meet bone that counts.
template <typename T>
std::vector<Way> BlockedWays(const GridView<const T>& view, const AnyGridView& volume,
  const std::vector<const MeshSample*>& samples, const InsertionSettings& s,
  const glm::dvec3& direction)
{
  const Walk<T> walk(view, volume, s.isovalue, direction);
  std::vector<std::optional<Stay>> stays(samples.size());
  ParallelFor(0, static_cast<std::int64_t>(samples.size()), 256,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
        stays[n] = walk.Next(samples[n]->point, 0.0);
    });
  BonePieces pieces(volume, s.isovalue, s.ignoreBelowMm3);
  std::vector<Way> ways;
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    while (stays[n] && !pieces.Counts(samples[n]->point + stays[n]->from * direction))
      stays[n] = walk.Next(samples[n]->point, stays[n]->to + walk.Step());
    if (stays[n])
      ways.push_back({ samples[n], *stays[n] });
  }
  return ways;
}
} // namespace

Insertion MeasureInsertion(const AnyGridView& volume, std::span<const MeshSample> samples,
  const InsertionSettings& s, const ProgressFunction& progress)
{
  GeometryOf(volume).Validate();
  const double length = glm::length(s.direction);
  if (!std::isfinite(s.isovalue) || !(s.ignoreBelowMm3 >= 0.0) || !(s.toleranceMm > 0.0) ||
      !(length > 0.0) || !std::isfinite(length))
    throw std::invalid_argument("insertion: needs a finite isovalue, ignoreBelowMm3 >= 0, "
                                "toleranceMm > 0 and a direction that is not 0");
  const glm::dvec3 direction = s.direction / length;
  std::vector<const MeshSample*> ahead; // what looks back follows in the way of these
  for (const MeshSample& sample : samples)
    if (glm::dot(sample.normal, direction) > 0.0)
      ahead.push_back(&sample);
  Insertion insertion;
  insertion.samples = ahead.size();
  const std::vector<Way> ways = std::visit(
    [&](const auto& view) { return BlockedWays(view, volume, ahead, s, direction); }, volume);
  ReportProgress(progress, 0.5);

  std::vector<glm::dvec3> middles;
  for (const Way& way : ways)
    middles.push_back(way.sample->point + 0.5 * (way.stay.from + way.stay.to) * direction);
  const auto depths = DistanceToIsosurface(volume, s.isovalue, middles, Insertion::BeyondMm);
  for (std::size_t n = 0; n < ways.size(); ++n)
  {
    const double depth = depths[n] ? -depths[n]->distance : Insertion::BeyondMm;
    if (!(depth > s.toleranceMm))
      continue;
    ++insertion.blocked;
    insertion.blockedMm2 += ways[n].sample->areaMm2;
    if (depth > insertion.deepestMm)
    {
      insertion.deepestMm = depth;
      insertion.partAt = ways[n].sample->point;
      insertion.boneAt = middles[n];
    }
  }
  ReportProgress(progress, 1.0);
  return insertion;
}

} // namespace hasp
