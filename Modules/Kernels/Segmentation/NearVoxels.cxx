#include "Segmentation/NearVoxels.h"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

constexpr float Infinity = std::numeric_limits<float>::infinity();
constexpr int Block = 16; // neighbouring lines worked on together: one cache line of floats
constexpr int Slab = 32;  // slices worked on together

/// Lower envelope of the parabolas f(q) + step^2 (p - q)^2 along one line.
class Parabolas
{
public:
  Parabolas(int most, double step)
    : Step2(step * step),
      Apex(static_cast<std::size_t>(most)),
      Value(static_cast<std::size_t>(most)),
      Height(static_cast<std::size_t>(most)),
      From(static_cast<std::size_t>(most))
  {
  }

  void Clear() { this->Count = 0; }

  /// From left to right.
  void Add(int q, double f)
  {
    const double height = f / this->Step2 + double(q) * q;
    double from = -std::numeric_limits<double>::infinity();
    for (; this->Count > 0; --this->Count)
    {
      const std::size_t top = this->Count - 1;
      // Where the new one falls below the last one, and stays there.
      from = 0.5 * (height - this->Height[top]) / (q - this->Apex[top]);
      if (from > this->From[top])
        break;
      from = -std::numeric_limits<double>::infinity();
    }
    this->Apex[this->Count] = q;
    this->Value[this->Count] = f;
    this->Height[this->Count] = height;
    this->From[this->Count++] = from;
  }

  /// Calls write(p, value) for each p in [first, last], in order; not at all of no parabolas.
  template <typename F>
  void Write(int first, int last, F&& write) const
  {
    for (std::size_t n = 0; n < this->Count && first <= last; ++n)
      for (; first <= last && (n + 1 == this->Count || first <= this->From[n + 1]); ++first)
      {
        const double steps = first - this->Apex[n];
        write(first, this->Value[n] + steps * steps * this->Step2);
      }
  }

private:
  double Step2;
  std::size_t Count = 0;
  std::vector<int> Apex;
  std::vector<double> Value;
  std::vector<double> Height; ///< value / step^2 + apex^2
  std::vector<double> From;   ///< where each begins to be the lowest
};

/// What Dilated works on, and what it works out.
class Dilation
{
public:
  Dilation(const BoxMask& mask, const VoxelBox& box, const glm::dvec3& spacing, double radiusMm)
    : Mask(mask),
      Spacing(spacing),
      Most(radiusMm * radiusMm * (1.0 + 2e-6)),
      Steps(glm::min(glm::dvec3(1e6), std::sqrt(this->Most) / spacing)),
      Result(EmptyMask(box)),
      PerSlice(std::size_t(box.Size().x) * box.Size().y)
  {
  }

  BoxMask Run(const ProgressFunction& progress)
  {
    const VoxelBox& box = this->Result.box;
    for (int from = box.low.z; from < box.high.z; from += Slab)
    {
      ReportProgress(progress, double(from - box.low.z) / box.Size().z);
      const int to = std::min(from + Slab, box.high.z);
      this->Hold(from - this->Steps.z, to + this->Steps.z);
      ParallelFor(box.low.y, box.high.y, 4,
        [&](std::int64_t first, std::int64_t last)
        {
          for (int j = int(first); j < last; ++j)
            for (int i = box.low.x; i < box.high.x; i += Block)
              this->CoverAlongZ(i, j, from, to);
        });
    }
    ReportProgress(progress, 1.0);
    return std::move(this->Result);
  }

private:
  const VoxelBox& Seeds() const { return this->Mask.box; }

  /// Squared distances within their slices, of the mask's slices from <= k < to.
  void Hold(int from, int to)
  {
    from = std::max(from, this->Seeds().low.z);
    to = std::min(to, this->Seeds().high.z);
    if (from >= to)
    {
      this->First = this->Last = from;
      return;
    }
    const int kept = std::max(0, this->Last - std::max(from, this->First));
    if (kept > 0 && from > this->First)
      std::copy_n(this->Squared.begin() + std::ptrdiff_t((from - this->First) * this->PerSlice),
        kept * this->PerSlice, this->Squared.begin());
    this->Squared.resize((to - from) * this->PerSlice);
    this->First = from;
    ParallelFor(from + kept, to, 1,
      [&](std::int64_t k, std::int64_t)
      { this->WithinSlice(int(k), &this->Squared[(k - from) * this->PerSlice]); });
    this->Last = to;
  }

