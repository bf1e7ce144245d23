#ifndef HapticInput_h
#define HapticInput_h

#include "Grid/RigidPose.h"

#include "vtkHaspInteractionHapticsModule.h" // for export macro: tests
#include "vtkNew.h"
#include "vtkWeakPointer.h"

#include <array>
#include <cstdint>
#include <functional>

class vtkCallbackCommand;
class vtkRenderWindowInteractor;
class vtkRenderer;
class vtkTDxMotionEventInfo;

namespace hasp
{

class InputHapticDevice;

/// Feeds an InputHapticDevice from a window: the pointer moves along the screen as the mouse does,
/// at the tool's depth; the wheel is depth; a middle drag turns; left and right are buttons 0 and
/// 1; arrow and page keys are steps of the wheel's length; a 3Dconnexion device's events of VTK
/// (TDx) are rates. Shift is the clutch: what moves meanwhile does not reach the device, so that no
/// tick can see a part of it. What `takes` does not take, and all with Ctrl held, is the
/// interactor's style's; who had a button's press has its drag and its release.
///
/// Threads: RENDER. Held weakly: windows, renderers and the device may go (Forget the device
/// before).
class VTKHASPINTERACTIONHAPTICS_EXPORT HapticInput
{
public:
  HapticInput();
  ~HapticInput();
  HapticInput(const HapticInput&) = delete;
  HapticInput& operator=(const HapticInput&) = delete;

  /// Null for any: lets go. No button of the device before is held then.
  void Follow(
    vtkRenderWindowInteractor* interactor, vtkRenderer* renderer, InputHapticDevice* device);
  /// The same device, from another window; null for any: none, as long as nobody says another.
  void FollowIn(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer);
  /// Where the tool is (world), and how large a mm of the device is there: once a frame.
  void At(const glm::dvec3& tool, double scale);

  /// The device, if there is one, by so much (its axes, mm and radians).
  void Yield(const glm::dvec3& mm, const glm::dvec3& radians);
  /// Asked at each press, move, notch of the wheel and key: is it the tool's? At this pixel; button
  /// 0, 1, or -1 for all else. None: all of it is the device's.
  std::function<bool(int button, int x, int y)> takes;
  /// Called when the device has been told of a press that is the tool's.
  std::function<void()> pressed;

  double wheelMm = 2.0;                        ///< of the device, a notch or a key
  double turnRadPerPixel = 0.01;               ///< of a middle drag
  double rateMmPerS = 60.0, rateRadPerS = 1.5; ///< of a 6-DOF device's full deflection

private:
  bool Handle(unsigned long event, void* data);
  bool Step(unsigned long event);
  bool Takes(int button) const;
  bool Press(int button);
  bool Release(int button);
  void Give(int button, bool device);
  void Rates(const vtkTDxMotionEventInfo& said);
  void Move();
  bool Key();
  bool Clutched() const;
  double MmPerPixel() const;

  vtkNew<vtkCallbackCommand> Command;
  /// Hears of releases even while a style keeps its drag's events to itself (GrabFocus).
  vtkNew<vtkCallbackCommand> Releases;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor;
  vtkWeakPointer<vtkRenderer> Renderer;
  InputHapticDevice* Device = nullptr;
  glm::dvec3 Tool{ 0.0 };
  double Scale = 1.0;
  std::array<int, 2> Before{ 0, 0 };
  std::uint32_t Held = 0;
  std::uint32_t Styles = 0; ///< buttons whose drags are the style's: until the last release
  bool Any = false;
};

} // namespace hasp

#endif
