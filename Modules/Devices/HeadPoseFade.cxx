#include "Devices/HeadPoseFade.h"

#include <algorithm>

namespace hasp
{

void HeadPoseFade::Begin(const HeadPose& drawn, const HeadPose& wanted, double seconds)
{
  this->Offset = drawn.position - wanted.position;
  this->Turn = glm::normalize(drawn.orientation * glm::conjugate(wanted.orientation));
  this->ElapsedS = 0.0;
  this->TotalS = seconds;
}

void HeadPoseFade::Advance(double seconds)
{
  this->ElapsedS = std::min(this->ElapsedS + seconds, this->TotalS);
}

HeadPose HeadPoseFade::Apply(const HeadPose& wanted) const
{
  if (!this->Active())
    return wanted;
  const double x = this->ElapsedS / this->TotalS, left = 1.0 - x * x * (3.0 - 2.0 * x);
  const glm::dquat turn = glm::slerp(glm::dquat(1, 0, 0, 0), this->Turn, left);
  return { wanted.position + left * this->Offset, glm::normalize(turn * wanted.orientation) };
}

} // namespace hasp