  /// Whether a voxel of the mask has a face neighbour that is not of it. All others can be left
  /// out: from any place outside, one of their neighbours is nearer.
  bool AtSurface(int i, int j, int k) const
  {
    const VoxelBox& b = this->Seeds();
    if (i == b.low.x || j == b.low.y || k == b.low.z || i + 1 == b.high.x || j + 1 == b.high.y ||
        k + 1 == b.high.z)
      return true;
    const std::uint8_t* at = &this->Mask.inside[this->Mask.Offset(i, j, k)];
    const std::ptrdiff_t row = b.Size().x, slice = row * b.Size().y;
    return !(at[-1] && at[1] && at[-row] && at[row] && at[-slice] && at[slice]);
  }

  /// Squared distance along x to the nearest of the row, of each voxel of the result's columns.
  void AlongX(int j, int k, std::vector<float>& squared) const
  {
    const VoxelBox &seeds = this->Seeds(), &box = this->Result.box;
    std::fill(squared.begin(), squared.end(), Infinity);
    const auto nearer = [&](int i, int steps)
    {
      if (i < box.low.x || i >= box.high.x || steps > this->Steps.x)
        return;
      const double along = this->Spacing.x * steps;
      float& least = squared[static_cast<std::size_t>(i - box.low.x)];
      least = std::min(least, static_cast<float>(along * along));
    };
    const std::uint8_t* row = &this->Mask.inside[this->Mask.Offset(seeds.low.x, j, k)];
    int reached = box.low.x; // all before have met the seeds to their left
    int last = std::numeric_limits<int>::min();
    for (int i = seeds.low.x; i < seeds.high.x; ++i)
    {
      if (!row[i - seeds.low.x] || !this->AtSurface(i, j, k))
        continue;
      // Those between the last one and this, each from the nearer side.
      for (int p = std::max(reached, i - this->Steps.x); p < std::min(i, box.high.x); ++p)
        nearer(p, i - p);
      if (last != std::numeric_limits<int>::min())
        for (int p = last; p < i && p <= last + this->Steps.x; ++p)
          nearer(p, p - last);
      reached = i;
      last = i;
    }
    if (last != std::numeric_limits<int>::min())
      for (int p = last; p < box.high.x && p <= last + this->Steps.x; ++p)
        nearer(p, p - last);
  }

  void WithinSlice(int k, float* slice) const
  {
    const VoxelBox &seeds = this->Seeds(), &box = this->Result.box;
    const int width = box.Size().x;
    const int low = std::max(seeds.low.y, box.low.y - this->Steps.y);
    const int high = std::min(seeds.high.y, box.high.y + this->Steps.y);
    std::fill_n(slice, this->PerSlice, Infinity);
    if (low >= high)
      return;
    std::vector<float> rows(std::size_t(high - low) * width), row(std::size_t(width), Infinity);
    for (int j = low; j < high; ++j)
    {
      this->AlongX(j, k, row);
      std::copy(row.begin(), row.end(), rows.begin() + std::ptrdiff_t(j - low) * width);
    }
    Parabolas parabolas(high - low, this->Spacing.y);
    for (int i = 0; i < width; ++i)
    {
      parabolas.Clear();
      for (int j = low; j < high; ++j)
        if (const float f = rows[std::size_t(j - low) * width + i]; f != Infinity)
          parabolas.Add(j - low, f);
      parabolas.Write(box.low.y - low, box.high.y - 1 - low,
        [&](int p, double squared)
        {
          if (squared <= this->Most)
            slice[std::size_t(p + low - box.low.y) * width + i] = static_cast<float>(squared);
        });
    }
  }

