#include "SampleCase.h"

#include "../../CommandLine/Testing/HaspProcess.h"

#include <algorithm>
#include <cmath>

namespace fs = std::filesystem;

std::unique_ptr<PlannerProcess> SampleCase::BeginSample(const std::string& action)
{
  auto planner = this->Begin();
  planner->Menu({ "menu.file", "menu.samples", action });
  planner->Click("tour.leave");
  planner->Key("ctrl+m");
  return planner;
}

std::array<int, 2> SampleCase::PixelOf(PlannerProcess& planner, const Place& place)
{
  const auto rect = planner.Widget("view.scene").at("rect").get<std::array<int, 4>>();
  const double side = std::min(rect[2], rect[3]);
  return { rect[0] + int(std::lround(0.5 * rect[2] + place[0] * side)),
    rect[1] + int(std::lround(0.5 * rect[3] + place[1] * side)) };
}

namespace
{

/// As ClickAt and Drag have it: shares of a view's width and height.
std::array<double, 2> SharesOf(PlannerProcess& planner, const std::array<double, 2>& place)
{
  const auto rect = planner.Widget("view.scene").at("rect").get<std::array<int, 4>>();
  const double side = std::min(rect[2], rect[3]);
  return { 0.5 + place[0] * side / rect[2], 0.5 + place[1] * side / rect[3] };
}

} // namespace

void SampleCase::Touch(PlannerProcess& planner, const std::vector<Place>& places)
{
  for (const Place& place : places)
  {
    const auto [x, y] = SharesOf(planner, place);
    planner.ClickAt("view.scene", x, y);
  }
}

void SampleCase::Stroke(PlannerProcess& planner, const Place& from, const Place& to)
{
  const auto a = SharesOf(planner, from), b = SharesOf(planner, to);
  planner.Drag("view.scene", a[0], a[1], b[0], b[1]);
}

void SampleCase::LookFrom(PlannerProcess& planner, const std::string& keys)
{
  planner.WaitSettled();
  if (planner.Has("message.close"))
    planner.Click("message.close"); // it takes room from the view
  planner.Key(keys);
}

void SampleCase::ExpectThereAndBack(PlannerProcess& planner)
{
  constexpr std::size_t mostSteps = 200;
  const auto press = [&](const std::string& keys) -> Json
  {
    planner.Key(keys);
    return planner.State("plan");
  };
  std::vector<Json> plans{ planner.State("plan") }; // from the last to the first
  for (Json before = press("ctrl+z"); before != plans.back(); before = press("ctrl+z"))
  {
    plans.push_back(before);
    ASSERT_LT(plans.size(), mostSteps);
  }
  EXPECT_GT(plans.size(), 6U);
  const Json made = plans.front();
  for (plans.pop_back(); !plans.empty(); plans.pop_back())
    EXPECT_EQ(press("ctrl+y"), plans.back()) << plans.size() - 1 << " from the last";
  EXPECT_EQ(press("ctrl+y"), made) << "there is no more";
}

std::vector<std::string> SampleCase::Scans() const
{
  std::vector<std::string> scans;
  for (const auto& entry :
    fs::recursive_directory_iterator(this->folder / "home/state/hasp-planner/scans"))
    if (entry.path().extension() == ".nrrd")
      scans.push_back(entry.path().string());
  return scans;
}

void SampleCase::ExpectExportAsRun(PlannerProcess& planner, const std::string& called)
{
  ExportAll(planner, this->Path("parts"));
  Picture(planner, called);
  ASSERT_TRUE(fs::exists(this->Path("parts/run.json"))) << planner.State("message");
  const std::string copy = this->Path("copy.hasp"); // it would keep what it makes
  fs::copy(this->SavedPlan(), copy, fs::copy_options::recursive);
  std::vector<std::string> words{ "run", copy, "--rebuild", "--output", this->Path("again") };
  for (const std::string& scan : this->Scans())
    words.insert(words.end(), { "--volume", scan });
  const HaspRun run = RunHasp(words);
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const auto written = FilesBelow(this->Path("parts")), expected = FilesBelow(this->Path("again"));
  EXPECT_GT(expected.size(), 1U);
  EXPECT_EQ(written.size(), expected.size());
  for (const auto& [name, bytes] : expected)
  {
    ASSERT_TRUE(written.contains(name)) << name;
    EXPECT_TRUE(written.at(name) == bytes) << name;
  }
}

std::map<std::string, std::string> SampleCase::Verdicts() const
{
  std::map<std::string, std::string> verdicts;
  const Json report = Json::parse(ReadBytes(this->Path("parts/run.json")));
  for (const Json& part : report.at("parts"))
    verdicts[part.at("file")] = part.at("verdict");
  return verdicts;
}
