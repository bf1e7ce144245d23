#include "Distance/EuclideanDistance.h"

#include "Grid/ParallelFor.h"

#include <algorithm>
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

/// Lower envelope of the parabolas f(q) + step^2 (p - q)^2 over one of `Block` lines side by side.
class LowerEnvelope
{
public:
  LowerEnvelope(int length, double step)
    : Step(step),
      PerStep2(1.0 / (step * step)),
      Apex(length),
      Height(length),
      From(length),
      HalfPer(length)
  {
    for (int d = 1; d < length; ++d)
      this->HalfPer[d] = 0.5 / d;
  }

  void Clear() { this->Count = 0; }

  /// Parabolas come from left to right; infinite ones are left out.
  void Add(int q, float f)
  {
    if (f == Infinity)
      return;
    const double height = double(f) * this->PerStep2 + double(q) * q;
    double from = -std::numeric_limits<double>::infinity();
    for (; this->Count > 0; --this->Count)
    {
      const int top = this->Count - 1;
      const double meet = (height - this->Height[top]) * this->HalfPer[q - this->Apex[top]];
      if (meet > this->From[top])
      {
        from = meet;
        break;
      }
    }
    this->Apex[this->Count] = q;
    this->Height[this->Count] = height;
    this->From[this->Count++] = from;
  }

  /// Calls write(p, q, squared way along the line) for each p in [first, last], q its lowest.
  template <typename F>
  void Write(int first, int last, F&& write) const
  {
    for (int n = 0, p = first; n < this->Count && p <= last; ++n)
    {
      const int q = this->Apex[n];
      // Truncated: what lies before the line's beginning has no place in it.
      const double until = n + 1 < this->Count ? this->From[n + 1] : double(last);
      const int end = until < 0.0 ? -1 : static_cast<int>(std::min(until, double(last)));
      for (; p <= end; ++p)
      {
        const double along = this->Step * (p - q);
        write(p, q, along * along);
      }
    }
  }

private:
  double Step, PerStep2;
  int Count = 0;
  std::vector<int> Apex;
  std::vector<double> Height, From, HalfPer;
};

/// Up to `Block` lines along an axis, neighbours in memory.
struct Lines
{
  std::size_t first;  ///< offset of the first voxel of the first line
  std::size_t stride; ///< from voxel to voxel of a line
  int lines, length;

  template <typename T>
  void Read(const T* from, std::vector<T>& to) const
  {
    for (int p = 0; p < this->length; ++p)
      std::copy_n(from + this->first + p * this->stride, this->lines, &to[p * Block]);
  }
  template <typename T>
  void Write(const std::vector<T>& from, T* to) const
  {
    for (int p = 0; p < this->length; ++p)
      std::copy_n(&from[p * Block], this->lines, to + this->first + p * this->stride);
  }
};

/// Calls sweep(Lines) for all lines along y (axis 1) or z (2), pieces of them side by side.
template <typename F>
void ForLines(const glm::ivec3& dims, int axis, F&& sweep)
{
  const std::int64_t nx = dims.x, ny = dims.y, nz = dims.z;
  const std::int64_t blocks = (nx + Block - 1) / Block, others = axis == 1 ? nz : ny;
  ParallelFor(0, blocks * others, 8,
    [&](std::int64_t first, std::int64_t last)
    {
      auto work = sweep(axis == 1 ? dims.y : dims.z);
      for (std::int64_t b = first; b < last; ++b)
      {
        const std::int64_t x = b % blocks * Block, other = b / blocks;
        const int width = static_cast<int>(std::min<std::int64_t>(Block, nx - x));
        if (axis == 1)
          work({ std::size_t(other * ny * nx + x), std::size_t(nx), width, dims.y });
        else
          work({ std::size_t(other * nx + x), std::size_t(nx * ny), width, dims.z });
      }
    });
}

void SweepFeatures(FeatureTransform& map, const glm::ivec3& dims, int axis, double step)
{
  ForLines(dims, axis,
    [&](int length)
    {
      const std::size_t size = std::size_t(length) * Block;
      return [&map, envelope = LowerEnvelope(length, step), f = std::vector<float>(size),
               to = std::vector<float>(size), seed = std::vector<std::uint32_t>(size),
               won = std::vector<std::uint32_t>(size)](const Lines& at) mutable
      {
        at.Read(map.squared.data(), f);
        at.Read(map.seed.data(), seed);
        to = f;
        won = seed;
        for (int l = 0; l < at.lines; ++l)
        {
          envelope.Clear();
          for (int q = 0; q < at.length; ++q)
            envelope.Add(q, f[q * Block + l]);
          envelope.Write(0, at.length - 1,
            [&](int p, int q, double along)
            {
              to[p * Block + l] = static_cast<float>(f[q * Block + l] + along);
              won[p * Block + l] = seed[q * Block + l];
            });
        }
        at.Write(to, map.squared.data());
        at.Write(won, map.seed.data());
      };
    });
}

