#include "ReportSegmentation.h"

#include "ImageSteps.h"
#include "ReportRegistry.h"
#include "ReportVolume.h"
#include "SegmentationTrials.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <algorithm>
#include <filesystem>

namespace hasp
{
namespace
{

/// The demo's CT, which cuts are planted in. Another CT need not be a skull.
RealSkull ReadSkull(const std::string& path)
{
  RealSkull skull;
  if (!std::filesystem::exists(path))
  {
    skull.absent = "no CT at --volume (Utilities/Scripts/cranium prints where the demo's is)";
    return skull;
  }
  const ReportVolume volume = ReadReportVolume(path);
  if (volume.name != "cranium")
  {
    skull.absent = "cuts are planted in the demo's skull alone, and --volume is another";
    return skull;
  }
  const AnyGridView view = ViewImage(volume.image);
  const auto* samples = std::get_if<GridView<const std::int16_t>>(&view);
  if (!samples)
  {
    skull.absent = "its samples are no 16-bit integers";
    return skull;
  }
  skull.geometry = samples->geometry;
  skull.samples.assign(samples->data, samples->data + samples->geometry.Size());
  skull.data = "real CT, 226";
  return skull;
}

/// By VTK's filter, as a threshold of a recipe blurs.
std::vector<float> Blur(const AnyGridView& samples, double sigmaMm)
{
  const GridGeometry grid = GeometryOf(samples);
  std::vector<float> values(grid.Size());
  std::visit(
    [&](const auto& view) { std::copy_n(view.data, grid.Size(), values.begin()); }, samples);
  const vtkSmartPointer<vtkImageData> blurred =
    ApplyStep(MakeImage(grid, values), GaussianStep{ sigmaMm }, {});
  const auto view = std::get<GridView<const float>>(ViewImage(blurred));
  return { view.data, view.data + grid.Size() };
}

} // namespace

void ReportSegmentation(ReportContext& context)
{
  const RealSkull skull = ReadSkull(context.settings.volume);
  TrySegmentation(context, skull);
  TryConeBeam(context, skull, Blur);
  TryResolve(context);
  TryDirect(context);
  AddUnusedSegmentation(context);
}

} // namespace hasp
