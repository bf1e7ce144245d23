#include "CutFixture.h"
#include "PlanFragmentLabels.h"
#include "Planning/PlanEdits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

using namespace cuttest;
using namespace hasp;

namespace
{

constexpr double Disc = M_PI * 36.0;              // of the bar's section, mm2
constexpr double End = 2.0 / 3.0 * M_PI * 216.0;  // half a ball, mm3
constexpr double Whole = Disc * 40.0 + 2.0 * End; // mm3
const std::string SomeHash(64, 'a');

PlanFragment FragmentOf(FragmentSource source)
{
  PlanFragment fragment;
  fragment.source = std::move(source);
  return fragment;
}

/// volume 1, the bar; bone 2 of it; cut 3 across it at 0, pieces 4 (left) and 5; cut 6 across 5 at
/// 10, pieces 7 and 8; segmentation 9: label 1 is what is right of -10, label 2 the rest; bones 10
/// and 11 are these; volume 12, bone 13 of it; surface 14, fragment 15 of it.
struct Bar
{
  Plan plan;
  BoneScan scan = ScanOfBar();
  std::vector<std::uint16_t> labels = std::vector<std::uint16_t>(scan.samples.size());

  Bar()
  {
    const auto blade = [](double x) {
      return Osteotomy{ { x, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 30.0, 30.0, 1.0 };
    };
    this->Add(PlanVolume{ 0, "", SomeHash });
    this->Add(FragmentOf(ComponentSource{ 1, 226.0, { 3, 0, 0 }, 0.8 }));
    this->Add(PlanCut{ 0, "", blade(0), { 2 } });
    this->Add(FragmentOf(PieceSource{ 2, { -10, 0, 0 } }));
    this->Add(FragmentOf(PieceSource{ 2, { 10, 0, 0 } }));
    this->Add(PlanCut{ 0, "", blade(10), { 5 } });
    this->Add(FragmentOf(PieceSource{ 5, { 5, 0, 0 } }));
    this->Add(FragmentOf(PieceSource{ 5, { 15, 0, 0 } }));
    this->Add(PlanSegmentation{ 0, "", 1, SomeHash });
    this->Add(FragmentOf(LabelSource{ 9, 1, 226.0, 0.5 }));
    this->Add(FragmentOf(LabelSource{ 9, 2, 226.0, 0.5 }));
    this->Add(PlanVolume{ 0, "", SomeHash });
    this->Add(FragmentOf(ComponentSource{ 12, 226.0, { 0, 14, 0 }, 0.8 }));
    this->Add(PlanSurface{ 0, "", SomeHash });
    this->Add(FragmentOf(SurfaceSource{ 14 }));
    for (std::size_t s = 0; s < this->labels.size(); ++s)
      this->labels[s] = this->World(s).x > -10.0 ? 1 : 2;
  }
  template <typename T>
  PlanId Add(T object)
  {
    object.id = this->plan.nextId;
    this->plan = Apply(this->plan, AddObject<T>{ object });
    return object.id;
  }
  glm::dvec3 World(std::size_t s) const
  {
    const glm::ivec3& dims = this->scan.grid.dims;
    const int n = int(s);
    return this->scan.grid.IndexToWorld({ n % dims.x, n / dims.x % dims.y, n / dims.x / dims.y });
  }
  PlanImages Images() const
  {
    return { { 1, this->scan.View() }, { 12, this->scan.View() },
      { 9, GridView<const std::uint16_t>{ this->labels.data(), this->scan.grid } } };
  }
  PlanFragmentVoxels Find(const std::vector<PlanId>& fragments) const
  {
    return PlanFragmentLabels(this->plan, this->Images(), fragments);
  }
  double VolumeMm3(const PlanFragmentVoxels& found, int number) const
  {
    const glm::dvec3& spacing = this->scan.grid.spacing;
    return double(std::count(found.numbers.begin(), found.numbers.end(), number)) * spacing.x *
           spacing.y * spacing.z;
  }
};

std::string Refusal(const Bar& bar, const std::vector<PlanId>& fragments, const PlanImages& images)
{
  try
  {
    PlanFragmentLabels(bar.plan, images, fragments);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "nothing was refused";
}

TEST(PlanFragmentLabels, WhatHasNoVoxelsIsRefused)
{
  const Bar bar;
  EXPECT_EQ(Refusal(bar, { 2, 3 }, bar.Images()), "fragment 3: there is none");
  EXPECT_EQ(Refusal(bar, { 15 }, bar.Images()), "fragment 15: it is a surface, and has no voxels");
  EXPECT_EQ(
    Refusal(bar, { 2, 13 }, bar.Images()), "fragments 2 and 13 are of two scans, must be of one");
  EXPECT_EQ(Refusal(bar, { 2 }, {}), "volume 1 is not among those given");
  EXPECT_THROW(PlanFragmentLabels(
                 bar.plan, bar.Images(), std::vector<PlanId>{ 4 }, [](double) { return false; }),
    Cancelled);
}

TEST(PlanFragmentLabels, OneThatIsNotFoundLeavesTheOthers)
{
  Bar bar;
  const PlanId twin = bar.Add(FragmentOf(PieceSource{ 2, { -12, 0, 0 } }));
  const PlanId lost = bar.Add(FragmentOf(PieceSource{ 2, { 0, 30, 0 } }));
  const PlanFragmentVoxels found = bar.Find({ 4, twin, lost, 5 });
  EXPECT_EQ(found.faults[0], "");
  EXPECT_NE(found.faults[1].find("fragment 16: it is one piece with fragment 4"), std::string::npos)
    << found.faults[1];
  EXPECT_NE(found.faults[2].find("fragment 17: source.seed is"), std::string::npos)
    << found.faults[2];
  EXPECT_EQ(found.faults[3], "");
  EXPECT_EQ(bar.VolumeMm3(found, 2) + bar.VolumeMm3(found, 3), 0.0);
  EXPECT_GT(bar.VolumeMm3(found, 1), 1000.0);
  EXPECT_GT(bar.VolumeMm3(found, 4), 1000.0);
}

TEST(PlanFragmentLabels, ALabelMapOfAnotherGridIsAFaultOfItsFragmentsAlone)
{
  const Bar bar;
  GridGeometry other = bar.scan.grid;
  other.origin.x += 1.0;
  PlanImages images = bar.Images();
  images.insert_or_assign(9, GridView<const std::uint16_t>{ bar.labels.data(), other });
  const std::vector<PlanId> fragments{ 10, 2 };
  const PlanFragmentVoxels found = PlanFragmentLabels(bar.plan, images, fragments);
  EXPECT_TRUE(found.faults[0].starts_with("fragment 10: bone: ")) << found.faults[0];
  EXPECT_EQ(found.faults[1], "");
  EXPECT_GT(bar.VolumeMm3(found, 2), 4000.0);
  images.erase(9);
  EXPECT_EQ(PlanFragmentLabels(bar.plan, images, fragments).faults[0],
    "fragment 10: segmentation 9 is not among those given");
}

// Samples count as bone at the isovalue: what voxels at the surface have too much others lack, to 1
// % of a bar of 20 by 12 voxels; a cut's faces are off by half a voxel at most.
TEST(PlanFragmentLabels, PiecesHaveTheClosedFormsVolumes)
{
  const Bar bar;
  const double slice = Disc * 0.3; // mm3
  const PlanFragmentVoxels whole = bar.Find({ 2 });
  EXPECT_NEAR(bar.VolumeMm3(whole, 1), Whole, 0.01 * Whole);
  const PlanFragmentVoxels two = bar.Find({ 4, 5 });
  EXPECT_NEAR(bar.VolumeMm3(two, 1), Disc * 19.5 + End, 0.01 * Whole + slice);
  EXPECT_NEAR(bar.VolumeMm3(two, 2), Disc * 19.5 + End, 0.01 * Whole + slice);
  const PlanFragmentVoxels parts = bar.Find({ 7, 8 });
  EXPECT_NEAR(bar.VolumeMm3(parts, 1), Disc * 9.0, 0.01 * Whole + 2.0 * slice);
  EXPECT_NEAR(bar.VolumeMm3(parts, 2), Disc * 9.5 + End, 0.01 * Whole + slice);
}

TEST(PlanFragmentLabels, DustIsNobodys)
{
  const Bar bar;
  const PlanFragmentVoxels found = bar.Find({ 4, 5 });
  int beside = 0;
  for (std::size_t s = 0; s < found.numbers.size(); ++s)
  {
    const double x = bar.World(s).x;
    ASSERT_TRUE(found.numbers[s] != 1 || x < -0.5) << x; // half of the kerf
    ASSERT_TRUE(found.numbers[s] != 2 || x > 0.5) << x;
    beside += found.numbers[s] != 0 && std::abs(x) < 0.7;
  }
  EXPECT_GT(beside, 100);
}

// The blade's box holds the far side of the bone, too, which it must leave: a ring, cut at one side
// by a blade that reaches through both.
TEST(PlanFragmentLabels, WhatABladeLeavesWholeIsThePieces)
{
  Bar bar;
  bar.scan = ScanOf([](const glm::dvec3& p)
    { return glm::length(glm::dvec2(glm::length(glm::dvec2(p)) - 14.0, p.z)) - 4.0; },
    { 20, 20, 6 });
  bar.Add(PlanCut{ 0, "", { { 14, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, 80.0, 30.0, 1.0 }, { 13 } });
  const PlanId open = bar.Add(FragmentOf(PieceSource{ 13, { 0, 14, 0 } }));
  const PlanFragmentVoxels found = bar.Find({ open });
  ASSERT_EQ(found.faults[0], "");
  int nearSide = 0, farSide = 0;
  for (std::size_t s = 0; s < found.numbers.size(); ++s)
    if (const glm::dvec3 p = bar.World(s); std::abs(p.y) < 0.4 && std::abs(p.z) < 3.0)
      (p.x > 0.0 ? nearSide : farSide) +=
        found.numbers[s] == 1 && std::abs(std::abs(p.x) - 14.0) < 3.0;
  EXPECT_EQ(nearSide, 0);
  EXPECT_GT(farSide, 50);
}

TEST(PlanFragmentLabels, ALabelIsTheBoneUnderIt)
{
  const Bar bar;
  const PlanFragmentVoxels found = bar.Find({ 11, 10 });
  for (std::size_t s = 0; s < found.numbers.size(); ++s)
    ASSERT_EQ(found.numbers[s], bar.scan.samples[s] >= 226 ? (bar.labels[s] == 1 ? 2 : 1) : 0);
}

TEST(PlanFragmentLabels, TogetherTheyAreAsAlone)
{
  const Bar bar;
  const std::vector<PlanId> all{ 5, 11, 4 }; // 11 is within 4, and asked for before it
  const PlanFragmentVoxels together = bar.Find(all);
  std::vector<std::uint16_t> joined(together.numbers.size());
  for (std::size_t n = 0; n < all.size(); ++n)
  {
    const PlanFragmentVoxels alone = bar.Find({ all[n] });
    for (std::size_t s = 0; s < joined.size(); ++s)
      if (alone.numbers[s] != 0)
        joined[s] = std::uint16_t(n + 1); // the later one has it
  }
  EXPECT_EQ(together.numbers, joined);
  EXPECT_EQ(bar.VolumeMm3(together, 2), 0.0);
}

TEST(PlanFragmentLabels, APieceIsOfItsWholesScan)
{
  const Bar bar;
  EXPECT_EQ(WholeOf(bar.plan, 8)->id, 2U);
  EXPECT_EQ(WholeOf(bar.plan, 10)->id, 10U);
  EXPECT_EQ(WholeOf(bar.plan, 1), nullptr);
  EXPECT_EQ(VolumeOfFragment(bar.plan, 8), 1U);
  EXPECT_EQ(VolumeOfFragment(bar.plan, 13), 12U);
  EXPECT_EQ(VolumeOfFragment(bar.plan, 10), 1U);
  EXPECT_EQ(VolumeOfFragment(bar.plan, 15), 0U);
  EXPECT_EQ(IsovalueOfFragment(bar.plan, 8), 226.0);
  EXPECT_EQ(IsovalueOfFragment(bar.plan, 15), 0.0);
  EXPECT_EQ(CutsOfPiece(bar.plan, 8), (std::vector<PlanId>{ 6, 3 }));
  EXPECT_EQ(CutsOfPiece(bar.plan, 2), std::vector<PlanId>{});
}

} // namespace
