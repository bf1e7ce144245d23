#include "HaspProcess.h"

#include "Grid/AnalyticShapes.h"
#include "Grid/Phantom.h"

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <sched.h>

#include <filesystem>

namespace
{

using nlohmann::json;

class HaspCut : public HaspTest
{
protected:
  /// Through the shaft of the phantom's fibula, 346 mm along z.
  static json Recipe()
  {
    const json cut{ { "point", { 0, -5, 20 } }, { "normal", { 0, 0, 1 } }, { "along", { 1, 0, 0 } },
      { "widthMm", 40 }, { "depthMm", 40 }, { "kerfMm", 1.5 }, { "reachMm", 8 } };
    return { { "format", "hasp-cut-recipe-1" }, { "isovalue", 226 }, { "spacingMm", 1.2 },
      { "ignoreBelowMm3", 100 }, { "crumbBelowMm3", 20 }, { "cuts", { cut } },
      { "resected", json::array({ json::array({ 0, -5, -100 }) }) } };
  }
  void Fibula()
  {
    ASSERT_EQ(RunHasp({ "phantom", "--anatomy", "fibula", "--spacing", "1,1,2", "--output",
                        this->Path("leg.mha") })
                .exitCode,
      0);
  }
  HaspRun Cut(const json& recipe, const std::vector<std::string>& more = {})
  {
    this->WriteText("cuts.json", recipe.dump());
    std::vector<std::string> words{ "cut", this->Path("leg.mha"), "--cuts", this->Path("cuts.json"),
      "--output", this->Path("parts") };
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  }
};

TEST_F(HaspCut, BadRecipesAreTwoAndLeaveNothing)
{
  this->Fibula();
  ExpectFailure(RunHasp({ "cut", this->Path("leg.mha"), "--cuts", this->Path("no.json"), "--output",
                  this->Path("parts") }),
    2, "the .json file: no such file");
  json recipe = Recipe();
  recipe["cuts"][0]["kerfMm"] = 9;
  ExpectFailure(this->Cut(recipe), 2, "kerfMm");
  recipe = Recipe();
  recipe["secret"] = 1;
  ExpectFailure(this->Cut(recipe), 2, "is unknown");
  recipe = Recipe();
  recipe["cuts"][0]["point"] = { 200, 200, 20 };
  ExpectFailure(this->Cut(recipe), 2, "cuts[0] does not meet bone");
  ExpectFailure(this->Cut(Recipe(), { "--labels", this->Path("no.mha") }), 2, "no such file");
  EXPECT_EQ(this->Names(), (std::vector<std::string>{ "cuts.json", "leg.mha" }));
  std::filesystem::create_directory(this->Path("parts"));
  this->WriteText("parts/mine.txt", "mine");
  ExpectFailure(this->Cut(Recipe()), 1, "folder");
  EXPECT_EQ(ReadBytes(this->Path("parts/mine.txt")), "mine");
}

TEST_F(HaspCut, WritesFragmentsLabelsAndMeasures)
{
  this->Fibula();
  const HaspRun run = this->Cut(Recipe(), { "--label-image", "--json", "--explain" });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const json document = json::parse(run.out);
  ASSERT_EQ(document.at("fragments").size(), 2U);
  EXPECT_EQ(document.at("cuts").at(0).at("parted"), true);
  EXPECT_LE(document.at("unaccounted_share"), 1e-3);
  EXPECT_EQ(document.at("fragments").at(0).at("resected"), true); // the lower, longer part
  const auto triangles = document.at("fragments").at(1).at("triangles").get<std::size_t>();
  EXPECT_EQ(ReadBytes(this->Path("parts/fragment-2.stl")).size(), 84U + 50U * triangles);
  const json measures = json::parse(ReadBytes(this->Path("parts/measures.json")));
  EXPECT_EQ(measures.at("cuts"), document.at("cuts"));
  EXPECT_EQ(ReadBytes(this->Path("parts/fragments.seg.nrrd")).substr(0, 7), "NRRD000");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(this->Path("parts")), {}), 4);
}

#if HASP_WITH_LIB3MF
TEST_F(HaspCut, WritesKeptFragmentsAsObjectsOfOneFile)
{
  this->Fibula();
  json recipe = Recipe();
  recipe["resected"] = json::array();
  const HaspRun run = this->Cut(recipe, { "--format", "3mf", "--json" });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const json fragments = json::parse(run.out).at("fragments");
  EXPECT_EQ(fragments.at(1).at("file"), "fragment-2.3mf");
  const HaspRun info = RunHasp({ "info", this->Path("parts/fragments.3mf"), "--json" });
  ASSERT_EQ(info.exitCode, 0) << info.err;
  const json passport = json::parse(info.out).at("passport");
  EXPECT_EQ(passport.at("closed"), true);
  ASSERT_EQ(passport.at("objects").size(), 2U);
  for (int n = 0; n < 2; ++n)
  {
    EXPECT_EQ(passport.at("objects")[n].at("name"), "fragment " + std::to_string(n + 1));
    EXPECT_EQ(passport.at("objects")[n].at("triangles"), fragments[n].at("triangles"));
  }
  std::filesystem::remove_all(this->Path("parts"));
  ASSERT_EQ(this->Cut(Recipe(), { "--format", "3mf" }).exitCode, 0); // the longer one is resected
  const HaspRun kept = RunHasp({ "info", this->Path("parts/fragments.3mf"), "--json" });
  const json objects = json::parse(kept.out).at("passport").at("objects");
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_EQ(objects[0].at("name"), "fragment 2");
}
#endif

TEST_F(HaspCut, OneCoreAndAllOfThemWriteTheSameBytes)
{
  this->Fibula();
  ASSERT_EQ(this->Cut(Recipe(), { "--label-image" }).exitCode, 0);
  std::filesystem::rename(this->Path("parts"), this->Path("all"));
  cpu_set_t before, one;
  ASSERT_EQ(sched_getaffinity(0, sizeof before, &before), 0);
  CPU_ZERO(&one);
  for (int cpu = 0; cpu < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++cpu)
    if (CPU_ISSET(cpu, &before))
      CPU_SET(cpu, &one);
  ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0); // processes started now inherit it
  const HaspRun run = this->Cut(Recipe(), { "--label-image" });
  ASSERT_EQ(sched_setaffinity(0, sizeof before, &before), 0);
  ASSERT_EQ(run.exitCode, 0) << run.err;
  for (const auto& file : std::filesystem::directory_iterator(this->Path("all")))
  {
    const std::string name = file.path().filename().string();
    EXPECT_EQ(ReadBytes(file.path().string()), ReadBytes(this->Path("parts/" + name))) << name;
  }
}

TEST_F(HaspCut, SaysThatACutDoesNotPartTheBoneAndMakesNoLabelsUnasked)
{
  this->Fibula();
  json recipe = Recipe();
  recipe["cuts"][0]["widthMm"] = 6; // the shaft is about 15 mm thick
  const HaspRun run = this->Cut(recipe, { "--explain" });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_NE(run.out.find("DOES NOT PART"), std::string::npos) << run.out;
  EXPECT_NE(run.err.find("warning: cuts[0] does not part the bone"), std::string::npos) << run.err;
  EXPECT_NE(run.out.find("label image"), std::string::npos) << run.out;
  EXPECT_FALSE(std::filesystem::exists(this->Path("parts/fragments.seg.nrrd")));
}

} // namespace
