#include "Grid/Phantom.h"
#include "Grid/Stopwatch.h"
#include "Segmentation/RandomWalker.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

/// BenchKernelRandomWalker [spacing mm]: the phantom's skull with three cracks, four labels; a
/// solve from nothing, then one more stroke at a time.
namespace
{

using hasp::Label;

/// Signed distance from the three cracks, which part left from right, and front from back twice.
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

} // namespace

int main(int argc, char** argv)
{
  const double spacing = argc > 1 ? std::atof(argv[1]) : 0.7;
  hasp::PhantomSettings settings;
  settings.noiseHU = 40.0;
  settings.blurMm = glm::dvec3(0.5);
  const hasp::GridGeometry geometry = hasp::PhantomGrid(glm::dvec3(spacing), settings);
  std::vector<std::int16_t> samples = hasp::SamplePhantom(geometry, settings);
  for (int k = 0; k < geometry.dims.z; ++k)
    for (int j = 0; j < geometry.dims.y; ++j)
      for (int i = 0; i < geometry.dims.x; ++i)
      {
        const double d = CrackDistance(geometry.IndexToWorld({ i, j, k }));
        std::int16_t& s =
          samples[(static_cast<std::size_t>(k) * geometry.dims.y + j) * geometry.dims.x + i];
        s = static_cast<std::int16_t>(s - (s > 0 ? 0.8 * s * std::exp(-d * d / 0.3) : 0.0));
      }
  std::vector<Label> labels(samples.size());
  const hasp::GridView<const std::int16_t> grid{ samples.data(), geometry };
  hasp::ThresholdLabels(grid, 226.0, 1e6, { labels.data(), geometry });
  hasp::Stopwatch clock;
  auto graph = std::make_shared<hasp::VoxelGraph>(
    grid, hasp::GridView<const Label>{ labels.data(), geometry }, Label{ 1 });
  std::printf("%.1f M voxels of bone, %.2f M spans, graph %.2f s, %.0f MB\n", graph->Nodes() * 1e-6,
    graph->Spans().size() * 1e-6, clock.Milliseconds() / 1000, graph->Bytes() * 1e-6);
  clock = {};
  hasp::RandomWalker walker(graph);
  std::printf("multigrid %.2f s\n", clock.Milliseconds() / 1000);

  std::vector<hasp::WalkerSeed> seeds;
  const auto solve = [&](const char* what, const hasp::RandomWalkerSettings& how)
  {
    clock = {};
    walker.SetSeeds(seeds);
    const double set = clock.Milliseconds() / 1000;
    clock = {};
    const hasp::RandomWalkerRun run = walker.Solve(how);
    const double solved = clock.Milliseconds() / 1000;
    clock = {};
    std::vector<Label> out = labels;
    walker.WriteLabels({ out.data(), geometry });
    std::vector<float> now(3 * graph->Nodes());
    for (int n = 0; n < graph->Nodes(); ++n)
      for (int l = 0; l < 3; ++l)
        now[3 * n + l] = walker.Probability(n, l + 3);
    hasp::RandomWalkerSettings fine;
    fine.tolerance = 3e-6;
    walker.Solve(fine);
    float worst = 0;
    double sq = 0;
    for (int n = 0; n < graph->Nodes(); ++n)
      for (int l = 0; l < 3; ++l)
      {
        float e = std::abs(now[3 * n + l] - walker.Probability(n, l + 3));
        worst = std::max(worst, e);
        sq += e * e;
      }
    std::vector<Label> out2 = labels;
    walker.WriteLabels({ out2.data(), geometry });
    size_t wrong = 0;
    for (size_t v = 0; v < out.size(); ++v)
      wrong += out[v] != out2[v];
    std::printf("TRUE %.1e rms %.1e labels %.1e of bone ", worst, std::sqrt(sq / now.size()),
      double(wrong) / graph->Nodes());
    std::printf(
      "%-28s set %.2f s, solve %.2f s, write %.2f s, %d iterations (%d coarse), error %.1e\n", what,
      set, solved, clock.Milliseconds() / 1000, run.iterations, run.coarseIterations, run.error);
    return out;
  };
  const auto outer = [&](double x, double y, double z) {
    return hasp::PhantomOuterTable(settings, { x, y, z });
  };
  Stroke(*graph, outer(1, 0.8, 0.5), 4.0, 2, seeds);
  Stroke(*graph, outer(-1, 0.8, 0.5), 4.0, 3, seeds);
  Stroke(*graph, outer(1, -1, 0.5), 4.0, 4, seeds);
  Stroke(*graph, outer(-1, -0.3, 0.9), 4.0, 5, seeds);
  for (const double tolerance : { 2e-2, 5e-3, 1e-3 })
    for (const bool coarse : { false, true })
    {
      hasp::RandomWalkerSettings how;
      how.tolerance = tolerance;
      how.coarseStart = coarse;
      walker.Reset();
      char what[64];
      std::snprintf(what, sizeof what, "cold %.0e%s", tolerance, coarse ? " coarse start" : "");
      solve(what, how);
    }
  for (const double tolerance : { 2e-2, 5e-3, 1e-3 })
    for (const bool coarse : { true })
    {
      hasp::RandomWalkerSettings how;
      how.tolerance = tolerance;
      how.coarseStart = coarse;
      const std::size_t before = seeds.size();
      walker.Reset();
      solve("again", how);
      char what[64];
      Stroke(*graph, outer(0.3, 1, 0.2), 3.0, 2, seeds);
      std::snprintf(
        what, sizeof what, "warm %.0e%s, same label", tolerance, coarse ? " coarse" : "");
      solve(what, how);
      Stroke(*graph, outer(-0.3, 1, 0.6), 3.0, 2, seeds);
      std::snprintf(
        what, sizeof what, "warm %.0e%s, other label", tolerance, coarse ? " coarse" : "");
      solve(what, how);
      seeds.resize(before);
    }
  std::printf("walker %.0f MB\n", walker.Bytes() * 1e-6);
  return 0;
}
