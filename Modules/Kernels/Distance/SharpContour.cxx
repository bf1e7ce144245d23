#include "Distance/SharpContour.h"
#include "Distance/BlockContour.h"
#include "Distance/ContourSize.h"
#include "Distance/KuhnTetrahedra.h"
#include "Grid/ParallelFor.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr int BlockCells = 8;
constexpr double MostFloatStep = 1e-3;
constexpr std::int64_t BatchBlocks = 4096; ///< between two reports of progress

/// Puts the blocks' meshes into one. Points on the sides of blocks, which several have, are told by
/// their coordinates: these have the same bits in each.
class Welder
{
public:
  explicit Welder(const GridGeometry& grid) : Mirrored(glm::determinant(grid.direction) < 0.0) {}

  void Add(const BlockContour& block)
  {
    this->NewId.clear();
    for (std::size_t n = 0; n < block.Points.size(); ++n)
      this->NewId.push_back(this->Id(block.Indices[n], block.Points[n]));
    for (const glm::uvec3& t : block.Triangles)
    {
      glm::uvec3 triangle(this->NewId[t.x], this->NewId[t.y], this->NewId[t.z]);
      if (this->Mirrored)
        std::swap(triangle.y, triangle.z);
      this->Mesh.triangles.push_back(triangle);
    }
  }

  TriangleMesh Mesh;

private:
  struct Hash
  {
    std::size_t operator()(const glm::dvec3& p) const
    {
      const std::hash<double> hash;
      return (hash(p.x) * 0x9E3779B97F4A7C15U + hash(p.y)) * 0x9E3779B97F4A7C15U + hash(p.z);
    }
  };

  std::uint32_t Id(const glm::dvec3& index, const glm::dvec3& world)
  {
    const glm::dvec3 blocks = index / double(BlockCells);
    const bool shared = glm::any(glm::equal(blocks, glm::floor(blocks)));
    const std::size_t next = this->Mesh.points.size();
    if (next >= std::numeric_limits<std::uint32_t>::max())
      throw std::invalid_argument("sharp contour: more than 2^32 - 1 points; use a coarser grid");
    if (shared)
    {
      const auto [found, isNew] = this->Shared.try_emplace(index, std::uint32_t(next));
      if (!isNew)
        return found->second;
    }
    this->Mesh.points.push_back(world);
    return std::uint32_t(next);
  }

  bool Mirrored;
  std::vector<std::uint32_t> NewId;
  std::unordered_map<glm::dvec3, std::uint32_t, Hash> Shared;
};

/// Every side of a triangle has its opposite: sums of numbers that say nothing of each other.
bool IsClosed(const TriangleMesh& mesh)
{
  const auto number = [](std::uint64_t a, std::uint64_t b)
  {
    std::uint64_t n = (a << 32 | b) + 0x9E3779B97F4A7C15U; // splitmix64
    n = (n ^ n >> 30) * 0xBF58476D1CE4E5B9U;
    n = (n ^ n >> 27) * 0x94D049BB133111EBU;
    return n ^ n >> 31;
  };
  std::uint64_t sum = 0;
  for (const glm::uvec3& t : mesh.triangles)
    for (int n = 0; n < 3; ++n)
      sum += number(t[n], t[(n + 1) % 3]) - number(t[(n + 1) % 3], t[n]);
  return sum == 0;
}

/// Steps of 32-bit floats at the grid's furthest corner, in shares of its shortest spacing.
double FloatStep(const GridGeometry& grid)
{
  float furthest = 0.0F;
  for (int c = 0; c < 8; ++c)
  {
    const glm::dvec3 world = glm::abs(grid.IndexToWorld(glm::dvec3(CellCorner(c) * grid.Cells())));
    furthest = std::max(furthest, float(std::max({ world.x, world.y, world.z })));
  }
  return (std::nextafter(furthest, std::numeric_limits<float>::max()) - furthest) /
         std::min({ grid.spacing.x, grid.spacing.y, grid.spacing.z });
}

