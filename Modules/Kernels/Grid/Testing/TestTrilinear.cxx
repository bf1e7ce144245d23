#include "Grid/Trilinear.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

namespace
{

TEST(Trilinear, ReproducesATrilinearPolynomialAndItsGradient)
{
  // x y z + 2 x y - 3 z + 5 is trilinear: interpolation is exact.
  const auto f = [](const glm::dvec3& p) { return p.x * p.y * p.z + 2 * p.x * p.y - 3 * p.z + 5; };
  const hasp::GridGeometry g{ { 5, 6, 7 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  std::vector<float> samples(g.Size());
  const hasp::GridView<float> write{ samples.data(), g };
  for (int k = 0; k < 7; ++k)
    for (int j = 0; j < 6; ++j)
      for (int i = 0; i < 5; ++i)
        write(i, j, k) = static_cast<float>(f({ i, j, k }));
  const hasp::GridView<const float> grid{ samples.data(), g };

  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int n = 0; n < 1000; ++n)
  {
    const glm::dvec3 p = glm::dvec3(unit(random), unit(random), unit(random)) * glm::dvec3(4, 5, 6);
    EXPECT_NEAR(*SampleTrilinear(grid, p), f(p), 1e-10);
    const auto at = LocateCell(g, p);
    const glm::dvec3 gradient = hasp::TrilinearGradient(CellCorners(grid, at->cell), at->local);
    EXPECT_NEAR(gradient.x, p.y * p.z + 2 * p.y, 1e-10);
    EXPECT_NEAR(gradient.y, p.x * p.z + 2 * p.x, 1e-10);
    EXPECT_NEAR(gradient.z, p.x * p.y - 3, 1e-10);
  }
}

TEST(Trilinear, NeighbourCellsAgreeBitForBitOnTheirFace)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1e3, 1e3), unit(0, 1);
  for (int n = 0; n < 1000; ++n)
  {
    std::array<double, 8> left{}, right{};
    for (int c = 0; c < 8; ++c)
    {
      left[c] = any(random);
      right[c] = any(random);
    }
    for (int c = 0; c < 8; c += 2)
      right[c] = left[c + 1]; // the face x = 1 of left is x = 0 of right
    const double y = unit(random), z = unit(random);
    EXPECT_EQ(hasp::TrilinearValue(left, { 1, y, z }), hasp::TrilinearValue(right, { 0, y, z }));
  }
}

TEST(Trilinear, OutsideAndNotFiniteIsNothing)
{
  const hasp::GridGeometry g{ { 3, 3, 3 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(hasp::LocateCell(g, { 0, 0, 0 }));
  EXPECT_TRUE(hasp::LocateCell(g, { 2, 2, 2 }));
  EXPECT_FALSE(hasp::LocateCell(g, { 2.0000001, 1, 1 }));
  EXPECT_FALSE(hasp::LocateCell(g, { -0.0000001, 1, 1 }));
  EXPECT_FALSE(hasp::LocateCell(g, { nan, 1, 1 }));
  const hasp::GridGeometry flat{ { 3, 3, 1 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  EXPECT_FALSE(hasp::LocateCell(flat, { 1, 1, 0 }));
}

} // namespace
