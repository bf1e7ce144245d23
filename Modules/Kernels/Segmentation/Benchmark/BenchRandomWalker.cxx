#include "Grid/Phantom.h"
#include "Grid/Stopwatch.h"
#include "Segmentation/RandomWalker.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <utility>
#include <vector>

/// BenchKernelRandomWalker [spacing mm] [errors]: the phantom's skull with two cracks across each
/// other, four labels; a solve from nothing, then one more stroke, at several tolerances. With a
/// second argument also how far off: against the same solved on.
namespace
{

using hasp::Label;

/// mm from the nearer of two wavy cracks, which part left from right and front from back.
double CrackDistance(const glm::dvec3& p)
{
  const double wave = 0.8 * std::sin(p.y * 0.4) * std::sin(p.z * 0.35);
  const double a = p.x - 3.0 - wave;
  const double b = p.y + 20.0 - 0.3 * p.z - 0.8 * std::sin(p.x * 0.3);
  return std::abs(a) < std::abs(b) ? a : b;
}

void Stroke(const hasp::VoxelGraph& graph, const glm::dvec3& middle, double radiusMm, Label label,
  std::vector<hasp::WalkerSeed>& seeds)
{
  const hasp::GridGeometry& geometry = graph.Geometry();
  const glm::dvec3 centre = geometry.WorldToIndex(middle);
  const glm::dvec3 reach = radiusMm / geometry.spacing;
  for (int k = static_cast<int>(centre.z - reach.z); k <= centre.z + reach.z; ++k)
    for (int j = static_cast<int>(centre.y - reach.y); j <= centre.y + reach.y; ++j)
      for (int i = static_cast<int>(centre.x - reach.x); i <= centre.x + reach.x; ++i)
        if (const std::int32_t node = graph.NodeAt(i, j, k);
            node >= 0 && glm::length(geometry.IndexToWorld({ i, j, k }) - middle) <= radiusMm)
          seeds.push_back({ node, label });
}

struct Skull
{
  hasp::PhantomSettings settings;
  hasp::GridGeometry geometry;
  std::vector<std::int16_t> samples;
  std::vector<Label> labels;

  explicit Skull(double spacing)
  {
    settings.noiseHU = 40.0;
    settings.blurMm = glm::dvec3(0.5);
    geometry = hasp::PhantomGrid(glm::dvec3(spacing), settings);
    samples = hasp::SamplePhantom(geometry, settings);
    std::size_t v = 0;
    for (int k = 0; k < geometry.dims.z; ++k)
      for (int j = 0; j < geometry.dims.y; ++j)
        for (int i = 0; i < geometry.dims.x; ++i, ++v)
          if (samples[v] > 0)
          {
            const double d = CrackDistance(geometry.IndexToWorld({ i, j, k }));
            samples[v] =
              static_cast<std::int16_t>(samples[v] * (1.0 - 0.8 * std::exp(-d * d / 0.3)));
          }
    labels.resize(samples.size());
    hasp::ThresholdLabels(Grid(), 226.0, 1e6, { labels.data(), geometry });
  }
  hasp::GridView<const std::int16_t> Grid() const { return { samples.data(), geometry }; }
  glm::dvec3 Outer(const glm::dvec3& direction) const
  {
    return hasp::PhantomOuterTable(settings, direction);
  }
};

struct Trial
{
  const Skull& skull;
  hasp::RandomWalker& walker;
  bool errors;

  /// All probabilities but the last label's, and labels.
  std::pair<std::vector<float>, std::vector<Label>> Answer() const
  {
    std::pair<std::vector<float>, std::vector<Label>> answer;
    for (std::int32_t n = 0; errors && n < walker.Graph().Nodes(); ++n)
      for (const Label label : { Label{ 2 }, Label{ 3 }, Label{ 4 } })
        answer.first.push_back(static_cast<float>(walker.Probability(n, label)));
    answer.second = skull.labels;
    walker.WriteLabels({ answer.second.data(), skull.geometry });
    return answer;
  }

