#pragma once
#include "Haptics/VirtualCoupling.h"

namespace hasp
{

struct ExplicitCouplingSettings
{
  CouplingSpring spring{};
  double damping = 0.001;   ///< N s/mm between device and tool; >= 0
  double turnDamping = 0.9; ///< N mm s/rad; >= 0
  double massKg = 0.05;     ///< of the tool; > 0
  double inertia = 45.0;    ///< kg mm^2, about every axis; > 0
  double tickS = 0.001;     ///< > 0
};

/// The rival of VirtualCoupling: a tool with a mass on a spring and damper, moved by semi-implicit
/// Euler, as most open toolkits do it (McNeely et al. 1999). Here for comparison: it has to have
/// spring + contacts < 4 m/T^2, which 60 points of 1 N/mm break for 20 g, and its mass is felt.
/// Threads: as VirtualCoupling.
class ExplicitCoupling
{
public:
  /// Throws std::invalid_argument with the value and its legal range.
  explicit ExplicitCoupling(const ExplicitCouplingSettings& settings = {});
  void Place(const RigidPose& tool) noexcept;
  const RigidPose& Tool() const noexcept { return this->ToolPose; }
  CouplingTick Tick(const RigidPose& device, ToolContact& contact) noexcept;

private:
  ExplicitCouplingSettings Settings;
  RigidPose ToolPose, LastDevice;
  struct
  {
    glm::dvec3 linear{ 0.0 };  ///< mm/s
    glm::dvec3 angular{ 0.0 }; ///< rad/s
  } Velocity;
  bool HasLast = false;
};

} // namespace hasp
