#include "Distance/SolidPrisms.h"
#include "Testing/SolidPromises.h"

#include "Distance/ImplicitShapes.h"
#include "Distance/SolidShapes.h"
#include "Distance/SolidSweeps.h"

#include <glm/gtc/matrix_transform.hpp>

namespace
{

const glm::dmat3 Tilted(glm::rotate(glm::dmat4(1), 0.7, glm::normalize(glm::dvec3(1, -2, 3))));

/// A corner that goes in, and one that is sharp.
const std::vector<glm::dvec2> Corners{ { -4, -3 }, { 4, -3 }, { 3, 4 }, { 0, 0.5 }, { -3, 2 } };

void ExpectPromises(const hasp::ImplicitSolid& solid)
{
  const auto places = hasp::RandomPlaces(3000, 8);
  hasp::ExpectSamplesAgree(solid, places);
  hasp::ExpectNoSteeperThanPromised(solid, places);
  hasp::ExpectFootPointsOnSurface(solid, places);
}

TEST(SolidPrisms, RefuseWhatIsNone)
{
  const double nan = std::nan("");
  const auto ball = hasp::MakeCapsule({}, {}, 1);
  EXPECT_THROW(hasp::MakePrism(std::span(Corners).first(2), Tilted, 1), std::invalid_argument);
  EXPECT_THROW(hasp::MakePrism(Corners, glm::dmat3(2), 1), std::invalid_argument);
  EXPECT_THROW(hasp::MakePrism(Corners, Tilted, 0), std::invalid_argument);
  EXPECT_THROW(
    hasp::MakePrism(std::vector<glm::dvec2>(3, { 0, nan }), Tilted, 1), std::invalid_argument);
  EXPECT_THROW(hasp::MakeExtrusion(nullptr, {}, { 0, 0, 1 }), std::invalid_argument);
  EXPECT_THROW(hasp::MakeExtrusion(ball, glm::dvec3(nan), { 0, 0, 1 }), std::invalid_argument);
  EXPECT_THROW(hasp::MakeExtrusion(ball, {}, {}), std::invalid_argument);
}

TEST(SolidPrisms, APrismIsItsPolygonAllAlong)
{
  for (const glm::dmat3& axes : { glm::dmat3(1), Tilted })
  {
    const auto prism = hasp::MakePrism(Corners, axes, 0.8);
    for (const glm::dvec3& x : hasp::RandomPlaces(3000, 8))
    {
      const double truth = hasp::PolygonDistance(glm::dvec2(x * axes), Corners) - 0.8;
      ASSERT_NEAR(prism->At(x), truth, 1e-12);
    }
    ExpectPromises(*prism);
  }
  const auto box = hasp::MakePrism(Corners, glm::dmat3(1), 0.8)->Bounds();
  EXPECT_EQ(box.low.x, -4.8);
  EXPECT_EQ(box.high.y, 4.8);
  EXPECT_EQ(box.high.z, std::numeric_limits<double>::infinity());
}

TEST(SolidPrisms, SidesGoOnBeyondTheCreaseBetweenThem)
{
  // Around the corner that goes in, each side's own offset: smooth, and apart from the other.
  const auto prism = hasp::MakePrism(Corners, glm::dmat3(1), 0.8);
  hasp::ExpectGradientsOfFaces(*prism, hasp::RandomPlaces(200, 0.3, { 0, 2, 0 }), { 2, 3 });
  EXPECT_EQ(prism->SampleAt({ 0.3, 1.8, 0 }).face, 2u);
  EXPECT_EQ(prism->SampleAt({ -0.3, 1.8, 5 }).face, 3u);
  EXPECT_GT(prism->FaceAt(3, { 0.6, 1.5, 0 }).value, prism->At({ 0.6, 1.5, 0 }) + 0.2);
}

TEST(SolidPrisms, AnExtrusionIsTheSameInEveryHeight)
{
  const auto ball = hasp::MakeCapsule({ 1, 0, 0 }, { 1, 0, 0 }, 2);
  const auto post = hasp::MakeExtrusion(ball, { 1, 0, 0 }, Tilted[2]);
  for (const glm::dvec3& x : hasp::RandomPlaces(3000, 8))
    ASSERT_NEAR(post->At(x), hasp::CylinderDistance(x, { 1, 0, 0 }, Tilted[2], 2), 1e-12);
  ExpectPromises(*post);
  // Off the ball's middle its gradient leaves the plane; the pillar's does not.
  const auto thin = hasp::MakeExtrusion(ball, glm::dvec3(1, 0, 0) + 1.2 * Tilted[2], Tilted[2]);
  for (const glm::dvec3& x : hasp::RandomPlaces(200, 8))
    ASSERT_NEAR(glm::dot(thin->SampleAt(x).gradient, Tilted[2]), 0.0, 1e-12);
  hasp::ExpectGradientsOfFaces(*thin, hasp::RandomPlaces(200, 8), { 0 });
  EXPECT_NEAR(thin->At(glm::dvec3(1, 0, 0) + 1.6 * Tilted[0]), 0.0, 1e-12); // 1.2, 1.6, 2
  const auto upright = hasp::MakeExtrusion(ball, { 1, 0, 0 }, { 0, 0, -3 });
  EXPECT_EQ(upright->Bounds().high.x, 3);
  ExpectPromises(*upright);
}

TEST(SolidPrisms, LettersBecomePillars)
{
  const auto text = hasp::MakeText("R2", {}, { 1, 0, 0 }, { 0, 1, 0 }, 6, 0.8);
  const auto pillars = hasp::MakeExtrusion(text, {}, { 0, 0, 1 });
  for (const glm::dvec3& x : hasp::RandomPlaces(2000, 8))
    ASSERT_EQ(pillars->At(x), text->At({ x.x, x.y, 0 }));
  ExpectPromises(*pillars);
}

} // namespace
