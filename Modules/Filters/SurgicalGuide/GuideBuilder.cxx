#include "GuideBuilder.h"

#include "Distance/Coverage.h"
#include "Distance/CoverageDistance.h"
#include "Distance/TetrahedraContour.h"
#include "Grid/Trilinear.h"
#include "GuideField.h"
#include "GuideFrame.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr double FarthestLandmarkMm = 3.0;
constexpr double CrumbShare = 0.01; // of the guide's volume

/// Part [from, to] of the whole.
ProgressFunction Part(const ProgressFunction& progress, double from, double to)
{
  return [&progress, from, to](double share)
  { return !progress || progress(from + share * (to - from)); };
}

/// Directions are unit within 1e-3 only, as people write them. A hole's axis that long off would
/// narrow the hole far from its point.
GuideRecipe WithUnitDirections(GuideRecipe recipe)
{
  recipe.withdrawal = glm::normalize(recipe.withdrawal);
  for (GuideSlot& slot : recipe.slots)
    slot.normal = glm::normalize(slot.normal);
  for (GuideHole& hole : recipe.holes)
    hole.axis = glm::normalize(hole.axis);
  return recipe;
}

void CheckLandmarksInVolume(const GridGeometry& volume, const GuideRecipe& recipe)
{
  for (std::size_t n = 0; n < recipe.landmarks.size(); ++n)
    if (!LocateCell(volume, volume.WorldToIndex(recipe.landmarks[n])))
    {
      const glm::dvec3& p = recipe.landmarks[n];
      std::ostringstream text;
      text << "guide: landmarks[" << n << "] (" << p.x << ", " << p.y << ", " << p.z
           << ") is outside the volume";
      throw std::runtime_error(text.str());
    }
}

void CheckLandmarksOnBone(const GridView<const float>& bone, const GuideRecipe& recipe)
{
  for (std::size_t n = 0; n < recipe.landmarks.size(); ++n)
  {
    const auto d = SampleTrilinear(bone, bone.geometry.WorldToIndex(recipe.landmarks[n]));
    if (d && std::abs(*d) <= FarthestLandmarkMm)
      continue;
    std::ostringstream text;
    text << "guide: landmarks[" << n << "] is " << (d ? *d : 0.0) << " mm from bone (isovalue "
         << recipe.isovalue << "), must be within " << FarthestLandmarkMm << " mm";
    throw std::runtime_error(text.str());
  }
}

/// One piece without hollows, or an error that says what is wrong.
TriangleMesh OnePiece(const TriangleMesh& mesh)
{
  const std::vector<double> volumes = FindPieces(mesh).volume;
  const double largest = volumes.empty() ? 0.0 : *std::max_element(volumes.begin(), volumes.end());
  std::ostringstream text;
  if (!(largest > 0.0))
    throw NothingLeft();
  int pieces = 0, hollows = 0;
  for (const double v : volumes)
    if (std::abs(v) >= CrumbShare * largest)
    {
      (v > 0.0 ? pieces : hollows) += 1;
      text << (text.tellp() > 0 ? ", " : "") << v;
    }
  if (pieces == 1 && hollows == 0)
    return WithoutSmallPieces(mesh, CrumbShare * largest);
  std::ostringstream fault;
  fault << "guide: it falls into " << pieces << " pieces and " << hollows
        << " hollows (mm3: " << text.str()
        << "); shorten the slots, widen the band, or move the landmarks";
  throw std::runtime_error(fault.str());
}
} // namespace

TriangleMesh BuildGuide(
  const AnyGridView& ct, const GuideRecipe& given, const ProgressFunction& progress)
{
  ValidateGuideRecipe(given);
  const GuideRecipe recipe = WithUnitDirections(given);
  GeometryOf(ct).Validate();
  CheckLandmarksInVolume(GeometryOf(ct), recipe);
  const std::vector<std::uint8_t> keep =
    KeepLargePieces(ct, recipe.isovalue, recipe.ignoreBelowMm3, Part(progress, 0.0, 0.2));
  const GuideFrame frame(recipe, GeometryOf(ct), keep);
  std::vector<float> field;
  {
    CoverageSettings settings;
    settings.isovalue = recipe.isovalue;
    settings.keep = keep;
    const std::vector<float> coverage =
      Coverage(ct, frame.Grid(), settings, Part(progress, 0.2, 0.5));
    field = CoverageDistance(frame.Grid(), coverage, Part(progress, 0.5, 0.8));
  }
  CheckLandmarksOnBone({ field.data(), frame.Grid() }, recipe);
  ComposeGuideField(field, ct, keep, frame, recipe, Part(progress, 0.8, 0.9));
  const TriangleMesh mesh =
    ContourTetrahedra({ field.data(), frame.Grid() }, Part(progress, 0.9, 1.0));
  return OnePiece(mesh);
}

} // namespace hasp
