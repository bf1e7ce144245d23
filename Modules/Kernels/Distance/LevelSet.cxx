#include "Distance/LevelSet.h"

#include "Grid/ParallelFor.h"
#include "LevelSetCells.h"
#include "SolidChecks.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

namespace hasp
{

namespace
{
using Tree = openvdb::FloatTree;
using Leaf = Tree::LeafNodeType;

constexpr int Side = static_cast<int>(Leaf::DIM); // voxels

double Checked(const GridGeometry& geometry, double bandVoxels)
{
  geometry.Validate();
  const glm::ivec3 d = geometry.dims;
  if (std::min({ d.x, d.y, d.z }) < 2)
    throw std::invalid_argument("level set: " + std::to_string(d.x) + " x " + std::to_string(d.y) +
                                " x " + std::to_string(d.z) +
                                " samples; each axis needs two at least");
  const glm::dvec3& h = geometry.spacing;
  const double unit = std::min({ h.x, h.y, h.z }), diagonal = glm::length(h) / unit;
  if (!(bandVoxels >= diagonal && bandVoxels <= std::max(1000.0, diagonal)))
    throw std::invalid_argument("level set: a band of " + SolidNumber(bandVoxels) +
                                " voxels; it must be in [" + SolidNumber(diagonal) +
                                ", 1000], the diagonal of a voxel at least");
  return bandVoxels * unit;
}

openvdb::math::Transform::Ptr TransformOf(const GridGeometry& geometry)
{
  const glm::dmat3 step = geometry.IndexToWorldMatrix();
  const glm::dvec3& o = geometry.origin;
  openvdb::math::Mat4d rows = openvdb::math::Mat4d::identity(); // of row vectors
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      rows(a, b) = step[a][b];
  rows.setTranslation({ o.x, o.y, o.z });
  return openvdb::math::Transform::createLinearTransform(rows);
}

/// Dense distances, cut off at the outermost samples, a block of OpenVDB's leaves at a time.
class Blocks
{
public:
  Blocks(const GridView<const float>& distances, double background)
    : Distances(distances),
      Last(distances.geometry.Cells()),
      Background(static_cast<float>(background))
  {
    for (int a = 0; a < 3; ++a)
    {
      const double reach = std::ceil(background / distances.geometry.spacing[a]);
      this->First[a] = static_cast<int>(std::floor(-reach / Side));
      this->Count[a] =
        static_cast<int>(std::floor((this->Last[a] + reach) / Side)) - this->First[a] + 1;
    }
  }

  /// Leaves, and whole blocks inside, of one slab of blocks.
  struct Slab
  {
    std::vector<std::unique_ptr<Leaf>> leaves;
    std::vector<openvdb::Coord> inside;
  };

  std::int64_t Slabs() const { return this->Count.z; }

  /// False if a value is NaN.
  bool Fill(int k, Slab& slab) const
  {
    for (int j = 0; j < this->Count.y; ++j)
      for (int i = 0; i < this->Count.x; ++i)
        if (!this->FillBlock((this->First + glm::ivec3(i, j, k)) * Side, slab))
          return false;
    return true;
  }

private:
  bool FillBlock(const glm::ivec3& low, Slab& slab) const
  {
    float values[Leaf::SIZE];
    bool near = false;
    for (int x = 0; x < Side; ++x)
      for (int y = 0; y < Side; ++y)
        for (int z = 0; z < Side; ++z)
        {
          const float v = this->Value(low + glm::ivec3(x, y, z));
          if (std::isnan(v))
            return false;
          near = near || std::abs(v) < this->Background;
          values[(x * Side + y) * Side + z] = v;
        }
    const openvdb::Coord origin(low.x, low.y, low.z);
    if (near)
    {
      auto leaf = std::make_unique<Leaf>(origin, this->Background, false);
      for (openvdb::Index n = 0; n < Leaf::SIZE; ++n)
        if (std::abs(values[n]) < this->Background)
          leaf->setValueOn(n, values[n]);
        else
          leaf->setValueOff(n, std::copysign(this->Background, values[n]));
      slab.leaves.push_back(std::move(leaf));
    }
    else if (values[0] < 0.0F) // the band is wider than a voxel: all of one sign
      slab.inside.push_back(origin);
    return true;
  }

  /// The greater of the distance at the nearest sample and that to the box of all samples.
  float Value(const glm::ivec3& p) const
  {
    const glm::ivec3 q = glm::clamp(p, glm::ivec3(0), this->Last);
    const glm::dvec3& h = this->Distances.geometry.spacing;
    const glm::dvec3 depth = glm::dvec3(glm::min(p, this->Last - p)) * h;
    const double least = std::min({ depth.x, depth.y, depth.z });
    const double box = least < 0.0 ? glm::length(glm::min(depth, glm::dvec3(0.0))) : -least;
    const float v = this->Distances(q.x, q.y, q.z);
    return std::isnan(v) ? v : std::max(v, static_cast<float>(box));
  }

  const GridView<const float>& Distances;
  glm::ivec3 Last, First{}, Count{};
  float Background;
};
} // namespace

openvdb::FloatGrid::Ptr LevelSetOf(
  const GridView<const float>& distances, double bandVoxels, const ProgressFunction& progress)
{
  const double background = Checked(distances.geometry, bandVoxels);
  const Blocks blocks(distances, background);
  auto grid = openvdb::FloatGrid::create(static_cast<float>(background));
  grid->setTransform(TransformOf(distances.geometry));
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  const std::int64_t step = std::max<std::int64_t>(8, blocks.Slabs() / 8);
  for (std::int64_t begin = 0; begin < blocks.Slabs(); begin += step)
  {
    ReportProgress(progress, double(begin) / double(blocks.Slabs()));
    std::vector<Blocks::Slab> slabs(std::min(step, blocks.Slabs() - begin));
    std::atomic<bool> sound{ true };
    ParallelFor(0, std::int64_t(slabs.size()), 1,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t k = first; k < last; ++k)
          if (!blocks.Fill(static_cast<int>(begin + k), slabs[k]))
            sound = false;
      });
    if (!sound)
      throw std::invalid_argument("level set: a distance is NaN; say what it stands for");
    for (Blocks::Slab& slab : slabs)
    {
      for (auto& leaf : slab.leaves)
        grid->tree().addLeaf(leaf.release());
      for (const openvdb::Coord& origin : slab.inside)
        grid->tree().addTile(1, origin, -static_cast<float>(background), false);
    }
  }
  grid->tree().prune();
  ReportProgress(progress, 1.0);
  return grid;
}

std::vector<float> SampleLevelSet(const openvdb::FloatGrid& levelSet, const GridGeometry& geometry)
{
  geometry.Validate();
  const LevelSetFrame frame(levelSet);
  std::vector<float> values(geometry.Size());
  const std::int64_t nx = geometry.dims.x, ny = geometry.dims.y;
  ParallelFor(0, ny * geometry.dims.z, 64,
    [&](std::int64_t first, std::int64_t last)
    {
      const LevelSetCells cells(levelSet);
      for (std::int64_t row = first; row < last; ++row)
        for (std::int64_t i = 0; i < nx; ++i)
        {
          const glm::dvec3 world = geometry.IndexToWorld(glm::dvec3(i, row % ny, row / ny));
          const auto [cell, local] = cells.Locate(frame.Index(world));
          values[row * nx + i] = static_cast<float>(TrilinearValue(cells.Corners(cell), local));
        }
    });
  return values;
}

} // namespace hasp
