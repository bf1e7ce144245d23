#pragma once
#include "Haptics/ContactForce.h"

namespace hasp
{

/// What touches a tool, as a coupling asks for it, several times a tick.
class ToolContact
{
public:
  struct Answer
  {
    ContactSums sums; ///< on the tool; WORLD axes, torques about the tool's origin
    /// As far as every point of the tool may go, any way, before one touches that does not touch
    /// now; mm. 0 if not known, or in contact.
    double clearanceMm = 0.0;
    bool last = false; ///< no time is left in this tick for another answer
  };
  virtual ~ToolContact() = default;
  /// HAPTIC: takes no memory, no lock, and does not throw.
  virtual Answer At(const RigidPose& tool) noexcept = 0;
};

} // namespace hasp
