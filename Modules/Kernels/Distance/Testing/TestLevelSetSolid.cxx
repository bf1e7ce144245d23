#include "Distance/LevelSetSolid.h"

#include "Distance/Csg.h"
#include "Distance/GridSolid.h"
#include "Distance/LevelSet.h"
#include "Distance/SolidShapes.h"
#include "Grid/Testing/CountNew.h"
#include "Testing/LevelSetShapes.h"
#include "Testing/SolidPromises.h"

namespace
{

const hasp::GridGeometry Grid = hasp::Turned({ 45, 41, 31 }, { 0.5, 0.5, 0.8 });
const hasp::SolidPointer Ball = hasp::MakeCapsule({ 0.2, 0.1, 0 }, { 0.2, 0.1, 0 }, 7);

openvdb::FloatGrid::Ptr BallSet(double band = 4)
{
  const auto values = hasp::SampledSolid(*Ball, Grid);
  return hasp::LevelSetOf(hasp::GridView<const float>{ values.data(), Grid }, band);
}

TEST(LevelSetSolid, RefusesWhatIsNoLevelSet)
{
  EXPECT_THROW(hasp::MakeLevelSetSolid(nullptr), std::invalid_argument);
  auto fog = BallSet();
  fog->setGridClass(openvdb::GRID_FOG_VOLUME);
  EXPECT_THROW(hasp::MakeLevelSetSolid(fog), std::invalid_argument);
  auto nothing = openvdb::FloatGrid::create(2);
  nothing->setGridClass(openvdb::GRID_LEVEL_SET);
  EXPECT_THROW(hasp::MakeLevelSetSolid(nothing), std::invalid_argument);
  auto thin = BallSet();
  thin->setTransform(openvdb::math::Transform::createLinearTransform(1.5)); // 2 mm of background
  EXPECT_THROW(hasp::MakeLevelSetSolid(thin), std::invalid_argument);
  auto sheared = BallSet();
  auto shear = openvdb::math::Mat4d::identity() * 0.5;
  shear(1, 0) = 0.1;
  shear(3, 3) = 1.0;
  sheared->setTransform(openvdb::math::Transform::createLinearTransform(shear));
  EXPECT_THROW(hasp::MakeLevelSetSolid(sheared), std::invalid_argument);
  for (const float bad : { std::nanf(""), 40.0F })
  {
    auto broken = BallSet();
    broken->tree().setValue({ 9, 20, 16 }, bad);
    EXPECT_THROW(hasp::MakeLevelSetSolid(broken), std::invalid_argument) << bad;
  }
  // A block of 8^3 inside that nothing surrounds, however far from the band: a jump.
  for (const openvdb::Coord& at : { openvdb::Coord(80, 80, 80), openvdb::Coord(-800, 0, 0) })
  {
    auto jump = BallSet();
    jump->tree().addTile(1, at, -2, false);
    EXPECT_THROW(hasp::MakeLevelSetSolid(jump), std::invalid_argument);
  }
}

TEST(LevelSetSolid, KeepsThePromisesOfASolid)
{
  const auto solid = hasp::MakeLevelSetSolid(BallSet());
  const auto places = hasp::RandomPlaces(3000, 13);
  hasp::ExpectSamplesAgree(*solid, places);
  hasp::ExpectSamplesAgree(*solid, hasp::RandomPlaces(300, 1000));
  hasp::ExpectNoSteeperThanPromised(*solid, places);
  EXPECT_GE(solid->Steepness(), 1.0);
  EXPECT_LT(solid->Steepness(), std::sqrt(3.0));
}

TEST(LevelSetSolid, IsItsSiblingWithinTheBand)
{
  const auto dense = hasp::MakeGridSolid(
    std::make_shared<std::vector<float>>(hasp::SampledSolid(*Ball, Grid)), Grid);
  const auto solid = hasp::MakeLevelSetSolid(BallSet());
  int met = 0;
  for (const glm::dvec3& x : hasp::RandomPlaces(4000, 9))
    // Less than a voxel's diagonal from the band's end a corner may be beyond it.
    if (std::abs(Ball->At(x)) < 2.0 - 1.07)
    {
      ++met;
      ASSERT_NEAR(solid->At(x), dense->At(x), 1e-6); // floats of 2 mm, turned there and back
      ASSERT_LT(glm::distance(solid->SampleAt(x).gradient, dense->SampleAt(x).gradient), 1e-5);
    }
  EXPECT_GT(met, 500);
}

TEST(LevelSetSolid, BeyondTheBandItKnowsTheSignAndABound)
{
  const auto solid = hasp::MakeLevelSetSolid(BallSet());
  for (const glm::dvec3& x : hasp::RandomPlaces(4000, 30))
  {
    const double truth = Ball->At(x), at = solid->At(x);
    if (std::abs(truth) < 2.0 + 1.07)
      continue;
    ASSERT_EQ(at > 0, truth > 0);
    ASSERT_GE(std::abs(at), 2.0);
    ASSERT_LE(std::abs(at), std::abs(truth) + 0.02); // trilinear between samples of a ball
  }
  // Far away it is no worse than the box of what is inside: 7 mm and two or three voxels.
  EXPECT_GT(solid->At({ 100, 0, 0 }), 100 - std::sqrt(3.0) * 10.2);
}

TEST(LevelSetSolid, GradientsFollowTheValues)
{
  const auto solid = hasp::MakeLevelSetSolid(BallSet());
  std::vector<glm::dvec3> places;
  for (const glm::dvec3& x : hasp::RandomPlaces(3000, 12))
  {
    const glm::dvec3 index = Grid.WorldToIndex(x), from = glm::abs(index - glm::round(index));
    if (std::min({ from.x, from.y, from.z }) > 1e-3 && glm::length(x) < 9.0)
      places.push_back(x); // off the faces between cells, and where the box takes over
  }
  hasp::ExpectGradientsOfFaces(*solid, places, { 0 });
}

TEST(LevelSetSolid, JoinsShapesInATreeAndTakesNoMemoryThere)
{
  const auto bone = hasp::MakeLevelSetSolid(BallSet());
  const auto drilled =
    hasp::MakeDifference(bone, hasp::MakeCylinder({ 0, 0, -12 }, { 0, 0, 12 }, 1));
  const auto places = hasp::RandomPlaces(1000, 14);
  hasp::ExpectSamplesAgree(*drilled, places);
  hasp::ExpectNoSteeperThanPromised(*drilled, places);
  EXPECT_NEAR(drilled->At({ 0.2, 0, 0 }), 0.8, 1e-9);
  double sum = 0.0;
  const std::size_t before = hasp::test::NewCount();
  for (const glm::dvec3& x : places)
  {
    const auto s = drilled->SampleAt(x);
    sum += drilled->At(x) + drilled->FaceAt(s.face, x).value;
  }
  EXPECT_EQ(hasp::test::NewCount(), before);
  EXPECT_NE(sum, 0.0);
}

TEST(LevelSetSolid, APlaceThatIsNotFiniteHasAFace)
{
  const auto solid = hasp::MakeLevelSetSolid(BallSet());
  for (const double bad : { std::nan(""), std::numeric_limits<double>::infinity(), -1e300, 1e300 })
    EXPECT_LT(solid->SampleAt({ 0, bad, 1 }).face, solid->Faces());
}

} // namespace
