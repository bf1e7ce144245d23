#pragma once
#include "../../CommandLine/Testing/HaspProcess.h"
#include "PlannerDesk.h"

/// The phantom of 1 mm, and the plan of Data/phantom-plan-edits.json on it: the jaw 2, cuts 3 and
/// 4, its pieces 5, 6 and 7, guide 8 and plate 9. Nothing is made.
class PhantomDesk : public PlannerDesk
{
protected:
  void SetUp() override
  {
    PlannerDesk::SetUp();
    if (this->IsSkipped())
      return;
    OutputOfHasp({ "phantom", "--spacing", "1,1,1", "--quiet", "--output", this->Scan() });
    OutputOfHasp({ "plan", this->Plan(), "--new" });
    OutputOfHasp({ "plan", this->Plan(), "--apply", HASP_PLAN_EDITS });
  }
  std::string Scan() const { return (this->folder / "head.mha").string(); }
  std::string Plan() const { return (this->folder / "case.hasp").string(); }
  std::unique_ptr<PlannerProcess> OpenPlan(std::vector<std::string> words = {})
  {
    words.insert(words.begin(), { this->Plan(), this->Scan() });
    return this->Open(std::move(words));
  }
};