/// Squared distances to the nearest voxel of the other kind. In a line, what lies beyond the first
/// of the other kind is never nearer than that one: each run is swept by itself, between the two.
void SweepRuns(std::vector<float>& squared, std::span<const std::uint8_t> inside,
  const glm::ivec3& dims, int axis, double step)
{
  ForLines(dims, axis,
    [&](int length)
    {
      const std::size_t size = std::size_t(length) * Block;
      return [&squared, inside, envelope = LowerEnvelope(length, step),
               f = std::vector<float>(size), to = std::vector<float>(size),
               kind = std::vector<std::uint8_t>(size)](const Lines& at) mutable
      {
        at.Read(squared.data(), f);
        at.Read(inside.data(), kind);
        to = f;
        for (int l = 0; l < at.lines; ++l)
          for (int first = 0, end = 0; first < at.length; first = end)
          {
            const bool is = kind[first * Block + l] != 0;
            for (end = first; end < at.length && (kind[end * Block + l] != 0) == is;)
              ++end;
            envelope.Clear();
            if (first > 0)
              envelope.Add(first - 1, 0.0F);
            for (int q = first; q < end; ++q)
              envelope.Add(q, f[q * Block + l]);
            if (end < at.length)
              envelope.Add(end, 0.0F);
            envelope.Write(first, end - 1,
              [&](int p, int q, double along)
              {
                const float height = q < first || q == end ? 0.0F : f[q * Block + l];
                to[p * Block + l] = static_cast<float>(height + along);
              });
          }
        at.Write(to, squared.data());
      };
    });
}

/// Nearest seed along x alone: two runs per row.
void SweepRow(FeatureTransform& map, std::span<const std::uint8_t> seeds, std::size_t first,
  int length, double step)
{
  std::int64_t last = -1;
  for (int pass = 0; pass < 2; ++pass, last = -1)
    for (int n = 0; n < length; ++n)
    {
      const std::size_t p = first + (pass ? length - 1 - n : n);
      if (seeds[p])
        last = static_cast<std::int64_t>(p);
      if (last < 0)
        continue;
      const double along = step * (double(p) - double(last));
      if (const auto squared = static_cast<float>(along * along); squared < map.squared[p])
      {
        map.squared[p] = squared;
        map.seed[p] = static_cast<std::uint32_t>(last);
      }
    }
}
/// Squared way along x to the nearest voxel of the other kind.
void SweepRowOfKinds(std::vector<float>& squared, std::span<const std::uint8_t> inside,
  std::size_t first, int length, double step)
{
  for (int from = 0, end = 0; from < length; from = end)
  {
    const bool is = inside[first + from] != 0;
    for (end = from; end < length && (inside[first + end] != 0) == is;)
      ++end;
    for (int p = from; p < end; ++p)
    {
      const int left = from > 0 ? p - from + 1 : length, right = end < length ? end - p : length;
      const double along = step * std::min(left, right);
      if (left < length || right < length)
        squared[first + p] = static_cast<float>(along * along);
    }
  }
}

void CheckSize(const GridGeometry& geometry, std::size_t count)
{
  geometry.Validate();
  if (count != geometry.Size() || count >= FeatureTransform::NoSeed)
    throw std::invalid_argument("distance transform: " + std::to_string(count) + " values for " +
                                std::to_string(geometry.Size()) +
                                " voxels; both must be the same and below 2^32 - 1");
}
} // namespace

FeatureTransform NearestSeeds(const GridGeometry& geometry, std::span<const std::uint8_t> seeds,
  const ProgressFunction& progress)
{
  CheckSize(geometry, seeds.size());
  const std::size_t size = geometry.Size();
  FeatureTransform map{ std::vector<float>(size, Infinity),
    std::vector<std::uint32_t>(size, FeatureTransform::NoSeed) };
  const std::int64_t nx = geometry.dims.x, rows = std::int64_t(geometry.dims.y) * geometry.dims.z;
  ParallelFor(0, rows, 64,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t row = first; row < last; ++row)
        SweepRow(map, seeds, row * nx, geometry.dims.x, geometry.spacing.x);
    });
  ReportProgress(progress, 0.2);
  SweepFeatures(map, geometry.dims, 1, geometry.spacing.y);
  ReportProgress(progress, 0.6);
  SweepFeatures(map, geometry.dims, 2, geometry.spacing.z);
  ReportProgress(progress, 1.0);
  return map;
}

std::vector<float> SignedEuclideanDistance(const GridGeometry& geometry,
  std::span<const std::uint8_t> inside, const ProgressFunction& progress)
{
  CheckSize(geometry, inside.size());
  std::vector<float> distance(inside.size(), Infinity); // squared until the end
  const std::int64_t nx = geometry.dims.x, rows = std::int64_t(geometry.dims.y) * geometry.dims.z;
  ParallelFor(0, rows, 64,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t row = first; row < last; ++row)
        SweepRowOfKinds(distance, inside, row * nx, geometry.dims.x, geometry.spacing.x);
    });
  ReportProgress(progress, 0.2);
  SweepRuns(distance, inside, geometry.dims, 1, geometry.spacing.y);
  ReportProgress(progress, 0.6);
  SweepRuns(distance, inside, geometry.dims, 2, geometry.spacing.z);
  const float half = 0.5F * static_cast<float>(std::min(
                              { geometry.spacing.x, geometry.spacing.y, geometry.spacing.z }));
  ParallelFor(0, std::int64_t(distance.size()), 1 << 16,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t v = first; v < last; ++v)
      {
        const float away = std::sqrt(distance[v]) - half;
        distance[v] = inside[v] ? -away : away;
      }
    });
  ReportProgress(progress, 1.0);
  return distance;
}

} // namespace hasp
