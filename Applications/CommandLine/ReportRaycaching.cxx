#include "ReportRaycaching.h"

#include "MeasuredRows.h"
#include "RaycachingScene.h"
#include "ReportRegistry.h"
#include "ReportVolume.h"
#include "Windows.h"

#include <filesystem>

namespace hasp
{
namespace
{

void Measure(ReportContext& context, const CellScene& cells, int pixels)
{
  const RaycachingScene scene(cells, pixels);
  ReportRaycachingQuality(context, scene);
  ReportRaycachingHead(context, scene);
  ReportRaycachingStereo(context, scene);
  ReportRaycachingLight(context, scene);
  ReportRaycachingStillLight(context, scene);
  ReportRaycachingFrames(context, scene);
  ReportRaycachingChanges(context, scene);
  if (context.settings.soakFrames > 0 && scene.cells.tag.empty())
    ReportRaycachingSoak(context, scene);
}

} // namespace

void ReportRaycaching(ReportContext& context)
{
  const bool quick = context.settings.quick;
  RequireReportVolume(context.settings.volume);
  ChooseWindows();
  context.report.machine.gl = OpenGLName();
  const int pixels = quick ? 160 : 512;
  Measure(context, HeadScene(quick ? 96 : 256, context.settings.seed, true), pixels);
  const std::string& path = context.settings.volume;
  if (std::filesystem::exists(path))
  {
    const ReportVolume volume = ReadReportVolume(path);
    Measure(context, { "@" + volume.name, volume.data, volume.image, volume.isovalue }, pixels);
  }
  else
    context.report.rows.push_back(AbsentRow("raycaching.psnr@cranium", "a real CT",
      "no real CT there: give --volume the path that Utilities/Scripts/cranium prints"));
}

} // namespace hasp
