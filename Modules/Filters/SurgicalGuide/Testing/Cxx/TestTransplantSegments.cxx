#include "CutFixture.h"
#include "Evaluation/MeshCheck.h"
#include "Grid/Phantom.h"
#include "TransplantSegments.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace cuttest;

namespace
{

/// A box of 12 x 8 mm (x, y), 120 mm long: a donor with a closed form.
constexpr double HalfX = 6.0, HalfY = 4.0, HalfZ = 60.0;

double BoxDistance(const glm::dvec3& p)
{
  const glm::dvec3 out = glm::abs(p) - glm::dvec3(HalfX, HalfY, HalfZ);
  return glm::length(glm::max(out, glm::dvec3(0))) +
         std::min(std::max({ out.x, out.y, out.z }), 0.0);
}

BoneScan ScanOfDonor()
{
  return ScanOf(BoxDistance, { 28, 30, 70 }, glm::dvec3(1), 0.2);
}

/// Two segments of 30 and 25 mm round a corner in the defect, on a plane of slant.
hasp::Transplant Plan()
{
  hasp::Transplant t;
  const double bend = 0.6; // radians
  t.joints = hasp::MitreJoints(std::vector<glm::dvec3>{ { 10, 20, -30 }, { 40, 20, -30 },
    { 40 + 25 * std::cos(bend), 20 + 25 * std::sin(bend), -30 } });
  t.outward = { { 0, 0, 1 }, { 0, 0, 1 } };
  t.donor.axis = { { 0, 0, -HalfZ }, { 0, 0, HalfZ } };
  t.donor.lateral = { 1, 0, 0 };
  t.donor.radiusMm = 7.3; // half the diagonal of its section: 7.211
  t.donor.keepMm = 10.0;
  return t;
}

hasp::TransplantSegments Donor(const BoneScan& scan)
{
  return { { scan.View(), {}, 1 }, Plan().donor, { 226.0, 0.5, 100.0 } };
}

TEST(TransplantSegments, WhatCannotBeCutIsNamed)
{
  const BoneScan scan = ScanOfDonor();
  hasp::DonorBone donor = Plan().donor;
  EXPECT_THROW(hasp::TransplantSegments({ scan.View(), {}, 1 }, donor, { 226.0, 5.0, 100.0 }),
    std::invalid_argument);
  donor.axis = { { 20, 0, -60 }, { 20, 0, 60 } };
  EXPECT_THROW(hasp::TransplantSegments({ scan.View(), {}, 1 }, donor), std::invalid_argument);
  hasp::TransplantSegments segments = Donor(scan);
  hasp::Transplant plan = Plan();
  ASSERT_EQ(segments.Place(plan).size(), 2U);
  plan.donor.keepMm = 40.0;
  EXPECT_THROW(segments.Place(plan), std::runtime_error); // too short
  plan = Plan();
  plan.donor.axis[0].z += 400.0;
  plan.donor.axis[1].z += 400.0;
  EXPECT_THROW(segments.Place(plan), std::runtime_error); // no bone there
  EXPECT_THROW(hasp::MeasureJoint({}, {}, {}, 0.0), std::invalid_argument);
}

TEST(TransplantSegments, ABoxHasTheClosedFormsLengthsAndWedges)
{
  const BoneScan scan = ScanOfDonor();
  const hasp::Transplant plan = Plan();
  hasp::TransplantSegments donor = Donor(scan);
  const auto& segments = donor.Place(plan);
  ASSERT_EQ(segments.size(), 2U);
  const double lengths[] = { 30.0, 25.0 };
  for (std::size_t n = 0; n < 2; ++n)
  {
    const hasp::PlacedSegment& segment = segments[n];
    EXPECT_NEAR(segment.cut.lengthMm, lengths[n], 1e-9);
    EXPECT_NEAR(segment.cut.wedgeRadians, 0.3, 1e-9); // half of the bend
    EXPECT_TRUE(hasp::CheckMesh(segment.mesh).Sound());
    // The mitre takes as much from one side as it adds on the other. Samples of 1 mm round the
    // box's edges by some 0.3 mm: 4 (1 - pi / 4) 0.3^2 of 96 mm2, and coverage knows 0.05 mm.
    EXPECT_NEAR(segment.volumeMm3 / (4.0 * HalfX * HalfY * lengths[n]), 1.0, 1e-2);
    // Nothing lies beyond the joints' planes, but for crossings near points of the contour's grid,
    // which keep a hundredth of an edge (0.5 sqrt(3) mm) from them, and for the four corners of
    // either end, which may be 0.16 of a cell off (SharpContour.h).
    std::size_t corners = 0;
    for (const glm::dvec3& p : segment.mesh.points)
    {
      const double beyond = std::max(-glm::dot(p - plan.joints[n].point, plan.joints[n].normal),
        glm::dot(p - plan.joints[n + 1].point, plan.joints[n + 1].normal));
      corners += beyond >= 0.01 * 0.5 * std::sqrt(3.0) ? 1 : 0;
      EXPECT_LT(beyond, 0.16 * 0.5);
    }
    EXPECT_LE(corners, 8U);
    // Along its sides, y across the bend: 4 mm from the axis, tilted by 0.3 at one end.
    const glm::dvec3 from = plan.joints[n].point,
                     along = glm::normalize(plan.joints[n + 1].point - from);
    const glm::dvec3 across = glm::cross(glm::dvec3(0, 0, 1), along);
    double shortest = 1e30, longest = -1e30;
    for (const double side : { -3.5, 3.5 })
    {
      double low = 1e30, high = -1e30; // of the faces' points beside that line
      for (const glm::dvec3& p : segment.mesh.points)
        for (const std::size_t joint : { n, n + 1 })
        {
          const hasp::TransplantJoint& plane = plan.joints[joint];
          if (std::abs(glm::dot(p - plane.point, plane.normal)) > 1e-3)
            continue;
          // Slide along the face's plane, which is what it is for.
          const double s = glm::dot(p - from, across), t = glm::dot(p - from, along);
          const double slope = -glm::dot(plane.normal, across) / glm::dot(plane.normal, along);
          (joint == n ? low : high) = t + slope * (side - s);
        }
      shortest = std::min(shortest, high - low);
      longest = std::max(longest, high - low);
    }
    EXPECT_NEAR(shortest, lengths[n] - 3.5 * std::tan(0.3), 2e-3);
    EXPECT_NEAR(longest, lengths[n] + 3.5 * std::tan(0.3), 2e-3);
  }
}

TEST(TransplantSegments, OnlyWhatMovedIsCutAgain)
{
  const BoneScan scan = ScanOfDonor();
  hasp::TransplantSegments donor = Donor(scan);
  hasp::Transplant plan = Plan();
  donor.Place(plan);
  EXPECT_EQ(donor.LastCut(), 2U);
  const auto before = donor.Place(plan)[0].mesh.points;
  EXPECT_EQ(donor.LastCut(), 0U);
  plan.joints[2].point.x += 2.0;
  EXPECT_EQ(donor.Place(plan)[0].mesh.points, before);
  EXPECT_EQ(donor.LastCut(), 1U);
  plan.joints[2].normal = { 3, 0, 0 };
  EXPECT_THROW(donor.Place(plan), std::invalid_argument);
  EXPECT_EQ(donor.LastCut(), 1U);
}

TEST(TransplantSegments, JointsMeetOnTheirPlaneAndStepsGapsAndOverlapsAreMeasured)
{
  const BoneScan scan = ScanOfDonor();
  hasp::TransplantSegments donor = Donor(scan);
  const hasp::Transplant plan = Plan();
  const auto segments = donor.Place(plan);
  const double section = 4.0 * HalfX * HalfY / std::cos(0.3);
  const hasp::TransplantJoint& joint = plan.joints[1];
  hasp::JointFit fit = hasp::MeasureJoint(joint, segments[0].mesh, segments[1].mesh, 15.0);
  // Columns of 0.25 mm: 1 % of the section for each 0.06 mm of its rim.
  EXPECT_NEAR(fit.contactMm2 / section, 1.0, 0.03);
  EXPECT_LT(fit.gapMm2 + fit.overlapMm2 + fit.stepMm2, 0.05 * section); // rounded edges
  const auto moved = [&](const glm::dvec3& by)
  {
    hasp::TriangleMesh mesh = segments[1].mesh;
    for (glm::dvec3& p : mesh.points)
      p += by;
    return hasp::MeasureJoint(joint, segments[0].mesh, mesh, 15.0);
  };
  fit = moved(0.8 * joint.normal);
  EXPECT_NEAR(fit.gapMm2 / section, 1.0, 0.06);
  EXPECT_NEAR(fit.gapMm3 / fit.gapMm2, 0.8, 0.02);
  EXPECT_EQ(fit.overlapMm2, 0.0);
  fit = moved(-0.5 * joint.normal);
  EXPECT_NEAR(fit.overlapMm3 / fit.overlapMm2, 0.5, 0.02);
  EXPECT_LT(fit.contactMm2, 0.03 * section);
  fit = moved({ 0, 0, 3.0 }); // along the donor's x: 3 of its 12 mm on each side
  EXPECT_NEAR(fit.contactMm2 / section, 0.75, 0.03);
  EXPECT_NEAR(fit.stepMm2 / section, 0.5, 0.05);
}

class PhantomTransplant : public testing::Test
{
protected:
  PhantomTransplant()
  {
    this->settings.anatomy = hasp::PhantomAnatomy::HeadAndFibula;
    for (int n = -17; n <= 17; ++n) // the fibula's bow: 5 mm forward in the middle of 340 mm
      this->plan.donor.axis.push_back(glm::dvec3(150.0, -5.0 * (1.0 - n * n / 289.0), 10.0 * n));
    this->plan.donor.lateral = { 1, 0, 0 };
    const hasp::HorseshoeShape arch{ { 0, -58, -96 }, 22.0, 1.08, 61.0, 5.0, 5.5 }; // of the jaw
    this->plan.joints = hasp::MitreJoints(
      std::vector<glm::dvec3>{ arch.PointAt(-40.0), arch.PointAt(-14.0), arch.PointAt(14.0) });
    this->plan.outward = { { 0, 0, 1 }, { 0, 0, 1 } };
  }
  /// A part of that world.
  BoneScan Scan(const glm::ivec3& dims, const glm::dvec3& origin, const glm::dvec3& spacing)
  {
    BoneScan scan;
    scan.grid = { dims, origin, spacing, glm::dmat3(1) };
    scan.samples = hasp::SamplePhantom(scan.grid, this->settings);
    return scan;
  }

