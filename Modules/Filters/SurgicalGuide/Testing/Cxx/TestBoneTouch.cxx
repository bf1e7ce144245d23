// Bone under a finger, against a ball and a bar whose surfaces are known.
#include "BoneTouch.h"
#include "CutFixture.h"

#include <gtest/gtest.h>

#include <random>

using namespace hasp;

namespace
{

cuttest::BoneScan ScanOfBall()
{
  return cuttest::ScanOf([](const glm::dvec3& p) { return glm::length(p) - 10.0; }, glm::dvec3(16));
}

TEST(BoneTouch, NothingIsTouchedWhereThereIsNone)
{
  const auto ball = ScanOfBall();
  EXPECT_FALSE(TouchBone(ball.View(), 226, { 0, 0, 0 }, 3)); // in its middle
  EXPECT_FALSE(TouchBone(ball.View(), 226, { 0, 0, 14 }, 3));
  EXPECT_FALSE(TouchBone(ball.View(), 226, { 0, 0, 100 }, 3)); // beyond the scan
  EXPECT_FALSE(BoneNormal(ball.View(), { 0, 0, 100 }));
  EXPECT_FALSE(IsInBone(ball.View(), 226, { 0, 0, 100 }));
  EXPECT_FALSE(IsInBone(ball.View(), 226, { 0, 0, 11 }));
  EXPECT_TRUE(IsInBone(ball.View(), 226, { 0, 0, 9 }));
}

TEST(BoneTouch, TheNearestSurfaceAndItsNormalAreTheBalls)
{
  const auto ball = ScanOfBall();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1), radius(8, 12);
  for (int n = 0; n < 200; ++n)
  {
    const glm::dvec3 out = glm::normalize(glm::dvec3(any(random), any(random), any(random)));
    const glm::dvec3 place = radius(random) * out;
    const auto touched = TouchBone(ball.View(), 226, place, 3);
    ASSERT_TRUE(touched);
    // Trilinear in samples of 0.8 mm on a radius of 10: 0.8^2 / 8 / 10; and half of a tenth more.
    EXPECT_NEAR(glm::length(touched->place), 10.0, 0.05);
    EXPECT_LT(glm::distance(touched->place, 10.0 * out), 0.4);
    EXPECT_GT(glm::dot(touched->normal, glm::normalize(touched->place)), 0.999); // 2.6 degrees
  }
}

TEST(BoneTouch, OfTwoSurfacesItIsTheNearerOne)
{
  const auto bar = cuttest::ScanOfBar(); // of radius 6
  const auto touched = TouchBone(bar.View(), 226, { 0, 4, 0 }, 20);
  ASSERT_TRUE(touched);
  EXPECT_NEAR(touched->place.y, 6.0, 0.05);
  EXPECT_GT(touched->normal.y, 0.99);
}

TEST(BoneTouch, TheMiddleOfABoneIsHalfWayThroughIt)
{
  const auto bar = cuttest::ScanOfBar();
  const auto middle = MiddleOfBone(bar.View(), 226, { 3, 6, 0 }, { 0, -1, 0 }, 25);
  ASSERT_TRUE(middle);
  // Half of a step, of 0.15 mm, at either end.
  EXPECT_NEAR(glm::distance(*middle, glm::dvec3(3, 0, 0)), 0.0, 0.15);
  EXPECT_FALSE(MiddleOfBone(bar.View(), 226, { 3, 9, 0 }, { 0, 1, 0 }, 5));
}

} // namespace
