#ifndef HapticChain_h
#define HapticChain_h

#include "Devices/GuardedHapticDevice.h"     // for the guard
#include "Devices/HapticRecorder.h"          // for the recorder
#include "Devices/WorkspaceMapping.h"        // for the mapping
#include "HapticExchange.h"                  // for what is exchanged
#include "Realtime/Handover.h"               // for scenes
#include "Realtime/TripleBuffer.h"           // for the newest values
#include "vtkHaspInteractionHapticsModule.h" // for export macro

namespace hasp
{

struct HapticChainSettings
{
  HapticStepSettings step{};
  WorkspaceSettings workspace{};
  WatchdogSettings watchdog{};
};

/// What a device stands of a wanted coupling. The hand feels stiffness k as g s k and a turn's as
/// (g / s) k (WorkspaceMapping: scale s, gain g), so k is at most StableStiffness of the device's
/// own damping and delay, half of the limit, by g s; the turn's at most as wanted at g / s = 1.
/// Forces saturate at what the motors give. A device without motors takes the spring as it is.
VTKHASPINTERACTIONHAPTICS_EXPORT CouplingSpring SpringFor(const DeviceProfile& profile,
  const CouplingSpring& wanted, double scale, double gain, double tickS) noexcept;

/// What in the numbers of contact and spring no tick can count with; null if nothing. Any thread.
VTKHASPINTERACTIONHAPTICS_EXPORT const char* WrongIn(const HapticControl& control) noexcept;

/// One haptic tick from device to device: read, guard, workspace mapping, HapticStep, and back.
///
/// Free of VTK and of clocks: the tick is told the time, so that the same object runs on a thread,
/// in virtual time, or once a frame where there is no thread. A device that takes no force (not
/// homed, unplugged, at fault) gets zero and the tool stays; when it is back, or has new poses
/// after the guard took force away from old ones, forces grow from zero, as they do when a tool is
/// taken in hand.
///
/// Threads: Tick and Rest on HAPTIC; the four functions of RENDER on RENDER, at the same time;
/// neither waits. Where no thread runs its owner does both. A tick is noexcept, takes and frees no
/// memory, no lock, logs nothing: scenes are freed by Collect. Cost: 1 us a tick besides the device
/// and the step.
class VTKHASPINTERACTIONHAPTICS_EXPORT HapticChain
{
public:
  /// Throws std::invalid_argument as the parts do, and for no device.
  explicit HapticChain(
    std::unique_ptr<HapticDevice> device, const HapticChainSettings& settings = {});

  // HAPTIC
  void Tick(std::uint64_t number, std::int64_t nowNs) noexcept;
  /// Where nobody ticks: the device is read, gets no force, and the tool goes along with it. At any
  /// rate, once a frame say.
  void Poll(std::int64_t nowNs) noexcept;
  /// Before the first tick, after Polls: the tool is taken in hand at this pose (world) with all
  /// that Control was told so far.
  void Place(const RigidPose& tool) noexcept;
  /// No force until the next tick: after the last one.
  void Rest() noexcept;

  // RENDER
  void Control(const HapticControl& control) noexcept { this->Controls.Write(control); }
  /// The scene is felt from the next tick on; null is ignored. What comes back is to be collected.
  /// The start of an offer that no tick has taken goes on to one that has a tool and no start.
  void OfferScene(std::unique_ptr<HapticSceneOffer> offer) noexcept;
  /// Frees what came back; once a frame.
  void Collect() noexcept { this->Scenes.Collect(); }
  /// What the last tick was; null before the first.
  const HapticSnapshot* Latest() noexcept;
  Handover<HapticDiscRequest>& Discs() noexcept { return this->Requests; }

  /// Each tick from now on; null: none. Not while ticks go on. It must outlive them.
  void Record(HapticRecorder* recorder) noexcept { this->Recorder = recorder; }
  const DeviceProfile& Profile() const noexcept { return this->Device.Profile(); }
  double TickS() const noexcept { return this->Settings.step.tickS; }
  GuardCounts Counts() const noexcept { return this->Device.Counts(); } ///< not while ticks go on
  HapticDevice& Guarded() noexcept { return this->Device.Guarded(); }   ///< not while ticks go on

private:
  void Run(std::uint64_t number, std::int64_t nowNs, bool forces) noexcept;
  Wrench Feel(const RigidPose& device) noexcept;
  void TakeControl() noexcept;
  void TakeScene() noexcept;
  void Take(const RigidPose& tool) noexcept;
  void SetIsovalues() noexcept;
  void AnswerDiscs() noexcept;
  void Publish(std::int64_t nowNs, const Wrench& onDevice) noexcept;

  HapticChainSettings Settings;
  GuardedHapticDevice Device;
  WorkspaceMapping Mapping;
  HapticStep Step;
  TripleBuffer<HapticControl> Controls;
  TripleBuffer<HapticSnapshot> Snapshots;
  Handover<HapticSceneOffer> Scenes;
  Handover<HapticDiscRequest> Requests;
  HapticRecorder* Recorder = nullptr;

  // HAPTIC's
  HapticControl Now;
  std::array<double, HapticControl::MostIsovalues> Isovalues; ///< that the scene was told
  DeviceSample Sample;
  DeviceStatus Status = DeviceStatus::NotHomed;
  HapticTick Last;
  std::int64_t BeforeNs = 0;
  std::uint64_t Ticks = 0, Away = 0, Scene = 0;
  bool Holding = false; ///< the last tick's device took forces
  bool Placed = false;  ///< the tool is somewhere
};

} // namespace hasp

#endif
