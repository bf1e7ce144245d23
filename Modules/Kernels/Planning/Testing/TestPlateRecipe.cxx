#include "Planning/PlateRecipe.h"
#include "Planning/PlateRecipeFile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace
{

hasp::PlateRecipe Valid()
{
  hasp::PlateRecipe r;
  r.note = "täst";
  r.landmarks = { { 1, 2, 3 }, { 0.1, 20, 3 }, { -5, 7, 1.0 / 3.0 } };
  r.screws = { { { 1, 2, 3 } }, { { 0, 9, 3 }, glm::dvec3(0, 0.6, -0.8), 2.0, 3.5, 0.2, 82, 12 } };
  r.fragments = { { 3, { 1, 0, 0 }, { 0.6, 0, 0.8, 0 } }, { 5 } };
  return r;
}

template <typename Work>
std::string Fault(Work work)
{
  try
  {
    work();
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return "";
}

#define EXPECT_NAMES(message, part) EXPECT_NE((message).find(part), std::string::npos) << (message)

TEST(PlateRecipe, EveryNumberOutOfItsRangeIsNamed)
{
  const auto fault = [](auto change)
  {
    hasp::PlateRecipe recipe = Valid();
    change(recipe);
    return Fault([&] { hasp::ValidatePlateRecipe(recipe); });
  };
  const double nan = std::nan("");
  EXPECT_EQ(fault([](auto&) {}), "");
  EXPECT_EQ(
    fault([&](auto& r) { r.gapMm = nan; }), "plate recipe: gapMm is nan, must be in [0, 5]");
  EXPECT_NAMES(fault([&](auto& r) { r.isovalue = nan; }), "isovalue is nan");
  EXPECT_NAMES(fault([](auto& r) { r.ignoreBelowMm3 = -1; }), "ignoreBelowMm3 is -1");
  EXPECT_NAMES(fault([](auto& r) { r.landmarks.resize(1); }), "landmarks is 1, must be 2 to 200");
  EXPECT_NAMES(fault([&](auto& r) { r.landmarks[1].y = nan; }), "landmarks[1][1] is nan");
  EXPECT_NAMES(fault([](auto& r) { r.landmarks[2] = r.landmarks[1]; }), "landmarks[2] is the same");
  EXPECT_NAMES(fault([](auto& r) { r.thicknessMm = 0; }), "thicknessMm is 0, must be in (0, 20]");
  EXPECT_NAMES(fault([](auto& r) { r.thicknessMm = 0.7; }), "at least two spacingMm");
  EXPECT_NAMES(fault([](auto& r) { r.widthMm = 101; }), "widthMm is 101");
  EXPECT_NAMES(fault([](auto& r) { r.bevelMm = 2.1; }), "bevelMm is 2.1, must be in [0.4, 2]");
  EXPECT_EQ(fault([](auto& r) { r.bevelMm = 0; }), "");
  EXPECT_NAMES(fault([&](auto& r) { r.bridgeMm = nan; }), "bridgeMm is nan");
  EXPECT_NAMES(fault([](auto& r) { r.edgeDistanceMm = -1; }), "edgeDistanceMm is -1");
  EXPECT_NAMES(fault([](auto& r) { r.holeDistanceMm = 21; }), "holeDistanceMm is 21");
  EXPECT_NAMES(fault([](auto& r) { r.spacingMm = 3; }), "spacingMm is 3");
  EXPECT_NAMES(fault([](auto& r) { r.screws.resize(101); }), "screws is 101, must be at most 100");
}

TEST(PlateRecipe, ScrewsAndFragmentsAreNamed)
{
  const auto fault = [](auto change)
  {
    hasp::PlateRecipe recipe = Valid();
    change(recipe);
    return Fault([&] { hasp::ValidatePlateRecipe(recipe); });
  };
  EXPECT_NAMES(
    fault([](auto& r) { r.screws[1].axis = glm::dvec3(0, 0, 2); }), "screws[1].axis's length is 2");
  EXPECT_NAMES(fault([](auto& r) { r.screws[0].diameterMm = 0.7; }), "screws[0].diameterMm is 0.7");
  EXPECT_NAMES(fault([](auto& r) { r.screws[0].headDiameterMm = 2; }),
    "screws[0].headDiameterMm is 2, must be in [2.4, 30]");
  EXPECT_NAMES(fault([](auto& r) { r.screws[1].headAngleDeg = 29; }), "screws[1].headAngleDeg");
  EXPECT_NAMES(fault([](auto& r) { r.screws[1].lengthMm = 0; }), "screws[1].lengthMm is 0");
  // 0.8 mm of cone and 1.8 mm above it.
  EXPECT_NAMES(fault([](auto& r) { r.screws[0].headDepthMm = 1.8; }),
    "screws[0].headDepthMm and the cone's depth is 2.6, must be at most thicknessMm");
  EXPECT_NEAR(hasp::ScrewHeadDepth(Valid().screws[0]), 1.1, 1e-12);
  EXPECT_NAMES(fault([](auto& r) { r.fragments[1].label = 0; }), "fragments[1].label is 0");
  EXPECT_NAMES(
    fault([](auto& r) { r.fragments[1].label = 3; }), "fragments[1].label is that of fragments[0]");
  EXPECT_NAMES(fault([](auto& r) { r.fragments[0].orientation.w = 0.7; }),
    "fragments[0].orientation's length is 1.06");
  EXPECT_NAMES(fault([](auto& r) { r.fragments[0].position.z = 5000; }), "fragments[0].position");
}

TEST(PlateRecipe, AFileIsReadAsItWasWrittenAndStrictly)
{
  const hasp::PlateRecipe recipe = Valid();
  const std::string text = hasp::FormatPlateRecipe(recipe);
  EXPECT_EQ(hasp::ParsePlateRecipe(text), recipe);
  const auto fault = [&](const std::string& from, const std::string& to)
  {
    std::string changed = text;
    const std::size_t at = changed.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    changed.replace(at, from.size(), to);
    return Fault([&] { hasp::ParsePlateRecipe(changed); });
  };
  EXPECT_NAMES(fault("bridgeMm", "secret"), "plate recipe: a key is unknown");
  EXPECT_NAMES(fault("bridgeMm", "bridge_mm"), "the nearest known is 'bridgeMm'");
  EXPECT_EQ(fault("bridgeMm", "secret").find("secret"), std::string::npos);
  EXPECT_NAMES(fault("hasp-plate-recipe-1", "hasp-guide-recipe-1"), "format is of another kind");
  EXPECT_NAMES(fault("\"gapMm\": 0.2,", ""), "gapMm is missing");
  EXPECT_NAMES(fault("\"gapMm\": 0.2", "\"gapMm\": \"0.2\""), "gapMm must be a number");
  EXPECT_NAMES(fault("\"headAngleDeg\": 82.0,", ""), "screws[1].headAngleDeg is missing");
  EXPECT_NAMES(fault("\"label\": 5", "\"label\": 5.5"), "fragments[1].label");
  EXPECT_NAMES(
    fault("\"orientation\": [", "\"orientation\": [ \"Erika\","), "must be four numbers");
  EXPECT_NAMES(Fault([] { hasp::ParsePlateRecipe("{"); }), "no JSON");
  EXPECT_NAMES(
    Fault([] { hasp::ReadPlateRecipe("/nowhere/plate.json"); }), "the file is not there");
}

} // namespace
