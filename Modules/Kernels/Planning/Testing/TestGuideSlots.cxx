// Slots of planned blades, against what a blade and a guide are.
#include "Planning/GuideSlots.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace
{

hasp::Osteotomy Upright()
{
  hasp::Osteotomy blade;
  blade.point = { 10, 20, 30 };
  blade.normal = { 1, 0, 0 };
  blade.along = { 0, 1, 0 };
  blade.widthMm = 40;
  blade.depthMm = 16;
  blade.kerfMm = 0.8;
  return blade;
}

TEST(GuideSlots, AnUprightBladeIsItsOwnSlot)
{
  const auto slot = hasp::SlotOfBlade(Upright(), { 0, 0, 1 });
  EXPECT_EQ(slot.point, glm::dvec3(10, 20, 30));
  EXPECT_EQ(slot.normal, glm::dvec3(1, 0, 0));
  EXPECT_EQ(slot.kerfMm, 0.8);
  EXPECT_DOUBLE_EQ(slot.lengthMm, 40);
  EXPECT_DOUBLE_EQ(slot.depthMm, 8);
  EXPECT_EQ(slot.guidingHeightMm, hasp::GuideSlot().guidingHeightMm);
  const auto moved = hasp::MovedSlot(slot, { 0, 0, 1 }, 3);
  EXPECT_EQ(moved.point, glm::dvec3(10, 20, 33));
  EXPECT_DOUBLE_EQ(moved.depthMm, 11);
  EXPECT_EQ(moved.normal, slot.normal);
}

TEST(GuideSlots, ABladeOnItsSideIsAsLongAsItIsDeep)
{
  auto blade = Upright();
  blade.along = { 0, 0, -1 };
  const auto slot = hasp::SlotOfBlade(blade, { 0, 0, 1 });
  EXPECT_DOUBLE_EQ(slot.lengthMm, 16);
  EXPECT_DOUBLE_EQ(slot.depthMm, 20);
}

TEST(GuideSlots, AllOfTheBladeComesInAndThePlaneIsItsOwn)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1, 1), size(1, 60);
  const auto direction = [&]
  { return glm::normalize(glm::dvec3(any(random), any(random), any(random))); };
  int taken = 0;
  for (int n = 0; n < 200; ++n)
  {
    hasp::Osteotomy blade;
    blade.point = 100.0 * direction();
    blade.normal = direction();
    blade.along = glm::normalize(glm::cross(blade.normal, direction()));
    blade.widthMm = size(random);
    blade.depthMm = size(random);
    const glm::dvec3 up = direction();
    if (std::abs(glm::dot(up, blade.normal)) > hasp::MostSawCosine)
      continue;
    ++taken;
    const auto slot = hasp::SlotOfBlade(blade, up);
    EXPECT_NEAR(glm::distance(slot.normal, blade.normal), 0, 1e-12);
    EXPECT_NEAR(glm::dot(slot.point - blade.point, blade.normal), 0, 1e-12);
    const double by = any(random) * 0.9 * slot.depthMm;
    const auto moved = hasp::MovedSlot(slot, up, by);
    EXPECT_NEAR(glm::dot(moved.point - blade.point, blade.normal), 0, 1e-10);
    // Of the blade's corners the farthest across are the slot's ends, the lowest its lower end.
    const glm::dmat3 axes = hasp::SawAxes(slot.normal, up);
    EXPECT_GT(glm::dot(axes[2], up), 0.4);
    double across = 0, low = 0;
    for (int c = 0; c < 4; ++c)
    {
      const glm::dvec3 corner =
        (c & 1 ? 0.5 : -0.5) * blade.widthMm * blade.along +
        (c & 2 ? 0.5 : -0.5) * blade.depthMm * glm::cross(blade.normal, blade.along);
      across = std::max(across, glm::dot(corner, axes[1]));
      low = std::min(low, glm::dot(corner - by * axes[2], axes[2]));
    }
    EXPECT_NEAR(0.5 * moved.lengthMm, across, 1e-10);
    EXPECT_NEAR(-moved.depthMm, low, 1e-10);
  }
  EXPECT_GT(taken, 150);
}

TEST(GuideSlots, WhatNoSawEntersIsNamed)
{
  auto blade = Upright();
  EXPECT_THROW(
    hasp::SlotOfBlade(blade, glm::normalize(glm::dvec3(1, 0.4, 0))), std::invalid_argument);
  EXPECT_NO_THROW(hasp::SlotOfBlade(blade, glm::normalize(glm::dvec3(1, 0.5, 0))));
  try
  {
    hasp::SlotOfBlade(blade, { 1, 0, 0 }, "slots[2]");
    ADD_FAILURE();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_EQ(std::string(error.what()).find("slots[2]: the cosine of the blade's normal"), 0U)
      << error.what();
  }
  blade.kerfMm = 0;
  EXPECT_THROW(hasp::SlotOfBlade(blade, { 0, 0, 1 }), std::invalid_argument);
  EXPECT_THROW(hasp::MovedSlot(hasp::SlotOfBlade(Upright(), { 0, 0, 1 }), { 0, 0, 1 }, -8),
    std::invalid_argument);
}

} // namespace
