#pragma once
#include "Devices/HeadTracker.h"
#include "Grid/ResourceUse.h"
#include "StereoChoices.h"
#include "SurfaceActors.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>

class vtkRenderWindow;
class vtkRenderer;

namespace hasp
{

/// A window's eyes: one or two, before a screen in the room or beside the camera, standing still or
/// going where a tracker says. What `hasp render` and `hasp view` draw through. RENDER thread.
class StereoView
{
public:
  /// Renderer and window must outlive it; the window must have the size that WindowPixels gives.
  /// tracker: null for a head that stands still. right: the right eye's window of two, for the
  /// layout dual-window. Throws Failure: WrongUse for choices that do not go together, BadInput for
  /// files.
  StereoView(vtkRenderer* renderer, vtkRenderWindow* window, const StereoChoices& choices,
    std::unique_ptr<HeadTracker> tracker = nullptr, vtkRenderWindow* right = nullptr);
  ~StereoView();

  /// Draws one frame for where the head is at nowS (SteadySeconds), or was when there was last
  /// anything to see from it. False: an error, as VTK's.
  bool Draw(double nowS);
  /// Is the head at nowS elsewhere than in the last frame, by more than 0.1 mm or 0.02 degrees, or
  /// does its tracker do something else? Never without a tracker.
  bool HeadMoved(double nowS);
  bool IsTracked() const;

  /// The tracker where it is the mouse: x and y in [-1, 1] of the view. Else does nothing.
  void PointAt(double x, double y);
  /// In which window are the pixels that follow? The main one at first.
  void PointIn(vtkRenderWindow* window);
  /// The line of sight of a window's pixel through all that is shown; none where nothing is seen.
  std::optional<std::pair<WorldPoint, WorldPoint>> RayOf(int x, int y) const;

  struct ViewPosition
  {
    double x, y;    ///< in the eye's view: (-1, -1) lower left, (1, 1) upper right
    bool eyesApart; ///< has each eye a part of the window of its own?
    bool rightEye;
  };
  /// Where a window's pixel lies in what its eye sees; none where nothing is seen.
  std::optional<ViewPosition> PositionInView(int x, int y) const;
  /// The same for one eye, whosever pixel it is: as if that eye's part of the window went on beyond
  /// its borders. None beyond what a lens shows.
  std::optional<ViewPosition> PositionInEye(bool rightEye, int x, int y) const;

  /// After the camera was placed anew: --life-size, if it was asked for.
  void CameraPlaced();
  /// "at 83 % of life size", then "head: tracking by opentrack, 33 ms (2.0 frames) old, 33
  /// predicted" in a line of its own; empty where there is neither a screen nor a tracker.
  std::string Text() const;
  /// What its tracker warns of, once each.
  std::vector<std::string> TakeWarnings();
  /// Draws the plan of --sketch as a PNG file. content: none where nothing is shown. Throws
  /// Failure: CannotDraw.
  std::string SketchPng(const std::optional<ContentBox>& content) const;
  void ListResources(ResourceList& list) const;

private:
  struct Parts;
  std::unique_ptr<Parts> Self;
};

} // namespace hasp
