#include "BrokenBlock.h"

#include "Grid/FinitePose.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace
{
const Halves& Rough()
{
  static const Halves halves{ BrokenBlock{} };
  return halves;
}
} // namespace

TEST(FractureFit, RefusesWhatItCannotUse)
{
  const Halves& h = Rough();
  EXPECT_THROW(hasp::FitFracture({}, h.upper.bodyInWorld, h.scene), std::invalid_argument);
  hasp::RigidPose nowhere;
  nowhere.position.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(hasp::FitFracture(h.moved, nowhere, h.scene), std::invalid_argument);
  hasp::FitSettings settings;
  settings.captureMm = 0.0;
  EXPECT_THROW(
    hasp::FitFracture(h.moved, h.upper.bodyInWorld, h.scene, settings), std::invalid_argument);
  settings = {};
  settings.law.penetrationMm = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(
    hasp::FitFracture(h.moved, h.upper.bodyInWorld, h.scene, settings), std::invalid_argument);
  hasp::FitScene hollow;
  hollow.partners.push_back({ nullptr, {} });
  EXPECT_THROW(hasp::FitFracture(h.moved, h.upper.bodyInWorld, hollow), std::invalid_argument);
  EXPECT_THROW(hasp::FitBody(nullptr, nullptr), std::invalid_argument);
}

TEST(FractureFit, FindsTheTruthFromThreeMillimetresAndFiveDegrees)
{
  const Halves& h = Rough();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  for (int n = 0; n < 8; ++n)
  {
    const auto direction = [&]
    { return glm::normalize(glm::dvec3(share(random), share(random), share(random))); };
    const hasp::RigidPose start = Moved(h.upper.bodyInWorld, 3.0 * direction(), direction(), 5.0);
    const hasp::FractureFit fit = hasp::FitFracture(h.moved, start, h.scene);
    EXPECT_TRUE(fit.touches);
    // A tenth of a voxel: the block's edges are rounded on the grid.
    EXPECT_LT(h.Off(fit), 0.05) << n;
    EXPECT_LT(DegreesBetween(fit.groupInWorld, h.upper.bodyInWorld), 0.2) << n;
  }
}

TEST(FractureFit, IsTheSameWhereverTheWorldIs)
{
  const Halves& h = Rough();
  const hasp::RigidPose start = Moved(h.upper.bodyInWorld, { 1.0, -1.0, 1.5 }, { 1, 2, 3 }, 4.0);
  const hasp::FractureFit fit = hasp::FitFracture(h.moved, start, h.scene);
  const hasp::RigidPose world{ { 300.0, -200.0, 100.0 }, hasp::TurnBy({ 1.0, -0.5, 0.7 }) };
  hasp::FitScene scene;
  scene.partners = { { h.lower.body, world * h.lower.bodyInWorld } };
  const hasp::FractureFit other = hasp::FitFracture(h.moved, world * start, scene);
  EXPECT_LT(hasp::RmsWay(h.moved, world * fit.groupInWorld, other.groupInWorld), 1e-3);
}

TEST(FractureFit, MovesAGroupAsItMovesItsBodies)
{
  const Halves& h = Rough();
  const hasp::RigidPose start = Moved(h.upper.bodyInWorld, { 1.0, 0.5, 1.0 }, { 1, 0, 1 }, 3.0);
  const hasp::FractureFit alone = hasp::FitFracture(h.moved, start, h.scene);
  // The same body, seen from axes elsewhere, and a body that is far from everything.
  const hasp::RigidPose bodyInGroup{ { 5.0, 6.0, -7.0 }, hasp::TurnBy({ 0.3, 0.2, -0.4 }) };
  const std::vector<hasp::GroupBody> group{ { h.upper.body, bodyInGroup },
    { h.upper.body, { { 0.0, 0.0, 500.0 }, {} } } };
  const hasp::FractureFit fit = hasp::FitFracture(group, start * bodyInGroup.Inverse(), h.scene);
  EXPECT_LT(hasp::RmsWay(h.moved, alone.groupInWorld, fit.groupInWorld * bodyInGroup), 0.02);
}

