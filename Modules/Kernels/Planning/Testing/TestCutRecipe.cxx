#include "Planning/CutRecipe.h"
#include "Planning/CutRecipeFile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace
{

hasp::CutRecipe Valid()
{
  hasp::CutRecipe recipe;
  recipe.cuts = { { {}, 8.0 }, { { { 1, 2, 3 }, { 0, 0, 1 }, { 1, 0, 0 }, 20, 30, 0.5 }, 0.0 } };
  recipe.resected = { { 4, 5, 6 } };
  return recipe;
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

TEST(CutRecipe, EveryNumberOutOfItsRangeIsNamed)
{
  const auto fault = [](auto change)
  {
    hasp::CutRecipe recipe = Valid();
    change(recipe);
    return Fault([&] { hasp::ValidateCutRecipe(recipe); });
  };
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(fault([](auto&) {}), "");
  EXPECT_EQ(fault([&](auto& r) { r.isovalue = nan; }),
    "cut recipe: isovalue is nan, must be in [-1e+06, 1e+06]");
  EXPECT_EQ(fault([](auto& r) { r.spacingMm = 0.05; }),
    "cut recipe: spacingMm is 0.05, must be in [0.1, 2]");
  EXPECT_NE(fault([&](auto& r) { r.ignoreBelowMm3 = infinite; }).find("ignoreBelowMm3 is inf"),
    std::string::npos);
  EXPECT_NE(
    fault([](auto& r) { r.crumbBelowMm3 = -1; }).find("crumbBelowMm3 is -1"), std::string::npos);
  EXPECT_NE(fault([](auto& r) { r.cuts.clear(); }).find("number of cuts is 0"), std::string::npos);
  EXPECT_NE(
    fault([](auto& r) { r.cuts.resize(101); }).find("number of cuts is 101"), std::string::npos);
  EXPECT_NE(fault([](auto& r) { r.resected.resize(101); }).find("number of resected is 101"),
    std::string::npos);
  EXPECT_NE(fault([](auto& r) { r.cuts[1].blade.kerfMm = 0.1; }).find("cuts[1].kerfMm is 0.1"),
    std::string::npos);
  EXPECT_NE(fault([&](auto& r) { r.cuts[1].reachMm = nan; }).find("cuts[1].reachMm is nan"),
    std::string::npos);
  EXPECT_NE(fault([](auto& r) { r.cuts[1].blade.widthMm = 0; }).find("cuts[1]: widthMm is 0"),
    std::string::npos);
  EXPECT_NE(fault([](auto& r) { r.resected[0].y = 5000; }).find("resected[0]"), std::string::npos);
}

TEST(CutRecipe, AThinKerfMakesTheGridFiner)
{
  hasp::CutRecipe recipe = Valid();
  EXPECT_EQ(hasp::CutSpacing(recipe), 0.5 / 1.8);
  recipe.cuts[1].blade.kerfMm = 2.0;
  EXPECT_EQ(hasp::CutSpacing(recipe), recipe.spacingMm);
}

TEST(CutRecipe, AFileIsReadAsItWasWrittenAndStrictly)
{
  const hasp::CutRecipe recipe = Valid();
  const std::string text = hasp::FormatCutRecipe(recipe);
  EXPECT_EQ(hasp::ParseCutRecipe(text), recipe);
  const auto fault = [&](const std::string& from, const std::string& to)
  {
    std::string changed = text;
    const std::size_t at = changed.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    changed.replace(at, from.size(), to);
    return Fault([&] { hasp::ParseCutRecipe(changed); });
  };
  EXPECT_NE(fault("reachMm", "secret").find("a key of cuts[0] is unknown"), std::string::npos);
  EXPECT_EQ(fault("reachMm", "secret").find("secret"), std::string::npos);
  EXPECT_NE(fault("hasp-cut-recipe-1", "hasp-cut-recipe-9").find("format"), std::string::npos);
  EXPECT_NE(fault("\"spacingMm\": 0.5,", "").find("spacingMm is missing"), std::string::npos);
  EXPECT_NE(fault("0.5", "\"0.5\"").find("spacingMm must be a number"), std::string::npos);
  EXPECT_NE(Fault([] { hasp::ParseCutRecipe("{"); }).find("no JSON"), std::string::npos);
  EXPECT_NE(Fault([] { hasp::ReadCutRecipe("/nowhere/cuts.json"); }).find("the file is not there"),
    std::string::npos);
}

} // namespace
