#ifndef vtkHaspHapticInteractor_h
#define vtkHaspHapticInteractor_h

#include "Grid/ResourceUse.h"                // for ListResources
#include "vtkCommand.h"                      // for the events
#include "vtkHaspInteractionHapticsModule.h" // for export macro
#include "vtkObject.h"

#include <cstdint> // for buttons
#include <memory>  // for Internals
#include <vector>  // for groups

class vtkHaspHapticLoop;
class vtkImageData;
class vtkMatrix4x4;
class vtkProp3D;
class vtkRenderer;

namespace hasp
{
class HapticDevice;
struct HapticChainSettings;
struct RigidPose;
}

/**
 * @class   vtkHaspHapticInteractor
 * @brief   Lets a haptic device, or a mouse, take actors in hand and feel others with them.
 *
 * Say what can be touched (AddTouchable) and what can be taken in hand (AddTool), give it a device
 * (SetDevice, or UseMouse) and a renderer, Start. A press of button GrabButton takes the tool
 * nearest to the device's point, if its surface is within GrabReach; its actors follow the
 * contact's pose by their user matrices until the button is let go, and stay there. A mouse takes
 * what is seen under it: the device's point goes there first. Examples/PressBalls.cxx is a whole
 * program.
 *
 * Distance maps and pointshells are baked on a WORKER, one prop after the other, as soon as
 * something can be touched and something taken in hand; until then, and without a device, nothing
 * is made. RENDER waits for none of it: GetState says Baking, then Ready. What is removed meanwhile
 * is cancelled. There is a thread HAPTIC only while a tool is in hand.
 *
 * Call Update once a frame, before it is drawn: all eyes of a frame then see the same pose,
 * whatever draws them. With an interactor (SetRenderer's window has one) Start does it by a timer,
 * and asks for a picture (RenderEvent) when something moved; the timer begins with the interactor,
 * whichever starts first, and nobody else sees its events. One without timers (no display) is a
 * warning.
 *
 * Poses: the device moves along the axes of the renderer's camera (CameraRelative), `Scale` world
 * mm for its mm; or, by SetDeviceToWorld, stands where it really stands (FitCoLocation), so that
 * the drawn tip is where the hand's is. Heads and eyes change neither.
 *
 * Events, on this: GrabEvent, ReleaseEvent; ButtonPressEvent and ButtonReleaseEvent, whose call
 * data is the button's number (int*), and of buttons 0, 1, 2 vtkCommand's LeftButtonPressEvent,
 * RightButtonPressEvent, MiddleButtonPressEvent and their releases as well; ReadyEvent when all
 * that is wanted is baked; ContactEvent and FreeEvent when the tool begins to touch and ends.
 *
 * Limits: what is hidden is felt all the same. Props must stand rigidly in the world (a scale is
 * refused). Samples of a prop must not be changed in place while they are baked. A body is closed
 * where its volume ends.
 *
 * Threads: RENDER. Props, renderer and window are held weakly: each may go at any time.
 * Errors: vtkErrorMacro with what to do; of what is baked, once a prop.
 */
