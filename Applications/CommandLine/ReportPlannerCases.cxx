#include "ReportPlannerCases.h"

#include "MeasuredChild.h"
#include "Report/Report.h"
#include "Report/ReportRegistry.h"
#include "Report/ReportText.h"
#include "Report/ScratchFolder.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace hasp
{
namespace
{
namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr double MostS = 1800.0, MostWaitS = 90.0;

struct PlannedCase
{
  const char* id;
  const char* suite; ///< of its test
  const char* data;
  double mostClicks;
};
constexpr PlannedCase Cases[] = {
  { "fracture", "PlannerFracture", "phantom mandible in four pieces, put together and plated",
    150 },
  { "fibula", "PlannerFibula", "phantom chin of two segments of a fibula, with its saw guide",
    250 },
};

ReportRow RowOf(const PlannedCase& one, const char* figure)
{
  ReportRow row;
  row.id = std::string("planner.") + figure + "." + one.id;
  row.method = "planner";
  row.better = Better::Lower;
  row.data = one.data;
  return row;
}

void AddAbsent(Report& report, const PlannedCase& one, const std::string& why)
{
  ReportRow row = RowOf(one, "clicks");
  row.rival = "the planner's user";
  row.absent = why;
  report.rows.push_back(row);
}

/// `counted`: what the test has noted of itself.
void AddCase(Report& report, const PlannedCase& one, const Json& counted)
{
  const auto figure = [&](const char* key)
  { return std::stod(counted.at(key).get<std::string>()); };
  ReportRow clicks = RowOf(one, "clicks");
  clicks.value = figure("clicks");
  clicks.unit = "count";
  clicks.bars.push_back({ {}, one.mostClicks });
  clicks.data += "; keys besides: " + std::to_string(int(figure("keys")));
  ReportRow wait = RowOf(one, "wait");
  wait.value = wait.timeS = figure("wait_s");
  wait.unit = "s";
  wait.error = figure("off_mm");
  wait.errorUnit = "mm, most that is planned off the truth";
  wait.bars.push_back({ {}, MostWaitS });
  wait.data += "; for jobs: " + FigureText(figure("jobs_s"), "s");
  report.rows.push_back(clicks); // both or, where a figure lacks, neither
  report.rows.push_back(wait);
}

/// The test beside this program; empty: it is not built.
std::string SamplesTest()
{
  std::error_code ignored;
  const fs::path program =
    fs::read_symlink("/proc/self/exe", ignored).parent_path() / "TestPlannerSamples";
  return fs::exists(program, ignored) ? program.string() : std::string();
}

/// Of a file of GoogleTest's. Throws std::exception: it is none, or not whole.
void AddCounted(Report& report, const PlannedCase& one, const Json& tests)
{
  std::string why =
    std::string("it did not end well: bin/TestPlannerSamples --gtest_filter=") + one.suite + ".*";
  for (const Json& suite : tests.at("testsuites"))
    for (const Json& test : suite.at("testsuite"))
    {
      if (suite.at("name") != one.suite)
        continue;
      if (test.at("result") != "COMPLETED")
        why = "its test was not run: it needs Xvfb";
      else if (!test.contains("failures"))
        return AddCase(report, one, test);
    }
  AddAbsent(report, one, why);
}

/// With all that it starts: a screen, and the planner.
void RunCases(const std::string& program, const fs::path& counted)
{
  RunMeasured(
    { "-k", "9", std::to_string(MostS), program, "--gtest_filter=PlannerFracture.*:PlannerFibula.*",
      "--gtest_output=json:" + counted.string() },
    { "/usr/bin/timeout", MostS + 60.0 });
}
} // namespace

void ReportPlannerCases(ReportContext& context)
{
  const auto absent = [&](const std::string& why)
  {
    for (const PlannedCase& one : Cases)
      AddAbsent(context.report, one, why);
  };
  const std::string program = SamplesTest();
  if (program.empty())
    return absent("TestPlannerSamples, which counts them, is not beside this program");
  const ScratchFolder scratch;
  const fs::path counted = fs::path(scratch.Path()) / "counted.json";
  context.progress(0.5, "planning whole cases by clicks");
  try
  {
    RunCases(program, counted);
  }
  catch (const std::runtime_error& error)
  {
    return absent(error.what());
  }
  if (!fs::exists(counted))
    return absent("TestPlannerSamples was ended before it had counted");
  for (const PlannedCase& one : Cases)
    try
    {
      AddCounted(context.report, one, Json::parse(std::ifstream(counted)));
    }
    catch (const std::exception&) // of JSON, or of numbers
    {
      AddAbsent(context.report, one, "what TestPlannerSamples has counted cannot be read");
    }
}

} // namespace hasp
