#include "HaspProcess.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>

namespace
{

using nlohmann::json;
namespace fs = std::filesystem;

class HaspMirror : public HaspTest
{
};

TEST_F(HaspMirror, WrongUseIsOneAndBadInputTwo)
{
  const std::string head = this->Phantom();
  ExpectFailure(RunHasp({ "mirror", head, "--plane", "0,0,0,0,0,0" }), 1, "normal has no length");
  EXPECT_EQ(RunHasp({ "mirror", head, "--plane", "0,0,0" }).exitCode, 1);
  EXPECT_EQ(RunHasp({ "mirror", head, "--output", this->Path("ghost.png") }).exitCode, 1);
  EXPECT_EQ(RunHasp({ "mirror", this->Path("none.mha") }).exitCode, 2);
}

TEST_F(HaspMirror, APlanKeepsTheGhostAndUndoTakesItBack)
{
  ASSERT_EQ(
    RunHasp({ "phantom", "--quiet", "--spacing", "2,2,2", "--output", this->Path("head.mha") })
      .exitCode,
    0);
  const std::string head = this->Path("head.mha"), plan = this->Path("case.hasp");
  const json hash = json::parse(RunHasp({ "info", head, "--json" }).out).at("passport").at("hash");
  ASSERT_EQ(RunHasp({ "plan", plan, "--new" }).exitCode, 0);
  const auto mirror = [&](std::vector<std::string> more)
  {
    more.insert(more.begin(), { "mirror", head, "--spacing", "2", "--quiet" });
    return RunHasp(more);
  };
  const auto mirrors = [&] {
    return json::parse(RunHasp({ "plan", plan, "--json" }).out).at("mirrors");
  };
  ExpectFailure(mirror({ "--plan", plan, "--store" }), 2, "IN is none of the plan's scans");
  this->WriteText("edits.json",
    json{ { "format", "hasp-edits-5" },
      { "edits", { { { "add", "volume" },
                   { "object", { { "id", 1 }, { "name", "" }, { "hash", hash } } } } } } }
      .dump());
  ASSERT_EQ(RunHasp({ "plan", plan, "--apply", this->Path("edits.json") }).exitCode, 0);
  ExpectFailure(mirror({ "--plan", plan }), 1, "--store or --write-edits");
  ExpectFailure(
    mirror({ "--plan", plan + "/plan.json", "--store" }), 1, "plan.json alone is only read");
  EXPECT_EQ(mirror({ "--store" }).exitCode, 1);

  const std::string edits = this->Path("ghost.json");
  const HaspRun only = mirror({ "--plan", plan + "/plan.json", "--write-edits", edits, "--json" });
  ASSERT_EQ(only.exitCode, 0) << only.err;
  EXPECT_TRUE(mirrors().empty());
  ASSERT_EQ(RunHasp({ "plan", plan, "--apply", edits }).exitCode, 0);
  const json applied = mirrors();
  ASSERT_EQ(applied.size(), 1U);
  ASSERT_EQ(RunHasp({ "plan", plan, "--undo" }).exitCode, 0);
  EXPECT_TRUE(mirrors().empty());

  const HaspRun stored = mirror({ "--plan", plan, "--store", "--json" });
  ASSERT_EQ(stored.exitCode, 0) << stored.err;
  const json found = json::parse(stored.out), listed = mirrors();
  EXPECT_LT(found.at("median_mm").get<double>(), 0.5);
  ASSERT_EQ(listed.size(), 1U);
  EXPECT_EQ(listed[0].at("mirror"), found.at("mirror"));
  EXPECT_EQ(listed[0].at("volume"), 1);
  EXPECT_EQ(listed[0].at("plane"), applied[0].at("plane"));
  for (int a = 0; a < 3; ++a)
    EXPECT_EQ(listed[0].at("plane").at("normal")[a], found.at("plane").at("normal")[a]);
  const HaspRun shown = RunHasp({ "plan", plan }); // 2 was given before
  EXPECT_NE(shown.out.find("mirror 3: bone of volume 1, at the plane through"), std::string::npos)
    << shown.out;
  ASSERT_EQ(RunHasp({ "plan", plan, "--undo" }).exitCode, 0);
  EXPECT_TRUE(mirrors().empty());
}

TEST_F(HaspMirror, FindsThePlaneAndWritesTheGhost)
{
  ASSERT_EQ(
    RunHasp({ "phantom", "--quiet", "--spacing", "2,2,2", "--output", this->Path("head.mha") })
      .exitCode,
    0);
  const HaspRun run = RunHasp({ "mirror", this->Path("head.mha"), "--spacing", "2", "--output",
    this->Path("ghost.ply"), "--json" });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const json result = json::parse(run.out);
  const json plane = result.at("plane");
  EXPECT_TRUE(plane.at("found").get<bool>());
  EXPECT_GT(plane.at("normal")[0].get<double>(), std::cos(0.01));
  EXPECT_LT(result.at("median_mm").get<double>(), 0.5);
  EXPECT_GT(result.at("matched_share").get<double>(), 0.9);
  EXPECT_TRUE(fs::exists(this->Path("ghost.ply")));
  const HaspRun info = RunHasp({ "info", this->Path("ghost.ply") });
  EXPECT_NE(info.out.find("hash        "), std::string::npos) << info.out;
}

} // namespace
