#include "RunFaults.h"

#include "Planning/PlanLists.h"

#include <algorithm>

namespace hasp
{

void RunFaults::Add(const Plan& plan, PlanId object, ExitCode code, const std::string& why)
{
  this->Objects.insert(object);
  const std::string called = CalledObject(plan, object) + ": ";
  this->All.push_back(why.starts_with(called) ? why : called + why);
  this->Code = std::min(this->Code, code); // what is not there is worse than what does not hold
}

void RunFaults::Add(const Failure& failure)
{
  this->All.push_back(failure.what());
  this->Code = std::min(this->Code, failure.code);
}

void RunFaults::Refuse(std::size_t parts, bool isKept) const
{
  if (this->All.empty())
    return;
  std::string text = "no folder was written";
  if (!this->Objects.empty())
    text += ": of " + std::to_string(parts) + " parts " + std::to_string(this->Objects.size()) +
            (this->Code == ExitCode::FailedCheck ? " do not hold (--force keeps them)"
                                                 : " cannot be made or do not hold");
  if (this->Objects.size() < parts && isKept && this->All.size() == this->Objects.size())
    text += "; the plan keeps the others, which are not made again";
  for (const std::string& fault : this->All)
    text += "\n  " + fault;
  throw Failure(this->Code, text);
}

} // namespace hasp
