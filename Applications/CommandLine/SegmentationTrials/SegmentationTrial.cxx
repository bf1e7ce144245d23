#include "DiceRows.h"
#include "ErrorCurves.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "SplitRival.h"

namespace hasp
{

void TrySegmentation(ReportContext& context, const RealSkull& skull)
{
  constexpr int Strokes = 10;
  DiceRows rows("", "at most 10 strokes of at most 3 mm radius and 30 mm");
  ForEachTrialScan(ScanSettings(context), skull,
    [&](const TrialScan& scan)
    {
      context.progress(0.0, "segmentation: " + scan.key);
      const TrialBone bone(scan.Samples(), FractureSettings{}.boneHU);
      const TrialResult result = TryUser(bone, scan, Strokes, context.settings.seed);
      rows.Add(context, scan, result);
      if (!scan.isBarred || (context.settings.quick && scan.key != "mandible"))
        return; // a watershed of a head takes longer than a quick report has
      context.progress(0.5, "segmentation: error against time, " + scan.key);
      DrawErrorCurves(context, scan, bone, result.user.strokes);
    });
  if (skull.samples.empty())
    rows.AddAbsent(context, "cranium", skull.absent);
  // The head's hairlines are a fifth of a quick report's voxels: that says nothing of the bar.
  const bool quick = context.settings.quick;
  rows.AddWorst(context, quick ? 0.0 : 0.97, quick ? 0.0 : 0.95, 0.99);
  for (const SplitRival& rival : WatershedRivals())
    if (!rival.absent.empty())
      context.report.rows.push_back(
        AbsentRow("segmentation.error_time.watershed", rival.name, rival.absent));
}

} // namespace hasp
