#include "ImplantBuilder.h"

#include "Distance/Coverage.h"
#include "Distance/CoverageDistance.h"
#include "Distance/Csg.h"
#include "Distance/GridSolid.h"
#include "Distance/SharpContour.h"
#include "Distance/SolidMoves.h"
#include "Distance/SolidShapes.h"
#include "Grid/ParallelFor.h"
#include "Grid/ProgressPart.h"
#include "ImplantOutline.h"
#include "MirrorFit.h"
#include "OnePiece.h"
#include "PosedBone.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
using Distances = std::shared_ptr<const std::vector<float>>;

constexpr double RimMm = 6.0; // of bone outside the outline, that the mirrored side is laid on

/// Of the samples that are kept bone.
glm::dvec3 MiddleOf(const GridGeometry& ct, const std::vector<std::uint8_t>& keep)
{
  glm::dvec3 sum(0.0);
  double count = 0.0;
  std::size_t n = 0;
  for (int k = 0; k < ct.dims.z; ++k)
    for (int j = 0; j < ct.dims.y; ++j)
      for (int i = 0; i < ct.dims.x; ++i, ++n)
        if (keep[n])
        {
          sum += glm::dvec3(i, j, k);
          count += 1.0;
        }
  if (count == 0.0)
    throw std::runtime_error("implant: there is no bone at this isovalue");
  return ct.IndexToWorld(sum / count);
}

/// Where the grid lies in the mirror: its samples are those of the mirrored scan.
GridGeometry MirroredGrid(const GridGeometry& grid, const MirrorPlane& plane)
{
  GridGeometry mirrored = grid;
  mirrored.origin = Mirrored(plane, grid.origin);
  for (int a = 0; a < 3; ++a)
    mirrored.direction[a] -= 2.0 * glm::dot(grid.direction[a], plane.normal) * plane.normal;
  return mirrored;
}

/// Fills what lies below bone, as seen from above.
void FillBelow(const GridGeometry& grid, std::vector<float>& coverage)
{
  const std::size_t slice = std::size_t(grid.dims.x) * grid.dims.y;
  for (std::size_t n = coverage.size() - slice; n-- > 0;)
    coverage[n] = std::max(coverage[n], coverage[n + slice]);
}

Distances DistancesOf(const GridGeometry& grid, const std::vector<float>& coverage,
  const char* what, const ProgressFunction& progress)
{
  auto distances =
    std::make_shared<const std::vector<float>>(CoverageDistance(grid, coverage, progress));
  if (!std::isfinite(distances->front()))
    throw std::runtime_error(
      std::string("implant: there is no ") + what + " surface around the outline");
  return distances;
}

/// Distance to what keeps an implant out, seen along the axis: bone at its height or above it, and
/// all that is outside the outline.
ColumnLayer DistanceToBlocked(const ImplantRecipe& recipe, const ColumnLayer& depth,
  const std::vector<float>& toBone, const ImplicitSolid& table)
{
  const GridGeometry& grid = depth.grid;
  ColumnLayer least{ grid, {} };
  // Beyond a step values do not matter for where it is 0, and some end at the depth looked at.
  const auto most = float(recipe.spacingMm);
  const double deepest = -recipe.thicknessMm - recipe.clearanceMm;
  least.values.assign(depth.values.size(), most);
  const auto slice = std::int64_t(least.values.size());
  ParallelFor(0, slice, 256,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
        for (std::int64_t k = grid.dims.z - 1; k >= 0 && least.values[n] > -most; --k)
        {
          const float value = toBone[std::size_t(k * slice + n)];
          if (value < least.values[n] &&
              table.At(grid.IndexToWorld({ n % grid.dims.x, n / grid.dims.x, k })) >= deepest)
            least.values[n] = std::max(value, -most);
        }
    });
  ColumnLayer distance = DistanceToZero(std::move(least));
  for (std::size_t n = 0; n < distance.values.size(); ++n)
    distance.values[n] = std::min(distance.values[n], depth.values[n]);
  return distance;
}

