// A guide, from the scan to the printed part, as a user makes it.
#include "Planning/DerivedPart.h" // before Qt, which has a macro "slots"

#include "../../CommandLine/Testing/HaspProcess.h"
#include "WholeWay.h"

#include <array>
#include <cmath>
#include <regex>

namespace
{

using Shares = std::vector<std::array<double, 2>>; // of the large view's width and height

/// From the front, in the large view: bone above the right eye, along the inner rim of the defect
/// and around its upper end, and between that and the midline.
const Shares AlongTheRim{ { 0.451, 0.480 }, { 0.448, 0.444 }, { 0.445, 0.406 }, { 0.437, 0.360 },
  { 0.419, 0.330 }, { 0.393, 0.348 } };
const Shares ForPins{ { 0.468, 0.462 }, { 0.460, 0.378 } };
/// Of the left forehead, which is whole.
const Shares OnPlainBone{ { 0.580, 0.430 }, { 0.582, 0.400 }, { 0.584, 0.370 }, { 0.586, 0.345 } };
constexpr std::size_t MostSteps = 60; // of a case that is planned here

/// The numbers before " mm" in a text, in order.
std::vector<double> MillimetresIn(const std::string& text)
{
  static const std::regex Number("(-?[0-9]+\\.[0-9]+) mm");
  std::vector<double> numbers;
  for (std::sregex_iterator at(text.begin(), text.end(), Number), end; at != end; ++at)
    numbers.push_back(std::stod((*at)[1]));
  return numbers;
}

using PlannerPlateAround = WholeWay;

/// Of pixels, those that differ.
double ShareOfOthers(const QImage& one, const QImage& other)
{
  if (one.size() != other.size())
    return 1.0;
  int others = 0;
  for (int y = 0; y < one.height(); ++y)
    for (int x = 0; x < one.width(); ++x)
      others += one.pixel(x, y) != other.pixel(x, y);
  return double(others) / (double(one.width()) * one.height());
}

class PlannerSkull : public WholeWay
{
protected:
  void SetUp() override
  {
    WholeWay::SetUp();
    if (!this->IsSkipped() && std::string(HASP_CRANIUM).empty())
      GTEST_SKIP() << "Cranium.inv3 is not here: Utilities/Scripts/cranium fetches it";
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
  static void Touch(PlannerProcess& planner, const Shares& places)
  {
    for (const auto& [x, y] : places)
      planner.ClickAt("view.scene", x, y);
    planner.Key("Escape");
  }
  static void PlanGuide(PlannerProcess& planner, const Shares& along)
  {
    planner.Click("step.guide");
    planner.Click("guide.new");
    Touch(planner, along);
    planner.SetNumber("guide.width", 16);
    planner.ClickRow("guide.pages", 1);
    planner.SetNumber("guide.thickness", 2.5);
    planner.SetNumber("guide.gap", 0.3);
  }
  static void PlanPins(PlannerProcess& planner)
  {
    planner.ClickRow("guide.pages", 3);
    planner.Click("guide.pins");
    Touch(planner, ForPins);
  }
  static QImage ViewOf(PlannerProcess& planner)
  {
    const auto rect = planner.Widget("view.scene").at("rect").get<std::array<int, 4>>();
    return planner.Hand().Picture().copy(rect[0], rect[1], rect[2], rect[3]);
  }
  static std::string Push(PlannerProcess& planner)
  {
    planner.Click("step.check");
    planner.Click("check.seat");
    return planner.Text("check.seat.result");
  }
};

TEST_F(PlannerSkull, AGuideIsMadeTriedOnWrittenAndTheSameByTheCommandLine)
{
  const auto planner = this->Begin();
  ShowBone(*planner);
  PlanGuide(*planner, AlongTheRim);
  PlanPins(*planner);
  EXPECT_EQ(MakeAll(*planner), "guide 2 is made: green.");
  const QImage before = ViewOf(*planner);
  planner->Click("check.fit");
  const auto isFree = [&](const Json& now)
  {
    for (const Json& widget : now["widgets"])
      if (widget["name"] == "check.fit.state")
        return widget.value("text", "") == "Free, 30.00 mm off its planned place.";
    return false;
  };
  planner->WaitUntil("the part in hand, lifted off", isFree);
  Picture(*planner, "PlannerSkullLifted");
  EXPECT_NE(Push(*planner).find("guide 2 seats"), std::string::npos) << Push(*planner);
  EXPECT_NE(planner->Text("check.fit.state").find("off its planned place"), std::string::npos);
  Picture(*planner, "PlannerSkullSeated");
  planner->Key("Escape");
  // The clipping range is another one, and depths are rounded otherwise: some hundred pixels at
  // edges, where another camera changes a hundred thousand.
  EXPECT_LT(ShareOfOthers(ViewOf(*planner), before), 0.001) << "not as before the test fit";
  ExportAll(*planner, this->Path("parts"));
  Picture(*planner, "PlannerSkullWritten");
  WriteReport(*planner, this->Path("report.html"));
  SaveAs(*planner, this->Path("skull.hasp"));
  Close(*planner, "A guide on the skull");
  for (const char* report : { "report.html", "report.pdf" })
    EXPECT_GT(std::filesystem::file_size(this->Path(report)), 100'000U) << report;
  this->ExpectSameAsRun(this->Path("skull.hasp"), HASP_CRANIUM, this->Path("parts"));
}

TEST_F(PlannerSkull, AllThatWasPlannedIsTakenBackToAnEmptyPlanAndDoneAgain)
{
  const auto planner = this->Begin();
  ShowBone(*planner);
  PlanGuide(*planner, AlongTheRim);
  PlanPins(*planner);
  const Json empty = hasp::PlanHash(hasp::Plan{});
  std::vector<Json> plans{ planner->State("plan") }; // from the last to the first
  while (plans.back() != empty && plans.size() <= MostSteps)
  {
    planner->Key("ctrl+z");
    plans.push_back(planner->State("plan"));
  }
  EXPECT_EQ(plans.back(), empty);
  EXPECT_GT(plans.size(), 10U); // a scan, places, pins and sizes
  const Json planned = plans.front();
  for (plans.pop_back(); !plans.empty(); plans.pop_back()) // through the same ones
  {
    planner->Key("ctrl+y");
    EXPECT_EQ(planner->State("plan"), plans.back()) << plans.size() - 1 << " from the last";
  }
  planner->Key("ctrl+y"); // there is no more
  EXPECT_EQ(planner->State("plan"), planned);
  planner->Key("ctrl+z");
  EXPECT_NE(planner->State("plan"), planned);
}

/// On plain bone, which faces the way, its first touch is the certificate's least gap
/// (TestGuideSeat.cxx says why, and why not along a rim). Both have two digits here.
TEST_F(PlannerSkull, AGuideOnPlainBoneSeatsWhereItsCertificateSays)
{
  const auto planner = this->Begin();
  ShowBone(*planner);
  PlanGuide(*planner, OnPlainBone);
  EXPECT_EQ(MakeAll(*planner), "guide 2 is made: green.");
  Picture(*planner, "PlannerSkullPlain");
  const std::string found = Push(*planner);
  ASSERT_NE(found.find("guide 2 seats"), std::string::npos) << found;
  const std::vector<double> mm = MillimetresIn(found); // depth, place, least gap
  ASSERT_GE(mm.size(), 2U) << found;
  EXPECT_NEAR(mm.front(), mm.back(), 0.1) << found;
  std::cout << found << "\n";
}

/// From the middle of the forehead over the top to below the widest place of the back: what goes
/// round bone by more than half goes on along no straight way. A guide is made without undercuts.
TEST_F(PlannerPlateAround, ASkullIsBlockedByItAndThatIsSaid)
{
  const std::string head = this->Path("head.mha");
  ASSERT_EQ(RunHasp({ "phantom", "--spacing", "1,1,1", "--output", head }).exitCode, 0);
  const auto planner = this->Begin();
  Import(*planner, head);
  planner->Key("ctrl+m");
  planner->Click("step.plate");
  planner->Click("plate.new");
  const std::pair<const char*, std::vector<double>> sides[]{ { "alt+1", { 0.42, 0.34 } },
    { "alt+7", { 0.4, 0.6 } }, { "alt+shift+1", { 0.34, 0.45, 0.56 } } };
  for (const auto& [side, heights] : sides)
  {
    planner->Key(side);
    for (const double y : heights)
      planner->ClickAt("view.scene", 0.5, y);
  }
  planner->Key("Escape");
  EXPECT_EQ(MakeAll(*planner), "plate 2 is made: green.");
  planner->Click("check.seat");
  const std::string found = planner->Text("check.seat.result");
  EXPECT_NE(found.find("plate 2 is blocked"), std::string::npos) << found;
  Picture(*planner, "PlannerSkullAround");
}

} // namespace