  void Run(const char* what, const std::vector<hasp::WalkerSeed>& seeds,
    const hasp::RandomWalkerSettings& how)
  {
    const hasp::Stopwatch setClock;
    walker.SetSeeds(seeds);
    const double set = setClock.Milliseconds();
    const hasp::Stopwatch clock;
    const std::clock_t start = std::clock();
    const hasp::RandomWalkerRun run = walker.Solve(how);
    const double cpu = static_cast<double>(std::clock() - start) * 1e3 / CLOCKS_PER_SEC;
    std::printf("%-22s tolerance %.0e: seeds %4.0f ms, solve %5.0f ms (%5.0f of cores), %2d "
                "cycles, work %.2f (%d coarse)",
      what, how.tolerance, set, clock.Milliseconds(), cpu, run.iterations, run.work,
      run.coarseIterations);
    if (errors)
    {
      const auto answer = Answer();
      walker.Solve({ .tolerance = 2e-6 });
      const auto truth = Answer();
      float worst = 0.0F;
      for (std::size_t n = 0; n < truth.first.size(); ++n)
        worst = std::max(worst, std::abs(answer.first[n] - truth.first[n]));
      std::size_t wrong = 0;
      for (std::size_t v = 0; v < truth.second.size(); ++v)
        wrong += answer.second[v] != truth.second[v] ? 1 : 0;
      std::printf(", estimate %.1e, error %.1e, labels %.1e of bone", run.error, worst,
        static_cast<double>(wrong) / static_cast<double>(walker.Graph().Nodes()));
    }
    std::printf("\n");
  }
};

} // namespace

int main(int argc, char** argv)
{
  const Skull skull(argc > 1 ? std::atof(argv[1]) : 0.7);
  const hasp::Stopwatch graphClock;
  auto graph = std::make_shared<hasp::VoxelGraph>(
    skull.Grid(), hasp::GridView<const Label>{ skull.labels.data(), skull.geometry }, Label{ 1 });
  std::printf("%.2f M voxels of bone, %.2f M spans, graph %.0f ms, %.0f MB\n",
    static_cast<double>(graph->Nodes()) * 1e-6, static_cast<double>(graph->Spans().size()) * 1e-6,
    graphClock.Milliseconds(), static_cast<double>(graph->Bytes()) * 1e-6);
  const hasp::Stopwatch walkerClock;
  hasp::RandomWalker walker(graph);
  std::printf("coarse graphs %.0f ms\n", walkerClock.Milliseconds());

  std::vector<hasp::WalkerSeed> seeds;
  Stroke(*graph, skull.Outer({ 1, 0.8, 0.5 }), 4.0, 2, seeds);
  Stroke(*graph, skull.Outer({ -1, 0.8, 0.5 }), 4.0, 3, seeds);
  Stroke(*graph, skull.Outer({ 1, -1, 0.5 }), 4.0, 4, seeds);
  Stroke(*graph, skull.Outer({ -1, -0.3, 0.9 }), 4.0, 5, seeds);
  std::vector<hasp::WalkerSeed> same = seeds;
  Stroke(*graph, skull.Outer({ 0.3, 1, 0.2 }), 3.0, 2, same);
  std::vector<hasp::WalkerSeed> other = same;
  Stroke(*graph, skull.Outer({ -0.3, 1, 0.6 }), 3.0, 2, other);
  Trial trial{ skull, walker, argc > 2 };
  for (const double tolerance : { 2e-2, 1e-2, 5e-3, 1e-3 })
  {
    walker.Reset();
    trial.Run(
      "from nothing", seeds, { .tolerance = tolerance, .coarseStart = false, .localEnd = false });
    walker.Reset();
    trial.Run("from coarse graphs", seeds, { .tolerance = tolerance });
    trial.Run("one more stroke", same, { .tolerance = tolerance });
    trial.Run("a stroke of another", other, { .tolerance = tolerance });
  }
  std::printf("solver %.0f MB\n", static_cast<double>(walker.Bytes()) * 1e-6);
  return 0;
}
