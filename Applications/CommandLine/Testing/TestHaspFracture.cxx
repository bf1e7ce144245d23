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
