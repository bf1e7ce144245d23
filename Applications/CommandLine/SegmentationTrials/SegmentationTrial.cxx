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
      if (context.settings.quick && scan.key != "mandible")
        return; // a watershed of a head takes longer than a quick report has
      context.progress(0.5, "segmentation: error against time, " + scan.key);
      DrawErrorCurves(context, scan, bone, result.user.strokes);
    });
  if (skull.samples.empty())
    rows.AddAbsent(context, "cranium", skull.absent);
  rows.AddWorst(context, 0.97, 0.95, 0.99);
  for (const SplitRival& rival : WatershedRivals())
    if (!rival.absent.empty())
      context.report.rows.push_back(
        AbsentRow("segmentation.error_time.watershed", rival.name, rival.absent));
}

} // namespace hasp
