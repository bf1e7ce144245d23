// Frames along the recorded paths: ours against every direct way there is.
#include "RaycachingScene.h"

#include "CellRows.h"
#include "ReportRegistry.h"

#include "vtkImageData.h"

#include <map>

namespace hasp
{
namespace
{

constexpr int Settling = 40; // frames of the path before any counts
constexpr double Step = 0.5; // of VTK's mapper, in voxels: what its error asks for, see its row

struct Rival
{
  std::string id;
  std::unique_ptr<IsosurfaceMethod> method;
};

std::vector<Rival> Rivals(const IsosurfaceView& view)
{
  std::vector<Rival> rivals;
  rivals.push_back(
    { "primary", std::make_unique<CachingMethod>(view, vtkHaspRayCachingMapper::Raycast) });
  rivals.push_back({ "skipping",
    std::make_unique<CachingMethod>(view, vtkHaspRayCachingMapper::RaycastSkipping) });
  rivals.push_back({ "vtk", MakeVolumeMethod(view, Step) });
  return rivals;
}

/// What the row is asked to reach.
std::string Bar(const std::string& rival, const std::string& mode, const std::string& way)
{
  if (!way.empty())
    return "";
  const std::map<std::string, std::string> bars{ { "primary@cache", "8" }, { "skipping@auto", "2" },
    { "vtk@auto", "20" } };
  const auto bar = bars.find(rival + "@" + mode);
  return bar == bars.end() ? ""
                           : "; bar: at least " + bar->second +
                               (rival == "vtk" ? ", our picture 33 dB" : ", both pictures 33 dB");
}

/// Ours against one rival along a path, both in each frame.
void Compare(ReportContext& context, const RaycachingScene& scene, const std::string& mode,
  CachingMethod& ours, Rival& rival, const RecordedPath& path, const IsosurfaceView& view)
{
  int frame = Settling;
  double isovalue = 0.0;
  const PairedTimes times = ComparePairs(
    [&]
    {
      isovalue = path.go(frame++);
      return TimeOf(
        [&]
        {
          ours.SetIsovalue(isovalue);
          ours.Draw();
        });
    },
    [&]
    {
      return TimeOf(
        [&]
        {
          rival.method->SetIsovalue(isovalue);
          rival.method->Draw();
        });
    },
    { 1, 9 });
  const PictureTruth truth = CentreRaycachingPicture(view, isovalue);
  const double psnr = ForegroundPsnr(truth, ours.Picture());
  // VTK's mapper shades otherwise: its picture is not held against ours.
  const std::string other =
    rival.id == "vtk" ? ""
                      : "; its picture " + Decibels(ForegroundPsnr(truth, rival.method->Picture()));
  const std::string way = path.id == "orbit"
                            ? std::string()
                            : std::string(".").append(path.id); // the path that the bars name
  context.report.rows.push_back(
    TimedRatio("raycaching.speedup." + rival.id + way + "@" + mode + scene.cells.tag, times,
      rival.method->Name() + other,
      { psnr, "dB against one exact ray at each pixel's centre, in the last frame" },
      scene.data + ", " + path.text + ", " + ours.Name() + Bar(rival.id, mode, way), true));
}

} // namespace

void ReportRaycachingFrames(ReportContext& context, const RaycachingScene& scene)
{
  IsosurfaceView view = scene.View();
  for (const RecordedPath& path : RecordedPaths(scene, view))
    for (const auto& [mode, number] : { std::pair("cache", vtkHaspRayCachingMapper::Cache),
           std::pair("auto", vtkHaspRayCachingMapper::Automatic) })
    {
      context.progress(0.0, "raycaching: " + path.id + " of " + scene.data + ", " + mode);
      CachingMethod ours(view, number);
      for (int frame = 0; frame < Settling; ++frame)
      {
        ours.SetIsovalue(path.go(frame));
        ours.Draw();
      }
      for (Rival& rival : Rivals(view))
        if (rival.id != "vtk" || path.id == "orbit") // seconds a frame, and 20 times the bar away
          Compare(context, scene, mode, ours, rival, path, view);
    }
}

} // namespace hasp
