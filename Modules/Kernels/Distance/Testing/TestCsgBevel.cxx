#include "Distance/Csg.h"
#include "Distance/SolidShapes.h"
#include "Testing/RandomSolid.h"
#include "Testing/SolidPromises.h"

#include <algorithm>

namespace
{

TEST(CsgBevel, RefusesWhatIsNoBevel)
{
  const auto ball = hasp::MakeCapsule({}, {}, 1);
  EXPECT_THROW(hasp::MakeBevelledIntersection(nullptr, ball, 1), std::invalid_argument);
  EXPECT_THROW(hasp::MakeBevelledIntersection(ball, nullptr, 1), std::invalid_argument);
  EXPECT_THROW(hasp::MakeBevelledIntersection(ball, ball, 0), std::invalid_argument);
  EXPECT_THROW(hasp::MakeBevelledIntersection(ball, ball, std::nan("")), std::invalid_argument);
}

TEST(CsgBevel, KeepsThePromisesOfASolid)
{
  for (unsigned seed = 0; seed < 30; ++seed)
  {
    SCOPED_TRACE(seed);
    hasp::RandomSolids random(seed);
    const auto a = random.Shape(), b = random.Shape();
    const auto solid = hasp::MakeBevelledIntersection(a, b, 0.4);
    ASSERT_EQ(solid->Faces(), a->Faces() + b->Faces() + a->Faces() * b->Faces());
    const auto places = hasp::RandomPlaces(300, 6);
    hasp::ExpectSamplesAgree(*solid, places);
    hasp::ExpectNoSteeperThanPromised(*solid, places);
  }
}

TEST(CsgBevel, CutsAnUprightEdgeOffByAsMuchOnBothFaces)
{
  const double bevel = 0.75;
  const auto top = hasp::MakePlane({}, { 0, 0, 1 }), wall = hasp::MakePlane({}, { 1, 0, 0 });
  const auto solid = hasp::MakeBevelledIntersection(top, wall, bevel);
  const auto diagonal = hasp::MakePlane({ -bevel, 0, 0 }, { 1, 0, 1 });
  const auto truth = hasp::MakeIntersection({ top, wall, diagonal });
  for (const glm::dvec3& x : hasp::RandomPlaces(3000, 3))
    ASSERT_EQ(solid->At(x) < 0.0, truth->At(x) < 0.0);
  EXPECT_NEAR(solid->At({ 0, 5, -bevel }), 0.0, 1e-12);
  EXPECT_NEAR(solid->At({ -bevel, 5, 0 }), 0.0, 1e-12);
  const auto s = solid->SampleAt({ -0.5 * bevel, 0, -0.5 * bevel });
  EXPECT_EQ(s.face, 2U);
  EXPECT_LT(glm::distance(glm::normalize(s.gradient), glm::normalize(glm::dvec3(1, 0, 1))), 1e-12);
  // On the creases the lower number is named, whatever the last digit.
  EXPECT_EQ(solid->SampleAt({ -bevel, 0, 1e-15 }).face, 0U);
  EXPECT_EQ(solid->SampleAt({ -1e-15, 0, -bevel }).face, 1U);
}

} // namespace
