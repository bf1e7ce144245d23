#include "Distance/Coverage.h"

#include "Grid/ParallelFor.h"
#include "Grid/Trilinear.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr int Brick = 8; ///< voxels along each axis

/// Supersamples the voxels of one target grid in one source grid.
template <typename T>
class Sampler
{
public:
  Sampler(const GridView<const T>& source, const GridGeometry& target, const CoverageSettings& s)
    : Source(source),
      Settings(s)
  {
    // Target index -> source index is affine: origin + matrix * (i,j,k).
    const auto toSource = [&](const glm::dvec3& index)
    { return source.geometry.WorldToIndex(target.IndexToWorld(index)); };
    this->Origin = toSource(glm::dvec3(0.0));
    for (int a = 0; a < 3; ++a)
    {
      glm::dvec3 unit(0.0);
      unit[a] = 1.0;
      this->Step[a] = toSource(unit) - this->Origin;
    }
    for (int a = 0; a < 3; ++a)
      this->Half[a] = 0.5 * (std::abs(this->Step[0][a]) + std::abs(this->Step[1][a]) +
                              std::abs(this->Step[2][a]));
    const int n = s.samplesPerAxis;
    for (int k = 0; k < n; ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
          this->Places.push_back(this->Step * ((glm::dvec3(i, j, k) + 0.5) / double(n) - 0.5));
  }

  /// Of all voxels [first, last], where the samples that they reach tell it at once.
  std::optional<float> OfAll(const glm::ivec3& first, const glm::ivec3& last) const
  {
    constexpr double Slack = 1e-6; // more than rounding
    glm::dvec3 half(Slack);
    for (int a = 0; a < 3; ++a)
      half += 0.5 * (last[a] - first[a] + 1) * glm::abs(this->Step[a]);
    const glm::dvec3 center = this->Origin + this->Step * (0.5 * glm::dvec3(first + last));
    const SampleBox box = this->BoxAround(center, half);
    bool allIn = box.within, noneInside = true;
    for (int k = box.first.z; k <= box.last.z; ++k)
      for (int j = box.first.y; j <= box.last.y; ++j)
      {
        for (int i = box.first.x; i <= box.last.x; ++i)
        {
          const bool inside = this->Inside(i, j, k);
          allIn = allIn && inside && this->Kept(i, j, k);
          noneInside = noneInside && !inside;
        }
        if (!allIn && !noneInside)
          return std::nullopt;
      }
    return noneInside ? 0.0F : 1.0F;
  }

  float operator()(const glm::dvec3& index) const
  {
    const glm::dvec3 center = this->Origin + this->Step * index;
    const glm::ivec3 top = this->Source.geometry.dims - 1;
    if (glm::any(glm::lessThan(center + this->Half, glm::dvec3(0.0))) ||
        glm::any(glm::greaterThan(center - this->Half, glm::dvec3(top))))
      return 0.0F;
    const auto [first, last, within] = this->BoxAround(center, this->Half);
    bool allInside = within, noneInside = true, allKept = true;
    for (int k = first.z; k <= last.z; ++k)
      for (int j = first.y; j <= last.y; ++j)
        for (int i = first.x; i <= last.x; ++i)
        {
          const bool inside = this->Inside(i, j, k);
          allInside = allInside && inside;
          noneInside = noneInside && !inside;
          allKept = allKept && (!inside || this->Kept(i, j, k));
        }
    if (noneInside || (allInside && allKept))
      return noneInside ? 0.0F : 1.0F;
    if (within)
      if (const auto uniform = this->FarFromSurface(center, first, last);
          uniform && (allKept || *uniform == 0.0F))
        return *uniform;
    return this->Supersample(center, !allKept);
  }

private:
  /// Samples of the source: all that were asked for are there, or those that are.
  struct SampleBox
  {
    glm::ivec3 first, last;
    bool within;
  };
  SampleBox BoxAround(const glm::dvec3& center, const glm::dvec3& half) const
  {
    const glm::dvec3 top(this->Source.geometry.dims - 1), zero(0.0);
    const glm::dvec3 low = glm::floor(center - half), high = glm::ceil(center + half);
    return { glm::ivec3(glm::clamp(low, zero, top + 1.0)),
      glm::ivec3(glm::clamp(high, zero - 1.0, top)),
      glm::all(glm::greaterThanEqual(low, zero)) && glm::all(glm::lessThanEqual(high, top)) };
  }

  bool Inside(int i, int j, int k) const
  {
    return double(this->Source(i, j, k)) >= this->Settings.isovalue; // NaN is not
  }
  bool Kept(int i, int j, int k) const
  {
    return this->Settings.keep.empty() || this->Settings.keep[this->Source.Offset(i, j, k)];
  }

  /// A voxel whose centre value is farther from the isovalue than the field can change over half
  /// its size: each partial derivative of a trilinear polynomial is bounded by its differences
  /// along edges, here those of all cells that the voxel reaches into, of samples [first, last].
  /// NaN and infinity bound nothing.
  std::optional<float> FarFromSurface(
    const glm::dvec3& center, const glm::ivec3& first, const glm::ivec3& last) const
  {
    const std::size_t row = this->Source.geometry.dims.x;
    const std::size_t steps[] = { 1, row, row * this->Source.geometry.dims.y };
    glm::dvec3 steepest(0.0);
    double all = 0.0; // finite if each is
    for (int k = first.z; k <= last.z; ++k)
      for (int j = first.y; j <= last.y; ++j)
        for (int i = first.x; i <= last.x; ++i)
        {
          const glm::ivec3 at(i, j, k);
          const T* sample = &this->Source(i, j, k);
          for (int a = 0; a < 3; ++a)
            if (at[a] < last[a])
            {
              const double change = std::abs(double(sample[steps[a]]) - double(*sample));
              steepest[a] = std::max(steepest[a], change);
              all += change;
            }
        }
    if (!std::isfinite(all))
      return std::nullopt;
    const auto at = LocateCell(this->Source.geometry, center);
    const double beyond =
      TrilinearValue(CellCorners(this->Source, at->cell), at->local) - this->Settings.isovalue;
    if (!(std::abs(beyond) > glm::dot(steepest, this->Half)))
      return std::nullopt;
    return beyond > 0 ? 1.0F : 0.0F;
  }

  float Supersample(const glm::dvec3& center, bool askKeep) const
  {
    int count = 0;
    Cell cell;
    for (const glm::dvec3& place : this->Places)
      count += this->PointInside(center + place, askKeep, cell);
    return static_cast<float>(double(count) / double(this->Places.size()));
  }

  /// That of the last place: most have the same.
  struct Cell
  {
    glm::ivec3 at{ -1 };
    std::array<double, 8> corners{};
  };
  bool PointInside(const glm::dvec3& index, bool askKeep, Cell& cell) const
  {
    const auto at = LocateCell(this->Source.geometry, index);
    if (!at)
      return false;
    if (at->cell != cell.at)
      cell = { at->cell, CellCorners(this->Source, at->cell) };
    if (!(TrilinearValue(cell.corners, at->local) >= this->Settings.isovalue))
      return false;
    if (!askKeep)
      return true;
    double heaviest = -1.0;
    bool kept = false;
    for (int n = 0; n < 8; ++n)
    {
      const glm::ivec3 bit(n & 1, n >> 1 & 1, n >> 2), p = at->cell + bit;
      const glm::dvec3 w = glm::mix(1.0 - at->local, at->local, glm::dvec3(bit));
      if (const double weight = w.x * w.y * w.z; weight > heaviest && this->Inside(p.x, p.y, p.z))
      {
        heaviest = weight;
        kept = this->Kept(p.x, p.y, p.z);
      }
    }
    return kept;
  }

  const GridView<const T>& Source;
  const CoverageSettings& Settings;
  glm::dvec3 Origin{}, Half{};
  glm::dmat3 Step{};
  std::vector<glm::dvec3> Places; ///< that a voxel is supersampled at, from its centre
};

void Check(const AnyGridView& source, const GridGeometry& target, const CoverageSettings& s)
{
  GeometryOf(source).Validate();
  target.Validate();
  if (const glm::ivec3 d = GeometryOf(source).dims; std::min({ d.x, d.y, d.z }) < 2)
    throw std::invalid_argument("coverage: the source has " + std::to_string(d.x) + " x " +
                                std::to_string(d.y) + " x " + std::to_string(d.z) +
                                " samples; between them is no room: each axis needs two at least");
  if (!std::isfinite(s.isovalue))
    throw std::invalid_argument("coverage: isovalue must be finite");
  if (s.samplesPerAxis < 1 || s.samplesPerAxis > 16)
    throw std::invalid_argument(
      "coverage: samplesPerAxis is " + std::to_string(s.samplesPerAxis) + ", must be in [1, 16]");
  if (!s.keep.empty() && s.keep.size() != GeometryOf(source).Size())
    throw std::invalid_argument("coverage: keep has " + std::to_string(s.keep.size()) +
                                " values, must have one for each of the source's " +
                                std::to_string(GeometryOf(source).Size()) + " samples");
}
} // namespace

