#pragma once
#include "../../CommandLine/Testing/HaspProcess.h"
#include "Tools/Planner.h"
#include "View/ViewGrid.h"

#include <QStringList>

#include <filesystem>
#include <map>
#include <memory>
#include <string>

/// A planner with the plan of Data/phantom-plan-edits.json on its scan, the phantom of 1 mm: the
/// jaw 2, cuts 3 and 4, its pieces 5, 6 and 7, guide 8 and plate 9. On a screen of its own.
class PlannerParts : public HaspTest
{
protected:
  PlannerParts();
  ~PlannerParts() override;

  /// Until no job is left.
  void Finish();
  hasp::Plan Now() const { return this->planner->plan.Now(); }
  void Do(const hasp::PlanEdit& edit) { ASSERT_TRUE(this->planner->plan.Do(edit)); }
  /// Cut 3, moved along its normal.
  void MoveCut(double mm);
  /// Guide 8, so that it cannot hold: with a hole that leaves too thin walls beside it.
  void SpoilGuide();
  std::map<std::string, std::string> Files(const std::string& folder) const;
  std::string Scan() const { return this->Path("head.mha"); }
  std::filesystem::path PathOf(const std::string& name) const { return this->folder / name; }
  /// All that was said to the user: good news, and faults.
  QStringList said, faults;

  std::unique_ptr<hasp::ViewGrid> views;
  std::unique_ptr<hasp::Planner> planner;
};
