#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "TrialScan.h"

#include "Segmentation/Testing/DirectSolution.h"
#include "Studies/FractureCases.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

namespace hasp
{
namespace
{

/// A shattered ball, and seeds of a stroke for each fragment.
struct SmallCase
{
  FracturedScan scan = ShatteredBall(6, 9.0, 0.9, 5);
  std::shared_ptr<const VoxelGraph> graph;
  std::vector<WalkerSeed> seeds;

  SmallCase()
  {
    const GridView<const std::int16_t> grey{ this->scan.samples.data(), this->scan.geometry };
    const TrialBone bone(grey, FractureSettings{}.boneHU);
    this->graph = std::make_shared<const VoxelGraph>(grey, bone.View(), Label{ 1 });
    const CoarseTruth known({ this->scan.truth.data(), this->scan.geometry });
    std::vector<BrushStroke> strokes;
    for (const CoarseHint& hint : known.Hints())
      strokes.push_back(DrawStroke(bone.View(), hint));
    const glm::ivec3 dims = this->scan.geometry.dims;
    std::vector<Label> marked(this->scan.geometry.Size());
    for (const SeedVoxels& seed : bone.Seeds(strokes))
      for (const VoxelRun& run : seed.voxels)
        std::fill_n(marked.begin() + std::ptrdiff_t(run.first), run.length, seed.label);
    for (std::size_t v = 0; v < marked.size(); ++v)
      if (const std::int32_t node = this->graph->NodeAt(
            int(v % dims.x), int(v / dims.x % dims.y), int(v / dims.x / dims.y));
          marked[v] != 0 && node >= 0)
        this->seeds.push_back({ node, marked[v] });
  }
};

} // namespace

void TryDirect(ReportContext& context)
{
  context.progress(0.0, "segmentation: a direct solver");
  const SmallCase small;
  std::vector<std::vector<double>> direct;
  const Timing directTime =
    TimeOf([&] { direct = testing::DirectSolution(*small.graph, small.seeds); });
  RandomWalkerSettings tight;
  tight.tolerance = 1e-9;
  RandomWalker walker(small.graph);
  walker.SetSeeds(small.seeds);
  const Timing time = TimeOf([&] { walker.Solve(tight); });
  const std::vector<Label> labels = testing::LabelsOf(small.seeds);
  double worst = 0.0;
  for (std::size_t l = 0; l < labels.size(); ++l)
    for (std::int32_t n = 0; n < small.graph->Nodes(); ++n)
      worst = std::max(
        worst, std::abs(walker.Probability(n, labels[l]) - direct[l][static_cast<std::size_t>(n)]));
  char text[120];
  std::snprintf(
    text, sizeof text, "Eigen's SimplicialLDLT in long double, %.3g s", directTime.wallS);
  ReportRow row =
    ErrorFigure("segmentation.direct", { worst, "of probabilities, at most" }, text, time,
      "shattered ball, " + std::to_string(small.graph->Nodes()) + " voxels, " +
        std::to_string(labels.size()) + " labels, tolerance 1e-9");
  row.bars = { { {}, 1e-6 } };
  context.report.rows.push_back(row);
}

} // namespace hasp
