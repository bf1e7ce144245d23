#include "Planning/ImplantRecipe.h"
#include "Planning/ImplantRecipeFile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace
{

hasp::ImplantRecipe Valid()
{
  hasp::ImplantRecipe r;
  r.note = "täst";
  r.mirror = hasp::MirrorPlane{ { 1, 2, 3 }, { 0.6, 0.8, 0 } };
  r.outline = { { 1, 2, 3 }, { 0.1, 20, 3 }, { -5, 7, 1.0 / 3.0 } };
  r.axis = glm::dvec3(0, -1, 0);
  r.holeDiameterMm = 2.0;
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

TEST(ImplantRecipe, EveryNumberOutOfItsRangeIsNamed)
{
  const auto fault = [](auto change)
  {
    hasp::ImplantRecipe recipe = Valid();
    change(recipe);
    return Fault([&] { hasp::ValidateImplantRecipe(recipe); });
  };
  const double nan = std::nan("");
  EXPECT_EQ(fault([](auto&) {}), "");
  EXPECT_EQ(fault([&](auto& r) { r.clearanceMm = nan; }),
    "implant recipe: clearanceMm is nan, must be in [0, 5]");
  EXPECT_NAMES(fault([&](auto& r) { r.isovalue = nan; }), "isovalue is nan");
  EXPECT_NAMES(fault([](auto& r) { r.ignoreBelowMm3 = -1; }), "ignoreBelowMm3 is -1");
  EXPECT_NAMES(fault([&](auto& r) { r.mirror->point.y = nan; }), "mirror.point[1] is nan");
  EXPECT_NAMES(fault([](auto& r) { r.mirror->normal *= 2; }), "mirror.normal's length is 2");
  EXPECT_NAMES(fault([](auto& r) { r.outline.resize(2); }), "outline is 2, must be 3 to 200");
  EXPECT_NAMES(fault([](auto& r) { r.outline[2] = r.outline[0]; }), "outline[2] is the same point");
  EXPECT_NAMES(fault([](auto& r) { r.axis = glm::dvec3(0); }), "axis's length is 0");
  EXPECT_NAMES(fault([](auto& r) { r.thicknessMm = 0.9; }), "at least two spacingMm");
  EXPECT_NAMES(fault([](auto& r) { r.thicknessMm = 21; }), "thicknessMm is 21");
  EXPECT_NAMES(fault([](auto& r) { r.spacingMm = 0; }), "spacingMm is 0");
  EXPECT_NAMES(fault([](auto& r) { r.holeDiameterMm = 0.9; }), "holeDiameterMm is 0.9");
  EXPECT_EQ(fault([](auto& r) { r.holeDiameterMm = 0; }), "");
  EXPECT_NAMES(fault([](auto& r) { r.holePitchMm = 2.9; }), "holePitchMm is 2.9");
  EXPECT_NAMES(fault([](auto& r) { r.holeEdgeMm = 0.4; }), "holeEdgeMm is 0.4");
}

TEST(ImplantRecipe, AFileIsReadAsItWasWrittenAndStrictly)
{
  const hasp::ImplantRecipe recipe = Valid();
  const std::string text = hasp::FormatImplantRecipe(recipe);
  EXPECT_EQ(hasp::ParseImplantRecipe(text), recipe);
  hasp::ImplantRecipe fitted = recipe;
  fitted.mirror.reset();
  fitted.axis.reset();
  EXPECT_EQ(hasp::ParseImplantRecipe(hasp::FormatImplantRecipe(fitted)), fitted);
  const auto fault = [&](const std::string& from, const std::string& to)
  {
    std::string changed = text;
    const std::size_t at = changed.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    changed.replace(at, from.size(), to);
    return Fault([&] { hasp::ParseImplantRecipe(changed); });
  };
  EXPECT_NAMES(fault("holeEdgeMm", "secret"), "is unknown");
  EXPECT_EQ(fault("holeEdgeMm", "secret").find("secret"), std::string::npos);
  EXPECT_NAMES(fault("implant-recipe-1", "guide-recipe-1"), "format is of another kind");
  EXPECT_NAMES(fault("\"clearanceMm\": 0.5,", ""), "clearanceMm is missing");
  EXPECT_NAMES(
    fault("\"normal\"", "\"norm\""), "a key of mirror is unknown, the nearest known is 'normal'");
  EXPECT_NAMES(Fault([] { hasp::ParseImplantRecipe("{"); }), "no JSON");
  EXPECT_NAMES(
    Fault([] { hasp::ReadImplantRecipe("/nowhere/implant.json"); }), "the file is not there");
}

} // namespace
