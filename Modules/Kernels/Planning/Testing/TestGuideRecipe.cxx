#include "Planning/GuideRecipeFile.h"
#include "Planning/PartRecipeFile.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>

namespace
{

hasp::GuideRecipe Good()
{
  hasp::GuideRecipe r;
  r.note = "täst";
  r.landmarks = { { 1, 2, 3 }, { 0.1, 20, 3 }, { -5, 7, 1.0 / 3.0 } };
  r.outline = hasp::GuideOutline::Closed;
  r.withdrawal = glm::normalize(glm::dvec3(1, 2, 2));
  r.strokes = { { { { 1, 2, 3 }, { 4, 5, 6 } }, 4, false }, { { { 1, 2, 3.5 } }, 2, true } };
  r.axisSearchDeg = 20;
  r.slots = { { { 1, 1, 1 }, { 0, 1, -0.0 }, 1.2, 20 } };
  r.flanges = { { { 1, 1, 2 }, { 1, 0, 0 }, 0.8, 21, 13, 9, 7 } };
  r.holes = { { { 0, 0, 1 }, { 0, 0, 1 }, 2 }, { { 3, 0, 1 }, { 1, 0, 0 }, 2.7, 12, 0 } };
  r.labels = { { "CASE 7", { 1, 1, 1 }, { 0, 1, 0 }, 6, 0.9, true } };
  return r;
}

/// The message a text is refused with; empty if it is not.
std::string Refusal(const std::string& json)
{
  try
  {
    hasp::ParseGuideRecipe(json);
    return {};
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
}

std::string Refusal(const std::function<void(hasp::GuideRecipe&)>& spoil)
{
  auto r = Good();
  spoil(r);
  try
  {
    hasp::ValidateGuideRecipe(r);
    return {};
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
}

std::string Replaced(const std::string& from, const std::string& to)
{
  std::string text = hasp::FormatGuideRecipe(Good());
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

#define EXPECT_NAMES(message, part) EXPECT_NE((message).find(part), std::string::npos) << (message)

TEST(GuideRecipe, SurvivesTheRoundTripBitForBit)
{
  const auto r = Good(), back = hasp::ParseGuideRecipe(hasp::FormatGuideRecipe(r));
  EXPECT_EQ(back, r);
  EXPECT_EQ(hasp::FormatGuideRecipe(back), hasp::FormatGuideRecipe(r));
}

TEST(GuideRecipe, TheFirstFormatIsTheSameGuideAsItWas)
{
  const auto r = hasp::ParseGuideRecipe(R"({ "format": "hasp-guide-recipe-1", "isovalue": 300,
    "landmarks": [[1, 2, 3], [4, 5, 6]], "outline": "open", "withdrawal": [0, 0, 1],
    "gapMm": 0.4, "thicknessMm": 2.5, "widthMm": 12, "spacingMm": 0.5, "ignoreBelowMm3": 50,
    "slots": [{ "point": [1, 1, 1], "normal": [0, 1, 0], "widthMm": 1.2, "lengthMm": 18 }],
    "holes": [{ "point": [3, 0, 1], "axis": [1, 0, 0], "diameterMm": 2.7 }] })");
  hasp::GuideRecipe same;
  same.isovalue = 300;
  same.landmarks = { { 1, 2, 3 }, { 4, 5, 6 } };
  same.gapMm = 0.4;
  same.thicknessMm = 2.5;
  same.widthMm = 12;
  same.edgeRadiusMm = 0;
  same.clearanceMm = 0;
  same.spacingMm = 0.5;
  same.ignoreBelowMm3 = 50;
  same.slots = { { { 1, 1, 1 }, { 0, 1, 0 }, 1.2, 18, 500, 0 } };
  same.holes = { { { 3, 0, 1 }, { 1, 0, 0 }, 2.7, 500, 0 } };
  EXPECT_EQ(r, same);
  EXPECT_EQ(hasp::SlotWidthMm(r, r.slots[0].kerfMm), 1.2);
  EXPECT_EQ(hasp::ParseGuideRecipe(hasp::FormatGuideRecipe(r)), same);
  // Strict, too: what came later is no key of it.
  EXPECT_NAMES(Refusal(Replaced("recipe-2", "recipe-1")), "is unknown");
}

TEST(GuideRecipe, FilesAreStrict)
{
  EXPECT_NAMES(Refusal("{"), "no JSON");
  EXPECT_NAMES(Refusal("[]"), "must be an object");
  EXPECT_NAMES(Refusal("{}"), "format is missing");
  EXPECT_NAMES(Refusal(Replaced("\"gapMm\"", "\"gap\"")),
    "guide recipe: a key is unknown, the nearest known is 'gapMm'");
  EXPECT_NAMES(Refusal(Replaced("\"gapMm\": 0.3,", "")), "gapMm is missing");
  EXPECT_NAMES(Refusal(Replaced("\"gapMm\": 0.3", "\"gapMm\": \"0.3\"")), "gapMm must be a number");
  EXPECT_NAMES(Refusal(Replaced("recipe-2", "recipe-3")),
    "of another version, must be 'hasp-guide-recipe-2' or 'hasp-guide-recipe-1'");
  EXPECT_NAMES(Refusal(Replaced("hasp-guide-recipe-2", "hasp-plate-recipe-1")),
    "the file is a plate recipe, which hasp plate takes; here it must be 'hasp-guide-recipe-2' or");
  EXPECT_NAMES(Refusal(Replaced("\"hasp-guide-recipe-2\"", "2")), "format must be text");
  EXPECT_NAMES(Refusal(Replaced("closed", "round")), "open, closed or filled");
  EXPECT_NAMES(Refusal(Replaced("\"diameterMm\": 2.0", "\"diameter\": 2.0")),
    "a key of holes[0] is unknown, the nearest known is 'diameterMm'");
  EXPECT_NAMES(Refusal(Replaced("\"lengthMm\": 20.0", "\"lengthMm\": -20.0")), "slots[0].lengthMm");
  EXPECT_NAMES(Refusal(Replaced("\"gapMm\": 0.3", "\"gapMm\": NaN")), "no JSON");
  EXPECT_NAMES(Refusal(Replaced("\"gapMm\": 0.3", "\"gapMm\": 1e999")), "no JSON");
}

TEST(GuideRecipe, APartsRecipeIsOfTheKindThatItsFormatSays)
{
  EXPECT_EQ(
    std::get<hasp::GuideRecipe>(hasp::ParsePartRecipe(hasp::FormatGuideRecipe(Good()))), Good());
  const auto refusal = [](const std::string& json)
  {
    try
    {
      hasp::ParsePartRecipe(json);
      return std::string();
    }
    catch (const std::exception& error)
    {
      return std::string(error.what());
    }
  };
  EXPECT_NAMES(refusal(R"({ "format": "hasp-plate-recipe-1", "Erika": 1 })"),
    "plate recipe: a key is unknown");
  EXPECT_NAMES(refusal(R"({ "format": "hasp-implant-recipe-9" })"),
    "implant recipe: format is of another version");
  EXPECT_NAMES(refusal(R"({ "format": "hasp-cut-recipe-1" })"),
    "the file is a cut recipe, which hasp cut --cuts takes; here it must be 'hasp-guide-recipe-2'");
  EXPECT_NAMES(refusal("{}"), "guide recipe: format is missing");
}

TEST(GuideRecipe, ErrorsSayNothingOfTheFilesText)
{
  for (const std::string& bad :
    { std::string("{ \"Erika"), std::string("Erika"), Replaced("\"gapMm\"", "\"Erika\""),
      Replaced("closed", "Erika"), Replaced("hasp-guide-recipe-2", "Erika"),
      Replaced("CASE 7", "Erika"), Replaced("\"gapMm\": 0.3", "\"gapMm\": Erika") })
  {
    EXPECT_NE(Refusal(bad), "");
    EXPECT_EQ(Refusal(bad).find("rika"), std::string::npos) << Refusal(bad);
  }
}

TEST(GuideRecipe, RangesAreNamed)
{
  using R = hasp::GuideRecipe;
  const double nan = std::nan("");
  EXPECT_EQ(Refusal([](R&) {}), "");
  EXPECT_NAMES(Refusal([=](R& r) { r.gapMm = nan; }), "gapMm is nan, must be in [0, 10]");
  EXPECT_EQ(Refusal([](R& r) { r.gapMm = 0; }), "");
  EXPECT_NAMES(Refusal([](R& r) { r.gapMm = -0.1; }), "gapMm is -0.1");
  EXPECT_NAMES(Refusal([](R& r) { r.thicknessMm = 0; }), "thicknessMm is 0, must be in (0, 50]");
  EXPECT_NAMES(Refusal([](R& r) { r.thicknessMm = 0.5; }), "two grid spacings");
  EXPECT_NAMES(Refusal([](R& r) { r.spacingMm = 0; }), "spacingMm");
  EXPECT_NAMES(Refusal([=](R& r) { r.isovalue = nan; }), "isovalue");
  EXPECT_NAMES(Refusal([](R& r) { r.withdrawal *= 2.0; }), "withdrawal's length is 2");
  EXPECT_NAMES(Refusal([=](R& r) { r.withdrawal.x = nan; }), "withdrawal");
  EXPECT_NAMES(Refusal([](R& r) { r.landmarks.resize(2); }), "at least 3");
  EXPECT_NAMES(Refusal([](R& r) { r.landmarks.clear(); }), "number of landmarks is 0");
  EXPECT_NAMES(
    Refusal([](R& r) { r.landmarks[1] = r.landmarks[0]; }), "landmarks[0] and landmarks[1]");
  EXPECT_NAMES(Refusal([=](R& r) { r.landmarks[2].y = nan; }), "landmarks[2][1] is nan");
  EXPECT_NAMES(Refusal([](R& r) { r.slots[0].kerfMm = 0.2; }), "slots[0].kerfMm and clearance");
  EXPECT_NAMES(Refusal([](R& r) { r.slots[0].depthMm = 0; }), "slots[0].depthMm");
  EXPECT_NAMES(
    Refusal([](R& r) { r.slots[0].guidingHeightMm = 4; }), "above gapMm + thicknessMm (4.3)");
  EXPECT_EQ(Refusal([](R& r) { r.slots[0].guidingHeightMm = 0; }), "");
  EXPECT_NAMES(Refusal([](R& r) { r.slots[0].normal = r.withdrawal; }), "slots[0].normal");
  EXPECT_NAMES(Refusal([](R& r) { r.holes[1].diameterMm = 0; }), "holes[1].diameterMm");
  EXPECT_NAMES(Refusal([=](R& r) { r.holes[0].axis = glm::dvec3(nan); }), "holes[0].axis");
  EXPECT_NAMES(Refusal([](R& r) { r.holes[0].sleeveHeightMm = 4; }), "holes[0].sleeveHeightMm");
  EXPECT_NAMES(Refusal([](R& r) { r.axisSearchDeg = 61; }), "axisSearchDeg");
  EXPECT_NAMES(Refusal([](R& r) { r.clearanceMm = -0.1; }), "clearanceMm");
  EXPECT_NAMES(Refusal([](R& r) { r.edgeRadiusMm = 2.1; }), "edgeRadiusMm is 2.1");
  EXPECT_NAMES(Refusal([](R& r) { r.edgeRadiusMm = 1.6; }), "at most half of wallMm");
  EXPECT_NAMES(Refusal([](R& r) { r.wallMm = 0.7; }), "wallMm is 0.7");
  EXPECT_NAMES(Refusal([](R& r) { r.sleeveWallMm = 0.5; }), "sleeveWallMm is 0.5");
  EXPECT_NAMES(Refusal([](R& r) { r.strokes[0].points.clear(); }), "strokes[0].points");
  EXPECT_NAMES(Refusal([=](R& r) { r.strokes[1].points[0].z = nan; }), "strokes[1].points[0][2]");
  EXPECT_NAMES(Refusal([](R& r) { r.strokes[0].radiusMm = 0.1; }), "strokes[0].radiusMm");
  EXPECT_NAMES(Refusal([](R& r) { r.flanges[0].normal = r.withdrawal; }), "flanges[0].normal");
  EXPECT_NAMES(Refusal([](R& r) { r.flanges[0].heightMm = 4; }), "flanges[0].heightMm");
  EXPECT_NAMES(Refusal([](R& r) { r.flanges[0].freeMm = 0; }), "flanges[0].freeMm");
  EXPECT_NAMES(Refusal([](R& r) { r.labels[0].text = "Case"; }), "labels[0].text must be of A to");
  EXPECT_NAMES(Refusal([](R& r) { r.labels[0].text = "  "; }), "must have a letter");
  EXPECT_NAMES(Refusal([](R& r) { r.labels[0].text.assign(41, 'A'); }), "labels[0].text is 41");
  EXPECT_NAMES(Refusal([](R& r) { r.labels[0].heightMm = 4; }), "a sixth of labels[0].heightMm");
  const auto thin = [](R& r)
  {
    r.spacingMm = 0.25;
    r.labels[0].heightMm = 3.5;
  };
  EXPECT_NAMES(Refusal(thin), "at least 0.6 mm, so that the strokes");
  EXPECT_NAMES(Refusal([](R& r) { r.labels[0].depthMm = 2.1; }), "at most half of thicknessMm");
  EXPECT_NAMES(Refusal([](R& r) { r.labels[0].right *= 1.1; }), "labels[0].right");
  EXPECT_NAMES(Refusal([](R& r) { r.slots.resize(101, r.slots[0]); }), "number of slots is 101");
}

TEST(GuideRecipe, APaintedAreaNeedsNoLandmarks)
{
  auto r = Good();
  r.landmarks.clear();
  r.outline = hasp::GuideOutline::Open;
  EXPECT_NO_THROW(hasp::ValidateGuideRecipe(r));
  r.strokes[0].erased = true; // nothing is painted
  EXPECT_THROW(hasp::ValidateGuideRecipe(r), std::invalid_argument);
}

TEST(GuideRecipe, SawAxesAreUprightInTheSawPlane)
{
  const glm::dvec3 n = glm::normalize(glm::dvec3(1, 2, 0.3)),
                   w = glm::normalize(glm::dvec3(0, 1, 2));
  const glm::dmat3 axes = hasp::SawAxes(1.0005 * n, w);
  EXPECT_NEAR(glm::determinant(axes), 1.0, 1e-12);
  EXPECT_NEAR(glm::distance(axes[0], n), 0.0, 1e-12);
  EXPECT_NEAR(glm::dot(axes[1], w), 0.0, 1e-12);
  EXPECT_GT(glm::dot(axes[2], w), 0.4);
}

TEST(GuideRecipe, LabelsAreOfLettersThatCanBeWritten)
{
  using hasp::BodySide;
  EXPECT_EQ(hasp::GuideLabelText("Case 7", BodySide::Left, "3fa41b2c99"), "CASE 7 L 3FA41B2C");
  EXPECT_EQ(hasp::GuideLabelText("", BodySide::Right, ""), "R");
  EXPECT_EQ(hasp::GuideLabelText("a_b", BodySide::None, ""), "A-B");
  auto r = Good();
  r.labels[0].text =
    hasp::GuideLabelText(std::string(60, 'x') + "\n", BodySide::Left, std::string(64, 'f'));
  EXPECT_NO_THROW(hasp::ValidateGuideRecipe(r));
  EXPECT_EQ(r.labels[0].text.substr(28), "X L FFFFFFFF"); // these are not cut off
}

TEST(GuideRecipe, ALabelOfTheCaseIsWrittenWhenThePartIsMade)
{
  auto r = Good();
  r.labels.push_back({ "", { 2, 2, 2 }, { 0, 1, 0 }, 5, 1, false, hasp::GuideLabelKind::Case });
  const std::string file = hasp::FormatGuideRecipe(r);
  EXPECT_NE(file.find("\"kind\": \"case\""), std::string::npos);
  EXPECT_EQ(hasp::ParseGuideRecipe(file), r);
  EXPECT_EQ(hasp::FormatGuideRecipe(Good()).find("kind"), std::string::npos);
  const auto made = hasp::WithCaseLabels(r, "Case 7", hasp::BodySide::Left, std::string(64, 'e'));
  EXPECT_EQ(made.labels[0], r.labels[0]);
  EXPECT_EQ(made.labels[1].text, "CASE 7 L EEEEEEEE");
  EXPECT_EQ(made.labels[1].kind, hasp::GuideLabelKind::Text);
  EXPECT_EQ(hasp::FormatGuideRecipe(r), file); // what names the plan is not in the plan
  EXPECT_EQ(hasp::WithCaseLabels(Good(), "", hasp::BodySide::None, ""), Good());
  EXPECT_THROW(hasp::WithCaseLabels(r, "", hasp::BodySide::None, ""), std::invalid_argument);
  EXPECT_NAMES(
    Refusal([](hasp::GuideRecipe& recipe) { recipe.labels[0].kind = hasp::GuideLabelKind::Case; }),
    "labels[0].text must be empty");
  std::string both = file;
  both.replace(both.find("\"kind\": \"case\""), 14, "\"kind\": \"case\", \"text\": \"A\"");
  EXPECT_NAMES(Refusal(both), "labels[1].text must not be there");
  both.replace(both.find("\"case\""), 6, "\"mine\"");
  EXPECT_NAMES(Refusal(both), "labels[1].kind must be text or case");
}

TEST(GuideRecipe, AFileIsReplacedWholeOrNotAtAll)
{
  const auto folder = std::filesystem::path(testing::TempDir());
  const std::string path =
    (folder / ("TestGuideRecipe" + std::to_string(getpid()) + ".json")).string();
  hasp::WriteGuideRecipe(path, Good());
  auto bad = Good();
  bad.gapMm = -1;
  EXPECT_THROW(hasp::WriteGuideRecipe(path, bad), std::invalid_argument);
  EXPECT_EQ(hasp::ReadGuideRecipe(path).gapMm, Good().gapMm);
  std::filesystem::resize_file(path, (16U << 20U) + 1); // zeros
  std::string refusal;
  try
  {
    hasp::ReadGuideRecipe(path);
  }
  catch (const std::runtime_error& error)
  {
    refusal = error.what();
  }
  EXPECT_EQ(refusal, "guide recipe: the file has 16777217 bytes, at most 16777216 are read");
  std::remove(path.c_str());
  EXPECT_THROW(hasp::ReadGuideRecipe(path), std::runtime_error);
  EXPECT_THROW(hasp::WriteGuideRecipe((folder / "no such folder" / "r.json").string(), Good()),
    std::runtime_error);
}

} // namespace