std::runtime_error NoTable(const glm::dvec3& at)
{
  std::ostringstream text;
  text.precision(4);
  text << "implant: the mirrored side has no whole outer table over the hole: it has a hole or an "
          "edge, too, mirrored to ("
       << at.x << ", " << at.y << ", " << at.z << "); give another mirror plane or axis";
  return std::runtime_error(text.str());
}

/// Height of a solid's first surface from above in a column; none if it begins in it or meets none
/// above `lowest`.
std::optional<double> HeightAt(
  const ImplicitSolid& solid, const GridGeometry& grid, const glm::dvec2& column, double lowest)
{
  const double least = 0.05 * grid.spacing.z;
  double z = grid.spacing.z * grid.Cells().z, steepness = solid.Steepness();
  if (!(solid.At(grid.origin + grid.direction * glm::dvec3(column, z)) > 0.0))
    return {};
  while (z > lowest)
  {
    const double value = solid.At(grid.origin + grid.direction * glm::dvec3(column, z));
    if (value <= 0.0)
      return z;
    z -= std::max(value / steepness, least);
  }
  return {};
}

/// All over the footprint there must be an outer table without steps.
void CheckTable(
  const ColumnLayer& footprint, const ImplicitSolid& table, double lowest, double mostStepMm)
{
  const int width = footprint.grid.dims.x;
  std::vector<double> heights(footprint.values.size());
  ParallelFor(0, std::int64_t(heights.size()), 64,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
        if (footprint.values[n] > 0.0F)
          heights[n] = HeightAt(table, footprint.grid, footprint.Place(std::size_t(n)), lowest)
                         .value_or(-1e30);
    });
  for (std::size_t n = std::size_t(width) + 1; n < heights.size(); ++n)
    for (const std::size_t m : { n - 1, n - std::size_t(width) })
      if (footprint.values[n] > 0.0F && footprint.values[m] > 0.0F &&
          !(std::min(heights[n], heights[m]) > 0.0 &&
            std::abs(heights[n] - heights[m]) <= mostStepMm))
        throw NoTable(footprint.grid.origin +
                      footprint.grid.direction *
                        glm::dvec3(footprint.Place(n), std::max({ heights[n], heights[m], 0.0 })));
}

/// As high as the mirrored side's end, where its distances are cut off, and a thickness more.
double LowestCut(const GridGeometry& grid, const RigidPose& pose, double thicknessMm)
{
  double highest = 0.0;
  for (int c = 0; c < 4; ++c)
  {
    const glm::dvec3 corner =
      grid.IndexToWorld({ c & 1 ? grid.Cells().x : 0, c & 2 ? grid.Cells().y : 0, 0 });
    highest = std::max(highest, glm::dot(pose.Place(corner) - grid.origin, grid.direction[2]));
  }
  return highest + thicknessMm + grid.spacing.z;
}

std::vector<glm::dvec3> PlaceHoles(const ImplantRecipe& recipe, const ColumnLayer& footprint,
  const ImplicitSolid& table, double lowest)
{
  std::vector<glm::dvec3> holes;
  if (recipe.holeDiameterMm == 0.0)
    return holes;
  for (const glm::dvec2& column : PlacePerforation(
         footprint, recipe.holePitchMm, recipe.holeEdgeMm + 0.5 * recipe.holeDiameterMm))
    holes.push_back(footprint.grid.origin +
                    footprint.grid.direction *
                      glm::dvec3(column, *HeightAt(table, footprint.grid, column, lowest)));
  if (holes.empty())
    throw std::runtime_error("implant: it has no room for a hole of holeDiameterMm, holeEdgeMm "
                             "from its edge; take less, or holeDiameterMm 0");
  return holes;
}

