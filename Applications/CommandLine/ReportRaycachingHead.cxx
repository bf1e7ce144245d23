// A viewer whose head moves before a screen: how far the picture is behind it, and what is not
// there yet where it looks.
#include "RaycachingScene.h"

#include "CellDepth.h"
#include "Devices/HeadTracker.h"
#include "Devices/RecordedHeadPose.h"
#include "Devices/SimulatedHeadPath.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "vtkHaspStereoCamera.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace hasp
{
namespace
{

constexpr double Hz = 60.0;       // of the tracker and of the picture
constexpr double DelayFrames = 1; // of the tracker, until a pose arrives
constexpr double SeenFrames = 2;  // from asking for the head until the picture is seen
// Asked half-way between two poses: where one is just due, rounding says whether it has come.
constexpr double PhaseFrames = 0.5;
constexpr int WarmUpFrames = 60;
constexpr int Pixels = 256; // but in a soak: each frame is held against all active cells

/// Eyes before a screen of 400 x 400 mm that shows the scene as its first view does.
class Desk
{
public:
  explicit Desk(IsosurfaceView& view) : View(view)
  {
    this->Base->DeepCopy(view.camera);
    this->Room.screen.widthMm = this->Room.screen.heightMm = 400.0;
  }
  /// The left eye's view for a head.
  void Place(const HeadPose& head)
  {
    this->Room.head.position = head.position;
    this->Room.head.right = head.orientation * glm::dvec3(1, 0, 0);
    SetCameraToEye(this->View.camera, RigOnScreen(this->Base, this->Room), StereoEye::Left);
    vtkNew<vtkRenderer> fit; // only to place near and far plane
    fit->SetActiveCamera(this->View.camera);
    fit->ResetCameraClippingRange(this->View.image->GetBounds());
    this->View.CameraMoved();
  }

private:
  IsosurfaceView& View;
  vtkNew<vtkCamera> Base;
  StereoRig Room;
};

/// A recording of one minute, replayed in virtual time.
class Replay
{
public:
  Replay(std::uint64_t seed, double seconds, bool predict)
  {
    SimulatedHeadSettings settings;
    settings.seed = seed;
    settings.noiseMm = 0.2;
    settings.noiseDegrees = 0.1;
    this->Truth = SimulatedHeadPath(settings);
    PlaybackSettings playback;
    playback.interpolate = false;
    playback.delayS = DelayFrames / Hz;
    HeadTrackerSettings tracking;
    tracking.horizonS = SeenFrames / Hz;
    tracking.predict = predict;
    this->Tracker = std::make_unique<HeadTracker>(
      std::make_unique<RecordedHeadPose>(this->Truth.Record(0.0, seconds, Hz), playback), tracking);
  }
  TrackedHead At(int frame) { return this->Tracker->At(AskedS(frame)); }
  HeadPose Seen(int frame) const { return this->Truth.At(SeenS(frame)); }
  glm::dvec3 Velocity(int frame) const { return this->Truth.VelocityMmPerS(SeenS(frame)); }

private:
  static double AskedS(int frame) { return (frame + PhaseFrames) / Hz; }
  static double SeenS(int frame) { return (frame + PhaseFrames + SeenFrames) / Hz; }

  SimulatedHeadPath Truth;
  std::unique_ptr<HeadTracker> Tracker;
};

const char* Suffix(bool predict)
{
  return predict ? "" : ".unpredicted";
}

/// Without pictures: the head that is drawn against the one that looks when it is seen.
void AddError(ReportContext& context, const RaycachingScene& scene, double seconds, bool predict)
{
  Replay replay(context.settings.seed, seconds, predict);
  const int frames = int(seconds * Hz);
  double squares = 0.0, behind = 0.0, speeds = 0.0, latency = 0.0;
  const Timing time = TimeOf(
    [&]
    {
      for (int frame = 0; frame < frames; ++frame)
      {
        const TrackedHead head = replay.At(frame);
        if (frame < WarmUpFrames)
          continue;
        const glm::dvec3 off = head.pose.position - replay.Seen(frame).position;
        const glm::dvec3 velocity = replay.Velocity(frame);
        squares += glm::dot(off, off);
        behind -= glm::dot(off, velocity);
        speeds += glm::dot(velocity, velocity);
        latency += head.latencyFrames;
      }
    });
  const int counted = frames - WarmUpFrames;
  char text[200];
  std::snprintf(text, sizeof text,
    "head path of %.0f s at %.0f Hz, asked half-way between two poses, %.2f frames from pose to "
    "picture, of which %.2f are left",
    seconds, Hz, latency / counted, Hz * behind / speeds);
  context.report.rows.push_back(
    ErrorFigure(std::string("raycaching.head.error") + Suffix(predict) + scene.cells.tag,
      { std::sqrt(squares / counted), "mm RMS of the head" }, "the head's closed form",
      { time.wallS / frames, time.cpuS / frames }, text));
}

/// Pictures of the cache for it; what is open in the worst of all frames.
void AddHoles(ReportContext& context, const RaycachingScene& scene, double seconds, bool predict)
{
  IsosurfaceView view = scene.View();
  Desk desk(view);
  Replay replay(context.settings.seed, seconds, predict);
  CachingMethod ours(view, vtkHaspRayCachingMapper::Cache);
  ours->SetPrediction(predict);
  const auto exact = MakeCellMethod(view);
  const int frames = int(seconds * Hz);
  double sum = 0.0, most = 0.0;
  Timing all;
  for (int frame = 0; frame < frames; ++frame)
  {
    desk.Place(replay.At(frame).pose);
    const Timing time = TimeOf([&] { ours.Draw(); });
    if (frame < WarmUpFrames)
      continue;
    all.wallS += time.wallS / (frames - WarmUpFrames);
    all.cpuS += time.cpuS / (frames - WarmUpFrames);
    const double share = HoleShare(*exact, ours);
    sum += share / (frames - WarmUpFrames);
    most = std::max(most, share);
  }
  char text[160];
  std::snprintf(text, sizeof text, ", head path of %.0f s at %.0f Hz, mean %.3g", seconds, Hz, sum);
  ReportRow row =
    ErrorFigure(std::string("raycaching.head.holes") + Suffix(predict) + scene.cells.tag,
      { most, "share of surface pixels, worst frame" }, "all active cells", all, scene.data + text);
  if (predict)
    row.bars = { { {}, 0.005 } };
  context.report.rows.push_back(row);
}

} // namespace

void ReportRaycachingHead(ReportContext& context, const RaycachingScene& wide)
{
  const ReportSettings& settings = context.settings;
  const bool soak = settings.soak && !settings.quick;
  const RaycachingScene scene(wide.cells, soak ? wide.pixels : std::min(Pixels, wide.pixels));
  const bool minute = soak || (!settings.quick && scene.cells.tag.empty());
  const double seconds = minute ? 60.0 : settings.quick ? 3.0 : 10.0;
  context.progress(0.0, "raycaching: a head's path, " + scene.data);
  for (const bool predict : { true, false })
  {
    if (scene.cells.tag.empty()) // the head knows nothing of what it looks at
      AddError(context, scene, 60.0, predict);
    AddHoles(context, scene, seconds, predict);
  }
}

} // namespace hasp
