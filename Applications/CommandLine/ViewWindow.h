#pragma once
#include "CameraOptions.h"
#include "Grid/ResourceUse.h"

#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>

class vtkImageData;
class vtkRenderWindow;
class vtkRenderWindowInteractor;
class vtkSliderWidget;

namespace hasp
{

class StereoView;
class SurfaceScene;

struct ViewSettings
{
  std::optional<std::array<double, 2>> range; ///< of the isovalue; none: it cannot be changed
  double isoValue = 0.0;                      ///< that the scene has
  std::string unit;                           ///< of the isovalue, "HU"; empty: not known
  std::string shown = "active cells";         ///< said where the isovalue cannot be changed
  CameraOptions camera;                       ///< of the first view, to which key r goes back
  bool overlay = true; ///< text and slider. They lie in the screen's plane: none in a head-mounted
                       ///< display, which has no such plane
  StereoView* eyes = nullptr;   ///< draws the frames, of one eye or two; none: the window itself.
                                ///< Must outlive the ViewWindow
  std::function<void()> closed; ///< called when the user has closed the window; may be empty
  std::function<void(const std::string&)> sayWarning; ///< takes what a head tracker warns of
};

/// A scene in a window that answers mouse and keys: trackball camera, a slider for the isovalue
/// that the surface follows while it is dragged, and a line of text. While the scene refines, a
/// timer draws it again; when it is complete nothing runs until the next event. Where eyes follow
/// a tracker, a timer asks it 120 times a second, and draws when the head has moved.
///
/// Left button turns, middle button pans (and left with Shift), right button and wheel zoom. Keys:
/// see ViewKeys.h. RENDER thread. Scene, window and interactor must outlive it; the scene's
/// renderer must be in the window, the window the interactor's.
class ViewWindow
{
public:
  ViewWindow(SurfaceScene& scene, vtkRenderWindow* window, vtkRenderWindowInteractor* interactor,
    const ViewSettings& settings);
  ~ViewWindow();

  /// Draws the first frame and handles events until the user closes the window. Throws Failure:
  /// CannotDraw.
  void Run();
  /// Draws until nothing new is found and all paths are traced; what the window then shows. Throws
  /// Failure: CannotDraw.
  vtkSmartPointer<vtkImageData> DrawComplete();
  /// What the surfaces held when the user closed the window, or as they are.
  ResourceList Resources() const;

  double IsoValue() const;
  /// The line of text: isovalue, milliseconds of the last frame but one, what drew it, the head
  /// tracker's state, and the last answer to a key.
  std::string Text() const;
  /// Will the timer draw another frame?
  bool WaitsForTimer() const;
  vtkSliderWidget* Slider() const; ///< null without a range

private:
  struct Parts;
  std::unique_ptr<Parts> Self;
};

} // namespace hasp
