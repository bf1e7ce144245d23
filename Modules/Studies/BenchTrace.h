#pragma once
#include "Studies/HapticBench.h"

#include <array>
#include <vector>

namespace hasp
{

/// What is written down at each tick of a bench's run, and the figures made of it.
class BenchTrace
{
public:
  explicit BenchTrace(const BenchScene& scene);
  void Asked(const Wrench& wrench);
  /// motors: what they hold from now until the next tick.
  void Tick(double timeS, const RigidPose& device, const Wrench& motors, BenchRenderer& renderer);
  BenchFigures Figures() const;

private:
  void Balance(double timeS, BenchRenderer& renderer);

  const BenchScene& Scene;
  std::array<std::vector<double>, 6> Hold; ///< mm; turns at the lever
  std::vector<double> HoldForce;           ///< N, by norm
  RigidPose Last;
  Wrench Held;
  bool HasLast = false;
  double TouchedAtS = -1.0;
  double UnbalancedFromS = -1.0;
  BenchFigures Sums;
};

} // namespace hasp
