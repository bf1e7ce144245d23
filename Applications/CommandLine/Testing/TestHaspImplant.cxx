#include "PartFixture.h"

#include "Grid/Phantom.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace
{

using nlohmann::json;

class HaspImplant : public PartTest
{
protected:
  HaspImplant() : PartTest("implant", "implant") {}
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
};

TEST_F(HaspImplant, BadRecipesAreTwoAndLeaveNothing)
{
  this->FinePhantom();
  ExpectFailure(RunHasp({ "implant", this->Path("head.mha"), "--recipe", this->Path("no.json"),
                  "--output", this->Path("implant.stl") }),
    2, "the .json file: no such file");
  json recipe = Recipe();
  recipe["thicknessMm"] = -4;
  ExpectFailure(this->Make(recipe), 2, "thicknessMm is -4");
  recipe = Recipe();
  recipe["outline"][1] = { 0, 0, 0 };
  ExpectFailure(this->Make(recipe), 2, "outline[1] (");
  recipe = Recipe();
  recipe["mirror"] = { { "point", { 300, 0, 0 } }, { "normal", { 1, 0, 0 } } };
  ExpectFailure(this->Make(recipe), 2, "no mirrored bone");
  // It claims no gap.
  ExpectFailure(
    this->Make(Recipe(), { "--check", "--least-share", "0.9" }), 1, "no option of implant");
  EXPECT_EQ(this->Names(), (std::vector<std::string>{ "head.mha", "implant.json" }));
}

TEST_F(HaspImplant, WritesAnImplantAndSaysWhatWasFound)
{
  this->FinePhantom();
  const HaspRun run = this->Make(Recipe(), { "--json" });
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
  ASSERT_EQ(this->Make(Recipe()).exitCode, 0);
  EXPECT_EQ(ReadBytes(this->Path("implant.stl")), first);
}

TEST_F(HaspImplant, IsHeldToItsRecipe)
{
  this->FinePhantom();
  json recipe = Recipe();
  recipe["spacingMm"] = 0.6; // contours of coarser grids have burrs in holes: ImplantClaims.h
  const HaspRun made = this->Make(recipe, { "--check", "--html", this->Path("a.html") });
  ASSERT_EQ(made.exitCode, 0) << made.out << made.err;
  EXPECT_NE(made.out.find("the mirrored side was moved"), std::string::npos) << made.out;
  EXPECT_EQ(ReadBytes(this->Path("a.html")).find("no recipe"), std::string::npos);
  EXPECT_EQ(this->CertifyMade().exitCode, 0); // its axis and holes are found again
  ExpectFailure(this->CertifyMade({ "--insertion-axis", "0,0,1" }), 1, "is for guides");
  // Perforated or not, it is as thick as that where it has no holes.
  recipe["thicknessMm"] = 4.6;
  this->WriteText("implant.json", recipe.dump());
  ExpectFailure(this->CertifyMade(), 3, "a wall away from slots and holes is ");
  recipe["thicknessMm"] = 4;
  recipe["holeDiameterMm"] = 3.4;
  this->WriteText("implant.json", recipe.dump());
  ExpectFailure(this->CertifyMade(), 3, "must have 3.40");
}

} // namespace
