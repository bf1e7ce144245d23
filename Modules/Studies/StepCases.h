#pragma once
#include "Studies/StabilityCases.h"
#include "Studies/StepRenderer.h"

#include <functional>
#include <memory>

namespace hasp
{

/// What a row of the whole step is made of: shells on the tool before ground at z = 0.
struct StepCase
{
  BenchScene scene;
  HapticStepSettings settings;
  bool skewed = false; ///< the ground's map
  int perSide = 32;    ///< points of the foot
  /// In the foot's place, where it is set. Made anew in each run.
  std::function<HapticShell()> shell{};
  StepRenderer::Change change{};
};

/// A foot of 10 mm pressed on the ground, N/mm per mm^2.
StepCase PressedStep(const BenchHand& hand, float stiffness);
/// A row "<family>.<id>.<hand>" that must be stable; lastS: until nothing changes any more.
void AddStep(std::vector<StabilityRow>& rows, const std::string& id, const std::string& text,
  StepCase made, double lastS = 0.0);
/// Once, at a time: `act` on the step.
StepRenderer::Change Once(double atS, std::function<void(HapticStep&)> act);

} // namespace hasp
