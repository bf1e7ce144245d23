// What is being typed, and what is in hand, when something else is done in bin/hasp-planner.
#include "PhantomDesk.h"

namespace
{

using PlannerTyping = PhantomDesk;

TEST_F(PlannerTyping, ANumberThatIsBeingTypedIsSavedWithThePlan)
{
  const auto planner = this->OpenPlan();
  planner->Click("step.guide");
  planner->ClickId("objects", 8);
  planner->Click("guide.width");
  planner->Key("ctrl+a");
  planner->Type("17");
  planner->Key("ctrl+s");
  EXPECT_FALSE(planner->State("modified"));
  EXPECT_NE(ReadBytes(this->Plan() + "/plan.json").find("\"widthMm\": 17"), std::string::npos);
  EXPECT_EQ(planner->Layout()["focus"], "guide.width");
}

TEST_F(PlannerTyping, AToolIsPutAwayWithItsPageAndABladeIsNot)
{
  const auto planner = this->OpenPlan();
  planner->Click("step.cut");
  planner->ClickId("objects", 3);
  planner->ClickRow("cut.pages", 0);
  EXPECT_TRUE(planner->Widget("cut.drag")["checked"]);
  planner->ClickRow("cut.pages", 1);
  planner->ClickRow("cut.pages", 0);
  EXPECT_TRUE(planner->Widget("cut.drag")["checked"]) << "its handles are there on all pages";
  for (const char* tool : { "cut.place", "cut.bone" }) // for a row of places; for a single one
  {
    planner->Click(tool);
    EXPECT_TRUE(planner->Widget(tool)["checked"]) << tool;
    planner->ClickRow("cut.pages", 1);
    planner->ClickRow("cut.pages", 0);
    EXPECT_FALSE(planner->Widget(tool)["checked"]) << tool;
  }
}

/// The list's menu does what its columns do.
TEST_F(PlannerTyping, AnObjectIsLockedHiddenAndRenamedByItsMenu)
{
  const auto planner = this->OpenPlan();
  const auto choose = [&](const char* action)
  {
    planner->ClickId("objects", 5, 0, 3);
    planner->Click(action);
  };
  const auto isChecked = [&](int column)
  {
    const auto objects = planner->Widget("objects");
    for (const auto& row : objects["rows"])
      if (row.value("id", 0) == 5 && row["column"] == column)
        return row["checked"].get<bool>();
    throw std::runtime_error("no fragment 5");
  };
  planner->ClickId("objects", 5);
  for (const auto& [action, column] : { std::pair("objects.lock", 1), { "objects.show", 0 } })
  {
    const bool before = isChecked(column);
    choose(action);
    EXPECT_NE(isChecked(column), before) << action;
    choose(action);
    EXPECT_EQ(isChecked(column), before) << action;
  }
  choose("objects.rename");
  planner->Key("ctrl+a");
  planner->Type("ramus");
  planner->Key("Return");
  planner->Key("ctrl+s");
  EXPECT_NE(ReadBytes(this->Plan() + "/plan.json").find("\"ramus\""), std::string::npos);
}

} // namespace
