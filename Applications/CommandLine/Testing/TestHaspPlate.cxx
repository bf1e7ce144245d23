#include "PartFixture.h"

#include "Grid/Phantom.h"

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

namespace
{

using nlohmann::json;

class HaspPlate : public PartTest
{
protected:
  HaspPlate() : PartTest("plate", "plate") {}
  /// Over the phantom's left frontal bone.
  static json Recipe()
  {
    const hasp::PhantomSettings settings;
    json landmarks = json::array();
    for (const double left : { 0.25, 0.40, 0.55 })
    {
      const glm::dvec3 p = hasp::PhantomOuterTable(settings, glm::dvec3(left, -1.0, 0.6));
      landmarks.push_back({ p.x, p.y, p.z });
    }
    const json screw{ { "point", landmarks[1] }, { "diameterMm", 2.4 }, { "headDiameterMm", 4 },
      { "headDepthMm", 0.3 }, { "headAngleDeg", 90 }, { "lengthMm", 5 } };
    return { { "format", "hasp-plate-recipe-1" }, { "isovalue", 226 }, { "ignoreBelowMm3", 100 },
      { "landmarks", landmarks }, { "gapMm", 0.3 }, { "thicknessMm", 2.5 }, { "widthMm", 7 },
      { "bevelMm", 0.75 }, { "bridgeMm", 0 }, { "edgeDistanceMm", 1 }, { "holeDistanceMm", 1 },
      { "spacingMm", 0.7 }, { "screws", { screw } }, { "fragments", json::array() } };
  }
};

TEST_F(HaspPlate, BadRecipesAreTwoAndLeaveNothing)
{
  this->FinePhantom();
  ExpectFailure(RunHasp({ "plate", this->Path("head.mha"), "--recipe", this->Path("no.json"),
                  "--output", this->Path("plate.stl") }),
    2, "the .json file: no such file");
  json recipe = Recipe();
  recipe["widthMm"] = -7;
  ExpectFailure(this->Make(recipe), 2, "widthMm is -7");
  recipe = Recipe();
  recipe["landmarks"][0] = { 0, 0, 0 };
  ExpectFailure(this->Make(recipe), 2, "landmarks[0] is");
  recipe = Recipe();
  for (json& place : recipe["landmarks"])
    place = { -place[0].get<double>() + 500.0, place[1], place[2] };
  ExpectFailure(this->Make(recipe), 2, "is outside the volume");
  recipe = Recipe();
  recipe["edgeDistanceMm"] = 2;
  ExpectFailure(this->Make(recipe), 2, "mm from the plate's edge, must be 2");
  ExpectFailure(this->Make(Recipe(), { "--labels", this->Path("no.mha") }), 2, "no such file");
  EXPECT_EQ(this->Names(), (std::vector<std::string>{ "head.mha", "plate.json" }));
}

TEST_F(HaspPlate, WritesAPlateAndSaysWhereItsScrewsAre)
{
  this->FinePhantom();
  const HaspRun run = this->Make(Recipe(), { "--json" });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const json document = json::parse(run.out);
  ASSERT_EQ(document.at("screws").size(), 1U);
  const json recipe = Recipe();
  for (int a = 0; a < 3; ++a)
    EXPECT_NEAR(document.at("screws")[0].at("outer_mm")[a].get<double>(),
      recipe["landmarks"][1][a].get<double>(), 4.0);
  EXPECT_GT(ReadBytes(this->Path("plate.stl")).size(), 84U + 50U * 1000U);
  const std::string first = ReadBytes(this->Path("plate.stl"));
  ASSERT_EQ(this->Make(Recipe()).exitCode, 0);
  EXPECT_EQ(ReadBytes(this->Path("plate.stl")), first);
}

TEST_F(HaspPlate, WarningsOfLabelsAreSaid)
{
  this->FinePhantom();
  this->WriteText(
    "labels.mha", "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementSpacing = 1 1 1\n"
                  "ElementType = MET_UCHAR\nElementDataFile = LOCAL\n" +
                    std::string(8, '\1'));
  const HaspRun run = this->Make(Recipe(), { "--labels", this->Path("labels.mha") });
  EXPECT_NE(run.err.find("hasp: warning: The file says no position"), std::string::npos) << run.err;
}

TEST_F(HaspPlate, AMovedFragmentsPlateIsNotHeldToTheScan)
{
  this->FinePhantom();
  json recipe = Recipe();
  recipe["fragments"] = { { { "label", 1 }, { "position", { 0, 0, 0 } },
    { "orientation", { 1, 0, 0, 0 } } } };
  ExpectFailure(this->Make(recipe, { "--check" }), 1, "the recipe moves fragments");
  ASSERT_EQ(this->Make(Recipe()).exitCode, 0);
  this->WriteText("plate.json", recipe.dump());
  ExpectFailure(this->CertifyMade(), 2, "plate claims: the recipe moves fragments");
}

#if HASP_WITH_CGAL
TEST_F(HaspPlate, APlateIsHeldToItsRecipe)
{
  this->FinePhantom();
  const HaspRun made = this->Make(Recipe(), { "--check", "--json" });
  ASSERT_EQ(made.exitCode, 0) << made.err;
  const json certificate = json::parse(made.out).at("certificate");
  EXPECT_EQ(certificate.at("passed"), true);
  EXPECT_EQ(certificate.at("holes").size(), 1U);
  EXPECT_EQ(this->CertifyMade().exitCode, 0);
  ExpectFailure(this->CertifyMade({ "--insertion-axis", "0,0,1" }), 1, "is for guides");
  // Of the same file, what another recipe promises.
  json recipe = Recipe();
  recipe["screws"][0]["diameterMm"] = 2.9;
  this->WriteText("plate.json", recipe.dump());
  const HaspRun held = this->CertifyMade({ "--html", this->Path("a.html"), "--json" });
  ExpectFailure(held, 3, "screws[0] has a diameter of 2.");
  ExpectFailure(held, 3, "must have 2.90 within 0.10");
  // One name everywhere, so that the page shows that very screw red.
  EXPECT_EQ(json::parse(held.out).at("certificate").at("holes")[0].at("name"), "screws[0]");
  const std::string page = ReadBytes(this->Path("a.html"));
  const std::string row = page.substr(std::min(page.find("<tr><td>screws[0]</td>"), page.size()));
  EXPECT_NE(row.substr(0, row.find("</tr>")).find("<td class=\"bad\">"), std::string::npos) << row;
  EXPECT_NE(this->CertifyMade().out.find("\nscrews[0] "), std::string::npos);
}
#endif

TEST_F(HaspPlate, APlateThatDoesNotHoldIsKeptByForceAlone)
{
  this->FinePhantom();
  ExpectFailure(this->Make(Recipe(), { "--force" }), 1, "--force is for parts that --check");
  json recipe = Recipe();
  recipe["gapMm"] = 0; // a scan's surface is not that smooth: it touches bone
  ExpectFailure(this->Make(recipe, { "--check" }), 3, "was not kept");
  EXPECT_EQ(this->Names(), (std::vector<std::string>{ "head.mha", "plate.json" }));
  ASSERT_EQ(this->Make(recipe, { "--check", "--force" }).exitCode, 0);
  EXPECT_NE(
    ReadBytes(this->Path("plate.stl")).substr(0, 80).find("DOES NOT HOLD"), std::string::npos);
}

} // namespace
