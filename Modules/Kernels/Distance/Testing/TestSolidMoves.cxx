#include "Distance/SolidMoves.h"
#include "Testing/RandomSolid.h"
#include "Testing/SolidPromises.h"

#include "Distance/GridSolid.h"
#include "Distance/SolidShapes.h"

namespace
{

constexpr double Infinite = std::numeric_limits<double>::infinity();

hasp::RigidPose Pose(const glm::dvec3& position, const glm::dvec3& turn)
{
  return { position, hasp::TurnBy(turn) };
}

TEST(SolidMoves, RefuseWhatIsNoPose)
{
  const auto ball = hasp::MakeCapsule({}, {}, 1);
  EXPECT_THROW(hasp::MakeMoved(nullptr, {}), std::invalid_argument);
  EXPECT_THROW(hasp::MakeMoved(ball, { { std::nan(""), 0, 0 }, {} }), std::invalid_argument);
  EXPECT_THROW(hasp::MakeMoved(ball, { {}, { 1.01, 0, 0, 0 } }), std::invalid_argument);
  EXPECT_THROW(hasp::MakeMoved(ball, { {}, { 0, 0, 0, 0 } }), std::invalid_argument);
  EXPECT_THROW(hasp::MakeMoved(ball, { {}, { std::nan(""), 0, 0, 0 } }), std::invalid_argument);
}

TEST(SolidMoves, KeepThePromisesOfASolid)
{
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    SCOPED_TRACE(seed);
    const auto part = hasp::RandomSolids(seed).Tree(2);
    const glm::dvec3 turn = seed % 4 == 0 ? glm::dvec3(0) : glm::dvec3(0.3, -0.9, 0.1 * seed);
    const auto moved = hasp::MakeMoved(part, Pose({ 1, -2, 0.5 }, turn));
    const auto places = hasp::RandomPlaces(300, 8);
    hasp::ExpectSamplesAgree(*moved, places);
    hasp::ExpectNoSteeperThanPromised(*moved, places);
  }
  const auto box = hasp::MakeMoved(
    hasp::MakeBox({ 0.5, 0, 0 }, glm::dmat3(1), { 2, 1, 1 }), Pose({ 1, 0, 0 }, { 0.5, 1, 2 }));
  hasp::ExpectGradientsOfFaces(*box, hasp::RandomPlaces(50, 6), hasp::AllFaces(*box));
  hasp::ExpectFootPointsOnSurface(*box, hasp::RandomPlaces(500, 6));
}

TEST(SolidMoves, AMovedShapeIsTheShapeMadeThere)
{
  const glm::dvec3 at(1, -2, 0.5), turn(0.4, 1.1, -0.7), half(2, 3, 1);
  const hasp::RigidPose pose = Pose(at, turn);
  const auto moved = hasp::MakeMoved(hasp::MakeBox({ 1, 1, 0 }, glm::dmat3(1), half), pose);
  const auto made = hasp::MakeBox(pose.Place({ 1, 1, 0 }), glm::mat3_cast(pose.orientation), half);
  EXPECT_EQ(moved->Faces(), made->Faces());
  for (const glm::dvec3& x : hasp::RandomPlaces(2000, 8))
  {
    ASSERT_NEAR(moved->At(x), made->At(x), 1e-9);
    for (const std::uint32_t face : { 4U, 13U, 25U })
    {
      const auto a = moved->FaceAt(face, x), b = made->FaceAt(face, x);
      ASSERT_NEAR(a.value, b.value, 1e-9);
      ASSERT_LT(glm::distance(a.gradient, b.gradient), 1e-9);
    }
  }
  // There and back again.
  const auto back = hasp::MakeMoved(moved, pose.Inverse());
  const auto first = hasp::MakeBox({ 1, 1, 0 }, glm::dmat3(1), half);
  for (const glm::dvec3& x : hasp::RandomPlaces(500, 8))
    ASSERT_NEAR(back->At(x), first->At(x), 1e-9);
}

TEST(SolidMoves, BoundsMoveAlongAndEndNowhereOnceTurned)
{
  const auto slab = hasp::MakeSlab({}, { 0, 0, 1 }, 2);
  const auto moved = hasp::MakeMoved(slab, Pose({ 5, 6, 7 }, {}));
  EXPECT_EQ(moved->Bounds().low, glm::dvec3(-Infinite, -Infinite, 6));
  EXPECT_EQ(moved->Bounds().high, glm::dvec3(Infinite, Infinite, 8));
  const auto turned = hasp::MakeMoved(slab, Pose({ 5, 6, 7 }, { 0.1, 0, 0 }));
  EXPECT_EQ(turned->Bounds().low, glm::dvec3(-Infinite));
  EXPECT_EQ(turned->Bounds().high, glm::dvec3(Infinite));
}

TEST(SolidMoves, AMovedGridIsAsSteepAsItWas)
{
  const hasp::GridGeometry grid{ { 3, 3, 3 }, { -1, -1, -1 }, glm::dvec3(1), glm::dmat3(1) };
  auto values = std::make_shared<std::vector<float>>();
  for (int n = 0; n < 27; ++n)
    values->push_back(1.5F * float(n % 3 - 1)); // 1.5 mm a mm
  const auto part = hasp::MakeGridSolid(values, grid);
  const auto moved = hasp::MakeMoved(part, Pose({ 9, 0, 0 }, { 0, 0, 0.7 }));
  EXPECT_EQ(moved->Steepness(), part->Steepness());
  EXPECT_GT(moved->Steepness(), 1.4);
  hasp::ExpectSamplesAgree(*moved, hasp::RandomPlaces(500, 1.5, { 9, 0, 0 }));
  hasp::ExpectNoSteeperThanPromised(*moved, hasp::RandomPlaces(500, 1.5, { 9, 0, 0 }));
}

} // namespace
