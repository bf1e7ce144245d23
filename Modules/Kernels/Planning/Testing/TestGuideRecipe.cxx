#include "Planning/GuideRecipeFile.h"

#include <glm/geometric.hpp>
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
  r.slots = { { { 1, 1, 1 }, { 0, 1, -0.0 }, 1.2, 20 } };
  r.holes = { { { 0, 0, 1 }, { 0, 0, 1 }, 2 }, { { 3, 0, 1 }, { 1, 0, 0 }, 2.7 } };
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
  EXPECT_EQ(back.note, r.note);
  EXPECT_EQ(back.landmarks, r.landmarks);
  EXPECT_EQ(back.outline, r.outline);
  EXPECT_EQ(back.withdrawal, r.withdrawal);
  EXPECT_EQ(back.gapMm, r.gapMm);
  ASSERT_EQ(back.slots.size(), 1U);
  EXPECT_EQ(back.slots[0].normal, r.slots[0].normal);
  ASSERT_EQ(back.holes.size(), 2U);
  EXPECT_EQ(back.holes[1].diameterMm, 2.7);
  EXPECT_EQ(hasp::FormatGuideRecipe(back), hasp::FormatGuideRecipe(r));
}

TEST(GuideRecipe, FilesAreStrict)
{
  EXPECT_NAMES(Refusal("{"), "no JSON");
  EXPECT_NAMES(Refusal("[]"), "must be an object");
  EXPECT_NAMES(Refusal("{}"), "format is missing");
  EXPECT_NAMES(Refusal(Replaced("\"gapMm\"", "\"gap\"")), "key 7 is unknown");
  EXPECT_NAMES(Refusal(Replaced("\"gapMm\": 0.3,", "")), "gapMm is missing");
  EXPECT_NAMES(Refusal(Replaced("\"gapMm\": 0.3", "\"gapMm\": \"0.3\"")), "gapMm must be a number");
  EXPECT_NAMES(Refusal(Replaced("recipe-1", "recipe-2")), "must be 'hasp-guide-recipe-1'");
  EXPECT_NAMES(Refusal(Replaced("closed", "round")), "open, closed or filled");
  EXPECT_NAMES(
    Refusal(Replaced("\"diameterMm\": 2.0", "\"radius\": 2.0")), "holes[0].key 3 is unknown");
  EXPECT_NAMES(Refusal(Replaced("\"lengthMm\": 20.0", "\"lengthMm\": -20.0")), "slots[0].lengthMm");
  EXPECT_NAMES(Refusal(Replaced("\"gapMm\": 0.3", "\"gapMm\": NaN")), "no JSON");
  EXPECT_NAMES(Refusal(Replaced("\"gapMm\": 0.3", "\"gapMm\": 1e999")), "no JSON");
}

TEST(GuideRecipe, ErrorsSayNothingOfTheFilesText)
{
  for (const std::string& bad : { std::string("{ \"Erika"), std::string("Erika"),
         Replaced("\"gapMm\"", "\"Erika\""), Replaced("closed", "Erika"),
         Replaced("hasp-guide-recipe-1", "Erika"), Replaced("\"gapMm\": 0.3", "\"gapMm\": Erika") })
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
  EXPECT_NAMES(Refusal([](R& r) { r.slots[0].widthMm = 0.5; }), "slots[0].widthMm");
  EXPECT_NAMES(Refusal([](R& r) { r.slots[0].normal = r.withdrawal; }), "slots[0].normal");
  EXPECT_NAMES(Refusal([](R& r) { r.holes[1].diameterMm = 0; }), "holes[1].diameterMm");
  EXPECT_NAMES(Refusal([=](R& r) { r.holes[0].axis = glm::dvec3(nan); }), "holes[0].axis");
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
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
  std::remove(path.c_str());
  EXPECT_THROW(hasp::ReadGuideRecipe(path), std::runtime_error);
  EXPECT_THROW(hasp::WriteGuideRecipe((folder / "no such folder" / "r.json").string(), Good()),
    std::runtime_error);
}

} // namespace
