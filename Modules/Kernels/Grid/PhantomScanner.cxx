#include "Grid/ParallelFor.h"
#include "Grid/PhantomScene.h"
#include "Grid/ScannerFaults.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <stdexcept>

namespace hasp
{
namespace
{

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
  const ScannerFaults faults(grid, settings, settings.center, MakePhantomShapes(settings).metal);
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
              RoundedSample(faults(values[tile.Offset(at)], at));
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
  const ScannerFaults faults(grid, settings, settings.center, MakePhantomShapes(settings).metal);
  const auto slice = [&](std::int64_t k, std::int64_t)
  {
    const Tile tile{ { 0, 0, int(k) }, { grid.dims.x, grid.dims.y, int(k) + 1 } };
    const std::size_t start = std::size_t(k - first) * grid.dims.x * grid.dims.y;
    ForEachSample(tile,
      [&](const glm::ivec3& at)
      {
        samples[start + tile.Offset(at)] =
          RoundedSample(faults(scene.Value(grid.IndexToWorld(at)), at));
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
