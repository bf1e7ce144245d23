#pragma once
#include "Haptics/ExplicitCoupling.h"
#include "Haptics/FieldContact.h"
#include "Haptics/VirtualCoupling.h"
#include "Realtime/ForceLimiter.h"
#include "Studies/HapticBench.h"

#include <functional>
#include <utility>
#include <vector>

namespace hasp
{

/// What a device gets if nobody chooses: half the stiffness that it stands without a hand, half of
/// its force, steps of a quarter voxel.
VirtualCouplingSettings DefaultCoupling(
  const BenchDevice& device, const BenchClock& clock, double voxelMm, double radiusMm);

/// A coupling, points against a body in closed form, and the limiter of a device behind it.
template <class Coupling>
class CoupledRenderer : public BenchRenderer
{
public:
  /// Called before each tick with the time: scenes that change.
  using Change = std::function<void(double timeS, FieldContact& contact, Coupling& coupling)>;

  CoupledRenderer(Coupling coupling, FieldContact contact, const BenchDevice& device, double tickS)
    : Held(std::move(coupling)),
      Touch(std::move(contact)),
      Device(device),
      Limiter(Limits(0.0)),
      TickS(tickS)
  {
  }
  void OnTick(Change change) { this->Changes = std::move(change); }
  /// As after a start: force grows from zero in this time.
  void RampIn(double seconds) { this->Limiter = ForceLimiter(this->Limits(seconds)); }
  /// Poses read in this span of time are not numbers.
  void LosePoses(double fromS, double toS)
  {
    this->LostFromS = fromS;
    this->LostToS = toS;
  }

  void Place(const RigidPose& tool) override { this->Held.Place(tool); }
  Wrench Tick(const RigidPose& device, double timeS) override;
  double DeepestMm() override { return this->Touch.At(this->Held.Tool()).sums.deepestMm; }
  double Residual() override { return this->Last.residual; }
  RigidPose Tool() const override { return this->Held.Tool(); }

private:
  ForceLimits Limits(double rampInS) const
  {
    ForceLimits limits;
    limits.force = this->Device.forceLimitN;
    limits.torque = this->Device.torqueLimitNmm;
    limits.rampInS = rampInS;
    return limits;
  }

  Coupling Held;
  FieldContact Touch;
  BenchDevice Device;
  ForceLimiter Limiter;
  CouplingTick Last;
  Change Changes;
  double TickS, LostFromS = 1e9, LostToS = 1e9;
};
extern template class CoupledRenderer<VirtualCoupling>;
extern template class CoupledRenderer<ExplicitCoupling>;
using QuasiStaticRenderer = CoupledRenderer<VirtualCoupling>;
using ExplicitRenderer = CoupledRenderer<ExplicitCoupling>;

/// No coupling at all: the contact's wrench at the device's pose.
class PenaltyRenderer : public BenchRenderer
{
public:
  explicit PenaltyRenderer(FieldContact contact) : Touch(std::move(contact)) {}
  void Place(const RigidPose& tool) override { this->Device = tool; }
  Wrench Tick(const RigidPose& device, double timeS) override;
  double DeepestMm() override { return this->Touch.At(this->Device).sums.deepestMm; }
  double Residual() override { return 0.0; }
  RigidPose Tool() const override { return this->Device; }

private:
  FieldContact Touch;
  RigidPose Device;
};

} // namespace hasp
