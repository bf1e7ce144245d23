#include "DiceRows.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"

#include "Segmentation/ConeBeam.h"
#include "Segmentation/ThresholdProposal.h"

#include <algorithm>

namespace hasp
{

void TryConeBeam(ReportContext& context, const RealSkull& skull, const BlurSamples& blur)
{
  constexpr int Strokes = 15;
  // Grey values are no HU: bone begins where the histogram says. Spongy bone is as dark as noise
  // in soft tissue: both are smoothed for the threshold, not for the split, which is to see cracks;
  // and what the threshold leaves out of bone is closed.
  constexpr double SmoothVoxels = 0.6, CloseMm = 1.0;
  const std::string how = "simulated cone beam, threshold proposed from the histogram of samples "
                          "smoothed by 0.6 voxels, closed by 1 mm and filled, at most 15 strokes";
  DiceRows corrected(".cbct", how + ", corrected"), plain(".cbct.uncorrected", how);
  TrialScanSettings settings = ScanSettings(context);
  settings.coneBeam = true;
  ForEachTrialScan(settings, skull,
    [&](const TrialScan& scan)
    {
      context.progress(0.0, "segmentation: cone beam, " + scan.key);
      const AnyGridView grey = scan.Samples();
      std::vector<float> samples(scan.scan.geometry.Size());
      ConeBeamSettings correction;
      correction.insideAbove = -100.0; // between the model's air, -550, and its soft tissue
      CorrectConeBeam(grey, correction, { samples.data(), scan.scan.geometry });
      const AnyGridView even = GridView<const float>{ samples.data(), scan.scan.geometry };
      for (const bool with : { true, false })
      {
        const AnyGridView& used = with ? even : grey;
        const glm::dvec3& spacing = scan.scan.geometry.spacing;
        const std::vector<float> smoothed =
          blur(used, SmoothVoxels * std::min({ spacing.x, spacing.y, spacing.z }));
        const AnyGridView smooth = GridView<const float>{ smoothed.data(), scan.scan.geometry };
        const TrialBone bone(used, smooth, ProposeThreshold(smooth).threshold, CloseMm);
        (with ? corrected : plain)
          .Add(context, scan, TryUser(bone, scan, Strokes, context.settings.seed));
      }
    });
  for (DiceRows* rows : { &corrected, &plain })
    if (skull.samples.empty())
      rows->AddAbsent(context, "cranium", skull.absent);
  const double bar = context.settings.quick ? 0.0 : 0.95; // as without a cone beam
  corrected.AddWorst(context, bar, bar, 0.97);
  plain.AddWorst(context, 0.0, 0.0, 0.0);
}

} // namespace hasp
