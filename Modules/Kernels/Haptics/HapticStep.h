#pragma once
#include "Haptics/ContactFriction.h"
#include "Haptics/CostModel.h"
#include "Haptics/HapticScene.h"
#include "Haptics/PassivityObserver.h"
#include "Haptics/VirtualCoupling.h"
#include "Realtime/ForceLimiter.h"

#include <memory>

namespace hasp
{

struct HapticStepSettings
{
  VirtualCouplingSettings coupling; ///< its travel and radius come from the scene
  ContactSettings contact;          ///< its hardening comes from leastContactMm2
  /// A contact of this area or more bears the spring's force limit before it is half a voxel in,
  /// however fine the tool: contact hardens as much as that takes, to a thousand times its
  /// stiffness at most. 0: it does not harden, and sinks in by F / (k A). mm^2; >= 0.
  double leastContactMm2 = 1.0;
  FrictionSettings friction;
  ForceLimits limits;
  double tickS = 0.001;    ///< > 0
  double budgetUs = 400.0; ///< of a tick, for contact: 40 % of it; infinite: all levels always
  double fadeS = 0.1;      ///< attraction from nothing to all of it; > 0
  double slewS = 0.05;     ///< stiffness, spring and scenes, from one value to another; > 0
  int blendTicks = 8;      ///< from one level to the next; >= 5
  bool control = false;    ///< the passivity controller, as a last resort
  PassivityControllerSettings passivity; ///< its tick is tickS
};

struct HapticTick
{
  Wrench onDevice; ///< WORLD axes, about the device's point; finite and within the limits
  RigidPose tool;
  ContactSums sums;         ///< on the tool; world axes, about its origin
  double levels = 0.0;      ///< finest level that counts, from 0, blended
  std::uint32_t points = 0; ///< evaluated, in all steps; a dynamic shell's living ones
  int evaluations = 0;
  std::uint32_t status = 0; ///< CouplingTick::Status
};

/// One tick of haptics: a device's pose in, a wrench for its motors out. Contact of a group of
/// shells before several maps, quasi-static coupling, limits. Dynamic shells draw their points
/// first, where the last tick has left the tool; levels of static ones share the time that is left.
///
/// What changes is slewed inside the tick: a new stiffness or spring over slewS, bodies that are
/// new in a scene grow from nothing over the same time, attraction fades over fadeS, levels are
/// blended over blendTicks. So whatever is set, and however often, the device feels it gradually.
///
/// Attraction is kept where its slope, at most a A / R, is under half of the spring's, so that its
/// negative part cannot run away from the coupling.
///
/// Threads: construct anywhere; then all of it HAPTIC. Tick takes no memory, no lock, logs nothing
/// and does not throw. The clock that it measures contact with is the steady one.
class HapticStep
{
public:
  /// Throws std::invalid_argument with the value and its legal range.
  explicit HapticStep(const HapticStepSettings& settings = {});

  /// The tool jumps there, forces grow from zero.
  void Place(const RigidPose& tool) noexcept;
  /// Takes the scene and gives back the one before, which somebody else is to free. Null: nothing
  /// can be touched. What both have in common stays as it is felt.
  void Swap(std::unique_ptr<HapticScene>& scene) noexcept;
  /// The one that it has; null: none.
  const HapticScene* Scene() const noexcept { return this->Held.get(); }
  /// Of a dynamic shell of the scene it has, felt in the next tick.
  void SetIsovalue(std::size_t shell, double isovalue) noexcept;
  /// Slewed from the next tick on. Not checked: in the ranges that the settings' headers tell.
  void Aim(const ContactSettings& contact) noexcept { this->WantedContact = contact; }
  void Aim(const CouplingSpring& spring) noexcept { this->WantedSpring = spring; }
  void Attract(bool on) noexcept { this->Attracts = on; }
  /// No more than so many levels, whatever the budget allows; >= 1. Blended, as any change of it.
  void LimitLevels(int levels) noexcept { this->MostLevels = levels; }

  HapticTick Tick(const RigidPose& device) noexcept;

  /// Of what the device held, behind all limits. Reads 0 unless the settings ask for control.
  const PassivityObserver& Observer() const noexcept { return this->Passivity.Observer(); }
  std::uint64_t Controlled() const noexcept { return this->Passivity.Activations(); }

private:
  class TimedContact;
  void Slew() noexcept;
  void Harden() noexcept;
  void SlewAttraction() noexcept;
  double AllowedFade(double attractedMm2) const noexcept;
  void SlewLevels() noexcept;
  void UpdateScene() noexcept;

  HapticStepSettings Settings;
  VirtualCoupling Coupling;
  ContactFriction Friction;
  ForceLimiter Limiter;
  PassivityController Passivity;
  CostModel Cost;
  double UpdateUs = 0.0; ///< what dynamic shells take of a tick, about
  std::unique_ptr<HapticScene> Held;
  ContactSettings WantedContact;
  CouplingSpring WantedSpring;
  HapticScene::Plan Plan;
  bool Attracts = false;
  int MostLevels = 99;
  double Fade = 0.0;         ///< as switched on or off
  double Bound = 1.0;        ///< what the spring allows
  double AttractedMm2 = 0.0; ///< the most of the last tick
};

} // namespace hasp
