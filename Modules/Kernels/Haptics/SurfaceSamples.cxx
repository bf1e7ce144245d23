#include "Haptics/SurfaceSamples.h"
#include "Grid/ParallelFor.h"
#include "Grid/Trilinear.h"
#include "Haptics/CellTriangles.h"
#include "Haptics/Hash.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace hasp
{

namespace
{

/// Calls visit(cell, triangle) for the surface in one layer of cells, always in the same order.
template <typename Visit>
void InLayer(const GridView<const float>& grid, int k, const Visit& visit)
{
  const glm::ivec3 cells = grid.geometry.Cells();
  for (int j = 0; j < cells.y; ++j)
  {
    const float* rows[] = { &grid(0, j, k), &grid(0, j + 1, k), &grid(0, j, k + 1),
      &grid(0, j + 1, k + 1) };
    const auto anyInside = [&](int i) {
      return rows[0][i] <= 0.0F || rows[1][i] <= 0.0F || rows[2][i] <= 0.0F || rows[3][i] <= 0.0F;
    };
    const auto anyOutside = [&](int i)
    { return rows[0][i] > 0.0F || rows[1][i] > 0.0F || rows[2][i] > 0.0F || rows[3][i] > 0.0F; };
    for (int i = 0; i < cells.x; ++i)
    {
      if (!(anyInside(i) || anyInside(i + 1)) || !(anyOutside(i) || anyOutside(i + 1)))
        continue;
      const std::array<double, 8> values = CellCorners(grid, { i, j, k });
      if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
        continue;
      InCell(values,
        [&](const CellTriangle& t)
        {
          visit(glm::ivec3(i, j, k), t);
          return false;
        });
    }
  }
}

/// Newton's steps along the gradient to the trilinear surface. False if it is not near.
bool MoveToSurface(const GridView<const float>& grid, glm::dvec3& index, glm::dvec3& normal)
{
  const GridGeometry& g = grid.geometry;
  const double voxel = std::min({ g.spacing.x, g.spacing.y, g.spacing.z });
  double off = 0.0;
  for (int step = 0; step < 5; ++step)
  {
    const auto at = LocateCell(g, index);
    if (!at)
      return false;
    const std::array<double, 8> corners = CellCorners(grid, at->cell);
    const glm::dvec3 perStep = TrilinearGradient(corners, at->local) / g.spacing; // mm per mm
    const double squared = glm::dot(perStep, perStep);
    if (!(squared > 1e-12 && std::isfinite(squared)))
      return false;
    normal = g.direction * (perStep / std::sqrt(squared));
    off = TrilinearValue(corners, at->local) / std::sqrt(squared);
    if (std::abs(off) < 1e-6 * voxel)
      break;
    const double move = std::clamp(off, -0.5 * voxel, 0.5 * voxel);
    const glm::dvec3 next = index - move * (perStep / std::sqrt(squared)) / g.spacing;
    index = glm::clamp(next, glm::dvec3(0.0), glm::dvec3(g.dims - 1));
  }
  return std::abs(off) < 0.1 * voxel;
}

/// The surface's area in each layer of cells, and how the points are shared out to layers.
class Shares
{
public:
  Shares(std::vector<double> areas, std::size_t count, std::uint32_t seed)
    : Ends(std::move(areas)),
      Points(count),
      Seed(seed)
  {
    double sum = 0.0;
    for (double& end : this->Ends)
      end = sum += end;
    this->Area = sum;
  }
  double Total() const { return this->Area; }
  double Begin(int layer) const { return layer == 0 ? 0.0 : this->Ends[layer - 1]; }
  double End(int layer) const { return this->Ends[layer]; }
  /// Where along the area of all cells point n lies: one to each equal share, ascending.
  double Place(std::size_t n) const
  {
    const double u = UnitHash(this->Seed, 3 * n);
    return std::min((n + u) / this->Points, OneBelow) * this->Area;
  }
  /// The first point at or beyond a place.
  std::size_t FirstFrom(double place) const
  {
    auto n = static_cast<std::size_t>(std::max(0.0, place / this->Area * this->Points - 2.0));
    while (n < this->Points && this->Place(n) < place)
      ++n;
    return n;
  }

private:
  static constexpr double OneBelow = 1.0 - 0x1p-50;
  std::vector<double> Ends;
  double Area = 0.0;
  std::size_t Points;
  std::uint32_t Seed;
};

/// Calls layer(k) for all layers of cells, on all cores.
template <typename Layer>
void OverLayers(int layers, const ProgressFunction& progress, double from, const Layer& layer)
{
  constexpr int AtOnce = 16;
  for (int k = 0; k < layers; k += AtOnce)
  {
    ReportProgress(progress, from + 0.5 * k / layers);
    ParallelFor(k, std::min(k + AtOnce, layers), 1,
      [&](std::int64_t first, std::int64_t) { layer(static_cast<int>(first)); });
  }
}

} // namespace

SurfaceSamples SampleSurface(const GridView<const float>& distances, const glm::dvec3& origin,
  std::size_t count, std::uint32_t seed, const ProgressFunction& progress)
{
  const GridGeometry& g = distances.geometry;
  const glm::ivec3 cells = g.Cells();
  const int layers = cells.x > 0 && cells.y > 0 ? cells.z : 0;
  std::vector<double> areas(layers, 0.0);
  OverLayers(layers, progress, 0.0,
    [&](int k)
    {
      InLayer(distances, k,
        [&](const glm::ivec3&, const CellTriangle& t) { areas[k] += AreaOf(t, g.spacing); });
    });
  const Shares shares(std::move(areas), count, seed);
  SurfaceSamples samples{ {}, shares.Total() };
  if (!(shares.Total() > 0.0) || count == 0)
    return samples;

  std::vector<SurfacePoint> made(count);
  std::vector<std::uint8_t> good(count, 0);
  const auto place = [&](std::size_t n, const glm::ivec3& cell, const CellTriangle& t)
  {
    const double u = UnitHash(seed, 3 * n + 1), v = UnitHash(seed, 3 * n + 2);
    glm::dvec3 index = glm::dvec3(cell) + PointIn(t, u, v), normal{ 0.0 };
    if (!MoveToSurface(distances, index, normal))
      return;
    made[n] = { g.IndexToWorld(index) - origin, normal };
    good[n] = 1;
  };
  OverLayers(layers, progress, 0.5,
    [&](int k)
    {
      const double begin = shares.Begin(k), end = shares.End(k);
      if (end <= begin)
        return;
      std::size_t n = shares.FirstFrom(begin);
      double sum = 0.0;
      glm::ivec3 lastCell{ 0 };
      CellTriangle last{};
      InLayer(distances, k,
        [&](const glm::ivec3& cell, const CellTriangle& t)
        {
          sum += AreaOf(t, g.spacing);
          lastCell = cell;
          last = t;
          for (; n < count && shares.Place(n) < std::min(begin + sum, end); ++n)
            place(n, cell, t);
        });
      for (; n < count && shares.Place(n) < end; ++n) // what rounding left over
        place(n, lastCell, last);
    });
  for (std::size_t n = 0; n < count; ++n)
    if (good[n] != 0)
      samples.points.push_back(made[n]);
  return samples;
}

} // namespace hasp
