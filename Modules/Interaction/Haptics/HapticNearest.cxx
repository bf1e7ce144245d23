// Which tool a hand means: HapticProps::Nearest.
#include "HapticProps.h"

#include "Grid/Trilinear.h"

#include "vtkProp3D.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hasp
{

namespace
{

/// Body axes, mm; infinity without points.
double DistanceTo(const PointShell& shell, const glm::dvec3& point)
{
  double least = std::numeric_limits<double>::infinity();
  std::vector<ShellDisc> discs;
  for (int level = 0; level < shell.Levels(); ++level)
  {
    discs.resize(shell.Level(level).count);
    discs.resize(CopyDiscs(shell.Level(level), 0, discs));
    for (const ShellDisc& disc : discs)
      least = std::min(least, glm::length(glm::dvec3(disc.center) - point));
  }
  return least;
}

/// The cells of a volume that an isosurface crosses, as boxes: the nearest to a point.
class CrossedCells
{
public:
  CrossedCells(const ShellVolume& volume, double isovalue, const glm::dvec3& world)
    : Volume(volume),
      Isovalue(isovalue),
      World(world),
      Geometry(GeometryOf(volume.grid)),
      Index(Geometry.WorldToIndex(world))
  {
  }

  /// mm; infinity if none is within reachMm.
  double Distance(double reachMm)
  {
    this->Reach = reachMm;
    const glm::ivec3 blocks = this->Volume.blocks->Blocks();
    ForEach(glm::ivec3(0), blocks,
      [this](const glm::ivec3& block)
      {
        if (this->Volume.blocks->Active(block, this->Isovalue) &&
            this->ToBox(MinMaxBlocks::Side * block, MinMaxBlocks::Side) < this->Bound())
          this->TakeBlock(block);
      });
    return this->Least;
  }

private:
  template <class Visit>
  static void ForEach(const glm::ivec3& from, const glm::ivec3& to, const Visit& visit)
  {
    for (int z = from.z; z < to.z; ++z)
      for (int y = from.y; y < to.y; ++y)
        for (int x = from.x; x < to.x; ++x)
          visit({ x, y, z });
  }

  double Bound() const { return std::min(this->Reach, this->Least); }

  double ToBox(const glm::ivec3& low, int side) const
  {
    const glm::dvec3 from(low), inside = glm::clamp(this->Index, from, from + double(side));
    return glm::length(this->Geometry.IndexToWorld(inside) - this->World);
  }

  void TakeBlock(const glm::ivec3& block)
  {
    const glm::ivec3 from = MinMaxBlocks::Side * block,
                     to = glm::min(from + MinMaxBlocks::Side, this->Geometry.dims - 1);
    std::visit(
      [&](const auto& grid)
      {
        ForEach(from, to,
          [&](const glm::ivec3& cell)
          {
            const double far = this->ToBox(cell, 1);
            if (!(far < this->Bound()))
              return;
            const auto corners = CellCorners(grid, cell);
            const auto [low, high] = std::minmax_element(corners.begin(), corners.end());
            if (*low < this->Isovalue && this->Isovalue <= *high)
              this->Least = far;
          });
      },
      this->Volume.grid);
  }

  const ShellVolume& Volume;
  double Isovalue;
  glm::dvec3 World;
  const GridGeometry& Geometry;
  glm::dvec3 Index;
  double Reach = 0.0, Least = std::numeric_limits<double>::infinity();
};

} // namespace

int HapticProps::Nearest(const glm::dvec3& point, double reachMm) const
{
  int nearest = -1;
  double least = reachMm;
  for (const HapticProp& it : this->Props)
  {
    if (it.tool < 0 || !it.prop || !this->ToolReady(it.tool))
      continue;
    const glm::dvec3 local = it.Pose().Inverse().Place(point);
    double far = std::numeric_limits<double>::infinity();
    if (const DynamicShellSource* source = it.baked.dynamic.get())
      far = CrossedCells(source->volume, it.Isovalue(), local + source->origin)
              .Distance(std::nextafter(least, far));
    else if (it.baked.shell)
      far = DistanceTo(*it.baked.shell, local);
    if (far <= least)
    {
      least = far;
      nearest = it.tool;
    }
  }
  return nearest;
}

} // namespace hasp
