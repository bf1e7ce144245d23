#include "Distance/CoverageDistance.h"
#include "Distance/EuclideanDistance.h"
#include "DistanceErrors.h"
#include "DistanceTrials.h"
#include "ReportRegistry.h"
#include "TrialShapes.h"
#include "TrialTimes.h"

#include <algorithm>
#include <cstdio>

namespace hasp
{
namespace
{

struct Ball
{
  TransformInput input;
  std::vector<double> truth;
  std::string name;

  explicit Ball(int samples)
  {
    const double radius = 80.3 * samples / 256.0;
    const AnalyticVolume shape =
      AnalyticSphere(0.31 * glm::dvec3(TrialVoxelMm), TrialVoxelMm * radius);
    this->input.grid = TrialGrid(samples);
    this->input.coverage = ExactCoverage(shape, this->input.grid);
    this->input.mask = MaskOf(this->input.coverage);
    this->truth = TrueDistances(shape, this->input.grid);
    char text[60];
    std::snprintf(text, sizeof text, "sphere R %.1f voxels in %d^3", radius, samples);
    this->name = text;
  }
  DistanceErrors Errors(const std::vector<float>& distances, double withinVoxels) const
  {
    DistanceErrors errors(TrialVoxelMm);
    AddErrors(distances, this->truth, this->input.grid, { -withinVoxels, withinVoxels, 0 },
      "the sphere", errors);
    return errors;
  }
};

/// Of masks, and of rivals that are as exact: voxels a second, ours / theirs.
void RaceExact(ReportContext& context, const RivalTransform& rival, Ball& ball, int threads,
  const std::string& id, bool bar)
{
  if (!rival.absent.empty())
  {
    context.report.rows.push_back(AbsentRow(id, rival.name, rival.absent));
    return;
  }
  ball.input.threads = threads;
  const auto theirs = rival.make(ball.input);
  std::vector<float> ours;
  const PairedTimes times = RaceOnThreads(
    threads, [&] { ours = SignedEuclideanDistance(ball.input.grid, ball.input.mask); },
    [&] { theirs->Run(); }, 9);
  const DistanceErrors error = ball.Errors(ours, 3.0);
  char text[200];
  const double voxels = 1e-6 * static_cast<double>(ball.input.grid.Size());
  std::snprintf(text, sizeof text,
    "mask of a %s, %d thread%s each; %.1f Mvoxel/s, theirs %.1f; within 3 voxels; aim 2",
    ball.name.c_str(), threads, threads > 1 ? "s" : "", voxels / times.a.wallS,
    voxels / times.b.wallS);
  const std::string beside = rival.name + ": " + ball.Errors(theirs->Distances(), 3.0).Text();
  // One thread: CPU time, which others' work does not blur. Several: what the user waits for.
  ReportRow row = threads == 1
                    ? CpuRatio(id, times, beside, { error.Rms(), "voxel" }, text, true)
                    : TimedRatio(id, times, beside, { error.Rms(), "voxel" }, text, true);
  if (bar)
    row.bars = { { 1.3, {} } };
  context.report.rows.push_back(row);
}

void RaceField(ReportContext& context, const RivalTransform& rival, const Ball& ball)
{
  const std::string id = "distance.field." + rival.key;
  if (!rival.absent.empty())
  {
    context.report.rows.push_back(AbsentRow(id, rival.name, rival.absent));
    return;
  }
  const auto theirs = rival.make(ball.input);
  const GridGeometry& grid = ball.input.grid;
  std::vector<float> ours;
  const PairedTimes times = RaceOnThreads(
    1,
    [&]
    {
      ours = rival.band ? CoverageDistanceBand(grid, ball.input.coverage)
                        : CoverageDistance(grid, ball.input.coverage);
    },
    [&] { theirs->Run(); }, 9);
  const double within = rival.band ? 3.0 : 40.0;
  const DistanceErrors error = ball.Errors(ours, within);
  context.report.rows.push_back(CpuRatio(id, times,
    rival.name + ": " + ball.Errors(theirs->Distances(), within).Text(), { error.Rms(), "voxel" },
    ball.name + ", one thread, " + (rival.band ? "band, within 3" : "full field, within 40") +
      " voxels"));
}

} // namespace

void TryRivals(ReportContext& context, const std::vector<RivalTransform>& rivals)
{
  const bool quick = context.settings.quick;
  {
    Ball ball(quick ? 128 : 256);
    for (const RivalTransform& rival : rivals)
      if (rival.exact && rival.key == "itk")
        for (const int threads : { 1, 2 })
          RaceExact(context, rival, ball, threads,
            std::string("distance.speed.edt") + (threads == 1 ? "" : "@2threads"), true);
      else if (rival.exact) // VTK's has one thread alone
        RaceExact(context, rival, ball, 1, "distance.speed.edt." + rival.key, false);
  }
  const Ball ball(quick ? 64 : 128);
  for (const RivalTransform& rival : rivals)
    RaceField(context, rival, ball);
}

} // namespace hasp
