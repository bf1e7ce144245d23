#include "HaspProcess.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>

namespace
{

using nlohmann::json;
namespace fs = std::filesystem;

class HaspFracture : public HaspTest
{
protected:
  HaspRun Break(const std::vector<std::string>& more, const std::string& folder = "case") const
  {
    std::vector<std::string> words{ "fracture", "--quiet", "--output", this->Path(folder) };
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  }
};

TEST_F(HaspFracture, WrongUseIsOneAndLeavesNothing)
{
  const std::vector<std::vector<std::string>> wrong{ { "--fragments", "1" }, { "--fragments", "6" },
    { "--fragments", "5" }, { "--shift", "-1" }, { "--turn", "nan" }, { "--chips", "21" },
    { "--phantom", "leg" }, { "--spacing", "0.3,0.3,0.3", "--fine", "2" } };
  for (const std::vector<std::string>& words : wrong)
    EXPECT_EQ(this->Break(words).exitCode, 1) << words[0] << " " << words[1];
  EXPECT_TRUE(this->Names().empty());
  this->WriteText("bad.mha", "no volume");
  EXPECT_EQ(this->Break({ "--volume", this->Path("bad.mha") }).exitCode, 2);
}

TEST_F(HaspFracture, ACaseIsWholeAndItsPlanIsOfItsScan)
{
  ASSERT_EQ(this
              ->Break({ "--fine", "1.2", "--spacing", "1.2,1.2,2", "--fragments", "3", "--shift",
                "4", "--turn", "6", "--eroded", "0.3", "--chips", "1", "--noise", "10" })
              .exitCode,
    0);
  for (const char* name : { "truth.json", "fractured_ct.mha", "fractured_labels.mha",
         "intact_ct.mha", "intact_labels.mha", "plan.hasp" })
    EXPECT_TRUE(fs::exists(this->Path("case") + "/" + name)) << name;
  EXPECT_FALSE(fs::exists(this->Path("case/labels.nrrd")));
  const json truth = json::parse(ReadBytes(this->Path("case/truth.json")));
  EXPECT_EQ(truth.at("format"), "fracture-case/1");
  ASSERT_EQ(truth.at("fragments").size(), 2U);
  EXPECT_EQ(truth.at("fixed_labels"), (json{ 2, 3 }));
  EXPECT_NEAR(truth.at("fragments")[0].at("displacement_rotation_deg").get<double>(), 6.0, 1e-9);
  // Of the fine voxels' centroid; the file has that of the coarse ones.
  EXPECT_NEAR(truth.at("fragments")[0].at("displacement_of_centroid_mm").get<double>(), 4.0, 0.05);
  EXPECT_EQ(truth.at("spacing_mm"), (json{ 1.2, 1.2, 2.0 }));
  const HaspRun info = RunHasp({ "info", this->Path("case/fractured_ct.mha"), "--json" });
  const json plan = json::parse(ReadBytes(this->Path("case/plan.hasp/plan.json"))).at("plan");
  EXPECT_NE(info.out.find(plan.at("volumes")[0].at("hash").get<std::string>()), std::string::npos);
  ASSERT_EQ(plan.at("fragments").size(), 4U);
  EXPECT_TRUE(plan.at("fragments")[0].at("locked").get<bool>());
  EXPECT_FALSE(plan.at("fragments")[3].at("locked").get<bool>());
  EXPECT_EQ(RunHasp({ "plan", this->Path("case/plan.hasp"), "--check" }).exitCode, 0);
  const HaspRun shown = RunHasp({ "plan", this->Path("case/plan.hasp") });
  EXPECT_NE(shown.out.find("fragment 3: label 2 of segmentation 2; locked"), std::string::npos)
    << shown.out;
}

TEST_F(HaspFracture, WhatBreaksLosesNoBone)
{
  // Put back, all pieces are the bone that was whole, to the last voxel; a saw's cut is missed.
  const std::vector<std::string> words{ "--fine", "1.2", "--shift", "0", "--turn", "0" };
  ASSERT_EQ(this->Break(words, "whole").exitCode, 0);
  const std::string labels = ReadBytes(this->Path("whole/intact_labels.mha"));
  EXPECT_EQ(ReadBytes(this->Path("whole/fractured_labels.mha")), labels);
  EXPECT_EQ(
    ReadBytes(this->Path("whole/fractured_ct.mha")), ReadBytes(this->Path("whole/intact_ct.mha")));
  std::vector<std::string> sawn = words;
  sawn.insert(sawn.end(), { "--crack", "1.5" });
  ASSERT_EQ(this->Break(sawn, "sawn").exitCode, 0);
  EXPECT_NE(ReadBytes(this->Path("sawn/fractured_labels.mha")), labels);
  // And moved ones are no smaller: at 226 HU a face of their own lies a little outside of it.
  ASSERT_EQ(this->Break({ "--fine", "0.8", "--shift", "12", "--turn", "10" }, "moved").exitCode, 0);
  const json truth = json::parse(ReadBytes(this->Path("moved/truth.json")));
  EXPECT_EQ(truth.at("damage").at("crack_mm"), 0.0);
  for (const json& piece : truth.at("fragments"))
    EXPECT_GE(piece.at("voxels_fractured"), piece.at("voxels_anatomical"));
}

TEST_F(HaspFracture, AScanBreaksTheSameForTheSameSeed)
{
  ASSERT_EQ(RunHasp({ "phantom", "--quiet", "--spacing", "2.5,2.5,2.5", "--output",
                      this->Path("head.mha") })
              .exitCode,
    0);
  const std::vector<std::string> words{ "--volume", this->Path("head.mha"), "--fragments", "3" };
  ASSERT_EQ(this->Break(words, "a").exitCode, 0);
  ASSERT_EQ(this->Break(words, "b").exitCode, 0);
  for (const char* name : { "/truth.json", "/fractured_ct.mha", "/fractured_labels.mha" })
    EXPECT_EQ(ReadBytes(this->Path("a") + name), ReadBytes(this->Path("b") + name)) << name;
}

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

// The way of a planner: strokes, fragments, a plan, the fit, and how far it is from the truth.
TEST_F(HaspFracture, StrokesLeadToFragmentsOfAPlanAndToTheReduction)
{
  ASSERT_EQ(this
              ->Break({ "--fine", "0.8", "--fragments", "2", "--shift", "5", "--turn", "5",
                "--crack", "1", "--strokes", "8" })
              .exitCode,
    0);
  const std::string scan = this->Path("case/fractured_ct.mha"),
                    labels = this->Path("fragments.seg.nrrd"),
                    plan = this->Path("trials/case/hasp-1.hasp");
  fs::create_directories(this->Path("trials/case"));
  fs::copy_file(this->Path("case/truth.json"), this->Path("trials/case/truth.json"));
  ASSERT_EQ(RunHasp({ "segment", scan, "--threshold", "226", "--seeds",
                      this->Path("case/strokes.json"), "--output", labels })
              .exitCode,
    0);
  EXPECT_EQ(
    RunHasp({ "compare", labels, this->Path("case/fractured_labels.mha"), "--least-dice", "0.95" })
      .exitCode,
    0);
  ASSERT_EQ(RunHasp({ "plan", plan, "--new" }).exitCode, 0);
  const HaspRun made = RunHasp({ "plan", plan, "--fragments", labels, "--volume", scan, "--label",
    "2", "3", "4", "--lock", "2", "3" });
  ASSERT_EQ(made.exitCode, 0) << made.err;
  EXPECT_NE(made.out.find("label 4 of segmentation 2"), std::string::npos) << made.out;
  const HaspRun reduced = RunHasp({ "reduce", plan, "--volume", scan, "--snap", "--obstacle", "3",
    "--starts", "8", "--start-mm", "6" });
  ASSERT_EQ(reduced.exitCode, 0) << reduced.err;
  const HaspRun judged = RunHasp({ "evaluate", this->Path("trials"), "--volume", scan, "--json" });
  ASSERT_EQ(judged.exitCode, 0) << judged.err;
  // The cut's millimetre closes, which the truth leaves open; half of one besides. It began 5 mm
  // off.
  const json tre = json::parse(judged.out).at("overall").at("accuracy").at("tre_mm");
  EXPECT_LT(tre.at("max").get<double>(), 1.5);
  EXPECT_GT(tre.at("max").get<double>(), 0.0);
}

TEST_F(HaspFracture, LabelsThatArePutIntoAPlanAreOfItsScan)
{
  ASSERT_EQ(this->Break({ "--fine", "1.2" }).exitCode, 0);
  const std::string scan = this->Path("case/fractured_ct.mha"),
                    labels = this->Path("case/fractured_labels.mha"), plan = this->Path("a.hasp");
  ASSERT_EQ(RunHasp({ "plan", plan, "--new" }).exitCode, 0);
  const auto add = [&](const std::vector<std::string>& words)
  {
    std::vector<std::string> all{ "plan", plan, "--fragments" };
    all.insert(all.end(), words.begin(), words.end());
    return RunHasp(all);
  };
  EXPECT_EQ(add({ labels }).exitCode, 1) << "of which scan?";
  EXPECT_EQ(add({ scan, "--volume", scan }).exitCode, 2) << "no labels";
  EXPECT_EQ(add({ labels, "--volume", scan, "--label", "77" }).exitCode, 2);
  EXPECT_EQ(add({ labels, "--volume", scan, "--label", "2", "--lock", "3" }).exitCode, 2);
  ASSERT_EQ(
    RunHasp({ "phantom", "--spacing", "3,3,3", "--output", this->Path("other.mha") }).exitCode, 0);
  EXPECT_EQ(add({ labels, "--volume", this->Path("other.mha") }).exitCode, 2) << "another grid";
  EXPECT_EQ(RunHasp({ "plan", plan, "--undo" }).exitCode, 1) << "nothing was kept of all that";
  ASSERT_EQ(add({ labels, "--volume", scan, "--lock", "2" }).exitCode, 0);
  EXPECT_EQ(add({ labels, "--volume", scan, "--label", "3" }).exitCode, 2) << "it is there";
  const json now = json::parse(ReadBytes(plan + "/plan.json")).at("plan");
  EXPECT_EQ(now.at("volumes").size(), 1U);
  EXPECT_EQ(now.at("segmentations").size(), 1U);
  EXPECT_TRUE(now.at("fragments")[0].at("locked").get<bool>());
  ASSERT_EQ(RunHasp({ "plan", plan, "--undo" }).exitCode, 0);
  EXPECT_TRUE(json::parse(ReadBytes(plan + "/plan.json")).at("plan").at("fragments").empty());
}

} // namespace
