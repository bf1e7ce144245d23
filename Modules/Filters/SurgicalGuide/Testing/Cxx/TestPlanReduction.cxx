#include "PlanReduction.h"
#include "Planning/PlanEdits.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

using namespace hasp;

namespace
{

/// A block of 30 x 22 x 30 mm, broken across at z = 0 along waves. Its upper half was scanned
/// `shift` and `turn` away from its place. Labels 1 (lower), 2 (upper), 3 (a ball far from both).
struct BrokenScan
{
  GridGeometry grid;
  std::vector<std::int16_t> grey;
  std::vector<std::uint16_t> labels;
  RigidPose displaced{ { 1.5, -1.0, 6.0 }, TurnBy({ 0.04, -0.03, 0.05 }) };

  BrokenScan()
  {
    this->grid.dims = { 70, 50, 70 };
    this->grid.spacing = { 0.7, 0.75, 0.8 };
    this->grid.origin = { -24.0, -18.0, -24.0 };
    for (int k = 0; k < this->grid.dims.z; ++k)
      for (int j = 0; j < this->grid.dims.y; ++j)
        for (int i = 0; i < this->grid.dims.x; ++i)
          this->Scan(this->grid.IndexToWorld({ i, j, k }));
  }

  PlanImages Images() const
  {
    return { { 1, GridView<const std::int16_t>{ this->grey.data(), this->grid } },
      { 2, GridView<const std::uint16_t>{ this->labels.data(), this->grid } } };
  }

private:
  static double Height(double x, double y)
  {
    return 1.5 *
           (std::sin(0.55 * x + 0.3) * std::cos(0.43 * y) + 0.5 * std::sin(0.83 * y - 0.71 * x));
  }
  /// Blurred by 0.5 mm.
  static double Share(double mm) { return 0.5 * std::erfc(mm / (std::sqrt(2.0) * 0.5)); }
  static double Half(const glm::dvec3& x, bool upper)
  {
    const glm::dvec3 q = glm::abs(x) - glm::dvec3(15.0, 11.0, 15.0);
    const double box = std::max({ q.x, q.y, q.z });
    const double step = 1e-4, height = Height(x.x, x.y);
    const glm::dvec2 slope(
      (Height(x.x + step, x.y) - height) / step, (Height(x.x, x.y + step) - height) / step);
    const double face = (x.z - height) / std::sqrt(1.0 + glm::dot(slope, slope));
    return Share(std::max(box, upper ? -face : face));
  }
  void Scan(const glm::dvec3& x)
  {
    const double shares[] = { Half(x, false), Half(this->displaced.Inverse().Place(x), true),
      Share(glm::length(x - glm::dvec3(21.0, 15.0, -20.0)) - 2.5) };
    double bone = 0.0;
    std::uint16_t label = 0;
    for (std::uint16_t n = 0; n < 3; ++n)
    {
      if (shares[n] > bone && 40.0 + 1000.0 * shares[n] >= 226.0)
        label = std::uint16_t(n + 1);
      bone = std::max(bone, shares[n]);
    }
    this->grey.push_back(std::int16_t(std::lround(40.0 + 1000.0 * bone)));
    this->labels.push_back(label);
  }
};

const BrokenScan& Scan()
{
  static const BrokenScan scan;
  return scan;
}

/// volume 1, segmentation 2, fragments 3 (lower, locked), 4 (upper), 5 (the ball).
Plan BrokenPlan(bool locked = true)
{
  Plan plan;
  const auto add = [&]<typename T>(T object)
  {
    object.id = plan.nextId;
    plan = Apply(plan, AddObject<T>{ object });
  };
  add(PlanVolume{ 0, "", std::string(64, 'a') });
  add(PlanSegmentation{ 0, "", 1, std::string(64, 'b') });
  for (std::uint32_t label = 1; label <= 3; ++label)
  {
    PlanFragment fragment;
    fragment.source = LabelSource{ 2, label, 226.0, 0.5 };
    fragment.locked = locked && label == 1;
    add(fragment);
  }
  return plan;
}

/// Where a coarse hand puts it: 2 mm and 3 degrees off.
PlanPose CoarsePose()
{
  const RigidPose truth = Scan().displaced.Inverse();
  const RigidPose off{ { 1.2, -1.0, 1.2 },
    TurnBy(glm::radians(3.0) * glm::normalize(glm::dvec3(1, 2, -1))) };
  const RigidPose pose = off * truth;
  return { pose.position, pose.orientation };
}

Plan CoarsePlan()
{
  return Apply(BrokenPlan(), PoseFragments{ { { 4, CoarsePose() } } });
}

PlanReductionSettings Few()
{
  PlanReductionSettings settings;
  settings.assembly.proposals.starts = 4;
  return settings;
}

/// Of the upper half's corners, how far the pose puts them from where they belong, mm at most.
double Off(const PlanPose& pose)
{
  double most = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 x(corner & 1 ? 15 : -15, corner & 2 ? 11 : -11, corner & 4 ? 15 : 0);
    most = std::max(most, glm::length(pose.Place(Scan().displaced.Place(x)) - x));
  }
  return most;
}