class VTKHASPINTERACTIONHAPTICS_EXPORT vtkHaspHapticInteractor : public vtkObject
{
public:
  static vtkHaspHapticInteractor* New();
  vtkTypeMacro(vtkHaspHapticInteractor, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Events
  {
    GrabEvent = vtkCommand::UserEvent + 7201,
    ReleaseEvent,
    ButtonPressEvent,
    ButtonReleaseEvent,
    ReadyEvent,
    ContactEvent,
    FreeEvent
  };
  enum States
  {
    Idle,   ///< nothing can be touched, or nothing taken in hand, or there is no device
    Baking, ///< a WORKER makes maps and shells
    Ready   ///< what could be made is there
  };

  ///@{
  /** False after an error: not an actor with one of the two mappers, or not rigid. An image has no
   * prop that could go or be removed: it is kept. */
  bool AddTouchable(vtkProp3D* prop);
  bool AddTouchable(vtkImageData* image, double isovalue, vtkMatrix4x4* imageToWorld);
  ///@}
  ///@{
  /** Taken in hand together. Number of the tool; -1 after an error. What can be touched as well is
   * not felt by the tool it belongs to. */
  int AddTool(vtkProp3D* prop);
#ifndef __VTK_WRAP__
  int AddTool(const std::vector<vtkProp3D*>& group);
#endif
  ///@}
  void Remove(vtkProp3D* prop);

  /** Where it is drawn, whose camera says what right is, and whose window ends it. The mouse and
   * the timer go along. */
  void SetRenderer(vtkRenderer* renderer);

#ifndef __VTK_WRAP__
  ///@{
  /** As vtkHaspHapticLoop's, with its errors. What is in hand is let go, the mouse with it. The new
   * device takes nothing over: it stands as the camera does (CameraRelative is on again if
   * SetDeviceToWorld had put it off), Scale is settings.workspace.scale, 1 unless said. */
  bool SetDevice(std::unique_ptr<hasp::HapticDevice> device);
  bool SetDevice(
    std::unique_ptr<hasp::HapticDevice> device, const hasp::HapticChainSettings& settings);
  ///@}
#endif
  /** The window's mouse, keys and 6-DOF device as the device: HapticInput.h says which does what. A
   * press takes at once, and not at the next Update: until then the pointer goes on. A
   * press of GrabButton where the last picture shows nothing within GrabReach of a tool is the
   * interactor's style's, and so is its drag. What is seen there is what the depth of the window's
   * last layer says. It has no motors: contact is firmer (0.5 N/mm per mm^2) than where a hand is
   * to be kept stable, which GetLoop's control changes; and with Snap-to-fit, which pulls nobody's
   * hand, the device's point goes along to where the tool is pulled. The renderer's window needs an
   * interactor. False after an error. */
  bool UseMouse();

  /** False after an error, as vtkHaspHapticLoop's: no device, above all. With nothing to touch or
   * nothing to take it begins all the same: the device is read, nothing is felt (GetState says
   * Idle), and what is added later counts. */
  bool Start();
  void Stop(); ///< lets go, too
  /** Once a frame; true if something moved. */
  bool Update();

  int GetState() const;
  double GetProgress() const; ///< of baking, [0, 1]
  ///@{
  /** The same as by the button. False before Start, while the tool is baked, and for a number that
   * is none. */
  bool Grab(int tool);
  void Release();
  int GetHeldTool() const; ///< -1: none
  ///@}

  /** For snapshots, control, rates. Device, scene and window are set here, not there. */
  vtkHaspHapticLoop* GetLoop();

  ///@{
  /** Of the device, 0 to 31; -1: by Grab alone. Default 0. */
  vtkSetClampMacro(GrabButton, int, -1, 31);
  vtkGetMacro(GrabButton, int);
  ///@}
  ///@{
  /** World mm. Default 20. */
  vtkSetClampMacro(GrabReach, double, 0.0, 1e6);
  vtkGetMacro(GrabReach, double);
  ///@}
  ///@{
  /** Of the device: while it is held the tool stays and the device moves on; -1: none. Default 1.
   */
  vtkSetClampMacro(ClutchButton, int, -1, 31);
  vtkGetMacro(ClutchButton, int);
  ///@}
  ///@{
  /** World mm for a mm of the device. Default 1. */
  vtkSetClampMacro(Scale, double, 0.001, 1000.0);
  vtkGetMacro(Scale, double);
  ///@}
  ///@{
  /** Default on; SetDeviceToWorld puts it off. */
  vtkSetMacro(CameraRelative, bool);
  vtkGetMacro(CameraRelative, bool);
  vtkBooleanMacro(CameraRelative, bool);
  ///@}
  ///@{
  /** Snap-to-fit: surfaces that face each other attract. Default off. */
  vtkSetMacro(SnapToFit, bool);
  vtkGetMacro(SnapToFit, bool);
  vtkBooleanMacro(SnapToFit, bool);
  ///@}
  ///@{
  /** Of the distance that is baked, mm; 0: BodyDistanceSettings'. Of what is added from then on. */
  void SetSpacing(double mm);
  double GetSpacing() const;
  ///@}
  ///@{
  /** Tools that are isosurfaces of volumes touch by points drawn where they touch: no preparation,
   * and another isovalue is felt at once. Of tools added from then on. Default off. */
  void SetDynamicShells(bool on);
  bool GetDynamicShells() const;
  ///@}
  ///@{
  /** Draws forces as arrows, and the dynamic shell's points. Default off: nothing is made. */
  void SetShowForces(bool on);
  bool GetShowForces() const;
  void SetShowShell(bool on);
  bool GetShowShell() const;
  ///@}
  /** Stands where the tool is: a stylus, say. Its own axes are the device's. Null: none. */
  void SetPointer(vtkProp3D* prop);
  /** Device axes to world: where the device that is there stands (FitCoLocation), until the next
   * SetDevice. CameraRelative off, Scale 1. False after an error: not rigid, or no device. */
  bool SetDeviceToWorld(vtkMatrix4x4* matrix);

#ifndef __VTK_WRAP__
  void ListResources(hasp::ResourceList& resources) const;
#endif

protected:
  vtkHaspHapticInteractor();
  ~vtkHaspHapticInteractor() override;

private:
  vtkHaspHapticInteractor(const vtkHaspHapticInteractor&) = delete;
  void operator=(const vtkHaspHapticInteractor&) = delete;

  void SendControl();
  void FollowButtons(std::uint32_t now);
  void FollowProps();
  void FollowContact();
  void YieldToSnap();
  void StartTimer();
  void BeginTimer();
  void Frame();
  bool PointAt(int x, int y);

  int GrabButton = 0, ClutchButton = 1;
  double GrabReach = 20.0, Scale = 1.0;
  bool CameraRelative = true, SnapToFit = false;
  struct Internals;
  std::unique_ptr<Internals> Self;
};

#endif
