// The phantom's head beside its mirror image: alike but for the hole, whose place is known.
#include "MirrorGhost.h"

#include "Distance/Coverage.h"
#include "Evaluation/MeshCheck.h"
#include "ImplantFixture.h"
#include "vtkHaspMirrorFilter.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

using namespace implanttest;

namespace
{

using glm::dvec3;
using hasp::MirrorGhost;
using hasp::MirrorGhostSettings;

const Scan& Vault()
{
  static const Scan scan(1.5, 0.0);
  return scan;
}

MirrorGhostSettings AtZero(double spacingMm = 1.5)
{
  MirrorGhostSettings settings;
  settings.plane = hasp::MirrorPlane{ dvec3(0.0), { -1.0, 0.0, 0.0 } };
  settings.spacingMm = spacingMm;
  return settings;
}

std::string Refusal(const MirrorGhostSettings& settings, double isovalue = HalfWayHU)
{
  try
  {
    hasp::MakeMirrorGhost(Vault().View(), isovalue, {}, settings);
    return "";
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
}

TEST(MirrorGhost, NonsenseIsRefused)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refusal = [](auto change)
  {
    MirrorGhostSettings settings = AtZero();
    change(settings);
    return Refusal(settings);
  };
  EXPECT_EQ(refusal([](auto& s) { s.spacingMm = 0.1; }).find("mirror: spacingMm"), 0U);
  EXPECT_EQ(refusal([&](auto& s) { s.matchedMm = nan; }).find("mirror: matchedMm"), 0U);
  EXPECT_EQ(
    refusal([](auto& s) { s.plane->normal.x = 2.0; }).find("mirror: the length of the plane"), 0U);
  EXPECT_EQ(
    refusal([&](auto& s) { s.plane->point.y = nan; }).find("mirror: the plane's point"), 0U);
  EXPECT_EQ(Refusal(AtZero(), 30000.0), "mirror: there is no bone; choose a lower isovalue");
  EXPECT_THROW(hasp::MakeMirrorGhost(Vault().View(), HalfWayHU, std::vector<std::uint8_t>(7, 1)),
    std::invalid_argument);
  EXPECT_THROW(
    hasp::MakeMirrorGhost(Vault().View(), HalfWayHU, {}, AtZero(), [](double) { return false; }),
    hasp::Cancelled);
}

TEST(MirrorGhost, OnlyTheHoleIsUnlikeItsMirrorImage)
{
  const MirrorGhost ghost = hasp::MakeMirrorGhost(Vault().View(), HalfWayHU, {}, AtZero());
  EXPECT_FALSE(ghost.found);
  EXPECT_EQ(ghost.plane.normal, dvec3(1.0, 0.0, 0.0)); // to the left
  EXPECT_TRUE(hasp::CheckMesh(ghost.mesh).Outward());
  EXPECT_LT(ghost.medianMm, 0.1); // samples of 1.5 mm lie at mirrored places: rounding alone
  EXPECT_GT(ghost.matchedShare, 0.9);
  EXPECT_LT(ghost.matchedShare, 1.0);
  const hasp::PhantomDefect hole = Vault().Hole();
  float most = 0.0F;
  dvec3 at(0.0);
  for (std::size_t n = 0; n < ghost.mesh.points.size(); ++n)
    if (ghost.signedDistanceMm[n] > most)
    {
      most = ghost.signedDistanceMm[n];
      at = ghost.mesh.points[n];
    }
  // Bone where there is none: half the hole's width from its rim, outside of real bone.
  EXPECT_NEAR(most, 0.5 * hole.widthMm, 3.0);
  EXPECT_LT(glm::distance(at, hole.center), 0.5 * hole.lengthMm + 5.0);
  EXPECT_LT(at.x, 0.0); // the right, where the left was mirrored to
}

TEST(MirrorGhost, APlaneThatIsAsideShowsTwiceHowFar)
{
  MirrorGhostSettings settings = AtZero();
  settings.plane->point.x = 2.0; // the ghost is 4 mm to the left
  const MirrorGhost ghost = hasp::MakeMirrorGhost(Vault().View(), HalfWayHU, {}, settings);
  // At the sides of the vault, which is 4 mm farther left there; outside of it on the left.
  float left = -1e9F, right = 1e9F;
  for (std::size_t n = 0; n < ghost.mesh.points.size(); ++n)
  {
    const dvec3& p = ghost.mesh.points[n];
    if (std::abs(p.y) < 15.0 && std::abs(p.z - 10.0) < 8.0 && p.x > 60.0)
      left = std::max(left, ghost.signedDistanceMm[n]);
    if (std::abs(p.y) < 15.0 && std::abs(p.z - 10.0) < 8.0 && p.x < -60.0)
      right = std::min(right, ghost.signedDistanceMm[n]);
  }
  EXPECT_NEAR(left, 4.0, 0.3);
  EXPECT_LT(right, -2.5); // within the wall of 7 mm
  EXPECT_GT(ghost.medianMm, 1.0);
}

TEST(MirrorGhost, ThePlaneIsFoundAndABallsOnlyIsKept)
{
  const auto keep = hasp::KeepLargePieces(Vault().View(), HalfWayHU, 100.0);
  MirrorGhostSettings settings;
  settings.spacingMm = 2.0;
  const MirrorGhost ghost = hasp::MakeMirrorGhost(Vault().View(), HalfWayHU, keep, settings);
  EXPECT_TRUE(ghost.found);
  EXPECT_GT(ghost.plane.normal.x, std::cos(glm::radians(0.3)));
  EXPECT_NEAR(glm::dot(ghost.plane.normal, ghost.plane.point), 0.0, 0.3);
  EXPECT_LT(ghost.medianMm, 0.3);
}

TEST(MirrorGhost, TheFilterGivesTheSame)
{
  const MirrorGhost ghost = hasp::MakeMirrorGhost(
    Vault().View(), HalfWayHU, hasp::KeepLargePieces(Vault().View(), HalfWayHU, 100.0), AtZero());
  vtkNew<vtkHaspMirrorFilter> filter;
  filter->SetInputData(hasp::MakeImage(Vault().grid, Vault().samples));
  filter->SetIsoValue(HalfWayHU);
  filter->SetIgnoreBelow(100.0);
  filter->SetSpacing(1.5);
  filter->FindPlaneOff();
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  ASSERT_EQ(std::size_t(output->GetNumberOfPoints()), ghost.mesh.points.size());
  ASSERT_NE(output->GetPointData()->GetArray("SignedDistance"), nullptr);
  EXPECT_EQ(output->GetPointData()->GetArray("SignedDistance")->GetTuple1(5),
    double(ghost.signedDistanceMm[5]));
  EXPECT_EQ(filter->GetUsedNormal()[0], 1.0);
  EXPECT_EQ(filter->GetMedianDistance(), ghost.medianMm);
  EXPECT_EQ(filter->GetMatchedShare(), ghost.matchedShare);
  filter->GlobalWarningDisplayOff();
  filter->SetSpacing(9.0); // out of range
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetMatchedShare(), 0.0);
  filter->GlobalWarningDisplayOn();
}

} // namespace
