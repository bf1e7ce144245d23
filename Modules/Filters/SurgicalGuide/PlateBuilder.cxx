#include "PlateBuilder.h"

#include "Distance/Csg.h"
#include "Distance/SharpContour.h"
#include "Distance/SolidSweeps.h"
#include "Grid/ProgressPart.h"
#include "OnePiece.h"
#include "PlaceChecks.h"
#include "PlateBed.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace hasp
{

namespace
{
constexpr double PlaceMarginMm = 3.0; // as far as landmarks and screws may be from bone
constexpr double GridRimSteps = 4.0;  // of the grid around the plate

double OuterHeight(const PlateRecipe& recipe)
{
  return recipe.gapMm + recipe.thicknessMm;
}

/// What the plate can depend on: bone below it as deep as MakeRibbon looks, and a curve that swings
/// out between its landmarks.
ImplicitSolid::Box RegionOf(const PlateRecipe& recipe)
{
  return BoxAround(recipe.landmarks, OuterHeight(recipe) + 2.5 * recipe.widthMm +
                                       2.0 * recipe.bridgeMm + GridRimSteps * recipe.spacingMm);
}

/// What can be said of the recipe's places before bone is looked at.
void CheckPlaces(
  const GridGeometry& volume, const PlateRecipe& recipe, const ImplicitSolid::Box& region)
{
  volume.Validate();
  std::vector<NamedPlace> places;
  for (std::size_t n = 0; n < recipe.landmarks.size(); ++n)
    places.push_back({ "landmarks[" + std::to_string(n) + "]", recipe.landmarks[n] });
  for (std::size_t n = 0; n < recipe.screws.size(); ++n)
    places.push_back({ "screws[" + std::to_string(n) + "].point", recipe.screws[n].point });
  if (recipe.fragments.empty()) // moved ones may leave it
    CheckInVolume("plate", volume, places, PlaceMarginMm);
  for (const NamedPlace& place : places)
  {
    const glm::dvec3 off = glm::max(region.low - place.point, place.point - region.high);
    if (const double most = std::max({ off.x, off.y, off.z }); most > PlaceMarginMm)
      throw std::runtime_error("plate: " + place.name + " is over " + std::to_string(int(most)) +
                               " mm off the landmarks' band");
  }
}

SolidPointer MakeBody(const SolidPointer& surface, const PlatePath& path, const PlateRecipe& recipe)
{
  const double to = OuterHeight(recipe);
  try
  {
    if (recipe.bevelMm == 0.0)
      return MakeRibbon(surface, path.places, recipe.widthMm, recipe.gapMm, to, path.normals);
    // Its own outer face lies so high that only the walls and the inner face are its part.
    const SolidPointer walls = MakeRibbon(
      surface, path.places, recipe.widthMm, recipe.gapMm, to + 2.0 * recipe.bevelMm, path.normals);
    return MakeBevelledIntersection(MakeOffset(surface, to), walls, recipe.bevelMm);
  }
  catch (const std::invalid_argument& error)
  {
    throw std::runtime_error(
      std::string("plate: it cannot lie along these landmarks: ") + error.what());
  }
}
} // namespace

PlateSolid MakePlateOn(SolidPointer bone, SolidPointer surface, const PlateRecipe& recipe)
{
  PlateSolid made;
  made.path = MakePlatePath(*surface, recipe);
  CheckPlateBed(*surface, made.path, recipe);
  const double reach =
    std::hypot(0.5 * recipe.widthMm, OuterHeight(recipe) + 0.75 * recipe.widthMm);
  made.grid =
    GridAround("plate", BoxAround(made.path.places, reach + GridRimSteps * recipe.spacingMm),
      glm::dmat3(1.0), recipe.spacingMm);
  made.solid = MakeBody(surface, made.path, recipe);
  made.screws = PlaceScrews(*bone, *surface, made.path, recipe);
  std::vector<SolidPointer> holes;
  for (std::size_t n = 0; n < made.screws.size(); ++n)
    holes.push_back(MakeScrewHole(recipe.screws[n], made.screws[n]));
  if (!holes.empty())
    made.solid = MakeDifference(made.solid, MakeUnion(std::move(holes)));
  return made;
}

PlateSolid MakePlateSolid(
  const BoneScan& scan, const PlateRecipe& recipe, const ProgressFunction& progress)
{
  ValidatePlateRecipe(recipe);
  const bool bridged = recipe.bridgeMm > 0.0;
  const ImplicitSolid::Box region = RegionOf(recipe);
  CheckPlaces(GeometryOf(scan.grey), recipe, region);
  const SolidPointer bone =
    PosedBone(scan, recipe, region, PartOf(progress, 0.0, bridged ? 0.5 : 0.95));
  const SolidPointer surface = bridged ? BridgedSolid(*bone, recipe.bridgeMm, region,
                                           recipe.spacingMm, PartOf(progress, 0.5, 0.95))
                                       : bone;
  PlateSolid made = MakePlateOn(bone, surface, recipe);
  ReportProgress(progress, 1.0);
  return made;
}

BuiltPlate BuildPlate(
  const BoneScan& scan, const PlateRecipe& recipe, const ProgressFunction& progress)
{
  PlateSolid made = MakePlateSolid(scan, recipe, PartOf(progress, 0.0, 0.6));
  const TriangleMesh mesh =
    SharpContour(*made.solid, made.grid, {}, nullptr, PartOf(progress, 0.6, 1.0));
  return { OnePiece(mesh, "plate", "move the landmarks, or take fewer or smaller screws"),
    std::move(made) };
}

} // namespace hasp
