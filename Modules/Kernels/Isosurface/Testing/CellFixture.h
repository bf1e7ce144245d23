#pragma once
#include "Isosurface/ActiveCells.h"

#include <random>
#include <vector>

namespace hasp::testing
{

/// Every byte of them is the same.
inline bool SameCells(const ClusteredCells& a, const ClusteredCells& b)
{
  const GridGeometry &g = a.geometry, &h = b.geometry;
  return g.dims == h.dims && g.origin == h.origin && g.spacing == h.spacing &&
         g.direction == h.direction && a.isovalue == b.isovalue && a.cornerType == b.cornerType &&
         a.precision == b.precision && a.count == b.count && a.clusters == b.clusters &&
         a.corners == b.corners && a.levels == b.levels && a.labels == b.labels &&
         a.colors == b.colors && a.firstColors == b.firstColors;
}

/// Noise in [0, 200]: about as many cells active at 100 as can be.
template <typename T>
std::vector<T> Noise(const GridGeometry& geometry, unsigned seed = 1)
{
  std::mt19937 engine(seed);
  std::vector<T> samples(geometry.Size());
  for (T& sample : samples)
    sample = static_cast<T>(engine() % 201);
  return samples;
}

/// Of a volume in memory.
inline ClusteredCells CellsOf(
  const AnyGridView& grid, double isovalue, CellPrecision precision = CellPrecision::Exact)
{
  return ExtractActiveCells(grid, MinMaxBlocks(grid), isovalue, precision);
}

} // namespace hasp::testing
