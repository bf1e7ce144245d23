#include "RunSteps.h"

#include "LabelReport.h"
#include "SegmentationWarnings.h"
#include "Session.h"
#include "VerbWork.h"

namespace hasp
{

StepLabels MakeStepLabels(
  vtkImageData* scan, const SegmentationRecipe& recipe, vtkImageData* begin, Session& session)
{
  const auto start = std::chrono::steady_clock::now();
  const auto progress = [&](double share) { return session.progress.Share(share); };
  const SegmentedScan made =
    Try(ExitCode::BadInput, "", [&] { return SegmentScan(scan, recipe, begin, {}, progress); });
  const double spent = MillisecondsSince(start);
  const double* spacing = scan->GetSpacing();
  const double voxelMm3 = spacing[0] * spacing[1] * spacing[2];
  return { made.labels, WarningsOf(recipe, made.findings, voxelMm3),
    FormatLabelReport(made.findings, voxelMm3), spent };
}

} // namespace hasp
