#pragma once
#include "Failure.h"

#include "Planning/Plan.h"

#include <cstddef>
#include <set>
#include <string>
#include <vector>

/// What a run could not make, and what does not hold.
namespace hasp
{

class RunFaults
{
public:
  /// Of an object's part; begins with the object, once.
  void Add(const Plan& plan, PlanId object, ExitCode code, const std::string& why);
  /// Of none.
  void Add(const Failure& failure);
  bool Has(PlanId object) const { return this->Objects.contains(object); }
  const std::vector<std::string>& Texts() const { return this->All; }
  /// Throws Failure if there are any: all of them, and what became of the other parts.
  void Refuse(std::size_t parts, bool isKept) const;

private:
  std::set<PlanId> Objects;
  std::vector<std::string> All;
  ExitCode Code = ExitCode::FailedCheck;
};

} // namespace hasp