TEST(FractureFit, StandsStillWhereNothingIsNear)
{
  const Halves& h = Rough();
  const hasp::RigidPose far = Moved(h.upper.bodyInWorld, { 0.0, 0.0, 60.0 }, { 1, 0, 0 }, 0.0);
  const hasp::FractureFit fit = hasp::FitFracture(h.moved, far, h.scene);
  EXPECT_FALSE(fit.touches);
  EXPECT_EQ(fit.groupInWorld, far);
  const hasp::FractureFit alone = hasp::FitFracture(h.moved, far, {});
  EXPECT_FALSE(alone.touches);
}

TEST(FractureFit, RestsOnTheHighestPlacesOfAFaceThatLostBone)
{
  // The truth is where nothing was lost; least squares close the mean gap.
  const Halves h{ BrokenBlock{ .lost = 0.4 } };
  const hasp::RigidPose start = Moved(h.upper.bodyInWorld, { 1, 1, 1 }, { 0, 1, 0 }, 3.0);
  hasp::FitSettings squares;
  squares.law.attraction = 1.0;
  squares.law.penetrationMm = 20.0;
  const auto low = [&](const hasp::FractureFit& fit)
  { return h.upper.bodyInWorld.position.z - fit.groupInWorld.position.z; };
  const hasp::FractureFit fit = hasp::FitFracture(h.moved, start, h.scene);
  const double least = low(hasp::FitFracture(h.moved, start, h.scene, squares));
  EXPECT_GT(least, 0.2);
  EXPECT_LT(low(fit), 0.9 * least);
  EXPECT_LT(DegreesBetween(fit.groupInWorld, h.upper.bodyInWorld), 0.3);
}

TEST(FractureFit, TouchesObstaclesButIsNotDrawnToThem)
{
  const Halves& h = Rough();
  hasp::FitScene scene;
  scene.obstacles = { h.lower };
  const hasp::RigidPose apart = Moved(h.upper.bodyInWorld, { 0, 0, 2.0 }, { 1, 0, 0 }, 0.0);
  EXPECT_FALSE(hasp::FitFracture(h.moved, apart, scene).touches);
  const hasp::RigidPose inside = Moved(h.upper.bodyInWorld, { 0, 0, -1.0 }, { 1, 0, 0 }, 0.0);
  const hasp::FractureFit fit = hasp::FitFracture(h.moved, inside, scene);
  EXPECT_GT(fit.sums.deepestMm, -0.3);
}

TEST(FractureFit, GetsOutOfAFragmentItBeginsInside)
{
  const Halves& h = Rough();
  const hasp::RigidPose inside = Moved(h.upper.bodyInWorld, { 0, 0, -4.0 }, { 1, 0, 0 }, 3.0);
  const hasp::FractureFit fit = hasp::FitFracture(h.moved, inside, h.scene);
  EXPECT_LT(h.Off(fit), 0.1);
}

TEST(FractureFit, SaysThatASmoothFaceSlides)
{
  const Halves h{ BrokenBlock{ .wave = 0.0, .wider = 12.0 } };
  const hasp::RigidPose start = Moved(h.upper.bodyInWorld, { 4, -3, 1 }, { 0, 0, 1 }, 10.0);
  hasp::FractureFit fit = hasp::FitFracture(h.moved, start, h.scene);
  EXPECT_NEAR(fit.groupInWorld.position.z, h.upper.bodyInWorld.position.z, 0.05);
  hasp::MeasureSpread(h.moved, h.scene, {}, fit);
  EXPECT_GT(h.Off(fit), 3.0);                   // it stays where it was put,
  EXPECT_GT(fit.spread.within95Mm, h.Off(fit)); // and nobody says that it must be there
  EXPECT_GT(fit.spread.within95Degrees, 10.0);
  hasp::FractureFit rough =
    hasp::FitFracture(Rough().moved, Rough().upper.bodyInWorld, Rough().scene);
  hasp::MeasureSpread(Rough().moved, Rough().scene, {}, rough);
  EXPECT_LT(rough.spread.within95Mm, 0.4);
}

