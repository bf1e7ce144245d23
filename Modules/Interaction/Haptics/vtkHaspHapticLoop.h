#ifndef vtkHaspHapticLoop_h
#define vtkHaspHapticLoop_h

#include "Grid/ResourceUse.h"                // for ListResources
#include "vtkHaspInteractionHapticsModule.h" // for export macro
#include "vtkObject.h"

#include <memory> // for Internals
#include <string> // for reports
#include <vector> // for shells

class vtkRenderWindow;

// HapticExchange.h and HapticChain.h say what these are; here they would bring GLM to VTK's
// wrapper.
namespace hasp
{
class HapticDevice;
class HapticRecorder;
struct DeviceProfile;
struct HapticBody;
struct HapticChainSettings;
struct HapticControl;
struct HapticDiscRequest;
struct HapticShell;
struct HapticSnapshot;
struct LoopSettings;
struct RateCounts;
struct RigidPose;
}

/**
 * @class   vtkHaspHapticLoop
 * @brief   A device, what its tool is made of and what it can touch, ticking at 1 kHz.
 *
 * Owns the thread HAPTIC, and runs hasp::HapticChain there. There is a thread only while it is
 * started, the tool has a shell and there is a body to be touched; else Update, once a frame, reads
 * the device, so that its pose and buttons are known all the same. Before the first Start nobody
 * reads it: a simulated hand's plan begins then. A loop without a device holds nothing.
 *
 * vtkHaspHapticInteractor does what is said here for scenes of actors. Alone it is for programs
 * that make maps and shells themselves.
 *
 * It stops, with no force at the device, when Stop is called, when it is deleted, and when the
 * window of SetRenderWindow goes or its interactor ends (an ExitEvent that nobody refuses: an
 * application that listens to it calls TerminateApp, as ever). Where the system refuses what HAPTIC
 * asks (real-time scheduling, locked memory) it runs without, and GetSchedulingReport says so.
 *
 * Units: mm, N, N mm, s. Threads: RENDER for all that is here; the device is HAPTIC's while
 * IsRunning. Errors: vtkErrorMacro, with what to do; false comes back and nothing has changed,
 * but where a call says what has.
 * Cost: 5 us of RENDER a frame; what a tick costs GetRates says. See thesis 2.3.3 and Threads.md.
 */
class VTKHASPINTERACTIONHAPTICS_EXPORT vtkHaspHapticLoop : public vtkObject
{
public:
  static vtkHaspHapticLoop* New();
  vtkTypeMacro(vtkHaspHapticLoop, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

#ifndef __VTK_WRAP__
  ///@{
  /** Takes the device over; null: none. The one before is stopped without force and freed, and its
   * scene, snapshot and control with it: a new one begins with all of HapticControl at its defaults
   * (it stands unturned at the world's origin, nothing attracts) but contact, spring and scale,
   * which are the settings'. So SetControl and SetScene come after SetDevice. What was started
   * stays so, and ticks again from the next scene on.
   *
   * False after an error alone: settings whose numbers are refused (the message says which, and
   * what is legal: HapticStep.h, WorkspaceMapping.h, GuardedHapticDevice.h). There is no device
   * then, neither this one nor the one before. Whether a device works is not asked: that is the
   * snapshot's status. */
  bool SetDevice(std::unique_ptr<hasp::HapticDevice> device);
  bool SetDevice(
    std::unique_ptr<hasp::HapticDevice> device, const hasp::HapticChainSettings& settings);
  ///@}
  /** Null without a device. Not to be read or written while IsRunning. */
  hasp::HapticDevice* GetDevice();
  const hasp::DeviceProfile* GetProfile(); ///< null without a device

  /** How the thread ticks, from the next Start on: period, priority, memory. The period is the
   * step's tickS (HapticChainSettings): no thread starts with another one, on which neither forces
   * nor the coupling's limit would be true. */
  void SetLoopSettings(const hasp::LoopSettings& settings);

  /** What the tool is made of, and what it can touch; either may be none. start: the tool is taken
   * in hand at this pose (world), before Start as soon as it is started; null: it goes on where it
   * is. What the scene before had as well is felt on as it is. Number of the scene, which snapshots
   * name once it is felt; 0 after an error: no device, a start that is no pose, what HapticScene
   * refuses, or a thread that does not start (as Start).
   *
   * Makes a HapticScene, on RENDER, while ticks go on and wait for nobody. A pair of a shell and a
   * body costs 0.002 ms where the shell is static (20,000 points before a map of 256^3; up to 0.5
   * ms the first time) and 0.2 ms where it is dynamic (1.4 ms the first time, of four pairs 5.1 ms:
   * memory that is new; twice as much on a busy machine). The first scene of a process also times
   * the kernels, 5 ms (FastestContactKernels): who cannot wait for it calls that on a WORKER
   * before, as vtkHaspHapticInteractor does. */
  std::uint64_t SetScene(std::vector<hasp::HapticShell> shells,
    std::vector<hasp::HapticBody> bodies, const hasp::RigidPose* start = nullptr);

  /** What may change at any time. Felt, gradually, from the next tick on. Contact or a spring that
   * no tick can count with (WrongIn) is an error. */
  bool SetControl(const hasp::HapticControl& control);
  const hasp::HapticControl& GetControl() const;

  /** The newest tick; all zero before the first. Changes with Update alone. */
  const hasp::HapticSnapshot& GetSnapshot() const;

  /** Each tick is recorded; null: none. Takes it over; refused while started. */
  bool SetRecorder(std::unique_ptr<hasp::HapticRecorder> recorder);

  /** Asks the next tick for the dynamic shells' points, at most so many; what the last such tick
   * answered, or null. Costs HAPTIC nothing unless it is called. */
  const hasp::HapticDiscRequest* AskForDiscs(std::size_t most);

  /** Of the thread's ticks; all zero before the first Start. */
  hasp::RateCounts GetRates() const;
#endif

  ///@{
  /** From Start on there is a thread whenever something can be touched: at once, or as soon as
   * SetScene says so. Again, once started: nothing happens, true.
   *
   * False, and it is not started, after an error: there is no device (SetDevice comes first), the
   * loop's periodNs is not the step's tickS, a number of SetLoopSettings is refused, or the system
   * gives no thread. Where SetScene finds one of these its 0 says so, and it is stopped. What the
   * system refuses of priority and memory is none: GetSchedulingReport. A device that is unplugged
   * is none either: it gets no force until it is back. */
  bool Start();
  void Stop();
  bool GetStarted() const;
  ///@}
  /** Whether the thread is there. */
  bool IsRunning() const;

  /** Once a frame, before it is drawn: takes the newest snapshot and frees what HAPTIC gave back.
   */
  void Update();

  /** What the thread did not get of the system, and what it lost, in sentences; empty if all. */
  std::string GetSchedulingReport() const;

  /** Stops when this window or its interactor goes, also one that it is given later. Held weakly;
   * null: none. */
  void SetRenderWindow(vtkRenderWindow* window);

#ifndef __VTK_WRAP__
  /** "haptic thread", "haptic scene": all 0, with a reason, while nothing can be touched. */
  void ListResources(hasp::ResourceList& resources) const;
#endif

protected:
  vtkHaspHapticLoop();
  ~vtkHaspHapticLoop() override;

private:
  vtkHaspHapticLoop(const vtkHaspHapticLoop&) = delete;
  void operator=(const vtkHaspHapticLoop&) = delete;

  bool RunOrRest();
  void FollowWindow();
  void FollowExit();

  struct Internals;
  std::unique_ptr<Internals> Self;
};

#endif
