#pragma once
#include "Grid/RigidPose.h"

#include <cstdint>

namespace hasp
{

/// The energy that has gone from a device into the renderer (Hannaford and Ryu 2002), N mm = mJ:
///   E(n) = sum of -w(k-1) . (x(k) - x(k-1)), six axes.
/// A renderer that gives back no more than it took keeps it >= 0. Threads: one; nothing throws.
class PassivityObserver
{
public:
  /// Once a tick: the pose read, and then the wrench that the device holds until the next one.
  /// Wrenches that are not finite are passed over. Where a pose is none, the way to the next one
  /// counts with the wrench that was held last.
  void Tick(const RigidPose& device, const Wrench& held) noexcept;
  /// Replaces what Tick was told, before the next one.
  void Hold(const Wrench& held) noexcept;
  double Energy() const noexcept { return this->Sum; }
  double Lowest() const noexcept { return this->Least; }
  void Restart() noexcept { *this = {}; }

private:
  RigidPose Last;
  Wrench Held;
  double Sum = 0.0, Least = 0.0;
  bool HasLast = false;
};

struct PassivityControllerSettings
{
  double allowance = 1.0;  ///< mJ below zero that are borne; >= 0
  double damping = 0.005;  ///< N s/mm at most; > 0. Under StableStiffness's b of the device
  double leverMm = 30.0;   ///< turns are damped as motion at this distance; > 0
  double cutoffHz = 100.0; ///< of the velocity's filter; > 0
  double tickS = 0.001;    ///< > 0
};

/// Last resort: where the observer reads under -allowance, damps the device by E/(v^2 T), bounded.
/// Damping by a filtered velocity has stability limits of its own: a scene that needs it is too
/// stiff. Activations are counted; nominal scenes have none. Threads: one; nothing throws.
class PassivityController
{
public:
  /// Throws std::invalid_argument with the value and its legal range.
  explicit PassivityController(const PassivityControllerSettings& settings = {});
  /// The wrench to hold: `wanted`, damped where needed. Observes what it returns.
  Wrench Tick(const RigidPose& device, const Wrench& wanted) noexcept;
  /// What is held instead of what Tick has returned, where limits come after it.
  void Hold(const Wrench& held) noexcept { this->Watch.Hold(held); }
  const PassivityObserver& Observer() const noexcept { return this->Watch; }
  std::uint64_t Activations() const noexcept { return this->Count; }
  void Restart() noexcept;

private:
  PassivityControllerSettings Settings;
  PassivityObserver Watch;
  RigidPose Last;
  glm::dvec3 Speed{ 0.0 }, Turning{ 0.0 }; ///< filtered: mm/s, rad/s
  bool HasLast = false;
  std::uint64_t Count = 0;
};

} // namespace hasp
