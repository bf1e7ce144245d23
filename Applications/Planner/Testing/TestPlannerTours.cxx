// The guided tours: each of their stops marks what it speaks of, is left when that is done and not
// before, and the last one is the end.
#include "LayoutEntries.h"
#include "SampleCase.h"

#include <cstdlib>

namespace
{

struct Stop
{
  const char *step, *marked;
};
using Stops = std::vector<Stop>;

const Stops Skull{ { "import", "view.scene" }, { "split", "split.isovalue" },
  { "guide", "guide.new" }, { "guide", "guide.gap" }, { "check", "check.makeall" },
  { "export", "export.all" } };
const Stops Mandible{ { "import", "view.scene" }, { "split", "split.isovalue" },
  { "split", "split.paint" }, { "split", "split.make" }, { "reduce", "reduce.grab" },
  { "plate", "plate.new" }, { "check", "check.makeall" }, { "export", "export.all" } };
/// What is made of another kind than the one that is chosen is marked by the choice of kinds.
const Stops Fibula{ { "import", "view.scene" }, { "cut", "cut.place" }, { "cut", "cut.pieces" },
  { "plate", "plate.kind" }, { "plate", "plate.kind" }, { "check", "check.makeall" },
  { "export", "export.all" } };

class PlannerTours : public SampleCase
{
protected:
  /// `scan`: of the skull's tour; one that is not there: a phantom.
  std::unique_ptr<PlannerProcess> BeginTour(const std::string& sample, const std::string& scan = {})
  {
    setenv("HASP_SAMPLE", scan.empty() ? "none" : scan.c_str(), 1); // of this process alone
    auto planner = this->Begin();
    planner->patienceS = 200.0;
    planner->Menu({ "menu.file", "menu.samples", "file.sample." + sample });
    planner->Widget("tour.text");
    return planner;
  }
  /// That the stop of that number, from 1, is where the tour is: its words, its step of the
  /// workflow, and the marker around all that is seen of its widget.
  static void ExpectAt(PlannerProcess& planner, const Stops& stops, std::size_t number)
  {
    SCOPED_TRACE("stop " + std::to_string(number));
    const Stop& stop = stops.at(number - 1);
    const std::string count = std::to_string(number) + " of " + std::to_string(stops.size()) + ": ";
    EXPECT_TRUE(planner.Text("tour.text").starts_with(count)) << planner.Text("tour.text");
    EXPECT_EQ(planner.State("step"), stop.step);
    const auto marker = layout::RectOf(planner.Widget("tour.marker"));
    const auto marked = layout::RectOf(planner.Widget(stop.marked), "shown");
    EXPECT_GT(marked[2] * marked[3], 0) << stop.marked << " is not to be seen";
    const layout::Rect around{ marked[0] - 4, marked[1] - 4, marked[2] + 8, marked[3] + 8 };
    EXPECT_EQ(marker, around) << stop.marked;
    EXPECT_EQ(planner.Text("tour.next"), number == stops.size() ? "Done" : "Next");
  }
  static void ExpectEnded(PlannerProcess& planner)
  {
    EXPECT_FALSE(planner.Has("tour.text"));
    EXPECT_FALSE(planner.Has("tour.marker"));
  }
  static void WalkToTheEnd(PlannerProcess& planner, const Stops& stops, std::size_t from = 1)
  {
    for (std::size_t number = from; number <= stops.size(); ++number)
    {
      ExpectAt(planner, stops, number);
      planner.Click("tour.next");
    }
    ExpectEnded(planner);
  }
};

TEST_F(PlannerTours, GoOnByNextToTheirEndAndDoNothing)
{
  for (const auto& [sample, stops] :
    { std::pair("skull", Skull), std::pair("mandible", Mandible), std::pair("fibula", Fibula) })
  {
    SCOPED_TRACE(sample);
    const auto planner = this->BeginTour(sample);
    const Json plan = planner->State("plan");
    WalkToTheEnd(*planner, stops);
    EXPECT_EQ(planner->State("plan"), plan);
    planner->Kill9(); // it would ask
    std::filesystem::remove_all(this->folder / "home");
  }
}

TEST_F(PlannerTours, GoBackAsFarAsToTheirBeginning)
{
  const auto planner = this->BeginTour("fibula");
  for (int stop = 1; stop < 4; ++stop)
    planner->Click("tour.next");
  for (std::size_t stop = 3; stop > 0; --stop)
  {
    planner->Click("tour.back");
    ExpectAt(*planner, Fibula, stop);
  }
  EXPECT_FALSE(planner->Widget("tour.back").value("enabled", true));
  planner->Click("tour.next");
  ExpectAt(*planner, Fibula, 2);
}

TEST_F(PlannerTours, AreLeftAtAnyStop)
{
  const auto planner = this->BeginTour("skull");
  planner->Click("tour.next");
  planner->Click("tour.leave");
  ExpectEnded(*planner);
  planner->Click("step.check"); // nothing is marked any more
  ExpectEnded(*planner);
}

TEST_F(PlannerTours, TheSkullsIsDoneByWhatItAsksFor)
{
  if (std::string(HASP_CRANIUM).empty())
    GTEST_SKIP() << "Cranium.inv3 is not here: Utilities/Scripts/cranium fetches it";
  const auto planner = this->BeginTour("skull", HASP_CRANIUM);
  ExpectAt(*planner, Skull, 1);
  planner->Drag("view.scene", 0.5, 0.5, 0.6, 0.5); // looking is no end of looking
  ExpectAt(*planner, Skull, 1);
  planner->Click("tour.next");
  planner->SetNumber("split.isovalue", 300);
  planner->SetNumber("split.isovalue", 226);
  ExpectAt(*planner, Skull, 2);
  planner->Click("tour.next");
  planner->Key("alt+1");
  planner->Click("guide.new");
  ExpectAt(*planner, Skull, 3);
  for (const Place& place : std::vector<Place>{ { 0.080, -0.078 }, { 0.082, -0.111 } })
  {
    Touch(*planner, { place });
    ExpectAt(*planner, Skull, 3);
  }
  Touch(*planner, { { 0.084, -0.144 } });
  ExpectAt(*planner, Skull, 4);
  planner->Key("Escape");
  planner->SetNumber("guide.gap", 0.3);
  ExpectAt(*planner, Skull, 4);
  planner->Click("tour.next");
  ExpectAt(*planner, Skull, 5);
  planner->Click("check.makeall");
  EXPECT_EQ(planner->State("message"), "guide 2 is made: green.");
  ExpectAt(*planner, Skull, 5);
  Picture(*planner, "PlannerTours-skull");
  planner->Click("tour.next");
  ExpectAt(*planner, Skull, 6);
  planner->Click("export.browse");
  planner->AnswerFile(this->Path("parts"));
  planner->Click("export.all");
  EXPECT_TRUE(std::filesystem::exists(this->Path("parts/guide-2.stl")));
  ExpectAt(*planner, Skull, 6);
  planner->Click("tour.next");
  ExpectEnded(*planner);
}

TEST_F(PlannerTours, TheMandiblesGoesOnWhenPiecesArePaintedAndMadeAndAPlateIsPlanned)
{
  const auto planner = this->BeginTour("mandible");
  planner->Click("tour.next");
  planner->SetNumber("split.isovalue", 226);
  planner->Click("tour.next");
  planner->Click("split.paint");
  LookFrom(*planner, "alt+shift+3");
  planner->ClickId("split.label", 2);
  Stroke(*planner, { -0.244, -0.177 }, { -0.300, -0.094 });
  Stroke(*planner, { 0.175, -0.115 }, { 0.244, -0.094 });
  ExpectAt(*planner, Mandible, 3); // one piece is none
  planner->ClickId("split.label", 3);
  Stroke(*planner, { 0.175, 0.151 }, { 0.258, 0.151 });
  ExpectAt(*planner, Mandible, 4);
  Picture(*planner, "PlannerTours-painted");
  planner->Click("split.make");
  ExpectAt(*planner, Mandible, 5);
  planner->Click("tour.next");
  ExpectAt(*planner, Mandible, 6);
  planner->Click("plate.new");
  for (const Place& place :
    std::vector<Place>{ { 0.045, 0.150 }, { 0.100, 0.148 }, { 0.170, 0.144 } })
  {
    Touch(*planner, { place });
    ExpectAt(*planner, Mandible, 6);
  }
  Picture(*planner, "PlannerTours-plate");
  planner->Click("tour.next");
  WalkToTheEnd(*planner, Mandible, 7);
}

TEST_F(PlannerTours, TheFibulasGoesOnWhenTheJawIsCutAndItsMiddleResected)
{
  const auto planner = this->BeginTour("fibula");
  planner->Click("tour.next");
  LookFrom(*planner, "alt+1");
  planner->Click("cut.place");
  Touch(*planner, { { -0.09, 0.29 } });
  ExpectAt(*planner, Fibula, 2);
  Touch(*planner, { { -0.09, 0.33 } });
  ExpectAt(*planner, Fibula, 2); // one cut
  planner->Click("cut.new");
  Touch(*planner, { { 0.09, 0.29 } });
  ExpectAt(*planner, Fibula, 2);
  Touch(*planner, { { 0.09, 0.33 } });
  ExpectAt(*planner, Fibula, 3);
  planner->Click("cut.pieces");
  ExpectAt(*planner, Fibula, 3); // nothing is resected yet
  Picture(*planner, "PlannerTours-jaw");
  planner->ClickRow("cut.piece.list", 2);
  planner->Click("cut.resect");
  WalkToTheEnd(*planner, Fibula, 4);
}

} // namespace
