// Frames along the recorded paths: ours against every direct way there is.
#include "RaycachingScene.h"

#include "MeasuredRows.h"
#include "ReportRegistry.h"

#include "vtkImageData.h"

#include <map>
#include <optional>

namespace hasp
{
namespace
{

constexpr int Settling = 40;       // frames of the path before any counts
constexpr double PictureDb = 33.0; // what counts as a picture of this surface
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

/// What the row is asked to reach. theirs: dB of the rival's picture, if it is to be held against
/// ours.
std::vector<ReportBar> Bars(const std::string& row, double ours, std::optional<double> theirs)
{
  const std::map<std::string, double> least{ { "primary@cache", 8.0 }, { "skipping@auto", 2.0 },
    { "vtk@auto", 20.0 } };
  const auto found = least.find(row);
  if (found == least.end())
    return {};
  std::vector<ReportBar> bars{ { found->second, {} }, { PictureDb, {}, "dB of ours", ours } };
  if (theirs)
    bars.push_back({ PictureDb, {}, "dB of its picture", *theirs });
  return bars;
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
  const auto theirs = rival.id == "vtk"
                        ? std::nullopt
                        : std::optional(ForegroundPsnr(truth, rival.method->Picture()));
  const std::string way = path.id == "orbit" ? std::string() // the path that the bars name
                                             : std::string(".").append(path.id);
  const std::string name = rival.id + way + "@" + mode;
  ReportRow row = TimedRatio("raycaching.speedup." + name + scene.cells.tag, times,
    rival.method->Name() + (theirs ? "; its picture " + Decibels(*theirs) : ""),
    { psnr, "dB against one exact ray at each pixel's centre, in the last frame" },
    scene.data + ", " + path.text + ", " + ours.Name(), true);
  row.bars = Bars(name, psnr, theirs);
  context.report.rows.push_back(row);
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
