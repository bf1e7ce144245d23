#include "HaspProcess.h"

#include "Grid/Phantom.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace
{

using nlohmann::json;

class HaspImplant : public HaspTest
{
protected:
  /// Around the phantom's hole.
  static json Recipe()
  {
    const hasp::PhantomSettings settings;
    const hasp::PhantomDefect hole = hasp::DefectOf(settings);
    json outline = json::array();
    for (int n = 0; n < 12; ++n)
    {
      const double angle = n * 6.283185307179586 / 12;
      const glm::dvec3 p = hasp::PhantomOuterTable(
        settings, hole.center + (0.6 * hole.lengthMm + 8) * std::cos(angle) * hole.along +
                    (0.6 * hole.widthMm + 8) * std::sin(angle) * hole.across - settings.center);
      outline.push_back({ p.x, p.y, p.z });
    }
    return { { "format", "hasp-implant-recipe-1" }, { "isovalue", 226 }, { "ignoreBelowMm3", 100 },
      { "outline", outline }, { "clearanceMm", 0.5 }, { "thicknessMm", 4 }, { "spacingMm", 1 },
      { "holeDiameterMm", 3 }, { "holePitchMm", 10 }, { "holeEdgeMm", 3 } };
  }
  HaspRun Implant(const json& recipe, const std::vector<std::string>& more = {})
  {
    this->WriteText("implant.json", recipe.dump());
    std::vector<std::string> words{ "implant", this->Path("head.mha"), "--recipe",
      this->Path("implant.json"), "--output", this->Path("implant.stl") };
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  }
  void Head()
  {
    ASSERT_EQ(
      RunHasp({ "phantom", "--spacing", "2,2,2", "--output", this->Path("head.mha") }).exitCode, 0);
  }
};

TEST_F(HaspImplant, BadRecipesAreTwoAndLeaveNothing)
{
  this->Head();
  ExpectFailure(RunHasp({ "implant", this->Path("head.mha"), "--recipe", this->Path("no.json"),
                  "--output", this->Path("implant.stl") }),
    2, "the .json file: no such file");
  json recipe = Recipe();
  recipe["thicknessMm"] = -4;
  ExpectFailure(this->Implant(recipe), 2, "thicknessMm is -4");
  recipe = Recipe();
  recipe["outline"][1] = { 0, 0, 0 };
  ExpectFailure(this->Implant(recipe), 2, "outline[1] (");
  recipe = Recipe();
  recipe["mirror"] = { { "point", { 300, 0, 0 } }, { "normal", { 1, 0, 0 } } };
  ExpectFailure(this->Implant(recipe), 2, "no mirrored bone");
  EXPECT_EQ(this->Names(), (std::vector<std::string>{ "head.mha", "implant.json" }));
}

TEST_F(HaspImplant, WritesAnImplantAndSaysWhatWasFound)
{
  this->Head();
  const HaspRun run = this->Implant(Recipe(), { "--json" });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const json document = json::parse(run.out);
  // Of a phantom, which is symmetric.
  EXPECT_GT(std::abs(document.at("mirror").at("normal")[0].get<double>()), 0.999);
  EXPECT_LT(document.at("rim").at("p95_mm").get<double>(), 0.6);
  const glm::dvec3 outward = hasp::DefectOf({}).outward;
  for (int a = 0; a < 3; ++a)
    EXPECT_NEAR(document.at("axis")[a].get<double>(), outward[a], 0.2);
  EXPECT_GT(document.at("holes_mm").size(), 4U);
  EXPECT_GT(ReadBytes(this->Path("implant.stl")).size(), 84U + 50U * 1000U);
  const std::string first = ReadBytes(this->Path("implant.stl"));
  ASSERT_EQ(this->Implant(Recipe()).exitCode, 0);
  EXPECT_EQ(ReadBytes(this->Path("implant.stl")), first);
}

TEST_F(HaspImplant, IsHeldToItsRecipe)
{
  this->Head();
  json recipe = Recipe();
  recipe["spacingMm"] = 0.6; // contours of coarser grids have burrs in holes: ImplantClaims.h
  const HaspRun made = this->Implant(recipe, { "--check", "--html", this->Path("a.html") });
  ASSERT_EQ(made.exitCode, 0) << made.out << made.err;
  EXPECT_NE(made.out.find("the mirrored side was moved"), std::string::npos) << made.out;
  EXPECT_EQ(ReadBytes(this->Path("a.html")).find("no recipe"), std::string::npos);
  const auto certify = [this](const std::vector<std::string>& more = {})
  {
    std::vector<std::string> words{ "certify", this->Path("implant.stl"), "--bone",
      this->Path("head.mha"), "--recipe", this->Path("implant.json") };
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  };
  EXPECT_EQ(certify().exitCode, 0); // its axis and holes are found again
  ExpectFailure(certify({ "--insertion-axis", "0,0,1" }), 1, "is for guides");
  // Perforated or not, it is as thick as that where it has no holes.
  recipe["thicknessMm"] = 4.6;
  this->WriteText("implant.json", recipe.dump());
  ExpectFailure(certify(), 3, "a wall away from slots and holes is ");
  recipe["thicknessMm"] = 4;
  recipe["holeDiameterMm"] = 3.4;
  this->WriteText("implant.json", recipe.dump());
  ExpectFailure(certify(), 3, "must have 3.40");
}

} // namespace
