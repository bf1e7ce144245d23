#include "GuideBuilder.h"

#include "Distance/Coverage.h"
#include "Distance/Csg.h"
#include "Distance/GridSolid.h"
#include "Distance/NearSurface.h"
#include "Distance/SharpContour.h"
#include "Grid/Trilinear.h"
#include "GuideBone.h"
#include "GuideFrame.h"
#include "GuideLabels.h"
#include "GuideParts.h"
#include "GuideWalls.h"
#include "InsertionAxis.h"
#include "OnePiece.h"
#include "PlaceChecks.h"
#include "Planning/GuideSlots.h"
#include "WorkingGrid.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <variant>

namespace hasp
{

namespace
{
constexpr double FarthestLandmarkMm = 3.0;
constexpr double BesideMm = 1.0; // apart are the lines of a blade that are looked for bone
// Twice the wall that a printer makes (0.6 mm, PartClaims), for what samples may miss.
constexpr double LeastBallMm = 0.6, BallCells = 1.25;
constexpr double ShellCells = 4.5; // a ball of BallCells, and a cell on either side of it
constexpr double OpenMm = 0.03; // of the balls': so that smooth bone alone tells where its gap ends
constexpr double EdgeShare = 0.45; // of a ball: edges of 90 degrees stay sharp
constexpr double EndlessMm = 1000.0;

/// Part [from, to] of the whole.
ProgressFunction Part(const ProgressFunction& progress, double from, double to)
{
  return [&progress, from, to](double share)
  { return !progress || progress(from + share * (to - from)); };
}

std::runtime_error NothingLeft()
{
  return std::runtime_error(
    "guide: nothing is left: no bone faces the withdrawal direction around the landmarks");
}

/// With the coarsest grid up to spacingMm that it is valid with; none but its own: nothing.
std::optional<GuideRecipe> CoarserRecipe(GuideRecipe recipe, double spacingMm)
{
  constexpr double Finer = 0.9;
  for (const double own = recipe.spacingMm; spacingMm > own; spacingMm *= Finer)
    try
    {
      recipe.spacingMm = spacingMm;
      ValidateGuideRecipe(recipe);
      return recipe;
    }
    catch (const std::invalid_argument&)
    {
      // Its slots, walls or letters need a finer one.
    }
  return std::nullopt;
}

/// Directions are unit within 1e-3 only, as people write them.
GuideRecipe WithUnitDirections(GuideRecipe recipe)
{
  recipe.withdrawal = glm::normalize(recipe.withdrawal);
  for (GuideSlot& slot : recipe.slots)
    slot.normal = glm::normalize(slot.normal);
  for (GuideFlange& flange : recipe.flanges)
    flange.normal = glm::normalize(flange.normal);
  for (GuideHole& hole : recipe.holes)
    hole.axis = glm::normalize(hole.axis);
  return recipe;
}

/// Calls check(name, place) with all places that must be on the bone.
template <typename Check>
void ForEachLandmark(const GuideRecipe& recipe, const Check& check)
{
  for (std::size_t n = 0; n < recipe.landmarks.size(); ++n)
    check("landmarks[" + std::to_string(n) + "]", recipe.landmarks[n]);
  for (std::size_t n = 0; n < recipe.strokes.size(); ++n)
    for (std::size_t p = 0; p < recipe.strokes[n].points.size(); ++p)
      if (!recipe.strokes[n].erased)
        check("strokes[" + std::to_string(n) + "].points[" + std::to_string(p) + "]",
          recipe.strokes[n].points[p]);
}

void CheckLandmarksInVolume(const GridGeometry& volume, const GuideRecipe& recipe)
{
  std::vector<NamedPlace> places;
  ForEachLandmark(recipe,
    [&](const std::string& name, const glm::dvec3& p) {
      places.push_back({ name, p });
    });
  CheckInVolume("guide", volume, places);
}

void CheckLandmarksOnBone(const GridView<const float>& bone, const GuideRecipe& recipe)
{
  ForEachLandmark(recipe,
    [&](const std::string& name, const glm::dvec3& p)
    {
      const auto d = SampleTrilinear(bone, bone.geometry.WorldToIndex(p));
      if (d && std::abs(*d) <= FarthestLandmarkMm)
        return;
      std::ostringstream text;
      text << "guide: " << name << " is " << (d ? *d : 0.0) << " mm from bone (isovalue "
           << recipe.isovalue << "), must be within " << FarthestLandmarkMm << " mm";
      throw std::runtime_error(text.str());
    });
}

/// Whether a bone sample is in the box of this half width, mm, around a place in the volume.
template <typename T>
bool BoneIsNear(const GridView<const T>& ct, const std::vector<std::uint8_t>& keep, double isovalue,
  const glm::dvec3& place, double reachMm)
{
  const glm::dvec3 reach = reachMm / ct.geometry.spacing, at = ct.geometry.WorldToIndex(place);
  const glm::ivec3 low(glm::max(glm::ceil(at - reach), glm::dvec3(0.0)));
  const glm::ivec3 high(
    glm::min(glm::floor(at + reach), glm::dvec3(ct.geometry.dims - glm::ivec3(1))));
  for (int k = low.z; k <= high.z; ++k)
    for (int j = low.y; j <= high.y; ++j)
      for (int i = low.x; i <= high.x; ++i)
        if (keep[ct.Offset(i, j, k)] && double(ct(i, j, k)) >= isovalue)
          return true;
  return false;
}

/// Before directions are searched, which says less of why there is no bone: bone's surface is
/// within a spacing of one of its samples.
void CheckBoneIsNear(
  const AnyGridView& ct, const std::vector<std::uint8_t>& keep, const GuideRecipe& recipe)
{
  const glm::dvec3 spacing = GeometryOf(ct).spacing;
  const double reach = FarthestLandmarkMm + std::max({ spacing.x, spacing.y, spacing.z });
  ForEachLandmark(recipe,
    [&](const std::string& name, const glm::dvec3& p)
    {
      if (std::visit([&](const auto& view)
            { return BoneIsNear(view, keep, recipe.isovalue, p, reach); },
            ct))
        return;
      std::ostringstream text;
      text << "guide: " << name << " is over " << FarthestLandmarkMm << " mm from bone (isovalue "
           << recipe.isovalue << "), must be within";
      throw std::runtime_error(text.str());
    });
}

/// The withdrawal direction found takes the place of the recipe's, which must suit it then.
InsertionAxis SearchAxis(
  const AnyGridView& ct, const std::vector<std::uint8_t>& keep, GuideRecipe& recipe)
{
  if (recipe.axisSearchDeg == 0.0)
    return { recipe.withdrawal, -1.0 };
  CheckBoneIsNear(ct, keep, recipe);
  const SolidPointer band = MakeGuideBand(recipe);
  const InsertionAxis found =
    FindInsertionAxis(ct, keep, *band, recipe.withdrawal, recipe.axisSearchDeg);
  recipe.withdrawal = found.direction;
  recipe.axisSearchDeg = 0.0;
  ValidateGuideRecipe(recipe);
  return found;
}

/// A blade's slot with its point on the bone.
GuideSlot SlotOnBone(const AnyGridView& ct, const std::vector<std::uint8_t>& keep,
  const GuideRecipe& recipe, const Osteotomy& blade)
{
  const std::string name =
    "guide: slots[" + std::to_string(recipe.slots.size()) + "], of a planned cut";
  const GuideSlot slot = SlotOfBlade(blade, recipe.withdrawal, name);
  const glm::dmat3 axes = SawAxes(slot.normal, recipe.withdrawal);
  const double top = slot.depthMm, reach = 0.5 * slot.lengthMm;
  for (double across = 0.0; std::abs(across) < reach;
       across = across > 0.0 ? -across : BesideMm - across)
  {
    const glm::dvec3 from = slot.point + across * axes[1] + top * axes[2];
    const auto way = WayToBone(ct, keep, recipe.isovalue, from, -axes[2], 2.0 * top);
    if (way && *way > 0.0)
      return MovedSlot(slot, recipe.withdrawal, top - *way);
  }
  throw std::runtime_error(name + ": its blade does not enter bone from the side that the guide "
                                  "lifts off to; make it deeper or move it");
}

/// Solids of one list of parts.
std::vector<SolidPointer> SolidsOf(const std::vector<GuidePart>& parts)
{
  std::vector<SolidPointer> solids;
  for (const GuidePart& part : parts)
    solids.push_back(part.solid);
  return solids;
}

SolidPointer Without(SolidPointer body, std::vector<SolidPointer> tools)
{
  return tools.empty() ? body : MakeDifference(std::move(body), MakeUnion(std::move(tools)));
}

/// Balls of this radius fit in what is printed, and in what is left open between it and bone.
double BallMm(const GuideRecipe& recipe)
{
  return std::max(LeastBallMm, BallCells * recipe.spacingMm);
}

/// What is farther from bone than the gap, and not in its pores.
SolidPointer Room(const GuideRecipe& recipe, const GridGeometry& grid, const SolidPointer& blocked,
  const ProgressFunction& progress)
{
  SolidPointer room =
    ThickParts(MakeShell(blocked, recipe.gapMm, EndlessMm), grid, BallMm(recipe), OpenMm, progress);
  return room ? room : throw NothingLeft();
}

/// What is done about edges of a shell that is too thin for its own grid to tell.
enum class Edges
{
  Thick, ///< thin ones are cut off, on a finer grid
  Quick  ///< they stay: a look before it is made
};

/// The grid that sees balls which fit in the shell: the guide's own, but for a thin shell.
GridGeometry GridOfBalls(const GuideRecipe& recipe, GridGeometry grid)
{
  const double spacing = recipe.thicknessMm / ShellCells;
  if (spacing >= recipe.spacingMm)
    return grid;
  const glm::dvec3 cells = glm::ceil(glm::dvec3(grid.Cells()) * (recipe.spacingMm / spacing));
  CheckPoints("guide", cells + 1.0, recipe.thicknessMm, "raise thicknessMm");
  grid.dims = glm::ivec3(cells) + 1;
  grid.spacing = glm::dvec3(spacing);
  return grid;
}

/// The shell where nothing is on it or through it.
SolidPointer BareShell(const GuideRecipe& recipe, const GuideFrame& frame, const SolidPointer& bone,
  const SolidPointer& room, Edges edges, const ProgressFunction& progress)
{
  const SolidPointer outer = MakeOffset(bone, recipe.gapMm + recipe.thicknessMm);
  SolidPointer shell = recipe.edgeRadiusMm > 0.0
                         ? MakeSmoothIntersection(outer, frame.region, recipe.edgeRadiusMm)
                         : MakeIntersection({ outer, frame.region });
  shell = MakeIntersection({ shell, room });
  const bool isThin = recipe.thicknessMm < ShellCells * recipe.spacingMm;
  if (isThin && edges == Edges::Quick)
    return shell;
  const GridGeometry grid = GridOfBalls(recipe, frame.grid);
  const double ball = std::min(BallMm(recipe), 0.5 * recipe.thicknessMm - grid.spacing.x);
  shell = ThickParts(shell, grid, ball, EdgeShare * ball, progress);
  return shell ? shell : throw NothingLeft();
}

/// Joins the shell, the parts and the letters; names what does not meet the shell.
SolidPointer Compose(const GuideRecipe& recipe, const GuideFrame& frame, const GuideParts& parts,
  const SolidPointer& bone, const SolidPointer& blocked, Edges edges,
  const ProgressFunction& progress)
{
  const SolidPointer room = Room(recipe, frame.grid, blocked, Part(progress, 0.0, 0.5));
  const SolidPointer bare = BareShell(recipe, frame, bone, room, edges, Part(progress, 0.5, 1.0));
  const glm::dvec3 half = 0.5 * glm::dvec3(frame.grid.Cells());
  const GuidePart all{ "", bare, frame.grid.IndexToWorld(half), frame.grid.direction,
    half * frame.grid.spacing };
  const ImplicitSolid::Box where = bare->Bounds();
  if (!PartMeets(all, *bare, frame.grid.spacing.x, where))
    throw NothingLeft();
  for (const GuidePart& part : parts.taken)
    if (!PartMeets(part, *bare, frame.grid.spacing.x, where))
      throw std::runtime_error("guide: " + part.name + " does not meet the guide");
  for (const GuidePart& part : parts.added)
    if (!PartMeets(part, *bare, frame.grid.spacing.x, where))
      throw std::runtime_error("guide: " + part.name + " does not stand on the guide");

  std::vector<SolidPointer> added = SolidsOf(parts.added), taken = SolidsOf(parts.taken);
  std::vector<SolidPointer> covered = added;
  covered.insert(covered.end(), taken.begin(), taken.end());
  const SolidPointer free = Without(bare, covered);
  for (std::size_t n = 0; n < recipe.labels.size(); ++n)
    (recipe.labels[n].engraved ? taken : added).push_back(MakeGuideLabel(recipe, n, bone, *free));
  added.push_back(bare);
  return Without(MakeIntersection({ MakeUnion(std::move(added)), room }), std::move(taken));
}

GuideSolid MakeSolid(const AnyGridView& ct, const GuideRecipe& given,
  std::span<const Osteotomy> blades, Edges edges, const ProgressFunction& progress)
{
  ValidateGuideRecipe(given);
  GuideRecipe recipe = WithUnitDirections(given);
  const GridGeometry& volume = GeometryOf(ct);
  volume.Validate();
  CheckLandmarksInVolume(volume, recipe);
  for (std::size_t n = 0; n < recipe.labels.size(); ++n)
    if (recipe.labels[n].kind == GuideLabelKind::Case)
      throw std::invalid_argument("guide: labels[" + std::to_string(n) +
                                  "] is to name the case, which was not said (WithCaseLabels)");
  const std::vector<std::uint8_t> keep =
    KeepLargePieces(ct, recipe.isovalue, recipe.ignoreBelowMm3, Part(progress, 0.0, 0.1));
  const InsertionAxis axis = SearchAxis(ct, keep, recipe);
  for (const Osteotomy& blade : blades)
    recipe.slots.push_back(SlotOnBone(ct, keep, recipe, blade));
  if (!blades.empty())
    ValidateGuideRecipe(recipe);
  ReportProgress(progress, 0.15);
  const GuideParts parts = MakeGuideParts(recipe);
  const GuideFrame frame = MakeGuideFrame(recipe, volume, keep, parts);
  const GuideDistances distances =
    DistanceToBone(ct, keep, recipe.isovalue, frame.grid, Part(progress, 0.2, 0.7));
  CheckLandmarksOnBone({ distances->data(), frame.grid }, recipe);
  const GuideDistances blocked =
    BlockUndercuts(*distances, ct, keep, recipe.isovalue, frame.grid, Part(progress, 0.7, 0.8));
  SolidPointer solid = Compose(recipe, frame, parts, MakeGridSolid(distances, frame.grid),
    MakeGridSolid(blocked, frame.grid), edges, Part(progress, 0.8, 1.0));
  ReportProgress(progress, 1.0);
  return { std::move(solid), frame.grid, std::move(recipe), axis.undercut };
}
} // namespace

GuideSolid MakeGuideSolid(const AnyGridView& ct, const GuideRecipe& recipe,
  std::span<const Osteotomy> blades, const ProgressFunction& progress)
{
  return MakeSolid(ct, recipe, blades, Edges::Thick, progress);
}

GuideSamples SampleGuide(
  const GuideSolid& guide, double spacingMm, const ProgressFunction& progress)
{
  if (!(spacingMm >= guide.grid.spacing.x))
    throw std::invalid_argument("guide: the preview's spacing is " + std::to_string(spacingMm) +
                                " mm, must be at least the recipe's spacingMm (" +
                                std::to_string(guide.grid.spacing.x) + ")");
  GuideSamples samples{ guide.grid, {} };
  samples.grid.spacing = glm::dvec3(spacingMm);
  samples.grid.dims =
    glm::ivec3(glm::ceil(glm::dvec3(guide.grid.Cells()) * guide.grid.spacing / spacingMm)) + 1;
  samples.values =
    DenseValues(EvaluateNearSurface(*guide.solid, samples.grid, 3.0 * spacingMm, progress));
  for (float& value : samples.values)
    value = -value;
  return samples;
}

GuideSolid MakePreviewSolid(const AnyGridView& ct, const GuideRecipe& recipe,
  std::span<const Osteotomy> blades, double spacingMm)
{
  if (const auto coarse = CoarserRecipe(recipe, spacingMm))
    try
    {
      return MakeSolid(ct, *coarse, blades, Edges::Quick, {});
    }
    catch (const std::exception&)
    {
      // Of what its own grid says of it a user can make sense.
    }
  return MakeGuideSolid(ct, recipe, blades);
}

BuiltGuide BuildGuide(const AnyGridView& ct, const GuideRecipe& recipe,
  std::span<const Osteotomy> blades, const ProgressFunction& progress)
{
  GuideSolid made = MakeGuideSolid(ct, recipe, blades, Part(progress, 0.0, 0.7));
  const TriangleMesh mesh =
    SharpContour(*made.solid, made.grid, {}, nullptr, Part(progress, 0.7, 1.0));
  return { OnePiece(mesh, "guide", "shorten the slots, widen the band, or move the landmarks"),
    std::move(made) };
}

} // namespace hasp
