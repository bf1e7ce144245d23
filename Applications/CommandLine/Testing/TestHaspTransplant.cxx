#include "HaspProcess.h"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace
{

using nlohmann::json;

class HaspTransplant : public HaspTest
{
protected:
  /// The demo's, for a leg that is a scan of its own, and coarser.
  static json Recipe()
  {
    json recipe = json::parse(ReadBytes(HASP_TRANSPLANT_RECIPE));
    for (json& tip : recipe["donor"]["axis"])
      tip[0] = 0;
    for (json& place : recipe["donor"]["vessel"])
      place[0] = place[0].get<double>() - 150.0;
    recipe["donor"].erase("paddle");
    recipe["resection"]["spacingMm"] = 1.2;
    recipe["guide"]["spacingMm"] = 0.7;
    return recipe;
  }
  void Scans()
  {
    ASSERT_EQ(RunHasp({ "phantom", "--spacing", "1.2,1.2,1.2", "--output", this->Path("head.mha") })
                .exitCode,
      0);
    ASSERT_EQ(RunHasp({ "phantom", "--anatomy", "fibula", "--spacing", "1,1,2", "--output",
                        this->Path("leg.mha") })
                .exitCode,
      0);
  }
  HaspRun Transplant(const json& recipe, const std::vector<std::string>& more = {})
  {
    this->WriteText("recipe.json", recipe.dump());
    std::vector<std::string> words{ "transplant", this->Path("head.mha"), "--donor",
      this->Path("leg.mha"), "--recipe", this->Path("recipe.json"), "--output", this->Path("set") };
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  }
};

TEST_F(HaspTransplant, BadInputIsTwoAndLeavesNothing)
{
  this->Scans();
  ExpectFailure(
    this->Transplant(Recipe(), { "--labels", this->Path("no.mha") }), 2, "no such file");
  json recipe = Recipe();
  recipe["secret"] = 1;
  ExpectFailure(this->Transplant(recipe), 2, "is unknown");
  recipe = Recipe();
  recipe["donor"]["radiusMm"] = -1;
  ExpectFailure(this->Transplant(recipe), 2, "donor.radiusMm is -1");
  recipe = Recipe();
  recipe["leastSegmentMm"] = 60;
  ExpectFailure(this->Transplant(recipe), 2, "segments[0]'s length is 25.");
  recipe = Recipe();
  recipe["donor"]["keepMm"] = 150;
  ExpectFailure(this->Transplant(recipe), 2, "mm too short");
  recipe = Recipe();
  recipe["donor"]["betweenMm"] = 0;
  ExpectFailure(this->Transplant(recipe), 2, "raise donor.betweenMm by");
  EXPECT_EQ(this->Names(), (std::vector<std::string>{ "head.mha", "leg.mha", "recipe.json" }));
  std::filesystem::create_directory(this->Path("set"));
  this->WriteText("set/mine.txt", "mine");
  ExpectFailure(this->Transplant(Recipe()), 1, "folder");
  EXPECT_EQ(ReadBytes(this->Path("set/mine.txt")), "mine");
}

TEST_F(HaspTransplant, WritesSegmentsStumpsMeasuresAndAGuideThatIsCertified)
{
  this->Scans();
  const HaspRun run = this->Transplant(Recipe(), { "--json", "--explain" });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const json document = json::parse(run.out);
  EXPECT_EQ(document.at("warnings"), json::array());
  ASSERT_EQ(document.at("segments").size(), 2U);
  EXPECT_NEAR(document["segments"][1]["length_mm"], 26.1, 0.1); // the chord of 28 mm of arc
  ASSERT_EQ(document.at("joints").size(), 3U);
  for (const json& joint : document.at("joints"))
  {
    EXPECT_LT(joint.at("gap_mm"), 0.1);
    EXPECT_GT(joint.at("contact_mm2"), 60.0);
  }
  EXPECT_EQ(document.at("donor_cuts").size(), 4U);
  EXPECT_EQ(document.at("guide").at("slots"), 4);
  const json measures = json::parse(ReadBytes(this->Path("set/measures.json")));
  EXPECT_EQ(measures.at("segments"), document.at("segments"));
  for (const json& segment : document.at("segments"))
    for (const char* key : { "file", "donor_file" })
      EXPECT_EQ(ReadBytes(this->Path("set/" + segment.at(key).get<std::string>())).size(),
        84U + 50U * segment.at("triangles").get<std::size_t>());
  EXPECT_GE(document.at("fragments").size(), 2U);
  const auto head = [&](const json& name)
  { return ReadBytes(this->Path("set/" + name.get<std::string>())).substr(0, 80); };
  EXPECT_NE(head(document["segments"][1]["donor_file"]).find("PART=segment 2"), std::string::npos);
  EXPECT_NE(head(document["fragments"][0]["file"]).find("PART=fragment 1"), std::string::npos);
  EXPECT_NE(head(document["guide"]["file"]).find("PART=guide"), std::string::npos);
#if HASP_WITH_OPENSSL
  for (const json& file : { document["segments"][0]["file"], document["fragments"][0]["file"],
         document["guide"]["file"] })
    EXPECT_NE(head(file).find("; HASH="), std::string::npos) << file;
#endif
  // What is written is what `hasp certify` takes.
  const HaspRun certify = RunHasp({ "certify", this->Path("set/mitre-guide.stl"), "--bone",
    this->Path("leg.mha"), "--recipe", this->Path("set/mitre-guide.json") });
#if HASP_WITH_CGAL
  EXPECT_EQ(certify.exitCode, 0) << certify.err << certify.out;
#else
  EXPECT_EQ(certify.exitCode, 3); // self-intersections are not checked
#endif
}

TEST_F(HaspTransplant, PrintsATableAndWarnsInWordsAndMakesNoGuideUnasked)
{
  this->Scans();
  json recipe = Recipe();
  recipe["resection"]["resected"] = json::array();
  const HaspRun run = this->Transplant(recipe, { "--no-guide" });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_NE(run.err.find("resection.resected names no fragment"), std::string::npos) << run.err;
  EXPECT_NE(run.out.find("segments[1]   26."), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("joints[2]"), std::string::npos) << run.out;
  EXPECT_FALSE(std::filesystem::exists(this->Path("set/mitre-guide.stl")));
}

} // namespace
