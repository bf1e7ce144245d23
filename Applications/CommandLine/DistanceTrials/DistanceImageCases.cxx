#include "Distance/Csg.h"
#include "Distance/NearSurface.h"
#include "Distance/SolidShapes.h"
#include "DistanceCase.h"
#include "DistanceCases.h"
#include "DistanceErrors.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

namespace hasp
{
namespace
{

/// What is no coverage: refused, or known for what it is.
void AddNoCoverage(ReportContext& context)
{
  const GridGeometry grid = TrialGrid(48);
  std::mt19937_64 random(context.settings.seed);
  std::uniform_real_distribution<float> any(0.0F, 1.0F);
  std::vector<float> noise(grid.Size());
  for (float& value : noise)
    value = any(random);
  AddCase(context, "distance.refused.noise", "noise as coverage",
    Accepted([&] { CoverageDistance(grid, noise); }), 0.0, "accepted");
  const double v = TrialVoxelMm;
  const AnalyticVolume ball = AnalyticSphere(v * glm::dvec3(0.31, -0.22, 0.43), 16.3 * v);
  for (const double blur : { 0.8, 2.0 })
  {
    const std::vector<float> image = ScannedImage(ball, grid, blur, 0.0, 1);
    char text[120];
    std::snprintf(text, sizeof text, "an image blurred by %.1f voxels as coverage", blur);
    AddCase(context, blur < 1.0 ? "distance.refused.blur" : "distance.refused.blur.wide", text,
      Accepted([&] { CoverageDistance(grid, image); }), 0.0, "accepted");
    DistanceErrors errors(v);
    AddErrors(
      ImageDistance({ image.data(), grid }), TrueDistances(ball, grid), grid, {}, "ball", errors);
    // A Gaussian moves the half of its step inwards by sigma^2 / R, and higher orders.
    const double moved = blur * blur / 16.3;
    std::snprintf(text, sizeof text,
      "the same, of unknown origin, a ball of R 16.3: sigma^2 / R of it is the scanner's, %.3f",
      moved);
    AddCase(context, blur < 1.0 ? "distance.unknown.blur" : "distance.unknown.blur.wide", text,
      std::abs(errors.Rms() - moved), 0.03, "voxel RMS beside that");
  }
  const std::vector<float> coverage = ExactCoverage(ball, grid);
  const std::vector<float> guide = CoverageDistance(grid, coverage);
  const std::vector<float> image = ImageDistance({ coverage.data(), grid });
  AddCase(context, "distance.unknown.coverage", "coverage of unknown origin is known as coverage",
    guide == image ? 0.0 : 1.0, 0.0, "1 if it is taken for a grey image");
}

/// About as thin as a voxel: refused as no coverage, gone, or there and true; never wrong in
/// silence.
void AddThin(ReportContext& context)
{
  const GridGeometry grid = TrialGrid(48);
  const double v = TrialVoxelMm;
  const glm::dvec3 normal = glm::normalize(glm::dvec3(1.0, 2.0, 5.0)),
                   at = v * glm::dvec3(0.21, 0.13, 0.07);
  for (const double thick : { 0.3, 0.6, 1.0 })
    for (const bool slot : { false, true })
    {
      const AnalyticVolume body{ slot ? "slot" : "plate", [=](const glm::dvec3& p)
        {
          const double half = 0.5 * thick * v - std::abs(glm::dot(normal, p - at));
          return slot ? -half : half;
        } };
      const std::vector<float> coverage = ExactCoverage(body, grid, 4);
      std::vector<float> distances;
      const bool accepted = Accepted([&] { distances = CoverageDistance(grid, coverage); }) > 0.0;
      DistanceErrors errors(v);
      if (accepted)
        AddErrors(distances, TrueDistances(body, grid), grid,
          slot ? ErrorRange{ -8.0, -4.0, 8 } : ErrorRange{ 4.0, 8.0, 8 }, body.name, errors);
      // Gone: nothing is inside, or all is, and everything is infinitely far.
      const bool gone = accepted && std::all_of(distances.begin(), distances.end(),
                                      [](float d) { return std::isinf(d); });
      char text[160];
      std::snprintf(text, sizeof text,
        "a %s %.1f voxels wide alone: refused, gone, or true to half a voxel 4 to 8 voxels from "
        "it; is %s",
        slot ? "slot" : "plate", thick,
        !accepted ? "refused"
        : gone    ? "gone"
                  : "there");
      char id[40];
      std::snprintf(id, sizeof id, "distance.thin.%s%.0f", slot ? "slot" : "plate", 10.0 * thick);
      AddCase(context, id, text, !accepted || gone ? 0.0 : errors.Rms(), 0.5, "voxel RMS");
    }
}

/// Offsets inwards by more than there is.
void AddBeyond(ReportContext& context)
{
  const GridGeometry grid = TrialGrid(32);
  const SolidPointer ball = MakeCapsule(glm::dvec3(0.0), glm::dvec3(0.0), 3.0);
  const std::pair<const char*, SolidPointer> solids[] = { { "offset", MakeOffset(ball, -3.1) },
    { "shell", MakeShell(ball, -5.0, -3.1) } };
  for (const auto& [name, solid] : solids)
  {
    const std::vector<float> values = DenseValues(EvaluateNearSurface(*solid, grid, 1.2));
    const auto inside =
      std::count_if(values.begin(), values.end(), [](float value) { return value < 0.0F; });
    AddCase(context, std::string("distance.beyond.") + name,
      "inwards by more than the part's radius: nothing is left", static_cast<double>(inside), 0.0,
      "samples inside");
  }
  const AnalyticVolume body = AnalyticSphere(glm::dvec3(0.03), 3.0);
  const std::vector<float> distances = CoverageDistance(grid, ExactCoverage(body, grid));
  const float deepest = *std::min_element(distances.begin(), distances.end());
  AddCase(context, "distance.beyond.field", "nothing in a ball of 3 mm is deeper than its radius",
    std::max(0.0, -double(deepest) - 3.0), 0.02 * TrialVoxelMm, "mm deeper");
}

} // namespace

void TryDistanceImages(ReportContext& context)
{
  AddNoCoverage(context);
  AddThin(context);
  AddBeyond(context);
}

} // namespace hasp
