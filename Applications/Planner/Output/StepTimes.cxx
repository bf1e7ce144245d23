#include "Output/StepTimes.h"

#include <algorithm>

namespace hasp
{

void StepTimes::Enter(const std::string& step, double now)
{
  if (!this->At.empty())
    this->Add(this->Visit(now));
  this->At = step;
  this->EnteredS = this->AliveS = now;
  this->ActiveS = 0.0;
}

void StepTimes::Alive(double now)
{
  this->ActiveS += std::clamp(now - this->AliveS, 0.0, this->PauseS);
  this->AliveS = std::max(now, this->AliveS);
}

StepTime StepTimes::Visit(double now) const
{
  if (this->At.empty())
    return {};
  const double rest = std::clamp(now - this->AliveS, 0.0, this->PauseS);
  return { this->At, 1, this->ActiveS + rest, std::max(now, this->AliveS) - this->EnteredS };
}

void StepTimes::Add(const StepTime& time)
{
  const auto known = std::find_if(this->Times.begin(), this->Times.end(),
    [&](const StepTime& of) { return of.step == time.step; });
  if (known == this->Times.end())
    return this->Times.push_back(time);
  known->visits += time.visits;
  known->activeS += time.activeS;
  known->wallS += time.wallS;
}

} // namespace hasp
