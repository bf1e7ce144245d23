#pragma once
#include "FrameTimer.h"

#include <chrono>
#include <functional>
#include <string>
#include <utility>
#include <vector>

class vtkObject;
class vtkRenderWindow;
class vtkRenderWindowInteractor;

namespace hasp
{

class StereoView;
class SurfaceScene;

/// The frames of a window: one when something asks for it, and more while the scene refines, at
/// once or at the pace of its paths, or when the head of a tracked viewer has moved: a timer asks
/// the tracker 120 times a second. Where nothing refines and nobody is tracked, nothing runs.
/// RENDER thread.
class ViewFrames
{
public:
  struct Hooks
  {
    std::function<void()> begins;                  ///< before a frame
    std::function<void()> failed;                  ///< once: nothing can be drawn any more
    std::function<void(const std::string&)> warns; ///< of the tracker
  };
  /// All must outlive it. eyes: draw the frames; null: the window does.
  ViewFrames(SurfaceScene& scene, vtkRenderWindow* window, vtkRenderWindowInteractor* interactor,
    StereoView* eyes, Hooks hooks);
  ~ViewFrames();
  ViewFrames(const ViewFrames&) = delete;
  ViewFrames& operator=(const ViewFrames&) = delete;

  void Draw();
  /// Until nothing new is found and all paths are traced, and once more with the text of the last
  /// frame.
  void DrawComplete();
  /// For good.
  void Stop();

  double Milliseconds() const { return this->FrameMs; } ///< of the last frame
  bool Refines() const { return this->Refining; }
  bool WaitsForTimer() const { return this->Timer.Runs(); }
  bool Tracked() const;
  const std::string& Error() const { return this->Complaint; } ///< why it failed

private:
  void Observe(vtkObject* object, unsigned long event, void (ViewFrames::*method)());
  void Begin();
  void End();
  void Wait();
  void Tick();

  SurfaceScene& Scene;
  vtkRenderWindow* Window;
  vtkRenderWindowInteractor* Interactor;
  StereoView* Eyes;
  Hooks Call;
  FrameTimer Timer;
  std::vector<std::pair<vtkObject*, unsigned long>> Observed;
  std::chrono::steady_clock::time_point Start;
  double FrameMs = 0.0;
  bool Refining = false, Ticking = false, Stopped = false;
  bool SaysOld = false; ///< the last frame's text, drawn before it: that it refines
  std::string Complaint;
};

} // namespace hasp
