#pragma once
#include "Planning/DerivedPart.h"
#include "Planning/PlanFile.h"

#include "PlannerDesk.h"

#include <chrono>
#include <cstdlib>
#include <random>
#include <string>
#include <thread>

/// A desk whose program is killed, and started again in the same home.
class CrashDesk : public PlannerDesk
{
protected:
  std::filesystem::path Plans() const { return this->folder / "home" / "Hasp"; }

  /// Brings back what was not saved, if that is asked. Says whether it was.
  static bool BringBack(PlannerProcess& planner)
  {
    if (!planner.Has("recover.bring"))
      return false;
    planner.Click("recover.bring");
    return true;
  }
  /// By Ctrl+S. Where a name is asked for it is `folder`; says whether it was.
  static bool Save(PlannerProcess& planner, const std::filesystem::path& folder)
  {
    planner.Key("ctrl+s");
    const bool asked = planner.Has("fileNameEdit");
    if (asked)
      planner.AnswerFile(folder.string());
    EXPECT_EQ(planner.State("modified"), false) << planner.State("message");
    return asked;
  }
  /// What was sent last is under way, or not begun, or done.
  static void KillSoon(PlannerProcess& planner, std::mt19937& dice, int mostMs)
  {
    std::this_thread::sleep_for(std::chrono::microseconds(dice() % (1000 * mostMs)));
    planner.Kill9();
  }
  /// How often: 50 times, or as Utilities/Scripts/crash-test says.
  static int Kills()
  {
    const char* said = std::getenv("HASP_KILLS");
    return said ? std::atoi(said) : 50;
  }
  /// The hash of a plan that has a case label and nothing else.
  static std::string PlanWith(const std::string& caseLabel)
  {
    hasp::Plan plan;
    plan.caseLabel = caseLabel;
    return hasp::PlanHash(plan);
  }
  static std::string LabelIn(const std::filesystem::path& plan)
  {
    return hasp::LoadPlan(plan).history.Current().caseLabel;
  }
};
