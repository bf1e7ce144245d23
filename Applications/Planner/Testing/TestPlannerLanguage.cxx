// bin/hasp-planner in Swedish: asked for by the option, and by the system.
#include "PlannerDesk.h"

#include <cstdlib>
#include <utility>

namespace
{

using PlannerLanguage = PlannerDesk;

TEST_F(PlannerLanguage, StepsMenusAndButtonsAreSwedish)
{
  const auto planner = this->Open({ "--language", "sv" });
  for (const auto& [step, title] :
    { std::pair("import", "Import"), std::pair("split", "Delning"),
      std::pair("reduce", "Reposition"), std::pair("cut", "Snitt"), std::pair("guide", "Sågmall"),
      std::pair("plate", "Platta"), std::pair("check", "Kontroll"), std::pair("export", "Export") })
    EXPECT_TRUE(planner->Text(std::string("step.") + step).starts_with(title)) << step;
  EXPECT_EQ(planner->Text("import.open"), "Öppna fil…");
  EXPECT_EQ(planner->Text("menu.file"), "Arkiv");
  planner->Click("menu.file");
  EXPECT_EQ(planner->Text("file.saveas"), "Spara som …");
  planner->Key("Escape");
}

/// Qt has no Swedish of its own.
TEST_F(PlannerLanguage, ButtonsOfQtAreSwedish)
{
  const auto planner = this->Open({ "--language", "sv" });
  planner->SetText("import.case", "K-17");
  planner->CloseWindow();
  EXPECT_EQ(planner->Text("question.save.save"), "Spara");
  EXPECT_EQ(planner->Text("question.save.cancel"), "Avbryt");
  EXPECT_EQ(planner->ClickToEnd("question.save.discard"), 0);
}

TEST_F(PlannerLanguage, IsTheSystemsWhereNoneIsAskedFor)
{
  ASSERT_EQ(setenv("LANGUAGE", "sv", 1), 0); // of this process: a test is one of its own
  EXPECT_EQ(this->Open()->Text("import.open"), "Öppna fil…");
  EXPECT_EQ(this->Open({ "--language", "en" })->Text("import.open"), "Open file…");
}

} // namespace
