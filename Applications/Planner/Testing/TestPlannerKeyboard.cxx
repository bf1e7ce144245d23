// bin/hasp-planner without a mouse: where Tab comes to, and what Alt and a letter do.
#include "LayoutEntries.h"
#include "PhantomDesk.h"

#include <map>
#include <set>

using namespace layout;

namespace
{

constexpr int MostTabs = 200; // until all have had the keyboard

/// What a mouse would be used on, but for what has keys of its own: menus, and the steps.
bool IsForUse(const Json& widget)
{
  const std::string kind = widget["class"], name = widget["name"];
  if (kind == "QAction" || kind == "QProgressBar" || name.starts_with("step."))
    return false;
  for (const char* key : { "checked", "value", "index", "length", "rows" })
    if (widget.contains(key))
      return true;
  return kind.ends_with("Button") || kind.ends_with("View");
}

std::set<std::string> ForUse(const Json& layout)
{
  std::set<std::string> names;
  for (const Json& widget : layout["widgets"])
    if (widget.value("enabled", true) && IsForUse(widget))
      names.insert(widget["name"]);
  return names;
}

std::string Joined(const std::set<std::string>& names)
{
  std::string text;
  for (const std::string& name : names)
    text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// Those that Tab does not come to, of all that can be used now.
std::string WithoutTab(PlannerProcess& planner)
{
  planner.WaitSettled();
  std::set<std::string> left = ForUse(planner.Layout());
  for (int tab = 0; tab < MostTabs && !left.empty(); ++tab)
  {
    planner.Key("Tab");
    if (const Json& focus = planner.Layout()["focus"]; focus.is_string())
      left.erase(focus.get<std::string>());
  }
  return Joined(left);
}

/// Letters that stand for more than one thing on the screen, disabled ones among them: they will be
/// enabled.
std::string GivenTwice(PlannerProcess& planner)
{
  planner.WaitSettled();
  std::map<std::string, std::set<std::string>> of;
  for (const Json& widget : planner.Layout()["widgets"])
    if (widget.contains("mnemonic"))
      of[widget["mnemonic"]].insert(widget["name"]);
  std::string twice;
  for (const auto& [letter, names] : of)
    if (names.size() > 1)
      twice += letter + ": " + Joined(names) + "; ";
  return of.size() < 5 ? "there are hardly any letters" : twice;
}

/// Whether it is the plan's, not a sample's.
bool ListsObjects(PlannerProcess& planner)
{
  const Json objects = planner.Widget("objects");
  for (const Json& row : objects["rows"])
    if (row.value("id", 0) == 9)
      return true;
  return false;
}

/// Each page of what is shown of a step, in turn.
template <typename Look>
void EachPage(PlannerProcess& planner, const Look& look)
{
  std::string pages;
  for (const Json& widget : planner.Layout()["widgets"])
    if (widget["class"] == "QTabWidget")
      pages = widget["name"];
  const std::size_t count = pages.empty() ? 1 : planner.Widget(pages)["rows"].size();
  for (std::size_t page = 0; page < count; ++page)
  {
    if (!pages.empty())
      planner.ClickRow(pages, int(page));
    look(pages.empty() ? std::string() : ", page " + std::to_string(page));
  }
}

/// What is chosen in the list of objects, so that forms are filled.
const std::map<std::string, int> Chosen{ { "reduce", 5 }, { "cut", 3 }, { "guide", 8 },
  { "plate", 9 } };

/// All that a step shows: its pages, and those of each kind of what is planned there.
template <typename Look>
void EachView(PlannerProcess& planner, const std::string& step, const Look& look)
{
  planner.Click("step." + step);
  if (const auto chosen = Chosen.find(step); chosen != Chosen.end() && ListsObjects(planner))
    planner.ClickId("objects", chosen->second);
  const int kinds = planner.Has("plate.kind") ? planner.Widget("plate.kind").value("count", 0) : 1;
  for (int kind = 0; kind < kinds; ++kind)
  {
    if (kind > 0)
      planner.Choose("plate.kind", kind);
    EachPage(planner,
      [&](const std::string& page) { look(step + ", kind " + std::to_string(kind) + page); });
  }
}

const char* const Steps[] = { "import", "split", "reduce", "cut", "guide", "plate", "check",
  "export" };

class PlannerTab : public PhantomDesk, public testing::WithParamInterface<const char*>
{
};

TEST_P(PlannerTab, ComesToAllThatCanBeClicked)
{
  const auto planner = this->OpenPlan();
  planner->Click("message.close");
  EachView(*planner, this->GetParam(),
    [&](const std::string& view) { EXPECT_EQ(WithoutTab(*planner), "") << view; });
}

INSTANTIATE_TEST_SUITE_P(Of, PlannerTab, testing::ValuesIn(Steps),
  [](const auto& step) { return std::string(step.param); });

class PlannerLetters : public PhantomDesk, public testing::WithParamInterface<const char*>
{
protected:
  void ExpectEachGivenOnce(PlannerProcess& planner)
  {
    for (const char* step : Steps)
      EachView(planner, step,
        [&](const std::string& view) { EXPECT_EQ(GivenTwice(planner), "") << view; });
  }
};

TEST_P(PlannerLetters, AreGivenOnceOfAPlan)
{
  const auto planner = this->OpenPlan({ "--language", this->GetParam() });
  this->ExpectEachGivenOnce(*planner);
}

TEST_P(PlannerLetters, AreGivenOnceWhereAScanIsMissing)
{
  const auto planner = this->Open({ this->Plan(), "--language", this->GetParam() });
  this->ExpectEachGivenOnce(*planner);
}

TEST_P(PlannerLetters, AreGivenOnceInTheTour)
{
  if (!HASP_READS_SAMPLE)
    GTEST_SKIP() << "the sample, a real CT in an archive, is not here or cannot be read";
  const auto planner = this->Open({ "--sample", "--language", this->GetParam() });
  planner->Widget("tour.next");
  this->ExpectEachGivenOnce(*planner);
}

INSTANTIATE_TEST_SUITE_P(Of, PlannerLetters, testing::Values("en", "sv"),
  [](const auto& language) { return std::string(language.param); });

using PlannerMenuKeys = PlannerDesk;

TEST_F(PlannerMenuKeys, AltAndItsLetterOpenEachMenuAndNoLetterIsInItTwice)
{
  const auto planner = this->Open();
  std::map<std::string, std::string> menus;
  planner->WaitSettled();
  for (const Json& widget : planner->Layout()["widgets"])
    if (widget["class"] == "QAction" && widget["name"].get<std::string>().starts_with("menu."))
      menus[widget["name"]] = widget.value("mnemonic", std::string());
  EXPECT_EQ(menus.size(), 5U);
  for (const auto& [menu, letter] : menus)
  {
    ASSERT_EQ(letter.size(), 1U) << menu;
    planner->Key("alt+" + std::string(1, char(std::tolower(letter[0]))));
    planner->WaitUntil(menu, [&](const Json& now) { return now["popup"] == menu; });
    std::map<std::string, int> inMenu;
    for (const Json& widget : planner->Layout()["widgets"])
      if (widget["class"] == "QAction" && widget.contains("mnemonic") &&
          !menus.contains(widget["name"]))
      {
        EXPECT_EQ(++inMenu[widget["mnemonic"]], 1) << widget["name"];
      }
    planner->Key("Escape");
    planner->Key("Escape"); // and the bar is left
  }
}

TEST_F(PlannerMenuKeys, AnActionIsDoneByLettersAlone)
{
  const auto planner = this->Open();
  planner->Key("alt+h");
  planner->Key("k");
  EXPECT_TRUE(planner->Has("page.keys"));
}

} // namespace
