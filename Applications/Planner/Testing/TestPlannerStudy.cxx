// Trials that operators do in the window, as the command line judges them: how far pieces are from
// where they broke, by a truth that is known, and how long each step took.
#include "../../CommandLine/Testing/HaspProcess.h"
#include "PlannerDesk.h"

#include <array>
#include <chrono>
#include <cmath>
#include <sstream>

namespace
{

using Json = nlohmann::json;
using Vector = std::array<double, 3>;
namespace fs = std::filesystem;

/// A coarse jaw in three, whose pieces were moved by 3 mm and not turned: the cranium 3, which is
/// locked, the chin 4, which is where it was, and the pieces 5 and 6.
class PlannerStudy : public PlannerDesk
{
protected:
  void SetUp() override
  {
    PlannerDesk::SetUp();
    if (this->IsSkipped())
      return;
    OutputOfHasp({ "fracture", "--fragments", "3", "--shift", "3", "--turn", "0", "--fine", "1.5",
      "--quiet", "--output", this->Path("case") });
    OutputOfHasp({ "plan", this->Path("jaw.hasp"), "--new" });
    OutputOfHasp(
      { "plan", this->Path("jaw.hasp"), "--fragments", this->Path("case/fractured_labels.mha"),
        "--volume", this->Scan(), "--label", "2", "3", "4", "5", "--lock", "2" });
    fs::create_directories(this->Path("trials/jaw"));
    fs::copy(this->Path("case/truth.json"), this->Path("trials/jaw/truth.json"));
    const Json truth = Json::parse(ReadBytes(this->Path("case/truth.json")));
    for (const Json& fragment : truth.at("fragments"))
    {
      const Json& back = fragment.at("reduction_4x4_truth");
      this->Back[fragment.at("label").get<int>() + 1] = { back[0][3], back[1][3], back[2][3] };
    }
    ASSERT_EQ(this->Back.size(), 2U);
  }
  std::string Path(const std::string& name) const { return (this->folder / name).string(); }
  std::string Scan() const { return this->Path("case/fractured_ct.mha"); }

  std::unique_ptr<PlannerProcess> Begin(const std::string& who, const std::string& trial)
  {
    auto planner = this->Open({ this->Path("jaw.hasp"), this->Scan(), "--study",
      this->Path("trials/jaw"), "--operator", who, "--trial", trial });
    planner->patienceS = 120.0;
    return planner;
  }
  /// Along an axis of LPS, by the pad; to the hundredth of a millimetre, as its field has it.
  static double Nudge(PlannerProcess& planner, int axis, double mm)
  {
    constexpr const char* Ways[3][2] = { { "left", "right" }, { "posterior", "anterior" },
      { "superior", "inferior" } };
    const double step = std::round(100.0 * std::abs(mm)) / 100.0;
    planner.SetNumber("reduce.move.step", step);
    planner.Click(std::string("reduce.move.") + Ways[axis][mm < 0.0 ? 1 : 0]);
    return std::copysign(step, mm);
  }
  /// The answers of a form, by its buttons.
  static void End(PlannerProcess& planner, const std::array<int, 10>& answers)
  {
    planner.CloseWindow();
    planner.Click("question.save.discard"); // the study keeps the plan
    for (int n = 0; n < 10; ++n)
      planner.Click("sus." + std::to_string(n + 1) + "." + std::to_string(answers[std::size_t(n)]));
    EXPECT_EQ(planner.ClickToEnd("sus.save"), 0);
    EXPECT_EQ(planner.Output(), "");
  }
  Json Evaluate() const
  {
    const HaspRun run =
      RunHasp({ "evaluate", this->Path("trials"), "--volume", this->Scan(), "--json" });
    EXPECT_EQ(run.exitCode, 0) << run.err;
    return Json::parse(run.out);
  }
  /// A line of the trial's log that says that.
  Json InLog(const std::string& trial, const std::string& what) const
  {
    std::istringstream log(ReadBytes(this->Path("trials/jaw/" + trial + ".jsonl")));
    for (std::string line; std::getline(log, line);)
      if (Json json = Json::parse(line); json.at("what") == what)
        return json;
    return {};
  }
  /// Of a step: active_s and wall_s.
  std::array<double, 2> Times(const std::string& trial, const std::string& step) const
  {
    std::istringstream table(ReadBytes(this->Path("trials/jaw/" + trial + ".csv")));
    for (std::string line; std::getline(table, line);)
      if (line.starts_with(step + ",1,"))
      {
        std::array<double, 2> times{};
        char comma = 0;
        std::istringstream(line.substr(step.size() + 3)) >> times[0] >> comma >> times[1];
        return times;
      }
    return { -1.0, -1.0 };
  }

