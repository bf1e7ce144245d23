#pragma once
#include "Haptics/ToolContact.h"

#include <cstdint>

namespace hasp
{

/// The spring between a device and the tool it holds. Defaults suit a Falcon-like device (1 N s/m,
/// one tick of delay) that nobody holds: see StableStiffness.
struct CouplingSpring
{
  double stiffness = 0.33;      ///< k, N/mm; > 0
  double turnStiffness = 300.0; ///< N mm/rad; > 0
  double forceLimit = 4.0;      ///< F_sat, N; > 0. Under h sum k for plates of thickness 2h
  double torqueLimit = 120.0;   ///< N mm; > 0

  /// Pulls the tool to the device: F_sat tanh(k d / F_sat) along d; the torque likewise.
  Wrench Pull(const RigidPose& device, const RigidPose& tool) const noexcept;
};

/// The stiffest coupling that a device stands, by share: (b + b_hand) / (T/2 + t_d) (Gil et al.
/// 2004; Colgate and Schenkel 1997 without delay and hand). Contact beyond it may be as stiff as it
/// likes: a quasi-static tool lets the device feel both in series, softer than either. Within 10 %
/// at 1 or 2 ticks of delay, on the safe side at 0. N/mm, from N s/mm and s; turns alike, from
/// N mm s/rad.
double StableStiffness(double damping, double tickS, double delayS, double share = 0.5) noexcept;

struct VirtualCouplingSettings
{
  CouplingSpring spring{};
  double travelMm =
    0.125; ///< of the tool's farthest point in a step towards contact: 1/4 voxel; > 0
  double radiusMm = 30.0;  ///< of the ball around the tool's origin that holds it; > 0
  int steps = 4;           ///< at most, a tick; > 0
  double tolerance = 0.05; ///< share of the limits that may be left unbalanced
};

/// What came of a tick.
struct CouplingTick
{
  enum Status : std::uint32_t
  {
    Good = 0,
    BadDevicePose = 1, ///< not finite, or no turn: no wrench, the tool stays
    Unsolved = 2,      ///< contact is not finite: the tool stays
    Travelling = 4,    ///< the tool is still on its way: travel or steps ran out
  };
  Wrench onDevice;  ///< WORLD axes; torque about the device's point. Within the spring's limits
  ContactSums sums; ///< the last that was asked for; on the tool
  double residual = 0.0; ///< at it: what is unbalanced, in shares of the limits
  int evaluations = 0;
  std::uint32_t status = Good;
};

/// Quasi-static coupling (Wan and McNeely 2003; Barbic and James 2008): the tool has no mass. A
/// tick moves it to where the spring and the contacts balance, by Newton steps on
///
///   (K_contact + K_spring) delta = w_spring + w_contact
///
/// with the spring's secant stiffness F(d)/d, not its tangent: in free space one step goes all the
/// way, and no saturated spring overshoots. Unconditionally stable, since K_contact is positive
/// semidefinite: the device feels k in series with the contact, never more (StableStiffness).
///
/// One step; another if after it more than `tolerance` may be left. A step near surfaces goes no
/// farther than travelMm past the contact's clearance, so that no point gets through a wall of
/// twice that thickness unseen. Attraction acts on the tool, but is not in the matrix: its slope
/// must stay under half of the spring's (HapticStep sees to it).
///
/// Limit: turns of more than pi between device and tool go the shorter way round.
/// Threads: one, HAPTIC once constructed. No memory is taken; nothing throws.
class VirtualCoupling
{
public:
  /// Throws std::invalid_argument with the value and its legal range.
  explicit VirtualCoupling(const VirtualCouplingSettings& settings = {});

  /// The tool jumps there, as when it is taken in hand.
  void Place(const RigidPose& tool) noexcept { this->ToolPose = tool; }
  const RigidPose& Tool() const noexcept { return this->ToolPose; }

  CouplingTick Tick(const RigidPose& device, ToolContact& contact) noexcept;

  /// Values as in the settings, not checked here; the caller slews them (HapticStep does).
  void SetSpring(const CouplingSpring& spring) noexcept { this->Settings.spring = spring; }
  void SetTravel(double travelMm, double radiusMm) noexcept;
  const VirtualCouplingSettings& GetSettings() const noexcept { return this->Settings; }

private:
  VirtualCouplingSettings Settings;
  RigidPose ToolPose;
};

/// Finite, with a turn whose length is 1 within 1e-3.
bool IsPose(const RigidPose& pose) noexcept;

} // namespace hasp