  hasp::PhantomSettings settings;
  hasp::Transplant plan;
};

TEST_F(PhantomTransplant, TheFibulaFillsTheMandibleThatWasResected)
{
  const BoneScan leg = this->Scan({ 23, 23, 180 }, { 138, -16, -179 }, { 1.1, 1.1, 2.0 });
  hasp::TransplantSegments donor({ leg.View(), {}, 1 }, this->plan.donor, { 226.0, 0.8, 100.0 });
  const auto& segments = donor.Place(this->plan);
  ASSERT_EQ(segments.size(), 2U);
  EXPECT_GE(segments[0].cut.fromMm, 75.0);
  for (const hasp::PlacedSegment& segment : segments)
  {
    EXPECT_TRUE(hasp::CheckMesh(segment.mesh).Sound());
    // A shaft of about 1.4 to 1.8 cm2 of bone and canal.
    EXPECT_GT(segment.volumeMm3, 60.0 * segment.cut.lengthMm);
    EXPECT_LT(segment.volumeMm3, 250.0 * segment.cut.lengthMm);
  }
  const auto& joints = this->plan.joints;
  const hasp::JointFit middle =
    hasp::MeasureJoint(joints[1], segments[0].mesh, segments[1].mesh, 20.0);
  EXPECT_GT(middle.contactMm2, 10.0 * (middle.stepMm2 + middle.gapMm2 + middle.overlapMm2));

  // The jaw is sawn within the defect, so that its stumps end at the first and last joint.
  const BoneScan head = this->Scan({ 105, 89, 67 }, { -62, -92, -108 }, glm::dvec3(1.2));
  const double kerf = 1.5;
  hasp::CutRecipe recipe;
  recipe.spacingMm = 1.0;
  for (const int n : { 0, 2 })
    recipe.cuts.push_back({ { joints[n].point + (n == 0 ? 0.5 : -0.5) * kerf * joints[n].normal,
                              joints[n].normal, { 0, 0, 1 }, 50.0, 60.0, kerf },
      8.0 });
  const hasp::CutBone jaw = hasp::CutFragments({ head.View(), {}, 1 }, recipe);
  ASSERT_TRUE(jaw.cuts[0].parted && jaw.cuts[1].parted);
  const auto stump = [&](const std::vector<int>& numbers) -> const hasp::TriangleMesh&
  { return jaw.fragments[std::size_t(numbers.at(0) - 1)].mesh; };
  const hasp::TriangleMesh& right = stump(jaw.cuts[0].back);
  const hasp::TriangleMesh& left = stump(jaw.cuts[1].front);
  const hasp::JointFit first = hasp::MeasureJoint(joints[0], right, segments[0].mesh, 30.0),
                       last = hasp::MeasureJoint(joints[2], segments[1].mesh, left, 30.0);
  for (const hasp::JointFit& fit : { first, last })
  {
    std::printf("jaw to fibula: contact %.0f, step %.0f, gap %.1f, overlap %.1f mm2\n",
      fit.contactMm2, fit.stepMm2, fit.gapMm2, fit.overlapMm2);
    EXPECT_GT(fit.contactMm2, 80.0);
    EXPECT_LT(fit.gapMm2 + fit.overlapMm2, 0.05 * fit.contactMm2);
  }
  // What each face has is in contact or a step, and the jaw's is what the saw went through.
  const double jawFace = hasp::MeasureJoint(joints[0], right, {}, 30.0).stepMm2,
               face = hasp::MeasureJoint(joints[0], {}, segments[0].mesh, 30.0).stepMm2;
  EXPECT_NEAR(2.0 * (first.contactMm2 + first.gapMm2 + first.overlapMm2) + first.stepMm2,
    jawFace + face, 1e-6);
  EXPECT_NEAR(jawFace / jaw.cuts[0].areaMm2, 1.0, 0.05);
}

} // namespace
