#include "BrokenBlock.h"

#include "Reduction/FitProposals.h"

#include <gtest/gtest.h>

TEST(FitProposals, RefuseSettingsOutOfRange)
{
  const Halves h{ BrokenBlock{} };
  hasp::ProposalSettings settings;
  settings.starts = 0;
  EXPECT_THROW(hasp::ProposeFits(h.moved, {}, h.scene, settings), std::invalid_argument);
  settings = {};
  settings.startMm = -1.0;
  EXPECT_THROW(hasp::ProposeFits(h.moved, {}, h.scene, settings), std::invalid_argument);
  EXPECT_THROW(hasp::ProposeFits({}, {}, h.scene), std::invalid_argument);
}

TEST(FitProposals, FindTheTruthFromFartherThanOneFitDoes)
{
  const Halves h{ BrokenBlock{} };
  hasp::ProposalSettings settings;
  settings.startMm = 6.0;
  settings.startDegrees = 10.0;
  settings.starts = 32;
  const hasp::RigidPose start = Moved(h.upper.bodyInWorld, { 4.0, -3.0, 2.0 }, { 1, 1, 1 }, 8.0);
  const hasp::FitProposals found = hasp::ProposeFits(h.moved, start, h.scene, settings);
  ASSERT_FALSE(found.proposals.empty());
  const double off =
    hasp::RmsWay(h.moved, h.upper.bodyInWorld, found.proposals[0].fit.groupInWorld);
  EXPECT_LT(off, 0.05);
  EXPECT_LE(off, found.within95Mm);
  double shares = 0.0;
  for (std::size_t n = 0; n < found.proposals.size(); ++n)
  {
    shares += found.proposals[n].share;
    if (n > 0)
      EXPECT_LE(found.proposals[n].share, found.proposals[n - 1].share);
  }
  EXPECT_NEAR(shares, 1.0, 1e-12);
}

TEST(FitProposals, AreTheSameEachTime)
{
  const Halves h{ BrokenBlock{} };
  hasp::ProposalSettings settings;
  settings.starts = 6;
  const auto a = hasp::ProposeFits(h.moved, h.upper.bodyInWorld, h.scene, settings, 5);
  const auto b = hasp::ProposeFits(h.moved, h.upper.bodyInWorld, h.scene, settings, 5);
  ASSERT_EQ(a.proposals.size(), b.proposals.size());
  for (std::size_t n = 0; n < a.proposals.size(); ++n)
    EXPECT_EQ(a.proposals[n].fit.groupInWorld, b.proposals[n].fit.groupInWorld);
  EXPECT_EQ(a.within95Mm, b.within95Mm);
}

TEST(FitProposals, AFlatFaceOnAWiderOneIsWideOpen)
{
  const Halves h{ BrokenBlock{ .wave = 0.0, .wider = 12.0 } };
  hasp::ProposalSettings settings;
  settings.starts = 12;
  const auto found = hasp::ProposeFits(h.moved, h.upper.bodyInWorld, h.scene, settings);
  ASSERT_FALSE(found.proposals.empty());
  EXPECT_GT(found.within95Mm, 1.0);
}

TEST(FitProposals, AreNoneWhereNothingIsInReach)
{
  const Halves h{ BrokenBlock{} };
  const hasp::RigidPose far = Moved(h.upper.bodyInWorld, { 0, 0, 100.0 }, { 1, 0, 0 }, 0.0);
  EXPECT_TRUE(hasp::ProposeFits(h.moved, far, h.scene).proposals.empty());
}

TEST(FitProposals, StopWhenTheyAreCancelled)
{
  const Halves h{ BrokenBlock{} };
  EXPECT_THROW(
    hasp::ProposeFits(h.moved, h.upper.bodyInWorld, h.scene, {}, 1, [](double) { return false; }),
    hasp::Cancelled);
}
