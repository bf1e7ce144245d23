#pragma once
#include "Devices/HeadPose.h"

namespace hasp
{

/// What keeps the drawn head from jumping where the wanted one does: their distance at the jump,
/// which shrinks to nothing along a smooth step. One thread; costs nothing.
class HeadPoseFade
{
public:
  /// From what is drawn to what is wanted, in `seconds` > 0.
  void Begin(const HeadPose& drawn, const HeadPose& wanted, double seconds);
  void Advance(double seconds);
  bool Active() const { return this->ElapsedS < this->TotalS; }
  HeadPose Apply(const HeadPose& wanted) const;

private:
  glm::dvec3 Offset{ 0.0 };
  glm::dquat Turn{ 1, 0, 0, 0 };
  double ElapsedS = 0.0, TotalS = 0.0;
};

} // namespace hasp
