#include "Distance/ChamferDistance.h"
#include "Distance/CoverageDistance.h"
#include "Distance/EuclideanDistance.h"
#include "DistanceErrors.h"
#include "DistanceTrials.h"
#include "ReportRegistry.h"
#include "TrialShapes.h"
#include "TrialTimes.h"

#include <map>

namespace hasp
{
namespace
{

/// ms of CPU and RMS within 3 voxels; the median of three runs.
std::pair<double, double> PointOf(const std::function<void()>& run,
  const std::function<std::vector<float>()>& distances, const std::vector<double>& truth,
  const GridGeometry& grid)
{
  std::vector<double> ms;
  for (int n = 0; n < 3; ++n)
    ms.push_back(OnThreads(1, [&] { return 1e3 * TimeOf(run).cpuS; }));
  DistanceErrors errors(TrialVoxelMm);
  AddErrors(distances(), truth, grid, {}, "", errors);
  return { QuartilesOf(ms).median, errors.Rms() };
}

} // namespace

void DrawCurves(ReportContext& context, const std::vector<RivalTransform>& rivals)
{
  std::vector<int> sizes{ 32, 64, 128 };
  if (!context.settings.quick)
    sizes.push_back(256);
  std::map<std::string, std::vector<std::pair<double, double>>> curves;
  for (const int samples : sizes)
  {
    const AnalyticVolume shape =
      AnalyticSphere(0.31 * glm::dvec3(TrialVoxelMm), TrialVoxelMm * 80.3 * samples / 256.0);
    TransformInput input;
    input.grid = TrialGrid(samples);
    input.coverage = ExactCoverage(shape, input.grid);
    input.mask = MaskOf(input.coverage);
    const std::vector<double> truth = TrueDistances(shape, input.grid);
    const std::vector<float> binary(input.mask.begin(), input.mask.end());
    std::vector<float> field;
    const auto draw = [&](const char* name, const std::function<std::vector<float>()>& transform)
    {
      curves[name].push_back(
        PointOf([&] { field = transform(); }, [&] { return field; }, truth, input.grid));
    };
    draw("<3,4,5>, binary", [&] { return ChamferDistance(input.grid, binary); });
    draw("<3,4,5>, anti-aliased", [&] { return ChamferDistance(input.grid, input.coverage); });
    draw(
      "exact Euclidean, binary", [&] { return SignedEuclideanDistance(input.grid, input.mask); });
    draw("guides', full field", [&] { return CoverageDistance(input.grid, input.coverage); });
    draw("guides', band", [&] { return CoverageDistanceBand(input.grid, input.coverage); });
    for (const RivalTransform& rival : rivals)
      if (rival.absent.empty() && rival.key != "openvdb.mesh.far") // the same error, later
      {
        const auto theirs = rival.make(input);
        curves[rival.key].push_back(
          PointOf([&] { theirs->Run(); }, [&] { return theirs->Distances(); }, truth, input.grid));
      }
  }
  for (const auto& [method, points] : curves)
    context.report.curves.push_back({ "distance.error_time", method, "ms", "voxel", points });
}

} // namespace hasp
