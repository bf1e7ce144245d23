#pragma once
#include "WholeWay.h"

#include <array>
#include <string>
#include <vector>

/// A case of a sample of the program, at a desk where cases are planned.
class SampleCase : public WholeWay
{
protected:
  /// In the 3D view: right and down from its middle, shares of its shorter side. What is seen from
  /// a side stays there when panels make the view wider or narrower.
  using Place = std::array<double, 2>;

  /// Begins with it, and leaves its tour; one large view.
  std::unique_ptr<PlannerProcess> BeginSample(const std::string& action);

  static void Touch(PlannerProcess& planner, const std::vector<Place>& places);
  /// Along a line.
  static void Stroke(PlannerProcess& planner, const Place& from, const Place& to);
  /// On the screen, pixels.
  static std::array<int, 2> PixelOf(PlannerProcess& planner, const Place& place);
  /// From a side ("alt+1"), with all that is planned in the picture.
  static void LookFrom(PlannerProcess& planner, const std::string& keys);

  /// Undoes all, and does it again: through the same plans.
  static void ExpectThereAndBack(PlannerProcess& planner);
  /// Exports, and compares with what bin/hasp makes of the plan as it was saved.
  void ExpectExportAsRun(PlannerProcess& planner, const std::string& called);
  /// What run.json of the export says of them, by file: "plate-8.stl".
  std::map<std::string, std::string> Verdicts() const;
  std::string SavedPlan() const { return this->Path("case.hasp"); }

private:
  std::vector<std::string> Scans() const; ///< that the program keeps
};
