// Reductions against each other, against the truth, and against another scan.
#include "EvaluateFixture.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <filesystem>

namespace
{

TEST_F(HaspEvaluate, WrongUseIsOneAndBadInputIsTwo)
{
  this->WriteBox("a.stl", 0);
  this->WriteTrial("a.hasp", 1.0);
  ExpectFailure(this->Evaluate({ "a.stl" }), 1, "one alone is a folder of trials");
  ExpectFailure(this->Evaluate({ "a.hasp" }), 2, "hasp run keeps it");
  ExpectFailure(this->Evaluate({ "a.stl", "none.stl" }), 2, "no such file");
  ExpectFailure(this->Evaluate({ "a.stl", "a.stl" }, { "--reference", "Erika" }), 1, "--reference");
  ExpectFailure(this->Evaluate({ "a.stl" }, { "--scan", this->Path("a.stl") }), 1, "one plan");
  ExpectFailure(this->Evaluate({ "a.hasp", "a.hasp" }), 2, "hasp run keeps it");
  ExpectFailure(this->Evaluate({ "a.hasp", "a.hasp" }, { "--isovalue", "3" }), 1, "--scan");
  this->WriteText("a.json", "{");
  ExpectFailure(this->Evaluate({ "a.json", "a.json" }), 2, "plan.json is damaged");
  std::filesystem::create_directories(this->Path("empty/case"));
  ExpectFailure(this->Evaluate({ "empty" }), 2, "OPERATOR-TRIAL");
}

TEST_F(HaspEvaluate, ASurfaceThatWasMovedIsThatFarAway)
{
  this->WriteBox("a.stl", 0);
  this->WriteBox("b.stl", 2.5);
  const json found = this->Found({ "a.stl", "b.stl" });
  ASSERT_EQ(found.at("fragments").size(), 1U);
  const json& one = found.at("fragments")[0];
  EXPECT_NEAR(one.at("pose").at("translation_mm"), 2.5, 1e-6);
  EXPECT_NEAR(one.at("pose").at("tre_mean_mm"), 2.5, 1e-6);
  EXPECT_NEAR(one.at("pose").at("rotation_deg"), 0.0, 1e-6);
  EXPECT_NEAR(one.at("s2s").at("max_mm"), 2.5, 1e-6);
  EXPECT_LE(one.at("s2s").at("mean_mm"), one.at("s2s").at("p95_mm"));
  EXPECT_GE(one.at("s2s").at("samples"), 20000);
  this->WriteBox("b.stl", 0, 11); // another mesh has no pose of this one
  EXPECT_FALSE(this->Found({ "a.stl", "b.stl" }).at("fragments")[0].contains("pose"));
  EXPECT_NE(this->Evaluate({ "a.stl", "b.stl" }).out.find("no TRE"), std::string::npos);
}

TEST_F(HaspEvaluate, PlansAreHeldToEachOtherBesideTheReference)
{
  this->WriteBox("fragment-3.stl", 40);
  this->WriteTrial("a.hasp", 1.0);
  this->WriteTrial("b.hasp", 3.0);
  const json found = this->Found({ "a.hasp", "b.hasp" }, { "--csv", this->Path("t.csv") });
  ASSERT_EQ(found.at("fragments").size(), 1U); // the locked one is the reference
  EXPECT_NEAR(found.at("fragments")[0].at("pose").at("tre_max_mm"), 2.0, 1e-9);
  EXPECT_EQ(found.at("reference_moved"), false);
  EXPECT_EQ(this->Evaluate({ "a.hasp/", "b.hasp/" }).exitCode, 0); // as shells complete them
  EXPECT_NE(ReadBytes(this->Path("t.csv")).find("\n3,"), std::string::npos);
  this->WriteTrial("c.hasp", 8.0, 7.0); // all of it 7 mm aside
  for (const char* reference : { "skull", "2" })
  {
    const json moved = this->Found({ "a.hasp", "c.hasp" }, { "--reference", reference });
    EXPECT_NEAR(moved.at("fragments")[0].at("pose").at("tre_max_mm"), 0.0, 1e-9);
    EXPECT_EQ(moved.at("reference_moved"), true);
  }
  const HaspRun text = this->Evaluate({ "a.hasp", "c.hasp" });
  EXPECT_EQ(text.out.find("jaw"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("relative to it"), std::string::npos) << text.out;
  EXPECT_NE(
    this->Evaluate({ "a.hasp", "c.hasp" }, { "--show-names" }).out.find("jaw"), std::string::npos);
}

TEST_F(HaspEvaluate, ATurnIsSaidInDegrees)
{
  this->WriteBox("fragment-3.stl", 0);
  this->WritePlan("a.hasp", json::array({ Fragment(3, "jaw", Pose(0)) }));
  this->WritePlan("b.hasp", json::array({ Fragment(3, "jaw", Pose(0, 6.0)) }));
  const json found = this->Found({ "a.hasp", "b.hasp" });
  EXPECT_NEAR(found.at("fragments")[0].at("pose").at("rotation_deg"), 6.0, 1e-9);
}

/// Two boxes of 10 x 20 x 30 mm, face to face at x = 10, and one far off.
TEST_F(HaspEvaluate, AKnownGapAndAKnownStepAreSaidAlongTheFracture)
{
  this->WriteBox("fragment-2.stl", 0);
  this->WriteBox("fragment-3.stl", 10);
  this->WriteBox("fragment-4.stl", 90);
  const auto plan = [this](const std::string& name, const json& pose)
  {
    this->WritePlan(name, { Fragment(2, "skull", Pose(0), true), Fragment(3, "jaw", pose),
                            Fragment(4, "tooth", Pose(0)) });
  };
  plan("gap.hasp", Pose(1.2));
  plan("step.hasp", Pose(0, 0, 0.8));
  const json apart = this->Found({ "gap.hasp" }, { "--csv", this->Path("t.csv") });
  ASSERT_EQ(apart.at("fractures").size(), 1U); // what is far off faces nothing
  const json& gap = apart.at("fractures")[0];
  EXPECT_EQ(gap.at("first"), "fragment 2");
  EXPECT_EQ(gap.at("second"), "fragment 3");
  for (const char* figure : { "p50_mm", "p95_mm", "max_abs_mm" })
  {
    EXPECT_NEAR(gap.at("gap").at(figure), 1.2, 1e-6) << figure;
    EXPECT_NEAR(gap.at("step").at(figure), 0.0, 1e-6) << figure;
  }
  EXPECT_NEAR(gap.at("gap").at("area_mm2"), 600.0, 1e-6);
  const std::string table = ReadBytes(this->Path("t.csv"));
  EXPECT_NE(table.find(",1.2,1.2,1.2,1.2,600\n"), std::string::npos) << table;
  EXPECT_NE(table.find("\n2,3,"), std::string::npos) << table; // names may hold commas
  // Of the face's rim 60 mm of 100 step, by as much up as down.
  const json stepped = this->Found({ "step.hasp", "gap.hasp" });
  EXPECT_EQ(stepped.at("second_along_fractures").at("fractures"), apart.at("fractures"));
  const json& step = stepped.at("first_along_fractures").at("fractures").at(0);
  for (const char* figure : { "p50_abs_mm", "p95_abs_mm", "max_abs_mm" })
    EXPECT_NEAR(step.at("step").at(figure), 0.8, 1e-6) << figure;
  EXPECT_NEAR(step.at("gap").at("max_abs_mm"), 0.0, 1e-6);
  plan("overlap.hasp", Pose(-1.0));
  const json inside = this->Found({ "overlap.hasp" }).at("fractures").at(0).at("gap");
  EXPECT_NEAR(inside.at("p5_mm"), -1.0, 1e-6);
  EXPECT_NEAR(inside.at("max_abs_mm"), 1.0, 1e-6);
  const HaspRun text = this->Evaluate({ "gap.hasp" });
  EXPECT_NE(text.out.find(
              "fragment 2 to fragment 3      0.000   0.000   0.000   1.200   1.200   1.200   1.200"
              "      600.0"),
    std::string::npos)
    << text.out;
  // Without its surface, or an open one, nothing is made up.
  std::filesystem::remove(this->Path("fragment-4.stl"));
  ExpectFailure(this->Evaluate({ "gap.hasp" }), 2, "fragment 4: its surface has not been made");
  this->WriteBox("fragment-4.stl", 90);
  const json near = this->Found({ "gap.hasp" }, { "--reach", "1" });
  EXPECT_TRUE(near.at("fractures").empty()); // 1.2 mm is beyond
  std::string open = ReadBytes(this->Path("fragment-3.stl"));
  open.erase(open.find("facet"), open.find("endfacet\n") + 9 - open.find("facet"));
  this->WriteText("fragment-3.stl", open);
  const json holed = this->Found({ "gap.hasp" });
  EXPECT_TRUE(holed.at("fractures").empty());
  EXPECT_EQ(holed.at("unmeasured"), (json{ "fragment 3: its surface is open" }));
}

/// One jaw, label 9, that came off by 2 mm along x; label 1 stands.
json Truth()
{
  const auto shifted = [](double x) {
    return json{ { 1, 0, 0, x }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 }, { 0, 0, 0, 1 } };
  };
  return { { "format", "fracture-case/1" }, { "case", "Erika" }, { "units", "mm" },
    { "axes", "LPS" }, { "spacing_mm", { 1, 1, 1 } }, { "origin_mm", { 0, 0, 0 } },
    { "dims_xyz", { 50, 50, 50 } }, { "fixed_labels", { 1 } }, { "convention", "as written" },
    { "cuts", json::array() },
    { "fragments", { { { "label", 9 }, { "name", "jaw" }, { "voxels_anatomical", 100 },
                     { "voxels_fractured", 100 }, { "volume_mm3", 100 },
                     { "centroid_anatomical_mm", { 40, 0, 0 } },
                     { "displacement_4x4", shifted(-2) }, { "reduction_4x4_truth", shifted(2) },
                     { "displacement_rotation_deg", 0 }, { "displacement_of_centroid_mm", 2 },
                     { "start_error_mm", { { "mean", 2 }, { "max", 2 } } } } } } };
}

TEST_F(HaspEvaluate, AFolderOfTrialsGivesPrecisionAndAccuracyApart)
{
  std::filesystem::create_directories(this->Path("all/Erika"));
  this->WriteBox("all/Erika/fragment-3.stl", 40);
  this->WriteTrial("all/Erika/Xaver-1.hasp", 1.0);
  this->WriteTrial("all/Erika/Xaver-2.hasp", 3.0);
  this->WriteTrial("all/Erika/Yvonne-1.hasp", 9.0, 1.0); // 8 beside the skull
  this->WriteText("all/Erika/truth.json", Truth().dump());
  const json found = this->Found({ "all" }, { "--csv", this->Path("t.csv") });
  const json& overall = found.at("overall");
  EXPECT_EQ(overall.at("intra_operator").at("pairs"), 1);
  EXPECT_NEAR(overall.at("intra_operator").at("tre_mm").at("mean"), 2.0, 1e-9);
  EXPECT_EQ(overall.at("inter_operator").at("pairs"), 2);
  EXPECT_NEAR(overall.at("inter_operator").at("tre_mm").at("mean"), 6.0, 1e-9);
  EXPECT_EQ(overall.at("accuracy").at("pairs"), 3);
  EXPECT_NEAR(overall.at("accuracy").at("tre_mm").at("mean"), (1 + 1 + 6) / 3.0, 1e-9);
  EXPECT_NEAR(overall.at("accuracy").at("tre_mm").at("max"), 6.0, 1e-9);
  ASSERT_EQ(found.at("missing").size(), 1U);
  EXPECT_EQ(found.at("missing")[0], "case 1: operator 2 trial 2 is not there");
  EXPECT_NE(ReadBytes(this->Path("t.csv")).find("all,accuracy,3"), std::string::npos);
  const HaspRun text = this->Evaluate({ "all" });
  EXPECT_NE(text.out.find("missing: case 1"), std::string::npos) << text.out;
  EXPECT_EQ(text.out.find("Erika"), std::string::npos);
  EXPECT_EQ(text.out.find("Yvonne"), std::string::npos);
  EXPECT_NE(
    this->Evaluate({ "all" }, { "--show-names" }).out.find("Yvonne trial 2"), std::string::npos);
  this->WriteText("all/Erika/truth.json", "{\"format\": \"Erika\"}");
  ExpectFailure(this->Evaluate({ "all" }), 2, "fracture-case/1");
  std::filesystem::rename(this->Path("all/Erika/Xaver-2.hasp"), this->Path("all/Erika/Xaver.hasp"));
  ExpectFailure(this->Evaluate({ "all" }), 2, "OPERATOR-TRIAL");
}

TEST_F(HaspEvaluate, APlanIsHeldToAnotherScanThatTheReferenceLeadsTo)
{
  const auto scan = [this](const std::string& name, const std::string& spacing)
  {
    ASSERT_EQ(RunHasp({ "phantom", "--anatomy", "fibula", "--spacing", spacing, "--output",
                        this->Path(name) })
                .exitCode,
      0);
  };
  scan("leg.mha", "1.2,1.2,2");
  scan("after.mha", "1,1.4,1.5");
  const std::string hash =
    json::parse(RunHasp({ "info", this->Path("leg.mha"), "--json" }).out).at("passport").at("hash");
  const json seed{ 0, -5, 20 };
  this->WritePlan("a.hasp",
    { Fragment(2, "leg", Pose(0), true, seed), Fragment(3, "same", Pose(0), false, seed),
      Fragment(4, "aside", Pose(4), false, seed) },
    hash);
  const std::vector<std::string> more{ "--scan", this->Path("after.mha"), "--volume",
    this->Path("leg.mha") };
  const json found = this->Found({ "a.hasp" }, more);
  EXPECT_EQ(found.at("registration").at("fits"), true);
  EXPECT_LT(found.at("registration").at("median_mm"), 0.2); // a sixth of a voxel
  ASSERT_EQ(found.at("fragments").size(), 2U);
  EXPECT_LT(found.at("fragments")[0].at("to_other_scan").at("mean_mm"), 0.3);
  EXPECT_GT(found.at("fragments")[1].at("to_other_scan").at("mean_mm"), 1.0);
  EXPECT_LE(found.at("fragments")[1].at("to_other_scan").at("max_mm"), 4.5);
  const std::string head = this->Phantom();
  ExpectFailure(this->Evaluate({ "a.hasp" }, { "--scan", head, "--volume", this->Path("leg.mha") }),
    3, "does not fit the reference");
  ExpectFailure(
    this->Evaluate({ "a.hasp" }, { "--scan", head, "--reference", "nobody" }), 1, "--reference");
}

} // namespace
