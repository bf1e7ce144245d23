// Random plates on the phantom, through the filter and a file: sound, or the named error.
#include "MadePlate.h"
#include "RandomPlates.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace
{

constexpr std::uint32_t SeedsEach = 11;

class RandomPlates : public testing::TestWithParam<std::uint32_t>
{
};

TEST_P(RandomPlates, AreSoundOrNamedErrors)
{
  const auto head = platetest::Head();
  int made = 0;
  for (std::uint32_t seed = GetParam(); seed < GetParam() + SeedsEach; ++seed)
  {
    const auto plate = hasp::RandomPlateRecipe(seed);
    const platetest::Made answer(head, plate.recipe);
    EXPECT_EQ(hasp::WrongWithPlate(plate, answer.error, answer.mesh), "") << "seed " << seed;
    made += !answer.mesh.triangles.empty();
  }
  EXPECT_GT(made, 0);
}

// 22 plates, every kind twice; hasp report guides makes hundreds.
INSTANTIATE_TEST_SUITE_P(, RandomPlates, testing::Values(0U, 11U));

TEST(RandomPlateRecipes, AreOfEveryKindAndTheSameAgain)
{
  std::map<std::string, int> kinds;
  for (std::uint32_t seed = 0; seed < 44; ++seed)
  {
    const auto plate = hasp::RandomPlateRecipe(seed);
    ++kinds[plate.kind];
    EXPECT_EQ(plate.words.empty(), plate.outcome != hasp::PlateOutcome::Refused);
    const auto again = hasp::RandomPlateRecipe(seed);
    if (std::string(plate.kind) != "nonsense") // whose NaN is like nothing
    {
      EXPECT_EQ(again.recipe, plate.recipe) << seed;
      EXPECT_NE(hasp::RandomPlateRecipe(seed + 44).recipe, plate.recipe);
    }
  }
  EXPECT_EQ(kinds.size(), hasp::RandomPlateKinds);
}

TEST(RandomPlateRecipes, WhatComesOfThemIsJudged)
{
  using hasp::WrongWithPlate;
  const hasp::TriangleMesh none, open{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } };
  const auto plain = hasp::RandomPlateRecipe(0), air = hasp::RandomPlateRecipe(5),
             any = hasp::RandomPlateRecipe(9);
  EXPECT_EQ(WrongWithPlate(air, "plate: screws[0] is 9 mm from bone", none), "");
  EXPECT_NE(WrongWithPlate(air, "plate: landmarks[0] is 9 mm from bone", none), "");
  EXPECT_NE(WrongWithPlate(air, "plate: screws[0] is 9 mm from bone", open), "");
  EXPECT_NE(WrongWithPlate(air, "", open), "");
  EXPECT_NE(WrongWithPlate(plain, "plate: no", none), "");
  EXPECT_NE(WrongWithPlate(plain, "", none), "");
  EXPECT_NE(WrongWithPlate(plain, "", open), "");
  EXPECT_EQ(WrongWithPlate(any, "plate: no", none), "");
  EXPECT_NE(WrongWithPlate(any, "bad allocation", none), "");
}

} // namespace
