// The order in which Tab goes through bin/hasp-planner.
#include "LayoutEntries.h"
#include "PhantomDesk.h"

#include <algorithm>
#include <tuple>

using namespace layout;

namespace
{

constexpr int MostTabs = 200; // until all have had the keyboard

using PlannerTabOrder = PhantomDesk;

/// What has the keyboard after that, by Tab.
std::string After(PlannerProcess& planner, const std::string& name)
{
  for (int tab = 0; tab < MostTabs && planner.Layout()["focus"] != name; ++tab)
    planner.Key("Tab");
  EXPECT_EQ(planner.Layout()["focus"], name);
  planner.Key("Tab");
  return planner.Layout().value("focus", std::string());
}

TEST_F(PlannerTabOrder, BoxesOfObjectsStandWhereTheyAreSeen)
{
  const auto planner = this->OpenPlan();
  planner->Click("step.guide");
  planner->ClickId("objects", 8);
  planner->ClickRow("guide.pages", 2);
  EXPECT_EQ(After(*planner, "guide.pages"), "guide.cut.3");
  EXPECT_EQ(After(*planner, "guide.cut.3"), "guide.cut.4");
}

TEST_F(PlannerTabOrder, LeavesTheTableOfResources)
{
  const auto planner = this->OpenPlan();
  planner->Menu({ "menu.view", "view.dock.use" });
  EXPECT_NE(After(*planner, "use"), "use");
}

/// From above to below and from left to right, all that can be used: parts have got their buttons
/// as they were made.
TEST_F(PlannerTabOrder, ExportIsGoneThroughAsItIsRead)
{
  const auto planner = this->OpenPlan();
  planner->Click("step.export"); // there is nothing in date yet
  planner->Click("step.check");
  for (int piece = 0; piece < 3; ++piece)
  {
    planner->ClickRow("check.table", piece);
    planner->Click("check.make");
  }
  planner->Click("step.export");
  planner->SetText("export.folder", "parts");
  std::vector<std::tuple<int, int, std::string>> read;
  for (const Json& widget : planner->Layout()["widgets"])
  {
    const std::string name = widget["name"], kind = widget["class"];
    if (name.starts_with("export.") && kind != "QLabel" && widget.value("enabled", false))
      read.emplace_back(MiddleY(HitOf(widget)), HitOf(widget)[0], name);
  }
  std::sort(read.begin(), read.end());
  ASSERT_GE(read.size(), 8U); // format, three parts, folder, its button, the report and its names
  for (std::size_t n = 0; n + 1 < read.size(); ++n)
    EXPECT_EQ(After(*planner, std::get<2>(read[n])), std::get<2>(read[n + 1]));
}

} // namespace
