#include "DistanceCases.h"

#include "Distance/NearSurface.h"
#include "DistanceCase.h"
#include "RandomTree.h"
#include "TrialTimes.h"

#include <cstring>

namespace hasp
{

void TryDistanceThreads(ReportContext& context)
{
  const GridGeometry grid{ { 61, 50, 43 }, { -12.2, -10, -12.9 }, { 0.4, 0.4, 0.6 },
    glm::dmat3(1) };
  const AnalyticVolume torus =
    AnalyticTorus(glm::dvec3(0.1), { 1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0 }, 6.0, 2.5);
  const std::vector<float> coverage = ExactCoverage(torus, grid);
  const std::vector<float> image = ScannedImage(torus, grid, 0.8, 0.03, context.settings.seed);
  RandomTreeSettings settings;
  settings.depth = 4;
  const SolidPointer tree = SolidOf(RandomTree(7, settings));
  const std::pair<const char*, std::function<std::vector<float>()>> makers[] = {
    { "chamfer", [&] { return ChamferDistance(grid, coverage); } },
    { "exact", [&] { return SignedEuclideanDistance(grid, MaskOf(coverage)); } },
    { "band", [&] { return CoverageDistanceBand(grid, coverage); } },
    { "guide", [&] { return CoverageDistance(grid, coverage); } },
    { "grey",
      [&] {
        return GreyDistance(GridView<const float>{ image.data(), grid }, 0.5);
      } },
    { "tree", [&] { return EvaluateNearSurface(*tree, TrialGrid(48), 1.2).values; } },
  };
  for (const auto& [name, make] : makers)
  {
    const std::vector<float> one = OnThreads(1, make);
    double different = 0.0;
    for (const int threads : { 2, 4 })
    {
      const std::vector<float> many = OnThreads(threads, make);
      different += many.size() != one.size() ||
                   std::memcmp(many.data(), one.data(), one.size() * sizeof(float)) != 0;
    }
    AddCase(context, std::string("distance.threads.") + name,
      "1, 2 and 4 threads: the same to the last bit", different, 0.0, "of 2 that differ");
  }
}

void TryDistanceCases(ReportContext& context)
{
  context.progress(0.0, "stability: distances");
  TryDistanceGrids(context);
  context.progress(0.5, "");
  TryDistanceImages(context);
  context.progress(0.7, "");
  TryDistanceThreads(context);
  context.progress(0.9, "");
  TryContourCases(context);
}

} // namespace hasp
