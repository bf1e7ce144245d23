// Frames of a camera that goes round: ours against every direct way there is.
#include "RaycachingScene.h"

#include "CellRows.h"
#include "ReportRegistry.h"

#include "vtkImageData.h"

namespace hasp
{
namespace
{

constexpr int Settling = 40; // frames of the orbit before any counts
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

std::string Decibels(double psnr)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.1f dB", psnr);
  return text;
}

void Compare(ReportContext& context, const RaycachingScene& scene, const std::string& mode,
  CachingMethod& ours, Rival& rival, CameraPath& path, IsosurfaceView& view)
{
  int frame = Settling;
  const PairedTimes times = ComparePairs(
    [&]
    {
      path.Orbit(frame++);
      return TimeOf([&] { ours.Draw(); });
    },
    [&] { return TimeOf([&] { rival.method->Draw(); }); }, { 1, 9 });
  const PictureTruth truth = TrueRaycachingPicture(view, scene.cells.isovalue);
  const double psnr = ForegroundPsnr(truth, ours.Picture());
  // VTK's mapper shades otherwise: its picture is not held against ours.
  const std::string other =
    rival.id == "vtk" ? ""
                      : "; its picture " + Decibels(ForegroundPsnr(truth, rival.method->Picture()));
  context.report.rows.push_back(
    TimedRatio("raycaching.speedup." + rival.id + "@" + mode + scene.cells.tag, times,
      rival.method->Name() + other, { psnr, "dB, foreground" },
      scene.data + ", orbit 1 degree a frame, " + ours.Name(), true));
}

} // namespace

void ReportRaycachingFrames(ReportContext& context, const RaycachingScene& scene)
{
  for (const auto& [mode, number] : { std::pair("cache", vtkHaspRayCachingMapper::Cache),
         std::pair("auto", vtkHaspRayCachingMapper::Automatic) })
  {
    context.progress(0.0, "raycaching: frames of " + scene.data + ", " + mode);
    IsosurfaceView view = scene.View();
    CameraPath path(view);
    CachingMethod ours(view, number);
    for (int frame = 0; frame < Settling; ++frame)
    {
      path.Orbit(frame);
      ours.Draw();
    }
    for (Rival& rival : Rivals(view))
      Compare(context, scene, mode, ours, rival, path, view);
  }
}

} // namespace hasp
