#include "Studies/BenchRenderers.h"

#include <limits>

namespace hasp
{

VirtualCouplingSettings DefaultCoupling(
  const BenchDevice& device, const BenchClock& clock, double voxelMm, double radiusMm)
{
  VirtualCouplingSettings settings;
  CouplingSpring& spring = settings.spring;
  spring.stiffness = StableStiffness(device.damping, clock.tickS, clock.delayTicks * clock.tickS);
  spring.turnStiffness = spring.stiffness * device.leverMm * device.leverMm;
  spring.forceLimit = 0.5 * device.forceLimitN;
  spring.torqueLimit = 0.5 * device.torqueLimitNmm;
  settings.travelMm = 0.25 * voxelMm;
  settings.radiusMm = radiusMm;
  return settings;
}

template <class Coupling>
Wrench CoupledRenderer<Coupling>::Tick(const RigidPose& device, double timeS)
{
  if (this->Changes)
    this->Changes(timeS, this->Touch, this->Held);
  RigidPose read = device;
  if (timeS >= this->LostFromS && timeS < this->LostToS)
    read.position.y = std::numeric_limits<double>::quiet_NaN();
  this->Last = this->Held.Tick(read, this->Touch);
  return this->Limiter.Limit(this->Last.onDevice, this->TickS);
}

template class CoupledRenderer<VirtualCoupling>;
template class CoupledRenderer<ExplicitCoupling>;

Wrench PenaltyRenderer::Tick(const RigidPose& device, double)
{
  this->Device = device;
  return this->Touch.At(device).sums.contact;
}

} // namespace hasp
