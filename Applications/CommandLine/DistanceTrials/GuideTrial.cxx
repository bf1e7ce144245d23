#include "Distance/ChamferDistance.h"
#include "Distance/CoverageDistance.h"
#include "DistanceErrors.h"
#include "DistanceTrials.h"
#include "ReportRegistry.h"
#include "TrialShapes.h"
#include "TrialTimes.h"

#include <cstdio>

namespace hasp
{
namespace
{

struct Size
{
  int samples;
  double sphere;       ///< radius, voxels
  double major, minor; ///< of the torus
};
constexpr Size Near[] = { { 36, 12.3, 0.0, 0.0 }, { 88, 0.0, 26.0, 12.2 }, { 80, 33.7, 0.0, 0.0 } };
constexpr Size Far[] = { { 128, 40.3, 0.0, 0.0 }, { 128, 0.0, 38.0, 14.0 } };

AnalyticVolume Shape(const Size& size, const glm::dvec3& centre, std::mt19937_64& random)
{
  const double v = TrialVoxelMm;
  AnalyticVolume shape = size.sphere > 0.0 ? AnalyticSphere(v * centre, v * size.sphere)
                                           : AnalyticTorus(v * centre, AnyDirection(random),
                                               v * size.major, v * size.minor);
  char name[60];
  if (size.sphere > 0.0)
    std::snprintf(name, sizeof name, "sphere R %.1f", size.sphere);
  else
    std::snprintf(name, sizeof name, "torus %.1f/%.1f", size.major, size.minor);
  shape.name = name;
  return shape;
}

struct Outcome
{
  DistanceErrors worst{ TrialVoxelMm }, all{ TrialVoxelMm };
  Timing time; ///< of the last run
  std::string names;
};

/// Errors of one shape at so many centres; the worst shape's by RMS is kept.
void Measure(ReportContext& context, const Size& size, bool far, int step, Outcome& outcome)
{
  const GridGeometry grid = TrialGrid(size.samples);
  std::mt19937_64 random(context.settings.seed);
  DistanceErrors errors(TrialVoxelMm);
  std::string name;
  for (int n = 0; n < 27; n += step)
  {
    const AnalyticVolume shape = Shape(size, SubVoxelCentre(n, context.settings.seed), random);
    const std::vector<float> coverage = ExactCoverage(shape, grid);
    std::vector<float> distances;
    outcome.time = OnThreads(1,
      [&]
      {
        return TimeOf(
          [&] {
            distances =
              far ? CoverageDistance(grid, coverage) : CoverageDistanceBand(grid, coverage);
          });
      });
    ErrorRange range;
    if (far)
      range = { -40.0, 40.0, 0 };
    AddErrors(distances, TrueDistances(shape, grid), grid, range, shape.name, errors);
    name = shape.name;
  }
  if (outcome.worst.Count() == 0 || errors.Rms() > outcome.worst.Rms())
    outcome.worst = errors;
  outcome.all.Add(errors);
  outcome.names += (outcome.names.empty() ? "" : ", ") + name + " voxels in " +
                   std::to_string(size.samples) + "^3";
}

std::string DataOf(const Outcome& outcome, int centres, const char* aim)
{
  return outcome.names + ", " + std::to_string(centres) +
         " centres, turned any way, exact coverage; the worst shape: " + outcome.worst.Text() +
         "; aim " + aim;
}

/// Time of the band and of the full field / anti-aliased <3,4,5>, on a sphere that scales.
void AddCosts(ReportContext& context, int samples, bool plain)
{
  const GridGeometry grid = TrialGrid(samples);
  const double scale = TrialVoxelMm * samples / 256.0;
  const AnalyticVolume shape = AnalyticSphere(0.31 * glm::dvec3(TrialVoxelMm), 80.3 * scale);
  const std::vector<float> coverage = ExactCoverage(shape, grid);
  const std::vector<double> truth = TrueDistances(shape, grid);
  std::vector<float> chamfer, ours;
  for (const bool far : { false, true })
  {
    const PairedTimes times = RaceOnThreads(
      1,
      [&] { ours = far ? CoverageDistance(grid, coverage) : CoverageDistanceBand(grid, coverage); },
      [&] { chamfer = ChamferDistance(grid, coverage); }, 9);
    ErrorRange range;
    if (far)
      range = { -40.0, 40.0, 0 };
    DistanceErrors error(TrialVoxelMm), rival(TrialVoxelMm);
    AddErrors(ours, truth, grid, range, shape.name, error);
    AddErrors(chamfer, truth, grid, range, shape.name, rival);
    char text[160];
    std::snprintf(text, sizeof text,
      "sphere R %.1f voxels in %d^3, one thread, within %s voxels; aim %s",
      shape.value(0.31 * glm::dvec3(TrialVoxelMm)) / TrialVoxelMm, samples, far ? "40" : "3",
      far ? "2" : "1");
    std::string id = far ? "distance.cost.far" : "distance.cost.guide";
    if (!plain)
      id.append("@").append(std::to_string(samples));
    ReportRow row =
      CpuRatio(id, times, "anti-aliased <3,4,5>: " + rival.Text(), { error.Rms(), "voxel" }, text);
    row.bars = { { {}, far ? 4.0 : 2.0 } };
    context.report.rows.push_back(row);
  }
}

} // namespace

void TryGuides(ReportContext& context)
{
  const bool quick = context.settings.quick;
  Outcome near, far;
  for (const Size& size : Near)
    Measure(context, size, false, quick ? 9 : 1, near);
  for (const Size& size : Far)
    Measure(context, size, true, quick ? 13 : 1, far);
  const int nearCentres = quick ? 3 : 27;
  ReportRow rms = ErrorFigure("distance.rms.guide", { near.worst.Rms(), "voxel" }, "closed form",
    near.time, DataOf(near, nearCentres, "0.003"));
  rms.bars = { { {}, 0.01 } };
  ReportRow max = ErrorFigure("distance.max.guide", { near.all.Most(), "voxel" }, "closed form",
    near.time, "the same; all shapes: " + near.all.Text() + "; aim 0.012");
  max.bars = { { {}, 0.04 } };
  ReportRow field = ErrorFigure("distance.rms.far", { far.worst.Rms(), "voxel" }, "closed form",
    far.time, DataOf(far, nearCentres, "0.02"));
  field.bars = { { {}, 0.03 } };
  for (ReportRow* row : { &rms, &max })
    row->n = static_cast<int>(near.all.Count());
  field.n = static_cast<int>(far.all.Count());
  context.report.rows.insert(context.report.rows.end(), { rms, max, field });
  AddCosts(context, quick ? 128 : 256, true);
  if (!quick)
    AddCosts(context, 128, false);
}

} // namespace hasp
