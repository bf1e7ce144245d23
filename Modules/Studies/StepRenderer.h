#pragma once
#include "Haptics/HapticStep.h"
#include "Studies/HapticBench.h"

#include <functional>
#include <utility>

namespace hasp
{

/// The whole haptic step on the bench: shells before baked maps, all levels, limits.
class StepRenderer : public BenchRenderer
{
public:
  using Change = std::function<void(double timeS, HapticStep& step)>;

  StepRenderer(const HapticStepSettings& settings, std::unique_ptr<HapticScene> scene)
    : Step(settings)
  {
    this->Step.Swap(scene);
  }
  void OnTick(Change change) { this->Changes = std::move(change); }

  void Place(const RigidPose& tool) override
  {
    this->Step.Place(tool);
    this->Last.tool = tool;
  }
  Wrench Tick(const RigidPose& device, double timeS) override
  {
    if (this->Changes)
      this->Changes(timeS, this->Step);
    this->Last = this->Step.Tick(device);
    return this->Last.onDevice;
  }
  double DeepestMm() override { return this->Last.sums.deepestMm; }
  double Residual() override
  {
    return (this->Last.status & CouplingTick::Travelling) != 0 ? 1.0 : 0.0; // on its way, or there
  }
  RigidPose Tool() const override { return this->Last.tool; }

private:
  HapticStep Step;
  HapticTick Last;
  Change Changes;
};

} // namespace hasp
