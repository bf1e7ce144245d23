// The report and a study's trial, as the program writes them for a user.
#include "../../CommandLine/Testing/HaspProcess.h"
#include "PlannerDesk.h"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace
{

using Json = nlohmann::json;
namespace fs = std::filesystem;

/// A coarse phantom, and a plan of it: the jaw 2, named "tumour", and a cut 3 through it.
class PlannerDocuments : public PlannerDesk
{
protected:
  void SetUp() override
  {
    PlannerDesk::SetUp();
    if (this->IsSkipped())
      return;
    OutputOfHasp(
      { "phantom", "--spacing", "3,3,3", "--quiet", "--output", this->Path("head.mha") });
    const Json passport = Json::parse(OutputOfHasp({ "info", this->Path("head.mha"), "--json" }));
    std::ofstream(this->Path("edits.json")) << Edits(passport.at("passport").at("hash")).dump();
    OutputOfHasp({ "plan", this->Path("jaw.hasp"), "--new" });
    OutputOfHasp({ "plan", this->Path("jaw.hasp"), "--apply", this->Path("edits.json") });
  }
  static Json Edits(const std::string& hash)
  {
    const Json pose{ { "position", { 0, 0, 0 } }, { "orientation", { 1, 0, 0, 0 } } };
    const Json bone{ { "volume", 1 }, { "isovalue", 226 }, { "seed", { -20, -67, -96 } },
      { "spacingMm", 1.5 } };
    const Json jaw{ { "id", 2 }, { "name", "tumour" }, { "source", bone }, { "colour", "#e3dac9" },
      { "state", "kept" }, { "locked", false }, { "scanToPlanned", pose } };
    const Json blade{ { "point", { 0, -80, -96 } }, { "normal", { 1, 0, 0 } },
      { "along", { 0, 0, 1 } }, { "widthMm", 60 }, { "depthMm", 60 }, { "kerfMm", 1 } };
    const Json cut{ { "id", 3 }, { "name", "" }, { "fragments", { 2 } }, { "reachMm", 8 },
      { "blade", blade } };
    const Json scan{ { "id", 1 }, { "name", "" }, { "hash", hash } };
    return { { "format", "hasp-edits-2" },
      { "edits",
        { { { "add", "volume" }, { "object", scan } }, { { "add", "fragment" }, { "object", jaw } },
          { { "add", "cut" }, { "object", cut } } } } };
  }
  std::string Path(const std::string& name) const { return (this->folder / name).string(); }
  std::unique_ptr<PlannerProcess> OpenPlan(std::vector<std::string> words = {})
  {
    words.insert(words.begin(), { this->Path("jaw.hasp"), this->Path("head.mha") });
    return this->Open(std::move(words));
  }
};

TEST_F(PlannerDocuments, AReportThatCannotBeWrittenIsSaidAndNoPathIs)
{
  const auto planner = this->OpenPlan();
  planner->Click("step.export");
  planner->Click("export.report");
  planner->AnswerFile(this->Path("jaw.hasp/plan.json/report.html")); // within a file
  const std::string message = planner->State("message");
  EXPECT_NE(message.find("The report is not written"), std::string::npos) << message;
  EXPECT_EQ(message.find(Canary), std::string::npos) << message;
}

TEST_F(PlannerDocuments, ReportsOfOnePlanAreTheSameAndNameNoFolder)
{
  const auto planner = this->OpenPlan();
  planner->Click("step.export");
  for (const char* name : { "a.html", "b.html" })
  {
    planner->Click("export.report");
    planner->AnswerFile(this->Path(name));
  }
  for (const char* ending : { ".html", ".pdf" })
  {
    const std::string a = ReadBytes(this->Path(std::string("a") + ending));
    EXPECT_GT(a.size(), 100'000U) << ending << ": it has eight pictures";
    EXPECT_TRUE(a == ReadBytes(this->Path(std::string("b") + ending))) << ending;
    EXPECT_EQ(a.find(Canary), std::string::npos) << ending;
  }
  const std::string page = ReadBytes(this->Path("a.html"));
  EXPECT_EQ(page.find("Pictures lack"), std::string::npos);
  EXPECT_NE(page.find("bone of volume 1"), std::string::npos);
  EXPECT_EQ(page.find("tumour"), std::string::npos) << "a name, which nobody has asked for";
  planner->CloseWindow();
  EXPECT_EQ(planner->ExitCode(), 0);
  EXPECT_EQ(planner->Output(), "");
}

TEST_F(PlannerDocuments, ATrialIsKeptWithItsForm)
{
  const auto planner =
    this->OpenPlan({ "--study", this->Path("study"), "--operator", "A", "--trial", "3" });
  planner->Click("step.cut");
  planner->Key("ctrl+z");
  planner->Key("ctrl+y");
  planner->CloseWindow();
  for (int statement = 1; statement <= 10; ++statement)
    planner->Click("sus." + std::to_string(statement) + (statement % 2 == 1 ? ".5" : ".1"));
  EXPECT_EQ(planner->ClickToEnd("sus.save"), 0);
  std::istringstream log(ReadBytes(this->Path("study/A-3.jsonl")));
  std::vector<std::string> whats;
  double score = -1.0;
  for (std::string line; std::getline(log, line);)
  {
    const Json json = Json::parse(line);
    whats.push_back(json.at("what"));
    score = json.value("score", score);
  }
  for (const char* what : { "begin", "step", "undo", "redo", "sus", "finish" })
    EXPECT_EQ(std::count(whats.begin(), whats.end(), what), what == std::string("step") ? 2 : 1)
      << what;
  EXPECT_EQ(score, 100.0);
  EXPECT_TRUE(fs::exists(this->Path("study/A-3.hasp/plan.json")));
  EXPECT_NE(ReadBytes(this->Path("study/A-3.csv")).find("\ncut,1,"), std::string::npos);
}

} // namespace
