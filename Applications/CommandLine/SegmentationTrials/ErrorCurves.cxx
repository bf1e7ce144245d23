#include "ErrorCurves.h"

#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "SplitRival.h"

#include "Segmentation/Components.h"

namespace hasp
{
namespace
{

double MedianSeconds(const std::function<void()>& run)
{
  std::vector<double> seconds;
  for (int n = 0; n < 3; ++n)
    seconds.push_back(TimeOf(run).wallS);
  return QuartilesOf(seconds).median;
}

/// A line of each chart.
struct Line
{
  std::string method;
  std::vector<std::pair<double, double>> dice{}, surface{};

  void Add(double seconds, const SegmentationDice& figure)
  {
    this->dice.emplace_back(seconds, 1.0 - figure.Worst().Dice());
    this->surface.emplace_back(seconds, 1.0 - figure.WorstSurface().SurfaceDice());
  }
};

Line WalkerLine(const std::string& method, double norm, const TrialScan& scan,
  const TrialBone& bone, const std::vector<SeedVoxels>& seeds)
{
  Line line{ method + ", tolerance 0.1 to 1e-4" };
  for (const double tolerance : { 0.1, 2e-2, 5e-3, 1e-3, 1e-4 })
  {
    RandomWalkerSettings settings;
    settings.tolerance = tolerance;
    std::vector<Label> labels;
    const double seconds = MedianSeconds(
      [&]
      {
        labels.assign(bone.View().data, bone.View().data + scan.scan.geometry.Size());
        LabelSplit split(bone.Grey(), bone.View(), 1, { {}, norm });
        split.Share(seeds, { labels.data(), scan.scan.geometry }, settings);
      });
    line.Add(seconds, CompareWithTruth(scan, labels, LabelPairing::SameNumber));
  }
  return line;
}

/// Higher thresholds open cracks, and lose bone.
Line ComponentsLine(const TrialScan& scan)
{
  Line line{ "components above 226, 350, 500, 700 HU" };
  for (const double threshold : { 226.0, 350.0, 500.0, 700.0 })
  {
    constexpr double LeastMm3 = 20.0; // of dust there are thousands of pieces
    std::vector<Label> labels(scan.scan.geometry.Size());
    const double seconds = MedianSeconds(
      [&]
      {
        const GridView<Label> view{ labels.data(), scan.scan.geometry };
        ThresholdLabels(scan.Samples(), threshold, 1e6, view);
        SeparateComponents(view, 1, { LeastMm3, false });
      });
    line.Add(seconds, CompareWithTruth(scan, labels, LabelPairing::BestMatch));
  }
  return line;
}

} // namespace

void DrawErrorCurves(ReportContext& context, const TrialScan& scan, const TrialBone& bone,
  const std::vector<BrushStroke>& strokes)
{
  const std::vector<SeedVoxels> seeds = bone.Seeds(strokes);
  std::vector<Line> lines{ WalkerLine("least cut, norm 1", 1.0, scan, bone, seeds),
    WalkerLine("random walker, norm 2", 2.0, scan, bone, seeds), ComponentsLine(scan) };
  const SplitInput input{ scan.Samples(), bone.View(), seeds };
  for (const SplitRival& rival : WatershedRivals())
    if (rival.absent.empty())
    {
      const auto theirs = rival.make(input);
      Line line{ rival.name };
      const double seconds = MedianSeconds([&] { theirs->Run(); });
      line.Add(seconds, CompareWithTruth(scan, theirs->Labels(), LabelPairing::SameNumber));
      lines.push_back(line);
    }
  for (const Line& line : lines)
  {
    context.report.curves.push_back(
      { "segmentation.error_time@" + scan.key, line.method, "s", "1 - Dice", line.dice });
    context.report.curves.push_back({ "segmentation.surface_time@" + scan.key, line.method, "s",
      "1 - surface Dice", line.surface });
  }
}

} // namespace hasp
