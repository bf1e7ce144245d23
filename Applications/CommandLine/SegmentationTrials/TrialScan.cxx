#include "TrialScan.h"

#include "Pairing.h"
#include "ReportRegistry.h"

#include "Grid/Stopwatch.h"
#include "Segmentation/Brush.h"
#include "Segmentation/Components.h"
#include "Segmentation/LabelMorphology.h"
#include "Studies/FractureCases.h"

#include <algorithm>
#include <cstdio>

namespace hasp
{
namespace
{

constexpr double KerfMm = 1.0; ///< of a saw

std::string SizeText(const GridGeometry& grid)
{
  char text[100];
  std::snprintf(text, sizeof text, "%d x %d x %d voxels of %.3g x %.3g x %.3g mm", grid.dims.x,
    grid.dims.y, grid.dims.z, grid.spacing.x, grid.spacing.y, grid.spacing.z);
  return text;
}

TrialScan Phantom(const std::string& key, const FractureCase& broken)
{
  TrialScan scan{ key, {}, BreakPhantom(broken.geometry, broken.settings) };
  char crack[60];
  std::snprintf(crack, sizeof crack, ", cracks of %.1f mm", broken.settings.crackMm);
  scan.data = broken.name + " phantom, " + std::to_string(scan.scan.names.size()) + " fragments, " +
              SizeText(broken.geometry) + crack;
  return scan;
}

} // namespace

TrialScanSettings ScanSettings(const ReportContext& context)
{
  TrialScanSettings settings;
  settings.seed = context.settings.seed;
  if (context.settings.quick)
  {
    settings.headMm = 1.4;
    settings.mandibleMm = 1.0;
  }
  return settings;
}

void ForEachTrialScan(const TrialScanSettings& settings, const RealSkull& skull,
  const std::function<void(const TrialScan&)>& visit)
{
  FractureCaseSettings broken;
  broken.coneBeam = settings.coneBeam;
  broken.seed = settings.seed;
  broken.spacingMm = settings.headMm;
  visit(Phantom("head", BrokenHead(broken)));
  broken.spacingMm = settings.mandibleMm;
  visit(Phantom("mandible", BrokenMandible(broken)));
  if (skull.samples.empty())
    return;
  const GridView<const std::int16_t> intact{ skull.samples.data(), skull.geometry };
  const std::vector<std::uint8_t> named = LargestBone(intact, FractureSettings{}.boneHU);
  const auto plant = [&](const std::string& key, double widthMm, bool isTrial)
  {
    broken.crackMm = widthMm;
    const FractureSettings cuts = PlantedCuts(intact, named, broken);
    TrialScan scan{ key, {}, BreakScan(intact, cuts, named), isTrial };
    char text[80];
    std::snprintf(
      text, sizeof text, ", %zu planted pieces, cuts of %.1f mm", cuts.pieces.size(), widthMm);
    scan.data = skull.data + ", " + SizeText(skull.geometry) + text;
    visit(scan);
  };
  plant("cranium", KerfMm, true);
  plant("cranium_hairline", FractureCaseSettings{}.crackMm, false);
}

TrialBone::TrialBone(const AnyGridView& grey, double threshold)
  : Samples(grey),
    Geometry(GeometryOf(grey)),
    Mask(GeometryOf(grey).Size())
{
  ThresholdLabels(grey, threshold, 1e6, { this->Mask.data(), this->Geometry });
}

TrialBone::TrialBone(
  const AnyGridView& grey, const AnyGridView& smooth, double threshold, double closeMm)
  : TrialBone(smooth, threshold)
{
  this->Samples = grey;
  const GridView<Label> mask{ this->Mask.data(), this->Geometry };
  CloseLabel(mask, 1, closeMm);
  FillCavities(mask, 1);
}

std::vector<SeedVoxels> TrialBone::Seeds(const std::vector<BrushStroke>& strokes) const
{
  std::vector<SeedVoxels> seeds;
  for (const BrushStroke& stroke : strokes)
    seeds.push_back(
      { stroke.label, RasterizeStroke(this->Geometry, stroke.points, stroke.radiusMm) });
  return seeds;
}

TrialResult TryUser(const TrialBone& bone, const TrialScan& scan, int strokes, std::uint64_t seed)
{
  CoarseTruthSettings coarse;
  coarse.seed = seed;
  const CoarseTruth known(scan.Truth(), coarse);
  const std::size_t voxels = scan.scan.geometry.Size();
  TrialResult result;
  const Stopwatch made;
  LabelSplit split(bone.Grey(), bone.View(), 1);
  const double madeS = 1e-3 * made.Milliseconds();
  std::vector<double> more;
  result.user = SimulateUser(bone.View(), known, { strokes },
    [&](const std::vector<BrushStroke>& drawn)
    {
      std::vector<Label> labels(bone.View().data, bone.View().data + voxels);
      const Stopwatch clock;
      split.Share(bone.Seeds(drawn), { labels.data(), scan.scan.geometry });
      const double seconds = 1e-3 * clock.Milliseconds();
      if (result.firstS == 0.0)
        result.firstS = madeS + seconds;
      else
        more.push_back(seconds);
      return labels;
    });
  result.allS = result.firstS;
  for (const double seconds : more)
    result.allS += seconds;
  if (!more.empty())
    result.strokeS = QuartilesOf(more).median;
  result.dice = CompareWithTruth(scan, result.user.labels, LabelPairing::SameNumber);
  return result;
}

std::string TrialResult::Text() const
{
  const LabelDice& worst = this->dice.Worst();
  const LabelDice& surface = this->dice.WorstSurface();
  char text[240];
  std::snprintf(text, sizeof text,
    "%zu strokes, the user %s; worst Dice %.4f of label %d, worst surface Dice %.4f of label %d; "
    "first split %.2f s, one more stroke %.2f s",
    this->user.strokes.size(), this->user.content ? "is content" : "sees errors still",
    worst.Dice(), worst.truth, surface.SurfaceDice(), surface.truth, this->firstS, this->strokeS);
  return text;
}

double OneVoxelMm(const GridGeometry& grid)
{
  return std::max({ grid.spacing.x, grid.spacing.y, grid.spacing.z });
}

SegmentationDice CompareWithTruth(
  const TrialScan& scan, const std::vector<Label>& labels, LabelPairing pairing)
{
  DiceSettings settings;
  settings.toleranceMm = OneVoxelMm(scan.scan.geometry);
  settings.pairing = pairing;
  // Bone that nobody named stands for no fragment.
  std::vector<Label> named(labels);
  if (pairing == LabelPairing::SameNumber)
    std::replace(named.begin(), named.end(), Label(1), Label(0));
  return CompareLabels(scan.Truth(), { named.data(), scan.scan.geometry }, settings);
}

} // namespace hasp
