// What a recipe's places are told before bone is looked at, and grids that no memory is for.
#include "PlaceChecks.h"
#include "WorkingGrid.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <gtest/gtest.h>

#include <stdexcept>

namespace
{

/// 200 mm x 200 mm x 100 mm, its middle far from the origin, as a scanner's are.
const hasp::GridGeometry Volume{ { 101, 101, 51 }, { 100, -300, 400 }, glm::dvec3(2),
  glm::dmat3(1) };

std::string Refusal(const std::vector<hasp::NamedPlace>& places, double marginMm = 0.0)
{
  try
  {
    hasp::CheckInVolume("guide", Volume, places, marginMm);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "";
}

TEST(PlaceChecks, WhatIsInTheVolumeOrNearItPasses)
{
  EXPECT_EQ(Refusal({}), "");
  EXPECT_EQ(Refusal({ { "a", { 100, -300, 400 } }, { "b", { 300, -100, 500 } } }), "");
  EXPECT_EQ(Refusal({ { "a", { 98, -300, 400 } } }, 2.0), "");
}

TEST(PlaceChecks, TheFirstThatIsOutsideIsNamed)
{
  EXPECT_EQ(Refusal({ { "a", { 200, -200, 450 } }, { "b", { 0, 0, 1 } }, { "c", { 0, 0, 2 } } }),
    "guide: b (0, 0, 1) is outside the volume");
  EXPECT_EQ(Refusal({ { "a", { 97.9, -300, 400 } } }, 2.0),
    "guide: a (97.9, -300, 400) is outside the volume");
}

TEST(PlaceChecks, OtherUnitsAndRASAreSaid)
{
  const glm::dvec3 p(200, -200, 450), q(110, -110, 401);
  const auto refusal = [&](const glm::dvec3& factor) {
    return Refusal({ { "a", p / factor }, { "b", q / factor } });
  };
  const auto says = [](const std::string& text, const char* words)
  { EXPECT_NE(text.find(words), std::string::npos) << text; };
  EXPECT_EQ(refusal({ -1, -1, 1 }),
    "guide: a (-200, 200, 450) is outside the volume. The places seem to be in RAS; turned to LPS "
    "(the signs of the first two numbers changed), all are in it");
  says(refusal(glm::dvec3(1000)), "seem to be in metres");
  says(refusal(glm::dvec3(10)), "seem to be in centimetres");
  says(refusal(glm::dvec3(25.4)), "seem to be in inches");
}

TEST(WorkingGrid, IsRefusedBeforeMemoryIsTaken)
{
  const auto refusal = [](double sideMm)
  {
    try
    {
      hasp::GridIn("plate", { glm::dvec3(0), glm::dvec3(sideMm) }, glm::dmat3(1), 0.5);
    }
    catch (const std::invalid_argument& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal(290), "");
  EXPECT_EQ(refusal(300),
    "plate: the working grid would have 2.17082e+08 points, at most 2e+08 are "
    "allowed; raise spacingMm (now 0.5 mm)");
  EXPECT_NE(refusal(1e12), "");
}

TEST(WorkingGrid, AxesAreRightHanded)
{
  for (const glm::dvec3& z : { glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0.6, 0, 0.8) })
  {
    const glm::dmat3 axes = hasp::AxesAlong(z);
    EXPECT_EQ(axes[2], z);
    EXPECT_NEAR(glm::determinant(axes), 1.0, 1e-12);
    EXPECT_NEAR(glm::length(axes[0]), 1.0, 1e-12);
    EXPECT_NEAR(glm::dot(axes[0], z), 0.0, 1e-12);
  }
}

} // namespace