std::string ErrorOf(const Plan& plan, const PlanReductionSettings& settings)
{
  try
  {
    ReducePlan(plan, Scan().Images(), settings);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "no error";
}
} // namespace

TEST(PlanReduction, SaysWhatCannotBePutTogether)
{
  EXPECT_EQ(ErrorOf(BrokenPlan(false), Few()),
    "reduction: nothing stays where it is: lock the reference, such as the cranium, or name it");
  PlanReductionSettings settings = Few();
  settings.fragments = { 9 };
  EXPECT_EQ(ErrorOf(CoarsePlan(), settings), "reduction: object 9 is not a fragment of the plan");
  settings.fragments = { 3 };
  EXPECT_EQ(ErrorOf(CoarsePlan(), settings), "reduction: there is nothing to move");
  settings = Few();
  settings.reference = 2;
  EXPECT_EQ(
    ErrorOf(CoarsePlan(), settings), "reduction: segmentation 2 is not a fragment of the plan");
  settings.reference = 4;
  EXPECT_EQ(
    ErrorOf(Apply(CoarsePlan(), SetFragmentState{ { 4 }, FragmentState::Resected }), settings),
    "reduction: fragment 4 is resected: it is not put together");
  settings = Few();
  settings.obstacles = { 3 }; // the only one that stands
  EXPECT_NE(ErrorOf(CoarsePlan(), settings).find("nothing stays where it is"), std::string::npos);
  settings = Few();
  settings.bake.spacingMm = 9.0;
  EXPECT_NE(ErrorOf(CoarsePlan(), settings).find("spacingMm"), std::string::npos);
}

TEST(PlanReduction, PutsAFragmentWhereItBrokeOff)
{
  const Plan plan = CoarsePlan();
  EXPECT_GT(Off(CoarsePose()), 1.5);
  const PlanReduction made = ReducePlan(plan, Scan().Images(), Few());
  ASSERT_EQ(made.units.size(), 3U);
  EXPECT_EQ(made.units[0].fragments, std::vector<PlanId>{ 3 }); // fixed ones first
  EXPECT_EQ(made.units[0].assembled.turn, 0);
  EXPECT_TRUE(made.units[1].assembled.placed);
  EXPECT_FALSE(made.units[2].assembled.placed); // the ball
  EXPECT_NEAR(made.softValue, 40.0, 2.0);
  const PoseFragments edit = ReductionEdit(plan, made);
  ASSERT_EQ(edit.poses.size(), 1U);
  EXPECT_EQ(edit.poses[0].fragment, 4U);
  // Half a voxel at the farthest corner.
  EXPECT_LT(Off(edit.poses[0].scanToPlanned), 0.4);
  const Plan reduced = Apply(plan, edit); // its turn is unit, nothing is locked
  EXPECT_EQ(reduced.fragments[1].scanToPlanned, edit.poses[0].scanToPlanned);
}

TEST(PlanReduction, TakesAnotherProposalAndRefusesNone)
{
  const Plan plan = CoarsePlan();
  const PlanReduction made = ReducePlan(plan, Scan().Images(), Few());
  EXPECT_THROW(ReductionEdit(plan, made, { 0, 40 }), std::invalid_argument);
}

TEST(PlanReduction, MovesAGroupAsOne)
{
  Plan plan = CoarsePlan();
  plan = Apply(plan, AddObject<PlanGroup>{ { plan.nextId, "", { 4, 5 } } });
  const PlanReduction made = ReducePlan(plan, Scan().Images(), Few());
  ASSERT_EQ(made.units.size(), 2U);
  EXPECT_EQ(made.units[1].fragments, (std::vector<PlanId>{ 4, 5 }));
  const PoseFragments edit = ReductionEdit(plan, made);
  ASSERT_EQ(edit.poses.size(), 2U);
  EXPECT_LT(Off(edit.poses[0].scanToPlanned), 0.4);
  // The ball went the same way as the half it is grouped with.
  const PlanPose before = plan.fragments[1].scanToPlanned, after = edit.poses[0].scanToPlanned;
  const glm::dvec3 ball(21.0, 15.0, -20.0), inHalf = before.PlaceBack(ball);
  EXPECT_LT(glm::length(edit.poses[1].scanToPlanned.Place(ball) - after.Place(inHalf)), 1e-9);
}

TEST(PlanReduction, LeavesOutWhatIsNotAskedFor)
{
  PlanReductionSettings settings = Few();
  settings.fragments = { 4 };
  const PlanReduction made = ReducePlan(CoarsePlan(), Scan().Images(), settings);
  EXPECT_EQ(made.fragments, (std::vector<PlanId>{ 3, 4 })); // the ball was not even baked
  EXPECT_EQ(made.bodies.size(), 2U);
}

TEST(PlanReduction, IsNotDrawnToObstacles)
{
  // The lower half as another bone, and the ball as what the upper one belongs to: far away.
  PlanReductionSettings settings = Few();
  settings.obstacles = { 3 };
  settings.reference = 5;
  const PlanReduction made = ReducePlan(CoarsePlan(), Scan().Images(), settings);
  EXPECT_TRUE(ReductionEdit(CoarsePlan(), made).poses.empty());
}
