#include "Grid/ParallelFor.h"
#include "Grid/PhantomScene.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hasp
{
namespace
{

/// A number in (0,1) that depends on the key alone: splitmix64.
double Uniform(std::uint64_t x)
{
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return (double((x ^ (x >> 31)) >> 11) + 0.5) * 0x1p-53;
}

/// Noise that depends on the sample's number alone, so that threads do not matter: Box-Muller.
double Normal(std::uint64_t seed, std::uint64_t sample)
{
  const std::uint64_t key = seed * 0xd1342543de82ef95U + 2 * sample;
  return std::sqrt(-2.0 * std::log(Uniform(key))) *
         std::cos(glm::two_pi<double>() * Uniform(key + 1));
}

std::int16_t Rounded(double value)
{
  return static_cast<std::int16_t>(std::clamp(std::round(value), -32768.0, 32767.0));
}

/// What a scanner does to the values of the scene: everything that is not blur.
class Faults
{
public:
  Faults(const GridGeometry& grid, const PhantomSettings& settings)
    : Grid(grid),
      Settings(settings),
      Crowns(MakePhantomShapes(settings).metal)
  {
  }
  bool Any() const
  {
    return this->Settings.noiseHU > 0.0 || !this->Crowns.empty() || this->Settings.coneBeam.on ||
           this->Settings.fieldRadiusMm > 0.0;
  }
  double operator()(double value, const glm::ivec3& index) const
  {
    if (!this->Any())
      return value;
    const PhantomSettings& s = this->Settings;
    const glm::dvec3 point = this->Grid.IndexToWorld(index);
    const glm::dvec2 off(point - s.center);
    const double radius = glm::length(off);
    if (s.fieldRadiusMm > 0.0 && radius > s.fieldRadiusMm)
      return s.coneBeam.on ? s.coneBeam.scale * s.airHU + s.coneBeam.offset : s.airHU;
    value += this->Streaks(point);
    if (s.coneBeam.on)
    {
      const double out = std::min(radius / s.coneBeam.cupRadiusMm, 1.0);
      const double cupped = (value + 1000.0) * (1.0 - s.coneBeam.cupping * (1.0 - out * out));
      value = s.coneBeam.scale * (cupped - 1000.0) + s.coneBeam.offset;
    }
    return s.noiseHU > 0.0 ? value + s.noiseHU * this->Noise(index) : value;
  }

private:
  double Noise(const glm::ivec3& at) const
  {
    const std::uint64_t row = this->Grid.dims.x;
    const std::uint64_t sample =
      (std::uint64_t(at.z) * this->Grid.dims.y + at.y) * row + std::uint64_t(at.x);
    if (!this->Settings.grain)
      return Normal(this->Settings.seed, sample);
    // Weights 1 2 1 both ways, scaled so that the variance stays 1: 36 = (1 + 4 + 1)^2.
    double sum = 0.0;
    for (int b = -1; b <= 1; ++b)
      for (int a = -1; a <= 1; ++a)
        sum += (2 - a * a) * (2 - b * b) *
               Normal(this->Settings.seed, sample + std::uint64_t(b) * row + std::uint64_t(a));
    return sum / 6.0;
  }

  /// Rays that leave a crown at distance `out` from its middle, in a pattern of its own.
  double Rays(const glm::dvec2& out, double crownRadius, std::uint64_t crown) const
  {
    const MetalModel& m = this->Settings.metal;
    const double away = glm::length(out), angle = std::atan2(out.y, out.x);
    double pattern = 0.0;
    for (std::uint64_t n = 0; n < 3; ++n)
      pattern +=
        std::cos(double(5 + 6 * n) * angle +
                 glm::two_pi<double>() * Uniform(this->Settings.seed * 31 + 3 * crown + n)) /
        3.0;
    const double ramp = std::min(away / crownRadius, 1.0); // the angle has no meaning in the middle
    return m.streakHU * pattern * ramp * std::exp(-std::max(away - crownRadius, 0.0) / m.decayMm);
  }

  double Streaks(const glm::dvec3& point) const
  {
    const MetalModel& m = this->Settings.metal;
    double sum = 0.0;
    for (std::size_t n = 0; n < this->Crowns.size(); ++n)
    {
      const RoundConeShape& crown = this->Crowns[n];
      const glm::dvec3 d = point - 0.5 * (crown.a + crown.b);
      const double off = d.z / m.sliceMm;
      if (std::abs(off) > 4.0)
        continue;
      const double slice = std::exp(-0.5 * off * off);
      sum += slice * this->Rays(glm::dvec2(d), crown.radiusB, n);
      for (std::size_t k = 0; k < n; ++k)
      {
        const glm::dvec2 way(this->Crowns[k].b - crown.b);
        const double t = glm::dot(glm::dvec2(d), way) / glm::dot(way, way);
        const double across = glm::length(glm::dvec2(d) - t * way) / crown.radiusB;
        const double between = std::clamp(8.0 * std::min(t, 1.0 - t), 0.0, 1.0);
        sum -= slice * m.bandHU * between * std::exp(-0.5 * across * across);
      }
    }
    return sum;
  }

  GridGeometry Grid;
  PhantomSettings Settings;
  std::vector<RoundConeShape> Crowns;
};

/// A box of samples, `to` not included.
struct Tile
{
  glm::ivec3 from, to;

  std::size_t Offset(const glm::ivec3& at) const
  {
    const glm::ivec3 size = this->to - this->from, d = at - this->from;
    return (static_cast<std::size_t>(d.z) * size.y + d.y) * size.x + d.x;
  }
};

template <typename Body>
void ForEachSample(const Tile& tile, const Body& body)
{
  for (int k = tile.from.z; k < tile.to.z; ++k)
    for (int j = tile.from.y; j < tile.to.y; ++j)
      for (int i = tile.from.x; i < tile.to.x; ++i)
        body(glm::ivec3(i, j, k));
}

/// The scene as all samples of a box see it.
PhantomScene NearBox(const PhantomScene& scene, const GridGeometry& grid, const Tile& box)
{
  const glm::dvec3 middle = 0.5 * glm::dvec3(box.from + box.to - 1);
  const glm::dvec3 half = 0.5 * grid.spacing * glm::dvec3(box.to - box.from - 1);
  // Directions may be 1e-4 off from orthonormal.
  return scene.Near(grid.IndexToWorld(middle), 1.001 * glm::length(half));
}

/// Halves the box until no surface is near, or few samples are left.
void FillBox(const PhantomScene& scene, const GridGeometry& grid, const Tile& tile, const Tile& box,
  std::vector<double>& values)
{
  constexpr int FewSamples = 64;
  const PhantomScene near = NearBox(scene, grid, box);
  if (near.paints.empty())
    return ForEachSample(box, [&](const glm::ivec3& at) { values[tile.Offset(at)] = near.base; });
  const glm::ivec3 size = box.to - box.from;
  if (size.x * size.y * size.z <= FewSamples)
    return ForEachSample(box,
      [&](const glm::ivec3& at) { values[tile.Offset(at)] = near.Value(grid.IndexToWorld(at)); });
  const glm::dvec3 extent = grid.spacing * glm::dvec3(size - 1);
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  Tile below = box, above = box;
  below.to[axis] = above.from[axis] = box.from[axis] + size[axis] / 2;
  FillBox(near, grid, tile, below, values);
  FillBox(near, grid, tile, above, values);
}

void CheckSlab(const GridGeometry& grid, int first, int last, std::size_t places)
{
  grid.Validate();
  if (!(0 <= first && first <= last && last <= grid.dims.z))
    throw std::invalid_argument("phantom: slices " + std::to_string(first) + " to " +
                                std::to_string(last) + " of " + std::to_string(grid.dims.z));
  const std::size_t needed = static_cast<std::size_t>(grid.dims.x) * grid.dims.y * (last - first);
  if (places != needed)
    throw std::invalid_argument("phantom: room for " + std::to_string(places) +
                                " samples, the slab has " + std::to_string(needed));
}

} // namespace

void SamplePhantomSlab(const GridGeometry& grid, const PhantomSettings& settings, int first,
  int last, std::span<std::int16_t> samples, const ProgressFunction& progress)
{
  CheckPhantom(settings);
  CheckSlab(grid, first, last, samples.size());
  const PhantomScene scene(settings);
  const Faults faults(grid, settings);
  constexpr glm::ivec3 Side(64, 32, 16);
  const glm::ivec3 tiles = (grid.dims + Side - 1) / Side;
  const auto layer = [&](int k)
  {
    ParallelFor(0, std::int64_t(tiles.x) * tiles.y, 1,
      [&](std::int64_t begin, std::int64_t)
      {
        const glm::ivec3 from(int(begin % tiles.x) * Side.x, int(begin / tiles.x) * Side.y, k);
        const Tile tile{ from, glm::min(from + Side, glm::ivec3(grid.dims.x, grid.dims.y, last)) };
        std::vector<double> values(tile.Offset(tile.to - 1) + 1);
        FillBox(scene, grid, tile, tile, values);
        ForEachSample(tile,
          [&](const glm::ivec3& at)
          {
            samples[(std::size_t(at.z - first) * grid.dims.y + at.y) * grid.dims.x + at.x] =
              Rounded(faults(values[tile.Offset(at)], at));
          });
      });
  };
  for (int k = first; k < last; k += Side.z)
  {
    ReportProgress(progress, double(k - first) / (last - first));
    layer(k);
  }
  ReportProgress(progress, 1.0);
}

void SamplePhantomPlainly(const GridGeometry& grid, const PhantomSettings& settings, int first,
  int last, std::span<std::int16_t> samples)
{
  CheckPhantom(settings);
  CheckSlab(grid, first, last, samples.size());
  const PhantomScene scene(settings);
  const Faults faults(grid, settings);
  const auto slice = [&](std::int64_t k, std::int64_t)
  {
    const Tile tile{ { 0, 0, int(k) }, { grid.dims.x, grid.dims.y, int(k) + 1 } };
    const std::size_t start = std::size_t(k - first) * grid.dims.x * grid.dims.y;
    ForEachSample(tile,
      [&](const glm::ivec3& at) {
        samples[start + tile.Offset(at)] = Rounded(faults(scene.Value(grid.IndexToWorld(at)), at));
      });
  };
  ParallelFor(first, last, 1, slice);
}

std::vector<std::int16_t> SamplePhantom(
  const GridGeometry& geometry, const PhantomSettings& settings)
{
  CheckPhantom(settings);
  geometry.Validate();
  std::vector<std::int16_t> samples(geometry.Size());
  SamplePhantomSlab(geometry, settings, 0, geometry.dims.z, samples);
  return samples;
}

} // namespace hasp
