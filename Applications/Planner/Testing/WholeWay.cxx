#include "WholeWay.h"

#include "../../CommandLine/Testing/HaspProcess.h"

#include <iomanip>
#include <iostream>

namespace fs = std::filesystem;

std::unique_ptr<PlannerProcess> WholeWay::Begin(std::vector<std::string> words)
{
  auto planner = this->Open(std::move(words));
  planner->patienceS = LongS;
  return planner;
}

void WholeWay::Import(PlannerProcess& planner, const std::string& path)
{
  planner.Click("step.import");
  planner.Click("import.open");
  planner.AnswerFile(path);
}

void WholeWay::ImportFolder(PlannerProcess& planner, const std::string& path)
{
  planner.Click("step.import");
  planner.Click("import.folder");
  planner.AnswerFile(path);
}

void WholeWay::ExportAll(PlannerProcess& planner, const std::string& folder)
{
  planner.Click("step.export");
  planner.Click("export.browse");
  planner.AnswerFile(folder);
  planner.Click("export.all");
}

void WholeWay::WriteReport(PlannerProcess& planner, const std::string& html)
{
  planner.Click("step.export");
  planner.Click("export.report");
  planner.AnswerFile(html);
}

void WholeWay::SaveAs(PlannerProcess& planner, const std::string& folder)
{
  planner.Key("ctrl+s");
  planner.AnswerFile(folder);
  EXPECT_FALSE(planner.State("modified").get<bool>()) << planner.State("message");
}

std::string WholeWay::MakeAll(PlannerProcess& planner)
{
  planner.Click("step.check");
  planner.Click("check.makeall");
  return planner.State("message");
}

void WholeWay::Close(PlannerProcess& planner, const std::string& called)
{
  const UserEffort effort = planner.Effort();
  planner.CloseWindow();
  EXPECT_EQ(planner.ExitCode(), 0);
  EXPECT_EQ(planner.Output(), "");
  const auto note = [](const char* key, double figure)
  { RecordProperty(key, std::to_string(figure)); };
  note("clicks", double(effort.clicks)); // what hasp report reads
  note("keys", double(effort.keys));
  note("wait_s", effort.machineWaitS);
  note("jobs_s", effort.ofThemBusyS);
  std::cout << called << ": " << effort.clicks << " clicks, " << effort.keys << " keys, "
            << std::fixed << std::setprecision(1) << effort.machineWaitS
            << " s of waiting, of them " << effort.ofThemBusyS << " s for jobs\n";
}

void WholeWay::ExpectSameAsRun(
  const std::string& plan, const std::string& scan, const std::string& parts)
{
  const std::string again = this->Path("again");
  const HaspRun run = RunHasp({ "run", plan, "--volume", scan, "--output", again, "--rebuild" });
  EXPECT_EQ(run.exitCode, 0) << run.err;
  const auto written = FilesBelow(parts), expected = FilesBelow(again);
  EXPECT_GT(expected.size(), 1U);
  for (const auto& [name, bytes] : expected)
  {
    ASSERT_TRUE(written.contains(name)) << name;
    EXPECT_TRUE(written.at(name) == bytes) << name;
  }
  EXPECT_EQ(written.size(), expected.size());
  const Json report = Json::parse(written.at("run.json"));
  for (const Json& part : report.at("parts"))
  {
    EXPECT_EQ(part.at("verdict"), "green") << part.at("faults");
    EXPECT_EQ(part.at("certificate").at("verdict"), "holds");
  }
}

void WholeWay::Picture(const PlannerProcess& planner, const std::string& name)
{
  fs::create_directories(HASP_TEST_PICTURES);
  planner.SavePicture(fs::path(HASP_TEST_PICTURES) / (name + ".png"));
}

std::map<std::string, std::string> FilesBelow(const fs::path& folder)
{
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[fs::relative(entry.path(), folder).string()] = ReadBytes(entry.path().string());
  return files;
}