SolidPointer Compose(const ImplantRecipe& recipe, const ImplantSolid& made,
  const ColumnLayer& footprint, const SolidPointer& table, double lowest)
{
  const SolidPointer body = MakeIntersection({ MakeShell(table, -recipe.thicknessMm, 0.0),
    MakeFootprintSolid(footprint), MakePlane(made.grid.origin + lowest * made.axis, -made.axis) });
  if (made.holes.empty())
    return body;
  std::vector<SolidPointer> holes;
  const double length = made.grid.spacing.z * made.grid.dims.z;
  for (const glm::dvec3& p : made.holes)
    holes.push_back(
      MakeCylinder(p - length * made.axis, p + length * made.axis, 0.5 * recipe.holeDiameterMm));
  return MakeDifference(body, MakeUnion(std::move(holes)));
}
} // namespace

ImplantSolid MakeImplantSolid(
  const AnyGridView& ct, const ImplantRecipe& recipe, const ProgressFunction& progress)
{
  ValidateImplantRecipe(recipe);
  const GridGeometry& scan = GeometryOf(ct);
  scan.Validate();
  CheckOutlineInVolume(recipe, scan);
  const std::vector<std::uint8_t> keep =
    KeepLargePieces(ct, recipe.isovalue, recipe.ignoreBelowMm3, PartOf(progress, 0.0, 0.1));
  CoverageSettings settings;
  settings.isovalue = recipe.isovalue;
  settings.keep = keep;
  ImplantSolid made;
  made.axis = ImplantAxis(recipe, MiddleOf(scan, keep));
  made.grid = ImplantGrid(recipe, made.axis);
  const Distances toBone =
    DistancesOf(made.grid, Coverage(ct, made.grid, settings, PartOf(progress, 0.1, 0.2)), "bone",
      PartOf(progress, 0.2, 0.4));
  const SolidPointer bone = MakeGridSolid(toBone, made.grid);
  CheckOutline(recipe, made.grid, *bone);
  made.mirror = recipe.mirror
                  ? MirrorPlane{ recipe.mirror->point, glm::normalize(recipe.mirror->normal) }
                  : FitMirrorPlane(ct, recipe.isovalue, keep, PartOf(progress, 0.4, 0.6));
  std::vector<float> coverage =
    Coverage(ct, MirroredGrid(made.grid, made.mirror), settings, PartOf(progress, 0.6, 0.7));
  FillBelow(made.grid, coverage);
  const SolidPointer mirrored = MakeGridSolid(
    DistancesOf(made.grid, coverage, "mirrored bone's", PartOf(progress, 0.7, 0.95)), made.grid);
  const ColumnLayer depth = OutlineDepth(recipe, made.grid);
  made.laid = LayOnRim(*mirrored, RimPlaces(*bone, depth, RimMm), made.grid.direction);
  const SolidPointer table = MakeMoved(mirrored, made.laid.pose);
  // No tongue narrower than the implant is thick.
  const ColumnLayer footprint = MakeFootprint(DistanceToBlocked(recipe, depth, *toBone, *table),
    recipe.clearanceMm, 0.5 * recipe.thicknessMm, recipe.outline);
  const double lowest = LowestCut(made.grid, made.laid.pose, recipe.thicknessMm);
  CheckTable(footprint, *table, lowest + recipe.thicknessMm, recipe.thicknessMm);
  made.holes = PlaceHoles(recipe, footprint, *table, lowest);
  made.solid = Compose(recipe, made, footprint, table, lowest);
  ReportProgress(progress, 1.0);
  return made;
}

BuiltImplant BuildImplant(
  const AnyGridView& ct, const ImplantRecipe& recipe, const ProgressFunction& progress)
{
  ImplantSolid made = MakeImplantSolid(ct, recipe, PartOf(progress, 0.0, 0.7));
  const TriangleMesh mesh =
    SharpContour(*made.solid, made.grid, {}, nullptr, PartOf(progress, 0.7, 1.0));
  return { OnePiece(mesh, "implant", "draw the outline around one hole, or take less clearance"),
    std::move(made) };
}

} // namespace hasp
