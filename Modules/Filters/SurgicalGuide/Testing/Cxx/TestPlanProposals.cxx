// Pieces and middle lines that a plan is offered, against closed forms.
#include "CutFixture.h"
#include "PlanProposals.h"
#include "Planning/PlanEdits.h"
#include "TransplantFixture.h"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>

using namespace hasp;

namespace
{

constexpr double Disc = M_PI * 36.0; // of the bar's section, mm2
constexpr double End = 2.0 / 3.0 * M_PI * 216.0;

template <typename T>
PlanId Add(Plan& plan, T object)
{
  object.id = plan.nextId;
  plan = Apply(plan, AddObject<T>{ object });
  return object.id;
}

template <typename Source>
PlanFragment FragmentOf(const Source& source)
{
  PlanFragment fragment;
  fragment.source = source;
  return fragment;
}

PlanCut CutAt(double x, PlanId fragment, double sizeMm = 30.0)
{
  PlanCut cut;
  cut.blade = { { x, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, sizeMm, sizeMm, 1.0 };
  cut.fragments = { fragment };
  return cut;
}

/// volume 1, the bar; bone 2; cuts 3 at -8 and 4 at 8.
Plan BarInThree()
{
  Plan plan;
  Add(plan, PlanVolume{ 0, "", std::string(64, 'a') });
  Add(plan, FragmentOf(ComponentSource{ 1, 226.0, { 3, 0, 0 }, 0.5 }));
  Add(plan, CutAt(-8, 2));
  Add(plan, CutAt(8, 2));
  return plan;
}

std::string Refusal(const std::function<void()>& act)
{
  try
  {
    act();
    return {};
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
}

TEST(PlanProposals, WhatCannotBeCutIsNamed)
{
  const auto bar = cuttest::ScanOfBar();
  const PlanImages images{ { 1, bar.View() } };
  Plan plan;
  Add(plan, PlanVolume{ 0, "", std::string(64, 'a') });
  Add(plan, FragmentOf(ComponentSource{ 1, 226.0, { 3, 0, 0 }, 0.5 }));
  const auto pieces = [&](PlanId of) { return Refusal([&] { ProposePieces(plan, images, of); }); };
  EXPECT_EQ(pieces(2), "fragment 2: no cut goes through it");
  EXPECT_EQ(pieces(7), "fragment 7: there is none");
  const PlanId cut = Add(plan, CutAt(25.9 + 30.0, 2)); // beyond the bar's end
  EXPECT_NE(pieces(2).find("cut " + std::to_string(cut)), std::string::npos) << pieces(2);
  EXPECT_NE(Refusal(
              [&] {
                ProposeDonorAxis(plan, images, 2, { glm::dvec3(0), glm::dvec3(1) }, 9);
              })
              .find("fragment 2: donor axis: the tips"),
    std::string::npos);
}

TEST(PlanProposals, TwoCutsLeaveThreePiecesFarFromThem)
{
  const auto bar = cuttest::ScanOfBar();
  const PlanImages images{ { 1, bar.View() } };
  Plan plan = BarInThree();
  const ProposedPieces found = ProposePieces(plan, images, 2);
  ASSERT_EQ(found.cuts.size(), 2U);
  EXPECT_TRUE(found.cuts[0].measure.parted && found.cuts[1].measure.parted);
  ASSERT_EQ(found.pieces.size(), 3U);
  double leastX = 0.0, mostX = 0.0;
  int inner = 0;
  for (const ProposedPiece& piece : found.pieces)
  {
    EXPECT_EQ(piece.fragment, 0U);
    EXPECT_FALSE(piece.crumb);
    leastX = std::min(leastX, piece.seed.x);
    mostX = std::max(mostX, piece.seed.x);
    const bool middle = std::abs(piece.seed.x) < 8.0;
    inner += middle;
    // 1 %: meshes of half a millimetre of a bar of 6
    const double volume = middle ? Disc * 15.0 : Disc * 11.5 + End;
    EXPECT_NEAR(piece.volumeMm3, volume, 0.02 * volume);
    if (middle) // as far from both as from its middle
    {
      EXPECT_NEAR(piece.seed.x, 0.0, 0.5);
    }
  }
  EXPECT_EQ(inner, 1);
  EXPECT_NEAR(leastX, -26.0, 0.3); // the bar's ends
  EXPECT_NEAR(mostX, 26.0, 0.3);
  // As pieces of the plan they are found again, and can be made.
  for (const ProposedPiece& piece : found.pieces)
    Add(plan, FragmentOf(PieceSource{ 2, piece.seed }));
  const ProposedPieces again = ProposePieces(plan, images, 2);
  PlanRebuild rebuild(plan, images);
  for (std::size_t n = 0; n < 3; ++n)
  {
    EXPECT_EQ(again.pieces[n].fragment, PlanId(5 + n));
    EXPECT_NEAR(rebuild.Make(PlanId(5 + n)).volumeMm3, found.pieces[n].volumeMm3, 1e-6);
  }
}

TEST(PlanProposals, APieceThatIsCutOnHasItsOwnPiecesAlone)
{
  const auto bar = cuttest::ScanOfBar();
  const PlanImages images{ { 1, bar.View() } };
  Plan plan = BarInThree();
  const PlanId right = Add(plan, FragmentOf(PieceSource{ 2, { 20, 0, 0 } }));
  Add(plan, CutAt(16, right));
  const ProposedPieces found = ProposePieces(plan, images, right);
  ASSERT_EQ(found.pieces.size(), 2U);
  for (const ProposedPiece& piece : found.pieces)
    EXPECT_GT(piece.seed.x, 8.4);
  EXPECT_EQ(found.cuts.size(), 3U);
}

TEST(PlanProposals, ACutThatDoesNotPartSaysSo)
{
  const auto bar = cuttest::ScanOfBar();
  Plan plan;
  Add(plan, PlanVolume{ 0, "", std::string(64, 'a') });
  Add(plan, FragmentOf(ComponentSource{ 1, 226.0, { 3, 0, 0 }, 0.5 }));
  Add(plan, CutAt(0, 2, 6.0)); // as wide as the bar's radius
  const ProposedPieces found = ProposePieces(plan, { { 1, bar.View() } }, 2);
  EXPECT_EQ(found.pieces.size(), 1U);
  EXPECT_FALSE(found.cuts[0].measure.parted);
}

TEST(PlanProposals, ADonorsAxisIsItsMiddleLine)
{
  const auto leg = transplanttest::ScanOfLeg();
  Plan plan;
  Add(plan, PlanVolume{ 0, "", std::string(64, 'a') });
  Add(plan, FragmentOf(ComponentSource{ 1, 226.0, { 150, -5, 0 }, 1.0 }));
  const auto axis =
    ProposeDonorAxis(plan, { { 1, leg.View() } }, 2, { { { 150, 0, -173 }, { 150, 0, 173 } } }, 9);
  ASSERT_GT(axis.size(), 20U);
  for (std::size_t n = 1; n + 1 < axis.size(); ++n)
  {
    const double bow = -5.0 * (1.0 - axis[n].z * axis[n].z / (170.0 * 170.0));
    // The middle of a three-sided section's samples; DonorAxis promises no more.
    EXPECT_NEAR(axis[n].y, bow, 1.5);
    EXPECT_NEAR(axis[n].x, 150.0, 1.5);
  }
}

} // namespace
