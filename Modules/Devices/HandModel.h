#pragma once
#include "Devices/HandIntention.h"
#include "Grid/RigidPose.h"

#include <cstdint>

namespace hasp
{

/// A grip: how a hand holds on to where it wants to be. Zero: no hand.
struct HandGrip
{
  double springNPerMm = 0.0;
  double damperNsPerMm = 0.0;
  double turnSpringNmmPerRad = 0.0;
  double turnDamperNmmSPerRad = 0.0;
};
HandGrip NoGrip() noexcept;
HandGrip LooseGrip() noexcept; ///< 100 N/m, 1 N s/m
HandGrip FirmGrip() noexcept;  ///< 500 N/m, 6 N s/m

/// The moving part of a device and what of the hand moves with it: one rigid body, whose centre of
/// mass is the body's origin.
struct HandBody
{
  double massKg = 0.12;
  glm::dvec3 inertiaKgMm2{ 100.0 }; ///< about the body's axes
  double viscousNsPerMm = 0.001;    ///< the device's own friction: 1 N s/m
  double turnViscousNmmSPerRad = 0.5;
  double coulombN = 0.0; ///< dry friction: c tanh(v / creep) against the motion
  double turnCoulombNmm = 0.0;
  double creepMmPerS = 1.0;
  double creepRadPerS = 0.05;
};

/// A hand that holds a haptic device, in virtual time: a rigid body with friction, pulled by a
/// spring and a damper to where the hand intends to be, and by the wrench the device gives.
///
///   m x'' = F + k (xi - x) + b (xi' - x') - bv x' - c tanh(|x'| / creep) x' / |x'|
///
/// and the same for turns, with the rotation vector from the pose to the intended one for the
/// angle, and Euler's equations for the inertia.
/// Integrated by the midpoint rule in steps of 20 us: of second order; an undamped grip of 500 N/m
/// gains less than 1e-6 of its energy a second. Deterministic.
/// Threads: one at a time. Advance takes no memory and does not throw. Cost: 4 us a ms where
/// the hand holds still, 10 moving, 15 with a tremor.
class HandModel
{
public:
  /// At rest where the intention starts, at 0 ns. Throws std::invalid_argument if a mass or
  /// inertia is not in [1e-6, 1e6] or three moments of inertia are those of no body, another number
  /// is negative or not finite, or the body is so light for its springs, dampers and friction that
  /// 20 us are too long a step.
  HandModel(const HandBody& body, const HandGrip& grip, HandIntention intention);

  /// To a later time, with one wrench on the body all the while. Torque about its origin, device
  /// axes. A time that has passed does nothing; a wrench that is not finite counts as none.
  void Advance(std::int64_t toNs, const Wrench& applied) noexcept;

  /// Puts it elsewhere, or sets it moving.
  void SetState(const RigidPose& pose, const glm::dvec3& velocityMmPerS,
    const glm::dvec3& turnRadPerS) noexcept;
  /// Another grip from now on: a device let go.
  void SetGrip(const HandGrip& grip);

  std::int64_t TimeNs() const noexcept { return this->NowNs; }
  const RigidPose& Pose() const noexcept { return this->Now.pose; }
  const glm::dvec3& VelocityMmPerS() const noexcept { return this->Now.velocity; }
  const glm::dvec3& TurnRadPerS() const noexcept { return this->Now.turn; }
  const HandIntention& Intention() const noexcept { return this->Plan; }
  /// What applied wrenches did to the body since the beginning, N mm (= mJ). More than was stored
  /// in it: something made energy.
  double AppliedWork() const noexcept { return this->Work; }
  double KineticEnergy() const noexcept; ///< N mm

private:
  struct State
  {
    RigidPose pose;
    glm::dvec3 velocity{ 0.0 }, turn{ 0.0 };
  };
  struct Rate
  {
    glm::dvec3 acceleration, turnAcceleration;
  };
  Rate RateOf(const State& state, const IntendedPose& aim, const Wrench& applied) const noexcept;
  void Step(double stepS, const Wrench& applied) noexcept;
  void CheckStep() const;

  HandBody Body;
  HandGrip Grip;
  HandIntention Plan;
  State Now;
  std::int64_t NowNs = 0;
  double Work = 0.0;
};

} // namespace hasp
