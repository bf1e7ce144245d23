#include "Evaluation/SlotFit.h"
#include "PartMeshes.h"

#include <gtest/gtest.h>

namespace
{

/// A plate of 20 x 14 x 4 mm with a slot of 1.2 x 9 mm along y, its middle at the origin; the
/// fourth of x's lines may be moved and so may what is in the slot.
hasp::TriangleMesh Plate(double upper = 0.6, bool bridged = false)
{
  return parttest::Blocks({ -10, -0.6, upper, 10 }, { -7, -4.5, 2, 3, 4.5, 7 }, { -2, 0, 2 },
    [bridged](int i, int j, int k)
    { return i != 1 || j == 0 || j == 4 || (bridged && j == 2 && k == 1); });
}

hasp::ClaimedSlot Claim(const parttest::Motion& motion)
{
  return { motion.Place({ 0, 0, 0 }), motion.Turn({ 1, 0, 0 }), motion.Turn({ 0, 1, 0 }), 1.2,
    9.0 };
}

TEST(SlotFit, MeasuresASlotUnderAnyRotation)
{
  for (int seed = 0; seed < 8; ++seed)
  {
    const auto motion = parttest::AnyMotion(seed);
    const auto fit = hasp::FitSlot(hasp::TriangleTree(motion(Plate())), Claim(motion));
    EXPECT_NEAR(fit.leastWidthMm, 1.2, 1e-9);
    EXPECT_NEAR(fit.widthMm, 1.2, 1e-9);
    EXPECT_NEAR(fit.flatnessMm, 0.0, 1e-9);
    EXPECT_NEAR(fit.tiltDegrees, 0.0, 1e-6);
    EXPECT_NEAR(fit.offsetMm, 0.0, 1e-9);
    EXPECT_NEAR(fit.lengthMm, 8.5, 0.26); // places are 0.25 mm apart, and end as far before it
    EXPECT_NEAR(fit.guideMm, 4.0, 0.5);
    EXPECT_FALSE(fit.blockedAt);
  }
}

TEST(SlotFit, WidthPlaceAndTiltAreOfTheMeshNotOfTheClaim)
{
  for (int seed = 0; seed < 8; ++seed)
  {
    const auto motion = parttest::AnyMotion(seed);
    // One wall 0.35 mm nearer: 0.85 mm wide, its middle 0.175 mm off.
    auto fit = hasp::FitSlot(hasp::TriangleTree(motion(Plate(0.25))), Claim(motion));
    EXPECT_NEAR(fit.leastWidthMm, 0.85, 1e-9);
    EXPECT_NEAR(fit.widthMm, 0.85, 1e-9);
    EXPECT_NEAR(fit.offsetMm, 0.175, 1e-9);
    // Claimed two degrees off, about the slot's length.
    hasp::ClaimedSlot turned = Claim(motion);
    const double angle = glm::radians(2.0);
    turned.normal = motion.Turn({ std::cos(angle), 0, std::sin(angle) });
    fit = hasp::FitSlot(hasp::TriangleTree(motion(Plate())), turned);
    EXPECT_NEAR(fit.tiltDegrees, 2.0, 1e-6);
    EXPECT_NEAR(fit.widthMm, 1.2, 1e-6);
  }
}

TEST(SlotFit, SaysWhereItIsBlockedAndIfThereIsNone)
{
  const auto motion = parttest::AnyMotion(3);
  const auto bridged = hasp::FitSlot(hasp::TriangleTree(motion(Plate(0.6, true))), Claim(motion));
  ASSERT_TRUE(bridged.blockedAt);
  const glm::dvec3 at = (*bridged.blockedAt - motion.to) * motion.turn;
  EXPECT_TRUE(at.y > 2 && at.y < 3 && at.z > 0 && at.z < 2) << at.y << " " << at.z;
  EXPECT_GT(bridged.places, 0U);

  const auto solid =
    motion(parttest::Blocks({ -10, 10 }, { -7, 7 }, { -2, 2 }, [](int, int, int) { return true; }));
  EXPECT_EQ(hasp::FitSlot(hasp::TriangleTree(solid), Claim(motion)).places, 0U);
  EXPECT_TRUE(hasp::FitSlot(hasp::TriangleTree(solid), Claim(motion)).blockedAt);
  hasp::ClaimedSlot away = Claim(motion);
  away.point += motion.Turn({ 30, 0, 0 });
  EXPECT_EQ(hasp::FitSlot(hasp::TriangleTree(motion(Plate())), away).places, 0U);
  EXPECT_FALSE(hasp::FitSlot(hasp::TriangleTree(motion(Plate())), away).blockedAt);
}

TEST(SlotFit, TheWallOfAnotherPartBehindIsNoWallOfTheSlot)
{
  // Over half of its height the slot has no wall on one side, but a block 1.4 mm behind.
  const auto motion = parttest::AnyMotion(2);
  const auto block = motion(parttest::Blocks({ -6, -0.6, 0.6, 2, 6 }, { -5, 5 }, { -2, 1, 2 },
    [](int i, int, int k) { return i == 0 || i == 3 || (i == 2 && k == 0); }));
  hasp::ClaimedSlot claim{ motion.to, motion.Turn({ 1, 0, 0 }), motion.Turn({ 0, 1, 0 }), 1.2,
    8.0 };
  const auto fit = hasp::FitSlot(hasp::TriangleTree(block), claim);
  EXPECT_NEAR(fit.widthMm, 1.2, 1e-6);
  EXPECT_NEAR(fit.leastWidthMm, 1.2, 1e-6);
  EXPECT_LT(fit.tiltDegrees, 1e-4);
  EXPECT_LT(fit.flatnessMm, 1e-6);
}

} // namespace
