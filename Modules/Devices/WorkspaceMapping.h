#pragma once
#include "Grid/RigidPose.h"

namespace hasp
{

struct WorkspaceSettings
{
  double scale = 1.0;     ///< world mm for a mm of the device; in [0.001, 1000]
  double forceGain = 1.0; ///< N at the device for a N in the world; in [0, 10]
  double fadeS = 0.05;    ///< force goes and comes in so long as the clutch does; in [0, 1]
};

/// Device to world and back: where the workspace lies, which way its axes point (the camera's, so
/// that right is right on the screen), how large it is, and a clutch. While the clutch is held the
/// tool stays and the device moves on, as a mouse that is lifted; on release, as at each change of
/// axes or scale, it goes on from where it is: the tool never jumps.
///
///   position     p = P + s R (x - X)              s: scale, R: device axes to world
///   orientation  q = R (o O^-1) R^-1 Q            (X, O), (P, Q): the anchor, device and world
///   force        f = g R^-1 F                     g: forceGain
///   torque       t = (g / s) R^-1 T
///
/// Power at the device is g / s times power in the world, for moves and turns alike: so a scene
/// that makes no energy feels like one that makes none, at any scale. That is why the torque is
/// divided by s: with one factor for moves and another for turns a path that leads back to its
/// beginning could bring energy home. A stiffness k feels like g s k, and the coupling's must stay
/// below the device's limit with that.
/// While the clutch is held the device moves and the tool does not; a force that stayed would do
/// work for nothing, so it fades to zero, and back in after the release.
///
/// Threads: HAPTIC alone (pass settings in through a TripleBuffer). No memory, no lock; nothing
/// throws but the constructor.
class WorkspaceMapping
{
public:
  /// Throws std::invalid_argument if a setting is out of its range.
  explicit WorkspaceMapping(const WorkspaceSettings& settings = {});

  /// The middle of the device's workspace, unturned, is this pose in the world, and device axes are
  /// its axes. With what FitCoLocation gives and a scale of 1 the drawn tip is where the device's
  /// is. The tool jumps: for beginnings. Ignored if a number is not finite.
  void Place(const RigidPose& deviceToWorld) noexcept;

  /// Other axes (the camera moved) or scale from now on; the tool stays. What is not finite, no
  /// rotation or out of range is ignored, and false comes back.
  bool SetAxes(const glm::dquat& deviceToWorld) noexcept;
  bool SetScale(double scale) noexcept;

  /// Once a tick: where the tool is, for where the device is. A pose with a number that is not
  /// finite, or that would be too far for finite numbers, leaves it where it is. `dtS`: since the
  /// tick before; not above 0: none.
  const RigidPose& Update(const RigidPose& device, bool clutchHeld, double dtS) noexcept;

  /// The last Update's.
  const RigidPose& Tool() const noexcept { return this->World; }

  /// What the hand feels of a wrench on the tool (world axes, torque about the tool's origin). Zero
  /// for one that is not finite.
  Wrench ToDevice(const Wrench& world) const noexcept;

  double Scale() const noexcept { return this->Settings.scale; }
  /// How much of the force there is: 1, or less while the clutch is held or was just now.
  double ForceShare() const noexcept { return this->Share; }

private:
  void AnchorHere() noexcept;

  WorkspaceSettings Settings;
  glm::dquat Axes{ 1, 0, 0, 0 }; ///< device to world
  RigidPose DeviceAnchor, WorldAnchor;
  RigidPose Device, World; ///< of the last Update
  bool Held = false;
  double Share = 1.0;
};

} // namespace hasp
