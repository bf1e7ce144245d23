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

/// Lower envelope of the parabolas f(q) + step^2 (p - q)^2; winner[p] is the q that is lowest at p.
class LowerEnvelope
{
public:
  explicit LowerEnvelope(int length) : Apex(length), From(length + 1) {}

  void Winners(const float* f, int length, double step, int* winner)
  {
    const double scale = 1.0 / (step * step);
    int count = 0;
    for (int q = 0; q < length; ++q)
    {
      if (f[q] == Infinity)
        continue;
      double from = -std::numeric_limits<double>::infinity();
      while (count > 0)
      {
        const int v = this->Apex[count - 1];
        from =
          0.5 * ((double(f[q]) - double(f[v])) * scale / double(q - v) + double(q) + double(v));
        if (from > this->From[count - 1])
          break;
        --count;
        from = -std::numeric_limits<double>::infinity();
      }
      this->Apex[count] = q;
      this->From[count++] = from;
    }
    int at = 0;
    for (int p = 0; p < length; ++p)
    {
      while (at + 1 < count && this->From[at + 1] < p)
        ++at;
      winner[p] = count ? this->Apex[at] : -1;
    }
  }

private:
  std::vector<int> Apex;
  std::vector<double> From;
};

/// One pass along an axis over `lines` lines that are neighbours in memory.
struct Lines
{
  std::size_t first;  ///< offset of the first voxel of the first line
  std::size_t stride; ///< from voxel to voxel of a line
  int lines, length;
};

void SweepLines(FeatureTransform& map, const Lines& at, double step)
{
  const std::size_t n = at.length;
  std::vector<float> f(n * at.lines);
  std::vector<std::uint32_t> seed(n * at.lines);
  std::vector<int> winner(n);
  LowerEnvelope envelope(at.length);
  for (std::size_t p = 0; p < n; ++p)
    for (int l = 0; l < at.lines; ++l)
    {
      f[l * n + p] = map.squared[at.first + p * at.stride + l];
      seed[l * n + p] = map.seed[at.first + p * at.stride + l];
    }
  for (int l = 0; l < at.lines; ++l)
  {
    const float* line = &f[l * n];
    envelope.Winners(line, at.length, step, winner.data());
    for (std::size_t p = 0; p < n && winner[p] >= 0; ++p)
    {
      const double along = step * (double(p) - winner[p]);
      const std::size_t to = at.first + p * at.stride + l;
      map.squared[to] = static_cast<float>(line[winner[p]] + along * along);
      map.seed[to] = seed[l * n + winner[p]];
    }
  }
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
} // namespace

FeatureTransform NearestSeeds(const GridGeometry& geometry, std::span<const std::uint8_t> seeds,
  const ProgressFunction& progress)
{
  geometry.Validate();
  const std::size_t size = geometry.Size();
  if (seeds.size() != size || size >= FeatureTransform::NoSeed)
    throw std::invalid_argument("distance transform: " + std::to_string(seeds.size()) +
                                " seeds for " + std::to_string(size) +
                                " voxels; both must be the same and below 2^32 - 1");
  FeatureTransform map{ std::vector<float>(size, Infinity),
    std::vector<std::uint32_t>(size, FeatureTransform::NoSeed) };
  const std::int64_t nx = geometry.dims.x, ny = geometry.dims.y, nz = geometry.dims.z;
  const std::int64_t blocks = (nx + Block - 1) / Block;
  const auto width = [&](std::int64_t x)
  { return static_cast<int>(std::min<std::int64_t>(Block, nx - x)); };

  ParallelFor(0, ny * nz, 64,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t row = first; row < last; ++row)
        SweepRow(map, seeds, row * nx, geometry.dims.x, geometry.spacing.x);
    });
  ReportProgress(progress, 0.2);
  ParallelFor(0, blocks * nz, 4,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t b = first; b < last; ++b)
      {
        const std::int64_t x = b % blocks * Block, z = b / blocks;
        SweepLines(map, { std::size_t(z * ny * nx + x), std::size_t(nx), width(x), int(ny) },
          geometry.spacing.y);
      }
    });
  ReportProgress(progress, 0.6);
  ParallelFor(0, blocks * ny, 4,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t b = first; b < last; ++b)
      {
        const std::int64_t x = b % blocks * Block, y = b / blocks;
        SweepLines(map, { std::size_t(y * nx + x), std::size_t(nx * ny), width(x), int(nz) },
          geometry.spacing.z);
      }
    });
  ReportProgress(progress, 1.0);
  return map;
}

std::vector<float> SignedEuclideanDistance(const GridGeometry& geometry,
  std::span<const std::uint8_t> inside, const ProgressFunction& progress)
{
  const auto half = [&](double from)
  { return [&progress, from](double share) { return !progress || progress(from + 0.5 * share); }; };
  const float halfVoxel = 0.5F * static_cast<float>(std::min(
                                   { geometry.spacing.x, geometry.spacing.y, geometry.spacing.z }));
  std::vector<float> distance = NearestSeeds(geometry, inside, half(0.0)).squared;
  std::vector<std::uint8_t> outside(inside.size());
  std::transform(inside.begin(), inside.end(), outside.begin(), [](auto v) { return v ? 0 : 1; });
  const std::vector<float> within = NearestSeeds(geometry, outside, half(0.5)).squared;
  for (std::size_t v = 0; v < distance.size(); ++v)
    distance[v] = inside[v] ? halfVoxel - std::sqrt(within[v]) : std::sqrt(distance[v]) - halfVoxel;
  return distance;
}

} // namespace hasp
