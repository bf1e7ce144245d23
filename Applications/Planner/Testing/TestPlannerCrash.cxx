// The program is killed at any moment: at most the action that was under way is lost.
#include "Planning/DerivedPart.h"

#include "PlannerDesk.h"

#include <chrono>
#include <cstdlib>
#include <random>
#include <set>
#include <thread>

namespace
{
std::string PlanOf(PlannerProcess& planner)
{
  return planner.State("plan");
}

/// The hash of a plan that has a case label and nothing else.
std::string PlanWith(const std::string& caseLabel)
{
  hasp::Plan plan;
  plan.caseLabel = caseLabel;
  return hasp::PlanHash(plan);
}

/// Brings back what was not saved, if that is asked. Says whether it was.
bool BringBack(PlannerProcess& planner)
{
  if (!planner.Has("recover.bring"))
    return false;
  planner.Click("recover.bring");
  return true;
}

/// One action of the user's: another case label, or one taken back.
void Act(PlannerProcess& planner, std::mt19937& dice, int number)
{
  if (number > 2 && dice() % 4 == 0)
    planner.Key(dice() % 2 == 0 ? "ctrl+z" : "ctrl+y");
  else
    planner.SetText("import.case", "K-" + std::to_string(number));
}

/// How often the program is killed: 50 times, or as Utilities/Scripts/crash-test says.
int Kills()
{
  const char* said = std::getenv("HASP_KILLS");
  return said ? std::atoi(said) : 50;
}

using PlannerCrash = PlannerDesk;

TEST_F(PlannerCrash, LosesAtMostTheActionUnderWayAndOffersTheRest)
{
  std::mt19937 dice(12);
  std::set<std::string> allowed; // plans that may come back
  int number = 0, offered = 0;
  for (int kill = 0; kill < Kills(); ++kill)
  {
    const auto planner = this->Open();
    const bool asked = BringBack(*planner);
    offered += asked;
    ASSERT_EQ(asked, kill > 0) << "kill " << kill;
    const std::string found = PlanOf(*planner);
    ASSERT_TRUE(kill == 0 || allowed.contains(found)) << "kill " << kill;
    const int actions = 1 + int(dice() % 3);
    for (int n = 0; n < actions; ++n)
      Act(*planner, dice, ++number);
    // The last action is sent, and the program killed while it works on it, or before, or after.
    allowed = { PlanOf(*planner) };
    planner->Click("import.case");
    planner->Hand().Key("ctrl+a");
    const std::string last = "L-" + std::to_string(++number);
    planner->Hand().Type(last);
    planner->Hand().Key("Return");
    std::this_thread::sleep_for(std::chrono::microseconds(dice() % 60'000));
    planner->Kill9();
    allowed.insert(PlanWith(last));
  }
  EXPECT_EQ(offered, Kills() - 1);
}

} // namespace