  /// The result's voxels from <= k < to of up to `Block` columns: each slice covers those that are
  /// as near along z as its squared distance leaves room for.
  void CoverAlongZ(int i, int j, int from, int to)
  {
    const VoxelBox& box = this->Result.box;
    const int lines = std::min(Block, box.high.x - i);
    const std::size_t at = std::size_t(j - box.low.y) * box.Size().x + (i - box.low.x);
    const double perStep2 = 1.0 / (this->Spacing.z * this->Spacing.z);
    std::array<std::array<int, Block>, Slab + 1> edges{}; // one more begins here than ends
    for (int k = this->First; k < this->Last; ++k)
    {
      const float* squared = &this->Squared[(k - this->First) * this->PerSlice + at];
      for (int l = 0; l < lines; ++l)
      {
        if (!(squared[l] <= this->Most))
          continue;
        const int reach =
          static_cast<int>(std::min(1e6, std::sqrt((this->Most - squared[l]) * perStep2)));
        const int begin = std::max(k - reach, from), end = std::min(k + reach + 1, to);
        if (begin >= end)
          continue;
        ++edges[std::size_t(begin - from)][std::size_t(l)];
        --edges[std::size_t(end - from)][std::size_t(l)];
      }
    }
    std::array<int, Block> covered{};
    for (int k = from; k < to; ++k)
      for (int l = 0; l < lines; ++l)
      {
        covered[std::size_t(l)] += edges[std::size_t(k - from)][std::size_t(l)];
        this->Result.inside[std::size_t(k - box.low.z) * this->PerSlice + at + l] =
          covered[std::size_t(l)] > 0;
      }
  }

  const BoxMask& Mask;
  glm::dvec3 Spacing;
  double Most; ///< squared radius, and what is forgiven
  glm::ivec3 Steps;
  BoxMask Result;
  std::size_t PerSlice;
  std::vector<float> Squared; ///< slices First <= k < Last of the mask, at the result's columns
  int First = 0, Last = 0;
};

} // namespace

glm::ivec3 StepsWithin(const glm::dvec3& spacing, double radiusMm, const char* what)
{
  constexpr double most = 50.0;
  constexpr int mostSteps = 1000;
  if (!(radiusMm > 0.0 && radiusMm <= most))
    throw std::invalid_argument(
      std::string(what) + " is " + std::to_string(radiusMm) + " mm, must be in (0, 50]");
  for (int a = 0; a < 3; ++a)
    if (!(radiusMm * (1.0 + 1e-6) < (mostSteps + 1) * spacing[a]))
      throw std::invalid_argument(std::string(what) + " is " + std::to_string(radiusMm) +
                                  " mm, which is more than 1000 voxels of " +
                                  std::to_string(spacing[a]) + " mm; use a coarser scan");
  return glm::ivec3(radiusMm * (1.0 + 1e-6) / spacing);
}

BoxMask EmptyMask(const VoxelBox& box)
{
  const glm::dvec3 size(box.Size());
  if (size.x * size.y * size.z >= 0x1p33)
    throw std::runtime_error("the label and the radius around it have " +
                             std::to_string(size.x * size.y * size.z) +
                             " voxels, must be fewer than 2^33; use a smaller radius");
  return { box,
    std::vector<std::uint8_t>(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z)) };
}

BoxMask Dilated(const BoxMask& mask, const VoxelBox& box, const glm::dvec3& spacing,
  double radiusMm, const ProgressFunction& progress)
{
  if (mask.box.Empty() || box.Empty())
    return EmptyMask(box);
  // Seeds inside the mask that are not at its surface are no seeds, and within it themselves.
  BoxMask near = Dilation(mask, box, spacing, radiusMm).Run(progress);
  const VoxelBox both{ glm::max(mask.box.low, box.low), glm::min(mask.box.high, box.high) };
  if (!both.Empty())
    ParallelFor(both.low.z, both.high.z, 1,
      [&](std::int64_t k, std::int64_t)
      {
        for (int j = both.low.y; j < both.high.y; ++j)
          for (int i = both.low.x; i < both.high.x; ++i)
            near.inside[near.Offset(i, j, int(k))] |= mask.At(i, j, int(k)) ? 1 : 0;
      });
  return near;
}

} // namespace hasp
