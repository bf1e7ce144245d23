// Where a plan is saved that a crash left: in its own place, or in one that is asked for.
#include "CrashDesk.h"

namespace
{
namespace fs = std::filesystem;

class PlannerRecovery : public CrashDesk
{
protected:
  /// A plan of that label, saved below the folder of plans.
  void SaveNew(PlannerProcess& planner, const std::string& label, const fs::path& place)
  {
    planner.SetText("import.case", label);
    ASSERT_TRUE(Save(planner, place));
    ASSERT_EQ(LabelIn(place), label);
  }
  const fs::path A = this->Plans() / "A.hasp", B = this->Plans() / "B.hasp";
};

TEST_F(PlannerRecovery, SavesWhereThePlanWasSavedBefore)
{
  auto planner = this->Open();
  this->SaveNew(*planner, "K-1", this->A);
  planner->SetText("import.case", "K-2");
  planner->Kill9();
  planner = this->Open();
  ASSERT_TRUE(BringBack(*planner));
  EXPECT_FALSE(Save(*planner, this->B)) << "it asked for a name";
  EXPECT_EQ(LabelIn(this->A), "K-2");
}

TEST_F(PlannerRecovery, APlanBegunAfterNewDoesNotReplaceTheOneBefore)
{
  auto planner = this->Open();
  this->SaveNew(*planner, "K-1", this->A);
  planner->Key("ctrl+n");
  planner->SetText("import.case", "K-2");
  planner->Kill9();
  planner = this->Open();
  ASSERT_TRUE(BringBack(*planner));
  EXPECT_TRUE(Save(*planner, this->B)) << "it did not ask for a name";
  EXPECT_EQ(LabelIn(this->A), "K-1");
  EXPECT_EQ(LabelIn(this->B), "K-2");
}

TEST_F(PlannerRecovery, APlanThatSomebodyElseHasSavedMeanwhileStays)
{
  auto planner = this->Open();
  this->SaveNew(*planner, "K-1", this->A);
  planner->SetText("import.case", "K-2");
  planner->Kill9();
  hasp::PlanDocument theirs = hasp::LoadPlan(this->A);
  theirs.history.Do(hasp::SetCaseLabel{ "theirs" });
  hasp::SavePlan(this->A, theirs);
  planner = this->Open();
  ASSERT_TRUE(BringBack(*planner));
  EXPECT_TRUE(Save(*planner, this->B)) << "it did not ask for a name";
  EXPECT_EQ(LabelIn(this->A), "theirs");
  EXPECT_EQ(LabelIn(this->B), "K-2");
}

} // namespace
