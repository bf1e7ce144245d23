// A guide, from the scan to the printed part, as a user makes it.
#include "WholeWay.h"

#include <array>

namespace
{

using Shares = std::vector<std::array<double, 2>>; // of the large view's width and height

/// From the front, in the large view: bone above the right eye, along the inner rim of the defect
/// and around its upper end, and between that and the midline.
const Shares AlongTheRim{ { 0.451, 0.480 }, { 0.448, 0.444 }, { 0.445, 0.406 }, { 0.437, 0.360 },
  { 0.419, 0.330 }, { 0.393, 0.348 } };
const Shares ForPins{ { 0.468, 0.462 }, { 0.460, 0.378 } };

class PlannerSkull : public WholeWay
{
protected:
  void SetUp() override
  {
    WholeWay::SetUp();
    if (!this->IsSkipped() && std::string(HASP_CRANIUM).empty())
      GTEST_SKIP() << "Cranium.inv3 is not here: Utilities/Scripts/cranium fetches it";
  }

  static void Touch(PlannerProcess& planner, const Shares& places)
  {
    for (const auto& [x, y] : places)
      planner.ClickAt("view.scene", x, y);
    planner.Key("Escape");
  }
  /// The scan, its bone from the front, large.
  static void ShowBone(PlannerProcess& planner)
  {
    Import(planner, HASP_CRANIUM);
    planner.Click("step.split");
    planner.SetNumber("split.isovalue", 226);
    planner.Key("alt+1");
    planner.Key("ctrl+m");
  }
  static void PlanGuide(PlannerProcess& planner)
  {
    planner.Click("step.guide");
    planner.Click("guide.new");
    Touch(planner, AlongTheRim);
    planner.SetNumber("guide.width", 16);
    planner.ClickRow("guide.pages", 1);
    planner.SetNumber("guide.thickness", 2.5);
    planner.SetNumber("guide.gap", 0.3);
    planner.ClickRow("guide.pages", 3);
    planner.Click("guide.pins");
    Touch(planner, ForPins);
  }
};

TEST_F(PlannerSkull, Explore)
{
  const auto planner = this->Begin();
  ShowBone(*planner);
  PlanGuide(*planner);
  Picture(*planner, "PlannerSkull-1");
  std::cout << MakeAll(*planner) << "\n";
  Picture(*planner, "PlannerSkull-2");
  planner->Click("check.seat");
  std::cout << planner->Text("check.seat.result") << "\n";
  planner->Click("check.fit");
  planner->WaitSettled();
  Picture(*planner, "PlannerSkull-3");
  std::cout << planner->Text("check.fit.state") << "\n";
  planner->Key("Escape");
  ExportAll(*planner, this->Path("parts"));
  std::cout << planner->State("message") << "\n";
  Picture(*planner, "PlannerSkull-4");
  WriteReport(*planner, this->Path("report.html"));
  std::cout << planner->State("message") << "\n";
  SaveAs(*planner, this->Path("skull.hasp"));
  Close(*planner, "A guide on the skull");
  this->ExpectSameAsRun(this->Path("skull.hasp"), HASP_CRANIUM, this->Path("parts"));
  std::system(("cp -r " + this->Path("skull.hasp") + " " + this->Path("parts") + " " + this->Path("report.html") + " " + this->Path("report.pdf")+ " /tmp/A-out/").c_str());
}

} // namespace