  std::map<int, Vector> Back; ///< of each piece: where it belongs, from where it was scanned
};

double Length(const Vector& v)
{
  return std::hypot(v[0], v[1], v[2]);
}

/// One operator puts a piece back, the other one turns it where it is.
TEST_F(PlannerStudy, WhatOperatorsDoIsWhatIsEvaluated)
{
  using Clock = std::chrono::steady_clock;
  const int piece = 6, other = 5;
  Vector left = this->Back.at(piece);
  {
    const auto planner = this->Begin("A", "1");
    const auto before = Clock::now();
    planner->Click("step.reduce");
    const auto there = Clock::now();
    planner->ClickId("objects", piece);
    for (int axis = 0; axis < 3; ++axis)
      left[std::size_t(axis)] -= Nudge(*planner, axis, left[std::size_t(axis)]);
    const auto leaves = Clock::now();
    planner->Click("step.export");
    const auto after = Clock::now();
    End(*planner, { 4, 2, 5, 1, 3, 3, 4, 2, 5, 2 });
    const auto [active, wall] = this->Times("A-1", "reduce");
    EXPECT_GE(wall, std::chrono::duration<double>(leaves - there).count());
    EXPECT_LE(wall, std::chrono::duration<double>(after - before).count());
    EXPECT_GT(active, 0.0);
    EXPECT_LE(active, wall);
  }
  {
    const auto planner = this->Begin("B", "1");
    planner->Click("step.reduce");
    planner->ClickId("objects", piece);
    planner->SetNumber("reduce.turn.step", 2.0);
    planner->Click("reduce.turn.zplus");
    Nudge(*planner, 0, 5.0);
    planner->Key("ctrl+z"); // no part of what is judged
    End(*planner, { 3, 3, 3, 3, 3, 3, 3, 3, 3, 3 });
  }
  EXPECT_EQ(this->InLog("A-1", "sus").at("score"), 77.5); // 2.5 (3+3+4+4+2+2+3+3+4+3)
  EXPECT_EQ(this->InLog("B-1", "sus").at("score"), 50.0);
  EXPECT_LT(Length(left), 0.01);

  const Json found = this->Evaluate();
  EXPECT_TRUE(found.at("missing").empty()) << found.at("missing");
  const Json& accuracy = found.at("overall").at("accuracy");
  EXPECT_EQ(accuracy.at("pairs"), 6); // three pieces that may move, two trials
  EXPECT_NEAR(accuracy.at("rotation_deg").at("max"), 2.0, 1e-6);
  EXPECT_NEAR(accuracy.at("rotation_deg").at("mean"), 2.0 / 6.0, 1e-6);
  const Json& between = found.at("overall").at("inter_operator");
  EXPECT_EQ(between.at("pairs"), 3);
  EXPECT_NEAR(between.at("rotation_deg").at("max"), 2.0, 1e-6);
  // Without the turn, to the last digit of what was typed: the piece that A put back, and the one
  // that nobody touched.
  fs::remove_all(this->Path("trials/jaw/B-1.hasp"));
  const Json ofA = this->Evaluate().at("overall").at("accuracy").at("tre_mm");
  const double untouched = Length(this->Back.at(other));
  EXPECT_NEAR(untouched, 3.0, 1e-9);
  EXPECT_NEAR(ofA.at("max"), untouched, 1e-6);
  EXPECT_NEAR(ofA.at("mean"), (untouched + Length(left)) / 3.0, 1e-6); // the chin stayed
}

} // namespace