void Check(const GridGeometry& grid, const SharpContourSettings& settings)
{
  grid.Validate();
  std::ostringstream fault;
  if (!(settings.tolerance >= 0.001 && settings.tolerance <= 0.1))
    fault << "tolerance is " << settings.tolerance << " of a cell, must be in [0.001, 0.1]. ";
  for (int a = 0; a < 3; ++a)
    if (grid.dims[a] > 1 << 20)
      fault << "dims[" << a << "] is " << grid.dims[a] << ", must be at most 2^20. ";
  if (fault.str().empty() && !(FloatStep(grid) <= MostFloatStep))
    fault << "32-bit floats come in steps of " << FloatStep(grid)
          << " of a cell at the grid's furthest corner, must be at most " << MostFloatStep
          << ": move the grid towards 0, or make its spacing larger. ";
  if (!fault.str().empty())
    throw std::invalid_argument("sharp contour: " + fault.str());
}

[[noreturn]] void RefuseSize(const std::string& triangles, const SharpContourSettings& settings)
{
  throw std::invalid_argument("sharp contour: " + triangles + " triangles, and at most " +
                              std::to_string(settings.mostTriangles) +
                              " were asked for: use a coarser grid, less of the solid, or a larger "
                              "limit");
}

/// Before any work: is it too much? Not asked of a grid that cannot hold so many.
void CheckSize(const BoundedSolid& solid, const GridGeometry& grid, std::int64_t blocks,
  const SharpContourSettings& settings)
{
  constexpr double MostPerBlock = 12.0 * BlockCells * BlockCells * BlockCells;
  if (double(blocks) * MostPerBlock <= double(settings.mostTriangles))
    return;
  const double triangles = EstimateTriangles(solid, grid);
  if (triangles <= 2.0 * double(settings.mostTriangles)) // it may be half of that
    return;
  std::ostringstream text;
  text.precision(2);
  text << "there would be about " << triangles;
  RefuseSize(text.str(), settings);
}
} // namespace

TriangleMesh SharpContour(const ImplicitSolid& solid, const GridGeometry& grid,
  const SharpContourSettings& settings, SharpContourFacts* facts, const ProgressFunction& progress)
{
  Check(grid, settings);
  const BoundedSolid bounded(solid, grid);
  const ContourLimits limits{ settings.tolerance * bounded.Cell(),
    FloatStep(grid) * bounded.Cell() };
  const glm::i64vec3 blocks =
    (glm::i64vec3(grid.Cells()) + std::int64_t(BlockCells - 1)) / std::int64_t(BlockCells);
  const std::int64_t count = blocks.x * blocks.y * blocks.z;
  CheckSize(bounded, grid, count, settings);
  SharpContourFacts made;
  made.blocks = std::size_t(count);
  Welder welder(grid);
  for (std::int64_t begin = 0; begin < count; begin += BatchBlocks)
  {
    const std::int64_t end = std::min(count, begin + BatchBlocks);
    std::vector<std::unique_ptr<BlockContour>> contours(std::size_t(end - begin));
    ParallelFor(begin, end, 1,
      [&](std::int64_t first, std::int64_t)
      {
        const glm::ivec3 at(
          first % blocks.x, first / blocks.x % blocks.y, first / (blocks.x * blocks.y));
        auto contour = std::make_unique<BlockContour>(bounded, grid, limits);
        contour->Contour(at * BlockCells, BlockCells);
        contour->FreeWork();
        if (contour->Cells > 0)
          contours[std::size_t(first - begin)] = std::move(contour);
      });
    for (const auto& contour : contours)
      if (contour)
      {
        welder.Add(*contour);
        if (welder.Mesh.triangles.size() > settings.mostTriangles)
          RefuseSize("there are more than " + std::to_string(settings.mostTriangles), settings);
        ++made.blocksHeld;
        made.cells += contour->Cells;
        made.splits += contour->Splits;
        made.creasePoints += contour->CreasePoints;
        made.keptInside += contour->KeptInside;
        made.leastHeight = std::min(made.leastHeight, contour->LeastSteps);
      }
    ReportProgress(progress, double(end) / double(count));
  }
  if (!IsClosed(welder.Mesh))
    throw std::runtime_error("sharp contour: the solid's value changes by more than 1 mm a mm, so "
                             "that surface was left out; scale it down");
  if (facts)
    *facts = made;
  return std::move(welder.Mesh);
}

} // namespace hasp
