#include "Grid/GridGeometry.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

namespace
{

hasp::GridGeometry Oblique()
{
  // Rotated by 30 degrees about z, then rows flipped: determinant -1.
  const double c = std::cos(0.5235987755982988), s = 0.5;
  return { { 7, 9, 11 }, { -12.5, 40.0, 3.25 }, { 0.3, 0.957, 3.0 },
    glm::dmat3(glm::dvec3(c, s, 0), -glm::dvec3(-s, c, 0), glm::dvec3(0, 0, 1)) };
}

TEST(GridGeometry, WorldAndIndexAreInverse)
{
  const hasp::GridGeometry g = Oblique();
  ASSERT_NO_THROW(g.Validate());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-100, 100);
  for (int n = 0; n < 1000; ++n)
  {
    const glm::dvec3 index(any(random), any(random), any(random));
    // Double rounding of coordinates below 1000 mm.
    EXPECT_LT(glm::length(g.WorldToIndex(g.IndexToWorld(index)) - index), 1e-11);
  }
}

TEST(GridGeometry, GradientToWorldMatchesFiniteDifference)
{
  // f(world) = a . world has world gradient a, whatever the grid.
  const hasp::GridGeometry g = Oblique();
  const glm::dvec3 a(0.3, -2.0, 5.0);
  const auto f = [&](const glm::dvec3& index) { return glm::dot(a, g.IndexToWorld(index)); };
  const glm::dvec3 at(1, 2, 3);
  const glm::dvec3 perStep(f(at + glm::dvec3(1, 0, 0)) - f(at), f(at + glm::dvec3(0, 1, 0)) - f(at),
    f(at + glm::dvec3(0, 0, 1)) - f(at));
  EXPECT_LT(glm::length(g.GradientToWorld(perStep) - a), 1e-12);
}

TEST(GridGeometry, ValidateNamesTheFault)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  hasp::GridGeometry g = Oblique();
  g.spacing.y = 0.0;
  EXPECT_THROW(g.Validate(), std::invalid_argument);
  g = Oblique();
  g.spacing.x = nan;
  EXPECT_THROW(g.Validate(), std::invalid_argument);
  g = Oblique();
  g.origin.z = std::numeric_limits<double>::infinity();
  EXPECT_THROW(g.Validate(), std::invalid_argument);
  g = Oblique();
  g.direction[2] = { 0, 0.1, 1 };
  EXPECT_THROW(g.Validate(), std::invalid_argument);
  g = Oblique();
  g.dims.x = 0;
  try
  {
    g.Validate();
    FAIL() << "dims 0 accepted";
  }
  catch (const std::invalid_argument& e)
  {
    EXPECT_NE(std::string(e.what()).find("dims[0] is 0"), std::string::npos) << e.what();
  }
}

TEST(GridGeometry, SizeIsComputedIn64Bits)
{
  hasp::GridGeometry g{ { 4096, 4096, 4096 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  EXPECT_EQ(g.Size(), std::size_t{ 1 } << 36);
  g.dims = glm::ivec3(1 << 22); // 2^66 would wrap round to a small volume
  EXPECT_THROW(g.Validate(), std::invalid_argument);
}

} // namespace
