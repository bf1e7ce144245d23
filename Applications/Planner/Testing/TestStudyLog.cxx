#include "Output/StudyLog.h"

#include "../../CommandLine/Testing/HaspProcess.h"
#include "Model/PlanSession.h"
#include "OffscreenQt.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <QSignalSpy>

#include <array>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>

using namespace hasp;
using nlohmann::json;
namespace fs = std::filesystem;

namespace
{

class StudyLogTest : public HaspTest
{
protected:
  StudyLogTest() { UseOffscreenQt(); }

  StudySettings Settings(const std::string& who, int trial) const
  {
    return { this->folder / "study", who, trial };
  }
  /// A plan of its own with a skull and a jaw, in a folder of its own.
  std::unique_ptr<PlanSession> Session(const std::string& name) const
  {
    fs::create_directories(this->folder / name);
    auto session = std::make_unique<PlanSession>(this->folder / name);
    PlanFragment skull, jaw;
    skull.id = 2;
    skull.name = "skull of Erika";
    skull.source = ComponentSource{ 1 };
    skull.locked = true;
    jaw.id = 3;
    jaw.name = "jaw of Erika";
    jaw.source = ComponentSource{ 1, 226.0, { 0, -70, -90 } };
    EXPECT_TRUE(session->Do({ AddObject<PlanVolume>{ { 1, "scan of Erika", std::string(64, 'a') } },
                              AddObject<PlanFragment>{ skull }, AddObject<PlanFragment>{ jaw } },
      "Erika's plan"));
    return session;
  }
  static PlanEdit JawTo(double x) { return PoseFragments{ { { 3, { { x, 0, 0 } } } } }; }
  std::vector<json> Lines(const std::string& name) const
  {
    std::vector<json> lines;
    std::ifstream file(this->folder / "study" / name);
    for (std::string line; std::getline(file, line);)
      lines.push_back(json::parse(line));
    return lines;
  }
  /// "begin step action"
  static std::string Whats(const std::vector<json>& lines)
  {
    std::string text;
    for (const json& line : lines)
      text += (text.empty() ? "" : " ") + line.at("what").get<std::string>();
    return text;
  }
  /// The jaw's surface, a box, as `hasp run` writes it.
  void WriteJaw() const
  {
    const int faces[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
      { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };
    std::ostringstream text;
    text << "solid box\n";
    for (const auto& f : faces)
      for (const auto& t : { std::array{ f[0], f[1], f[2] }, std::array{ f[0], f[2], f[3] } })
      {
        text << "facet normal 0 0 0\nouter loop\n";
        for (const int c : t)
          text << "vertex " << (c & 1) * 10 << " " << (c & 2) * 10 << " " << (c & 4) * 10 << "\n";
        text << "endloop\nendfacet\n";
      }
    std::ofstream(this->folder / "study/fragment-3.stl") << text.str() << "endsolid box\n";
  }
};

TEST_F(StudyLogTest, SettingsThatAreNoneAreRefused)
{
  const auto session = this->Session("work");
  for (const char* name : { "", "../A", "A/B", "Erika Mustermann", ".A" })
    EXPECT_THROW(StudyLog(this->Settings(name, 1), *session), std::invalid_argument) << name;
  EXPECT_THROW(StudyLog(this->Settings("A", 0), *session), std::invalid_argument);
  EXPECT_THROW(StudyLog(this->Settings("A", 10000), *session), std::invalid_argument);
  StudySettings nowhere = this->Settings("A", 1);
  nowhere.folder = this->folder / "none" / "study";
  try
  {
    StudyLog log(nowhere, *session);
    FAIL() << "its parent is not there";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_EQ(std::string(error.what()).find(this->folder.string()), std::string::npos);
  }
}

TEST_F(StudyLogTest, ATrialThatWasDoneIsNotDoneAgain)
{
  const auto session = this->Session("work");
  StudyLog log(this->Settings("A", 1), *session);
  ASSERT_TRUE(log.Finish());
  EXPECT_THROW(StudyLog(this->Settings("A", 1), *session), std::runtime_error);
  EXPECT_NO_THROW(StudyLog(this->Settings("A", 2), *session));
}

TEST_F(StudyLogTest, APlanThatCannotBeSavedIsSaidAndSavedLater)
{
  const auto session = this->Session("work");
  StudyLog log(this->Settings("A", 1), *session);
  QSignalSpy failed(&log, &StudyLog::Failed);
  const fs::path obstacle = this->folder / "study/A-1.hasp";
  std::ofstream(obstacle) << "a file";
  EXPECT_FALSE(log.Finish());
  ASSERT_EQ(failed.size(), 1);
  EXPECT_EQ(failed[0][0].toString().toStdString().find("Mustermann"), std::string::npos);
  EXPECT_FALSE(fs::exists(this->folder / "study/.A-1.part")) << "nothing half-written stays";
  fs::remove(obstacle);
  EXPECT_TRUE(log.Finish());
  EXPECT_EQ(LoadPlan(obstacle), session->Document());
}

TEST_F(StudyLogTest, EachActionIsALineAtOnce)
{
  const auto session = this->Session("work");
  StudyLog log(this->Settings("A", 3), *session);
  log.StepChanged("reduce");
  log.ToolTaken("grab");
  session->Do(JawTo(1.0), "Erika's jaw");
  session->Undo();
  session->Redo();
  session->Undo();
  session->Do(JawTo(2.0));
  session->KeepMade(
    { 3, PartFormat::Stl, PartInputs(session->Now(), 3), session->StoreBlob("a mesh"), "" });
  log.StepChanged("export");
  log.StepChanged("export");
  session->BeginNew();
  const std::vector<json> lines = this->Lines("A-3.jsonl"); // while the program runs
  EXPECT_EQ(this->Whats(lines), "begin step tool action undo redo undo action part left step plan");
  EXPECT_EQ(lines[0]["trial"], 3);
  EXPECT_EQ(lines[3]["label"], "Move fragment 3");
  EXPECT_EQ(lines[8]["id"], 3);
  double last = 0.0;
  for (const json& line : lines)
  {
    EXPECT_GE(line["t"].get<double>(), last);
    last = line["t"];
  }
}

TEST_F(StudyLogTest, NoWordOfTheUsersIsKeptBesideThePlan)
{
  const auto session = this->Session("work");
  StudyLog log(this->Settings("A", 1), *session);
  session->Do({ RenameObject{ 3, "Erika's chin" }, SetCaseLabel{ "Erika" } }, "Erika's label");
  ASSERT_TRUE(log.KeepSus({ 3, 3, 3, 3, 3, 3, 3, 3, 3, 3 }));
  ASSERT_TRUE(log.Finish());
  for (const char* name : { "study/A-1.jsonl", "study/A-1.csv" })
  {
    const std::string bytes = ReadBytes(this->Path(name));
    EXPECT_FALSE(bytes.empty()) << name;
    EXPECT_EQ(bytes.find("Erika"), std::string::npos) << bytes;
  }
}

TEST_F(StudyLogTest, ALogIsGoneOnWithAfterACrash)
{
  const auto session = this->Session("work");
  {
    StudyLog log(this->Settings("A", 1), *session);
    log.StepChanged("cut");
  }
  std::ofstream(this->folder / "study/A-1.jsonl", std::ios::app) << "{\"t\":1.0,\"wh";
  StudyLog log(this->Settings("A", 1), *session);
  log.StepChanged("cut");
  ASSERT_TRUE(log.Finish());
  const std::string table = ReadBytes(this->Path("study/A-1.csv"));
  EXPECT_EQ(table.find("step,visits,active_s,wall_s\ncut,2,"), 0U) << table;
  std::ifstream file(this->folder / "study/A-1.jsonl");
  std::vector<std::string> broken;
  std::string whats;
  for (std::string line; std::getline(file, line);)
    if (const json parsed = json::parse(line, nullptr, false); parsed.is_object())
      whats += parsed["what"].get<std::string>() + " ";
    else
      broken.push_back(line);
  EXPECT_EQ(whats, "begin step left begin step left finish ");
  EXPECT_EQ(broken, std::vector<std::string>{ "{\"t\":1.0,\"wh" });
}

TEST_F(StudyLogTest, TrialsAreWhatEvaluateReads)
{
  for (const auto& [who, x] : { std::pair("A", 1.0), { "B", 4.0 } })
    for (const int trial : { 1, 2 })
    {
      const auto session = this->Session(std::string("work") + who + std::to_string(trial));
      StudyLog log(this->Settings(who, trial), *session);
      log.StepChanged("reduce");
      session->Do(JawTo(x + trial));
      ASSERT_TRUE(log.KeepSus({ 4, 2, 4, 2, 4, 2, 4, 2, 4, 2 }));
      ASSERT_TRUE(log.Finish());
    }
  this->WriteJaw();
  const HaspRun run = RunHasp({ "evaluate", this->Path("study"), "--json" });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const json found = json::parse(run.out);
  EXPECT_TRUE(found.at("missing").empty());
  const json& overall = found.at("overall");
  EXPECT_EQ(overall.at("intra_operator").at("pairs"), 2);
  EXPECT_NEAR(overall.at("intra_operator").at("tre_mm").at("mean"), 1.0, 1e-9);
  EXPECT_EQ(overall.at("inter_operator").at("pairs"), 4); // 3, 4, 2 and 3 mm apart
  EXPECT_NEAR(overall.at("inter_operator").at("tre_mm").at("mean"), 3.0, 1e-9);
}

TEST(StepTimes, PausesCountNoMoreThanTheyMay)
{
  StepTimes times(10.0);
  times.Alive(1.0); // of no step
  times.Enter("cut", 2.0);
  times.Alive(5.0);   // 3
  times.Alive(105.0); // 10 of 100
  times.Alive(104.0); // a clock that goes back
  times.Enter("guide", 107.0);
  times.Enter("cut", 108.0);
  times.Enter("", 109.0);
  times.Alive(500.0);
  const std::vector<StepTime> expected{ { "cut", 2, 3.0 + 10.0 + 2.0 + 1.0, 105.0 + 1.0 },
    { "guide", 1, 1.0, 1.0 } };
  EXPECT_EQ(times.Left(), expected);
}

} // namespace
