#include "Reduction/BakeFitBody.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace
{
/// A ball of 8 mm, label 3, blurred by 0.5 mm; in shares.
struct Ball
{
  hasp::GridGeometry grid;
  hasp::BoneShares shares;

  Ball()
  {
    this->grid.dims = { 30, 34, 26 };
    this->grid.spacing = { 0.8, 0.7, 0.9 };
    this->grid.origin = { -11.6, -11.55, -11.25 };
    for (int k = 0; k < this->grid.dims.z; ++k)
      for (int j = 0; j < this->grid.dims.y; ++j)
        for (int i = 0; i < this->grid.dims.x; ++i)
        {
          const double r = glm::length(this->grid.IndexToWorld({ i, j, k }));
          this->shares.shares.push_back(float(0.5 * std::erfc((r - 8.0) / (std::sqrt(2.0) * 0.5))));
          this->shares.labels.push_back(this->shares.shares.back() >= 0.5F ? 3 : 0);
        }
  }
};
} // namespace

TEST(BakeFitBody, RefusesWhatItCannotUse)
{
  const Ball ball;
  EXPECT_THROW(hasp::BakeFitBody(ball.grid, ball.shares, 4), std::runtime_error);
  EXPECT_THROW(hasp::BakeFitBody(ball.grid, ball.shares, 0), std::runtime_error);
  EXPECT_THROW(
    hasp::BakeFitBody(ball.grid, ball.shares, 3, { .spacingMm = 0.0 }), std::invalid_argument);
  EXPECT_THROW(
    hasp::BakeFitBody(ball.grid, ball.shares, 3, { .rangeMm = 100.0 }), std::invalid_argument);
  EXPECT_THROW(
    hasp::BakeFitBody(ball.grid, ball.shares, 3, { .mostSamples = 1000 }), std::invalid_argument);
  hasp::BoneShares fewer = ball.shares;
  fewer.labels.pop_back();
  EXPECT_THROW(hasp::BakeFitBody(ball.grid, fewer, 3), std::invalid_argument);
}

TEST(BakeFitBody, HasTheSurfaceWhereSharesAreHalf)
{
  const Ball ball;
  const hasp::BakedFitBody baked = hasp::BakeFitBody(ball.grid, ball.shares, 3);
  // The blur takes 0.03 mm of a ball of this size; the grid errs by some hundredths besides.
  for (const hasp::OrientedPoint& p : baked.body->Points(100'000))
  {
    const glm::dvec3 world = baked.origin + p.place;
    EXPECT_NEAR(glm::length(world), 8.0, 0.1);
    EXPECT_GT(glm::dot(glm::normalize(world), p.normal), 0.98);
  }
  EXPECT_NEAR(baked.body->SurfaceArea(), 4.0 * M_PI * 64.0, 0.03 * 4.0 * M_PI * 64.0);
  const auto foot = baked.body->FootOf(glm::dvec3(12.0, 0.0, 0.0) - baked.origin);
  ASSERT_TRUE(foot.has_value());
  EXPECT_NEAR(foot->mm, 4.0, 0.1);
  EXPECT_GT(foot->outward.x, 0.98);
  EXPECT_FALSE(baked.body->FootOf(glm::dvec3(40.0, 0.0, 0.0) - baked.origin).has_value());
}