std::vector<float> Coverage(const AnyGridView& source, const GridGeometry& target,
  const CoverageSettings& settings, const ProgressFunction& progress)
{
  Check(source, target, settings);
  std::vector<float> coverage(target.Size());
  const auto fill = [&](const auto& view)
  {
    const Sampler sampler(view, target, settings);
    const glm::i64vec3 bricks = (target.dims + (Brick - 1)) / Brick;
    const GridView<float> filled{ coverage.data(), target };
    const auto fillBrick = [&](const glm::ivec3& first)
    {
      const glm::ivec3 end = glm::min(first + Brick, target.dims);
      const auto all = sampler.OfAll(first, end - 1);
      for (int k = first.z; k < end.z; ++k)
        for (int j = first.y; j < end.y; ++j)
          for (int i = first.x; i < end.x; ++i)
            filled(i, j, k) = all ? *all : sampler(glm::dvec3(i, j, k));
    };
    for (std::int64_t k = 0; k < bricks.z; ++k)
    {
      ReportProgress(progress, double(k) / double(bricks.z));
      ParallelFor(0, bricks.x * bricks.y, 1,
        [&](std::int64_t first, std::int64_t)
        { fillBrick(Brick * glm::ivec3(first % bricks.x, first / bricks.x, k)); });
    }
  };
  std::visit(fill, source);
  ReportProgress(progress, 1.0);
  return coverage;
}

std::vector<std::uint8_t> KeepLabel(const AnyGridView& labels, int label)
{
  GeometryOf(labels).Validate();
  std::vector<std::uint8_t> keep(GeometryOf(labels).Size());
  std::visit(
    [&](const auto& view)
    {
      ParallelFor(0, std::int64_t(keep.size()), 1 << 16,
        [&](std::int64_t first, std::int64_t last)
        {
          for (std::int64_t v = first; v < last; ++v)
            keep[v] = double(view.data[v]) == label;
        });
    },
    labels);
  return keep;
}

} // namespace hasp
