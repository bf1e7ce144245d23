#pragma once
#include "FragmentModels.h"
#include "Grid/AnalyticSolid.h"
#include "Grid/AnalyticVolumes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

/// Bone with closed-form truth, and fragments of it: what the tests of this module measure.
namespace hasp::testing
{

/// Grids that all volumes may lie on. Each has its middle at `middle`.
inline GridGeometry GridAt(const glm::ivec3& dims, const glm::dvec3& spacing,
  const glm::dmat3& direction, const glm::dvec3& middle)
{
  GridGeometry grid{ dims, glm::dvec3(0.0), spacing, direction };
  grid.origin = middle - grid.IndexToWorld(0.5 * glm::dvec3(dims - 1));
  return grid;
}

/// A turn about a skew axis; mirrored, too.
inline glm::dmat3 SkewAxes(bool mirrored)
{
  glm::dmat3 axes = glm::mat3_cast(glm::angleAxis(0.8, glm::normalize(glm::dvec3(1.0, -2.0, 0.5))));
  if (mirrored)
    axes[1] = -axes[1];
  return axes;
}

/// Bone as a scan in memory, with labels that may be painted.
class LabelledScan
{
public:
  static constexpr double Isovalue = 226.0;
  static constexpr double PerMm = 400.0; ///< grey values; saturates 75 mm off

  /// bone: > 0 inside, mm; labelOf: of samples that are bone, from their world place.
  LabelledScan(const GridGeometry& grid, const AnalyticVolume& bone,
    const std::function<std::uint16_t(const glm::dvec3&)>& labelOf)
    : Grid(grid),
      Samples(SampleAnalytic<std::int16_t>(bone, grid, PerMm, Isovalue)),
      Labels(grid.Size())
  {
    for (std::size_t n = 0; n < this->Labels.size(); ++n)
      if (this->Samples[n] >= Isovalue)
        this->Labels[n] = labelOf(grid.IndexToWorld(this->Place(n)));
  }

  glm::ivec3 Place(std::size_t n) const
  {
    const std::size_t x = this->Grid.dims.x, y = this->Grid.dims.y;
    return { int(n % x), int(n / x % y), int(n / x / y) };
  }
  std::uint16_t& Label(const glm::ivec3& at)
  {
    return this->Labels[(std::size_t(at.z) * this->Grid.dims.y + at.y) * this->Grid.dims.x + at.x];
  }
  AnyGridView Grey() const { return GridView<const std::int16_t>{ this->Samples.data(), Grid }; }
  GridView<const std::uint16_t> LabelView() const { return { this->Labels.data(), this->Grid }; }
  /// Owned by this.
  FragmentScan Scan() const { return { this->Grey(), this->LabelView(), {}, {}, Isovalue }; }
  double VoxelMm3() const
  {
    return this->Grid.spacing.x * this->Grid.spacing.y * this->Grid.spacing.z;
  }

  GridGeometry Grid;
  std::vector<std::int16_t> Samples;
  std::vector<std::uint16_t> Labels;
};

/// A ball, cut in two by a plane along the grid's samples, half way between two layers of them: the
/// border that labels can say exactly. Label 2 is the half towards the scan's first samples.
struct BrokenBall
{
  glm::dvec3 middle{ 30.0, -20.0, 500.0 };
  double radius = 9.0;
  glm::dvec3 normal; ///< of the cut, out of label 2
  LabelledScan scan;

  /// axis: of the grid, that the cut is across; dims even along it.
  BrokenBall(const glm::ivec3& dims, const glm::dvec3& spacing, const glm::dmat3& axes, int axis,
    double ballRadius = 9.0)
    : radius(ballRadius),
      normal(axes[axis]),
      scan(GridAt(dims, spacing, axes, middle), AnalyticSphere(middle, radius),
        [this](const glm::dvec3& p)
        { return glm::dot(p - this->middle, this->normal) < 0.0 ? 2 : 3; })
  {
  }
  AnalyticSolid Half(int label) const
  {
    const AnalyticSolid ball(EllipsoidShape{ this->middle, glm::dvec3(this->radius) });
    return AnalyticSolid::Intersection({ ball,
      AnalyticSolid(HalfSpaceShape{ this->middle, label == 2 ? this->normal : -this->normal }) });
  }
  /// How far a place is from the rim, where the half's two faces meet in an edge, mm.
  double ToRim(const glm::dvec3& p) const
  {
    const double along = glm::dot(p - this->middle, this->normal);
    const double across = glm::length(p - this->middle - along * this->normal);
    return std::hypot(along, across - this->radius);
  }
};

/// A box of bone along the grid's axes, cut into n^3 cuboids, numbered from 2 on.
inline LabelledScan Cuboids(int n, const GridGeometry& grid, double halfMm)
{
  const glm::dvec3 middle = grid.IndexToWorld(0.5 * glm::dvec3(grid.dims - 1));
  const glm::dmat3 toAxes = glm::transpose(grid.direction);
  const AnalyticVolume box{ "box",
    [=](const glm::dvec3& p)
    {
      const glm::dvec3 q = glm::abs(toAxes * (p - middle));
      return halfMm - std::max({ q.x, q.y, q.z });
    },
    1.0 };
  return { grid, box,
    [=](const glm::dvec3& p)
    {
      const glm::dvec3 share = (toAxes * (p - middle) / halfMm + 1.0) * (0.5 * n);
      const glm::ivec3 cuboid = glm::clamp(glm::ivec3(glm::floor(share)), 0, n - 1);
      return std::uint16_t(2 + (cuboid.z * n + cuboid.y) * n + cuboid.x);
    } };
}

/// What is said of a resource by its name; bytes of all for "".
inline ResourceUse UseOf(const FragmentModels& models, const std::string& name)
{
  ResourceList list;
  models.ListResources(list);
  ResourceUse all;
  for (const ResourceUse& use : list)
    if (name.empty())
      all.bytes += use.bytes, all.milliseconds += use.milliseconds;
    else if (use.resource == name)
      return use;
  return all;
}

} // namespace hasp::testing
