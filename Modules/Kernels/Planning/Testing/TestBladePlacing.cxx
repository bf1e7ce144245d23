// Blades as hands put them, against the planes and boxes that they must be.
#include "Planning/BladePlacing.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using glm::dvec3;
constexpr double Rounding = 1e-12; // of a dozen operations on numbers about 1
constexpr double RoundingMm = 1e-10;

std::string Refusal(const std::vector<dvec3>& places, const dvec3& view = { 0, 1, 0 })
{
  try
  {
    hasp::BladeThrough(places, view, {});
    return {};
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
}

TEST(BladePlacing, WhatIsNoPlaneIsRefusedInWords)
{
  EXPECT_EQ(Refusal({ { 0, 0, 0 } }), "blade: the number of places is 1, must be 2 or 3");
  EXPECT_EQ(Refusal({ { 0, 0, 0 }, { 0, 0, 0.5 } }),
    "blade: the distance of places[0] and places[1] is 0.5, must be at least 1 mm");
  EXPECT_NE(Refusal({ { 0, 0, 0 }, { 0, 9, 0 } }).find("turn the view"), std::string::npos);
  EXPECT_NE(Refusal({ { 0, 0, 0 }, { 9, 0, 0 } }, dvec3(0)).find("view"), std::string::npos);
  EXPECT_NE(
    Refusal({ { 0, 0, 0 }, { 9, 0, 0 }, { 20, 0.1, 0 } }).find("lie on a line"), std::string::npos);
  EXPECT_NE(Refusal({ { 0, 0, 0 }, { std::nan(""), 0, 0 } }).find("places[1]"), std::string::npos);
  EXPECT_EQ(Refusal({ { 0, 0, 0 }, { 9, 0, 0 } }), "");
}

TEST(BladePlacing, TwoPlacesAndTheViewLieInThePlane)
{
  const std::vector<dvec3> places{ { 10, 0, 5 }, { 10, 0, 35 } };
  const auto blade = hasp::BladeThrough(places, { 0, -3, 0 }, { .widthMm = 20, .kerfMm = 0.7 });
  EXPECT_NEAR(glm::distance(blade.point, dvec3(10, 0, 20)), 0.0, RoundingMm);
  EXPECT_NEAR(glm::distance(blade.along, dvec3(0, 0, 1)), 0.0, Rounding);
  EXPECT_NEAR(std::abs(blade.normal.x), 1.0, Rounding);
  EXPECT_DOUBLE_EQ(blade.widthMm, 40.0); // 30 mm and 5 on either side
  EXPECT_DOUBLE_EQ(blade.depthMm, 60.0);
  EXPECT_EQ(blade.kerfMm, 0.7);
}

TEST(BladePlacing, AnyPlacesLieInTheBladeAndItIsLegal)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(-1, 1);
  const auto place = [&] { return 60.0 * dvec3(any(random), any(random), any(random)); };
  int taken = 0;
  for (int n = 0; n < 400; ++n)
  {
    std::vector<dvec3> places{ place(), place() };
    if (n % 2)
      places.push_back(place());
    const dvec3 view = place();
    if (!Refusal(places, view).empty())
      continue;
    ++taken;
    const auto blade = hasp::BladeThrough(places, view, { .widthMm = 1, .depthMm = 1 });
    hasp::ValidateOsteotomy(blade);
    const glm::dmat3 axes = hasp::BladeAxes(blade);
    EXPECT_NEAR(glm::determinant(axes), 1.0, Rounding);
    for (const dvec3& touched : places)
    {
      const dvec3 at = glm::transpose(axes) * (touched - blade.point);
      EXPECT_NEAR(at.z, 0.0, RoundingMm);
      EXPECT_LE(std::abs(at.x), 0.5 * blade.widthMm - hasp::BeyondPlacesMm + RoundingMm);
      EXPECT_LE(std::abs(at.y), 0.5 * blade.depthMm - hasp::BeyondPlacesMm + RoundingMm);
    }
    if (places.size() == 2)
    {
      EXPECT_NEAR(glm::dot(blade.normal, glm::normalize(view)), 0.0, Rounding);
    }
  }
  EXPECT_GT(taken, 350);
}

TEST(BladePlacing, ShiftsAreAlongItsOwnAxes)
{
  const hasp::Osteotomy blade{ { 1, 2, 3 }, { 1, 0, 0 }, { 0, 1, 0 } };
  const auto shifted = hasp::ShiftedBlade(blade, { 10, 20, 30 });
  EXPECT_EQ(shifted.point, dvec3(31, 12, 23)); // normal is x, along y, across z
  EXPECT_EQ(shifted.normal, blade.normal);
  EXPECT_EQ(shifted.along, blade.along);
}

TEST(BladePlacing, TurnsKeepTheMiddleAndAddUp)
{
  hasp::Osteotomy blade{ { 1, 2, 3 }, { 1, 0, 0 }, { 0, 1, 0 } };
  const auto quarter = glm::angleAxis(std::acos(0.0), dvec3(0, 0, 1));
  const auto turned = hasp::TurnedBlade(blade, quarter);
  EXPECT_EQ(turned.point, blade.point);
  EXPECT_NEAR(glm::distance(turned.normal, dvec3(0, 1, 0)), 0.0, Rounding);
  EXPECT_NEAR(glm::distance(turned.along, dvec3(-1, 0, 0)), 0.0, Rounding);
  const auto little = glm::angleAxis(0.001, glm::normalize(dvec3(1, 2, 3)));
  for (int n = 0; n < 10'000; ++n)
    blade = hasp::TurnedBlade(blade, little);
  hasp::ValidateOsteotomy(blade);
  EXPECT_NEAR(glm::dot(blade.normal, blade.along), 0.0, Rounding);
}

TEST(BladePlacing, DirectionsHaveAMeanUnlessTheyCancelOut)
{
  EXPECT_FALSE(hasp::MeanDirection({}));
  EXPECT_FALSE(hasp::MeanDirection(std::vector<dvec3>{ { 1, 0, 0 }, { -1, 0, 0.1 } }));
  const auto mean = hasp::MeanDirection(std::vector<dvec3>{ { 1, 0, 0 }, { 0, 1, 0 } });
  ASSERT_TRUE(mean);
  EXPECT_NEAR(glm::distance(*mean, dvec3(std::sqrt(0.5), std::sqrt(0.5), 0)), 0.0, Rounding);
}

} // namespace
