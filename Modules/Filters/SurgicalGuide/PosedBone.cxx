#include "PosedBone.h"

#include "Distance/Coverage.h"
#include "Distance/Csg.h"
#include "Distance/GridSolid.h"
#include "Distance/SolidMoves.h"
#include "Grid/LabelGrid.h"
#include "Grid/ParallelFor.h"
#include "Grid/ProgressPart.h"
#include "GuideBone.h"
#include "WorkingGrid.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
using Box = ImplicitSolid::Box;

constexpr double RimSteps = 3.0; // of air around a scan that ends in bone

template <typename Place>
Box BoxOfCorners(const Box& box, const Place& place)
{
  Box moved{ glm::dvec3(1e30), glm::dvec3(-1e30) };
  for (int c = 0; c < 8; ++c)
  {
    const glm::dvec3 p = place(glm::dvec3(c & 1 ? box.high.x : box.low.x,
      c & 2 ? box.high.y : box.low.y, c & 4 ? box.high.z : box.low.z));
    moved.low = glm::min(moved.low, p);
    moved.high = glm::max(moved.high, p);
  }
  return moved;
}

/// The part of a world's box that the scan holds, along the scan's axes; empty if none.
Box WithinScan(const Box& world, const GridGeometry& ct, double rim)
{
  Box box = BoxOfCorners(world, [&](const glm::dvec3& p) { return p * ct.direction; });
  const Box scan = BoxOfCorners({ glm::dvec3(0), glm::dvec3(ct.Cells()) },
    [&](const glm::dvec3& index) { return ct.IndexToWorld(index) * ct.direction; });
  box.low = glm::max(box.low, scan.low - rim);
  box.high = glm::min(box.high, scan.high + rim);
  return box;
}

/// Bone as a solid; null if there is none in the grid.
SolidPointer SolidOf(const AnyGridView& grey, const std::vector<std::uint8_t>& keep,
  double isovalue, const GridGeometry& grid, const ProgressFunction& progress)
{
  const GuideDistances distances = DistanceToBone(grey, keep, isovalue, grid, progress);
  const float any = distances->front();
  if (std::isfinite(any))
    return MakeGridSolid(distances, grid);
  if (any > 0.0F)
    return nullptr;
  throw std::runtime_error(
    "plate: all around the landmarks is bone: is the isovalue below that of air?");
}

/// One bone near the region, moved by a pose; null if none of it is there.
SolidPointer OneBone(const AnyGridView& ct, const std::vector<std::uint8_t>& keep,
  const PlateRecipe& recipe, const Box& region, const RigidPose& pose,
  const ProgressFunction& progress)
{
  const RigidPose back = pose.Inverse();
  const Box scanned = BoxOfCorners(region, [&](const glm::dvec3& p) { return back.Place(p); });
  const GridGeometry& geometry = GeometryOf(ct);
  const Box local = WithinScan(scanned, geometry, RimSteps * recipe.spacingMm);
  if (local.low.x >= local.high.x || local.low.y >= local.high.y || local.low.z >= local.high.z)
    return nullptr;
  const GridGeometry grid = GridIn("plate", local, geometry.direction, recipe.spacingMm);
  const SolidPointer bone = SolidOf(ct, keep, recipe.isovalue, grid, progress);
  return !bone || pose == RigidPose{} ? bone : MakeMoved(bone, pose);
}

void CheckLabels(const BoneScan& scan)
{
  if (!scan.labels)
    throw std::invalid_argument("plate: the recipe moves fragments, but there are no labels");
  CheckLabelGrid("plate", GeometryOf(scan.grey), GeometryOf(*scan.labels));
}
} // namespace

Box BoxAround(std::span<const glm::dvec3> points, double margin)
{
  Box box{ glm::dvec3(1e30), glm::dvec3(-1e30) };
  for (const glm::dvec3& p : points)
  {
    box.low = glm::min(box.low, p - margin);
    box.high = glm::max(box.high, p + margin);
  }
  return box;
}

GridGeometry GridAround(const char* who, const Box& box, const glm::dmat3& axes, double spacingMm)
{
  return GridIn(
    who, BoxOfCorners(box, [&](const glm::dvec3& p) { return p * axes; }), axes, spacingMm);
}

SolidPointer PosedBone(const BoneScan& scan, const PlateRecipe& recipe, const Box& region,
  const ProgressFunction& progress)
{
  GeometryOf(scan.grey).Validate();
  std::vector<SolidPointer> bones;
  if (recipe.fragments.empty())
  {
    const std::vector<std::uint8_t> keep = KeepLargePieces(
      scan.grey, recipe.isovalue, recipe.ignoreBelowMm3, PartOf(progress, 0.0, 0.2));
    bones.push_back(OneBone(scan.grey, keep, recipe, region, {}, PartOf(progress, 0.2, 1.0)));
  }
  else
    CheckLabels(scan);
  const double share = 1.0 / double(std::max<std::size_t>(recipe.fragments.size(), 1));
  for (std::size_t n = 0; n < recipe.fragments.size(); ++n)
  {
    const PlateFragment& fragment = recipe.fragments[n];
    const RigidPose pose{ fragment.position, glm::normalize(fragment.orientation) };
    bones.push_back(OneBone(scan.grey, KeepLabel(*scan.labels, fragment.label), recipe, region,
      pose, PartOf(progress, double(n) * share, double(n + 1) * share)));
  }
  std::erase(bones, nullptr);
  if (bones.empty())
    throw std::runtime_error("plate: there is no bone around the landmarks");
  return MakeUnion(std::move(bones));
}

SolidPointer BridgedSolid(const ImplicitSolid& solid, double radiusMm, const Box& region,
  double spacingMm, const ProgressFunction& progress)
{
  const GridGeometry grid = GridAround("plate", region, glm::dmat3(1.0), spacingMm);
  std::vector<float> depth(grid.Size()); // positive inside, as grey values are
  const std::int64_t row = grid.dims.x;
  ParallelFor(0, std::int64_t(depth.size()) / row, 16,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t line = first; line < last; ++line)
        for (std::int64_t i = 0; i < row; ++i)
          depth[line * row + i] =
            float(-solid.At(grid.IndexToWorld({ i, line % grid.dims.y, line / grid.dims.y })));
    });
  const SolidPointer outer =
    SolidOf(GridView<const float>{ depth.data(), grid }, {}, -radiusMm, grid, progress);
  if (!outer)
    throw std::runtime_error("plate: there is no bone around the landmarks to bridge");
  return MakeOffset(outer, -radiusMm); // of bone that is there: something is covered
}

} // namespace hasp