TEST(FractureFit, SidesThatGoOnHoldASmoothFace)
{
  const Halves h{ BrokenBlock{ .wave = 0.0 } };
  const hasp::RigidPose start = Moved(h.upper.bodyInWorld, { 1, -1, 1 }, { 0, 0, 1 }, 3.0);
  const hasp::FractureFit fit = hasp::FitFracture(h.moved, start, h.scene);
  EXPECT_LT(h.Off(fit), 0.1);
}

TEST(FractureFit, AMirroredPieceFitsWorse)
{
  const Halves mirrored{ BrokenBlock{ .mirrored = true } };
  const hasp::RigidPose& truth = mirrored.upper.bodyInWorld;
  const hasp::FractureFit wrong = hasp::FitFracture(mirrored.moved, truth, mirrored.scene);
  const hasp::FractureFit right = hasp::FitFracture(Rough().moved, truth, Rough().scene);
  EXPECT_LT(right.sums.energy, 0.0);
  EXPECT_GT(wrong.sums.energy, 0.5 * right.sums.energy); // less than half as deep
}

TEST(FractureFit, FortyMillimetresAndNinetyDegreesOffIsNoFit)
{
  const Halves& h = Rough();
  const double right = hasp::FitFracture(h.moved, h.upper.bodyInWorld, h.scene).sums.energy;
  for (const glm::dvec3 shift :
    { glm::dvec3(40, 0, 0), glm::dvec3(0, 40, 0), glm::dvec3(25, 20, -24) })
    for (const glm::dvec3 axis : { glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1), glm::dvec3(1, 1, 1) })
    {
      const hasp::FractureFit fit =
        hasp::FitFracture(h.moved, Moved(h.upper.bodyInWorld, shift, axis, 90.0), h.scene);
      EXPECT_TRUE(hasp::IsFinite(fit.groupInWorld));
      EXPECT_TRUE(std::isfinite(fit.sums.energy));
      EXPECT_GT(fit.sums.energy, 0.5 * right); // whatever it rests on is not half as deep
    }
}

TEST(FractureFit, OnePointOfContactHoldsNothing)
{
  // A corner on a wide flat face, 40 degrees aslant.
  const Halves h{ BrokenBlock{ .wave = 0.0, .wider = 12.0 } };
  hasp::FitScene scene;
  scene.obstacles = { h.lower };
  const hasp::RigidPose aslant = Moved(h.upper.bodyInWorld, { 0, 0, 13.5 }, { 1, 1, 0 }, 40.0);
  hasp::FractureFit fit = hasp::FitFracture(h.moved, aslant, scene);
  EXPECT_TRUE(hasp::IsFinite(fit.groupInWorld));
  hasp::MeasureSpread(h.moved, scene, {}, fit);
  EXPECT_TRUE(std::isfinite(fit.spread.within95Mm));
  EXPECT_GT(fit.spread.within95Mm, 4.0);
}

TEST(FractureFit, WaysOfTheSurfaceAreThoseOfItsPoints)
{
  const Halves& h = Rough();
  const hasp::RigidPose a{ { 1, 2, 3 }, hasp::TurnBy({ 0.3, -0.2, 0.1 }) },
    b{ { 2, 1, 3 }, hasp::TurnBy({ -0.4, 0.9, 0.5 }) };
  double squares = 0.0;
  const auto points = h.upper.body->Points(100'000);
  for (const hasp::OrientedPoint& p : points)
  {
    const glm::dvec3 way = a.Place(p.place) - b.Place(p.place);
    squares += glm::dot(way, way) / double(points.size());
  }
  EXPECT_NEAR(hasp::RmsWay(h.moved, a, b), std::sqrt(squares), 1e-9);
}
