#include "Distance/SolidShapes.h"
#include "Testing/SolidPromises.h"

#include "Distance/Csg.h"
#include "Distance/ImplicitShapes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <string>

namespace
{

constexpr double Infinite = std::numeric_limits<double>::infinity();
const glm::dvec3 Tilted(1, 2, -2);
const glm::dmat3 Turned(glm::rotate(glm::dmat4(1), 0.8, Tilted));

struct Named
{
  std::string name;
  hasp::SolidPointer solid;
};

std::vector<Named> AllShapes()
{
  const glm::dvec3 c(1, -2, 0.5);
  return { { "plane", hasp::MakePlane(c, Tilted) }, { "slab", hasp::MakeSlab(c, Tilted, 3) },
    { "box", hasp::MakeBox(c, Turned, { 2, 3, 1 }) },
    { "rounded box", hasp::MakeRoundedBox(c, Turned, { 2, 3, 1 }, 0.4) },
    { "cylinder", hasp::MakeCylinder(c, c + Tilted, 1.5) },
    { "stadium", hasp::MakeStadium(c, c + glm::dvec3(3, 1, 0), Tilted, 1.2, 0.8) },
    { "capsule", hasp::MakeCapsule(c, c + Tilted, 1.5) }, { "cone", hasp::MakeCone(c, Tilted, 70) },
    { "flat cone", hasp::MakeCone(c, { 0, 0, -1 }, 150) },
    { "ball", hasp::MakeCapsule(c, c, 1.5) } };
}

TEST(SolidShapes, RefuseWhatIsNoShape)
{
  const double nan = std::nan("");
  EXPECT_THROW(hasp::MakePlane({ nan, 0, 0 }, Tilted), std::invalid_argument);
  EXPECT_THROW(hasp::MakePlane({}, {}), std::invalid_argument);
  EXPECT_THROW(hasp::MakePlane({}, { Infinite, 0, 0 }), std::invalid_argument);
  EXPECT_THROW(hasp::MakeSlab({}, Tilted, 0), std::invalid_argument);
  EXPECT_THROW(hasp::MakeSlab({}, Tilted, -1), std::invalid_argument);
  EXPECT_THROW(hasp::MakeBox({}, Turned, { 1, 0, 1 }), std::invalid_argument);
  EXPECT_THROW(hasp::MakeBox({}, 1.01 * Turned, { 1, 1, 1 }), std::invalid_argument);
  EXPECT_THROW(hasp::MakeBox({}, glm::dmat3(nan), { 1, 1, 1 }), std::invalid_argument);
  EXPECT_THROW(hasp::MakeRoundedBox({}, Turned, { 1, 2, 3 }, 1), std::invalid_argument);
  EXPECT_THROW(hasp::MakeRoundedBox({}, Turned, { 1, 2, 3 }, 0), std::invalid_argument);
  EXPECT_THROW(hasp::MakeCylinder({ 1, 1, 1 }, { 1, 1, 1 }, 1), std::invalid_argument);
  EXPECT_THROW(hasp::MakeCylinder({}, Tilted, Infinite), std::invalid_argument);
  EXPECT_THROW(hasp::MakeStadium({}, Tilted, Tilted, 1, 1), std::invalid_argument);
  EXPECT_THROW(hasp::MakeStadium({}, {}, Tilted, 1, 0), std::invalid_argument);
  EXPECT_THROW(hasp::MakeCapsule({}, { 0, nan, 0 }, 1), std::invalid_argument);
  EXPECT_THROW(hasp::MakeCapsule({}, {}, 0), std::invalid_argument);
  EXPECT_THROW(hasp::MakeCone({ nan, 0, 0 }, Tilted, 90), std::invalid_argument);
  EXPECT_THROW(hasp::MakeCone({}, {}, 90), std::invalid_argument);
  EXPECT_THROW(hasp::MakeCone({}, Tilted, 0.9), std::invalid_argument);
  EXPECT_THROW(hasp::MakeCone({}, Tilted, 180), std::invalid_argument);
}

TEST(SolidShapes, KeepThePromisesOfASolid)
{
  for (const Named& shape : AllShapes())
  {
    SCOPED_TRACE(shape.name);
    const auto places = hasp::RandomPlaces(2000, 6);
    hasp::ExpectSamplesAgree(*shape.solid, places);
    hasp::ExpectNoSteeperThanPromised(*shape.solid, places);
  }
}

TEST(SolidShapes, AreDistancesOutside)
{
  for (const Named& shape : AllShapes())
  {
    SCOPED_TRACE(shape.name);
    hasp::ExpectFootPointsOnSurface(*shape.solid, hasp::RandomPlaces(2000, 6));
  }
}

/// Places on a surface, CloudStep apart.
using Cloud = std::vector<glm::dvec3>;

constexpr double CloudStep = 0.02;

Cloud BoxCloud(const glm::dvec3& center, const glm::dmat3& axes, const glm::dvec3& half)
{
  Cloud cloud;
  for (int a = 0; a < 3; ++a)
    for (const double side : { -1.0, 1.0 })
    {
      const int b = (a + 1) % 3, c = (a + 2) % 3;
      for (double u = -half[b]; u <= half[b] + 1e-9; u += CloudStep)
        for (double v = -half[c]; v <= half[c] + 1e-9; v += CloudStep)
        {
          glm::dvec3 p(0.0);
          p[a] = side * half[a], p[b] = u, p[c] = v;
          cloud.push_back(center + axes * p);
        }
    }
  return cloud;
}

/// Of all places within `radius` of a segment along x, half as high as `half`: walls and ends.
Cloud StadiumCloud(double halfLength, double radius, double half)
{
  Cloud cloud;
  for (double x = -halfLength - radius; x <= halfLength + radius; x += CloudStep)
    for (double y = -radius; y <= radius; y += CloudStep)
      if (std::hypot(std::max(std::abs(x) - halfLength, 0.0), y) <= radius)
        for (const double z : { -half, half })
          cloud.emplace_back(x, y, z);
  for (double z = -half; z <= half + 1e-9; z += CloudStep)
  {
    for (double x = -halfLength; x <= halfLength + 1e-9; x += CloudStep)
      for (const double y : { -radius, radius })
        cloud.emplace_back(x, y, z);
    for (double angle = -1.5707963; angle <= 1.5707964; angle += CloudStep / radius)
      for (const double side : { -1.0, 1.0 })
        cloud.emplace_back(
          side * (halfLength + radius * std::cos(angle)), radius * std::sin(angle), z);
  }
  return cloud;
}

TEST(SolidShapes, AreAsFarAsTheNearestOfManyPlacesOnTheirSurface)
{
  const glm::dvec3 c(0.3, -0.2, 0.1);
  const struct
  {
    hasp::SolidPointer solid;
    Cloud cloud;
  } shapes[] = {
    { hasp::MakeBox(c, Turned, { 1, 0.7, 0.4 }), BoxCloud(c, Turned, { 1, 0.7, 0.4 }) },
    { hasp::MakeStadium({ -0.8, 0, 0 }, { 0.8, 0, 0 }, { 0, 0, 1 }, 0.6, 0.8),
      StadiumCloud(0.8, 0.6, 0.4) },
    { hasp::MakeCylinder({ 0, 0, -0.7 }, { 0, 0, 0.7 }, 0.6), StadiumCloud(0.0, 0.6, 0.7) },
  };
  for (const auto& shape : shapes)
    for (const glm::dvec3& x : hasp::RandomPlaces(100, 1.6))
    {
      double least = 1e9;
      for (const glm::dvec3& p : shape.cloud)
        least = std::min(least, glm::distance(p, x));
      // The cloud is never nearer, and by at most 0.7 steps beside the foot, at edges and rims a
      // whole step.
      ASSERT_GE(least, std::abs(shape.solid->At(x)) - 1e-9);
      ASSERT_LE(least, std::abs(shape.solid->At(x)) + CloudStep);
    }
}

TEST(SolidShapes, AgreeWithClosedFormsAtChosenPlaces)
{
  const glm::dmat3 one(1);
  EXPECT_DOUBLE_EQ(hasp::MakePlane({ 5, 5, 1 }, { 0, 0, 7 })->At({ 0, 0, 3 }), 2);
  EXPECT_DOUBLE_EQ(hasp::MakeSlab({ 1, 0, 0 }, { 3, 0, 0 }, 2)->At({ 4, 0, 0 }), 2);
  EXPECT_DOUBLE_EQ(hasp::MakeBox({}, one, { 1, 2, 3 })->At({ 4, 6, 0 }), 5);
  EXPECT_DOUBLE_EQ(hasp::MakeBox({}, one, { 1, 2, 3 })->At({ 0.5, 0, 0 }), -0.5);
  EXPECT_DOUBLE_EQ(
    hasp::MakeRoundedBox({}, one, { 2, 3, 4 }, 1)->At({ 5, 6, 0 }), std::sqrt(32.0) - 1);
  const auto cylinder = hasp::MakeCylinder({ 0, 0, -2 }, { 0, 0, 4 }, 2);
  EXPECT_DOUBLE_EQ(cylinder->At({ 3, 4, 0 }), 3);
  EXPECT_DOUBLE_EQ(cylinder->At({ 1, 0, 7 }), 3);
  EXPECT_DOUBLE_EQ(cylinder->At({ 5, 0, 8 }), 5);
  EXPECT_DOUBLE_EQ(cylinder->At({ 0, 0, 1 }), -2);
  EXPECT_DOUBLE_EQ(cylinder->At({ 0, 0, 3.5 }), -0.5);
  const auto stadium = hasp::MakeStadium({ -3, 0, 0 }, { 3, 0, 0 }, { 0, 0, 1 }, 1, 2);
  EXPECT_DOUBLE_EQ(stadium->At({ 7, 0, 0.5 }), 3);
  EXPECT_DOUBLE_EQ(stadium->At({ 2, 3, 0 }), 2);
  EXPECT_DOUBLE_EQ(stadium->At({ 6, 4, 5 }), std::hypot(4, 4));
  EXPECT_DOUBLE_EQ(stadium->At({ 2, 0, -0.75 }), -0.25);
  EXPECT_DOUBLE_EQ(hasp::MakeCapsule({ 0, 0, 0 }, { 9, 0, 0 }, 1)->At({ -3, 4, 0 }), 4);
  const auto cone = hasp::MakeCone({ 0, 0, 1 }, { 0, 0, 2 }, 90);
  EXPECT_NEAR(cone->At({ 3, 4, 1 }), 5 * std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(cone->At({ 0, 0, 4 }), -3 * std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(cone->At({ 0, 2, 3 }), 0, 1e-12);
  EXPECT_DOUBLE_EQ(cone->At({ 0, 3, -3 }), 5); // the tip is nearest
}

TEST(SolidShapes, OnEachSurfaceOnlyItsOwnFacesAreNamed)
{
  // Edges and corners have numbers, too, but those are of offsets. On a face, on an edge, at a
  // corner, also where rounding lifts the place off by its last digits: a plane face.
  const auto isPlane = [](std::uint32_t f)
  { return f == 4 || f == 10 || f == 12 || f == 13 || f == 15 || f == 21; };
  const glm::dvec3 half(1.1, 2.3, 0.7);
  for (const glm::dmat3& axes : { glm::dmat3(1), Turned })
  {
    const auto box = hasp::MakeBox({ 0.3, 0.1, -0.7 }, axes, half);
    std::vector<int> met(26);
    for (int n = 0; n < 27; ++n)
    {
      const glm::dvec3 at = glm::dvec3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1) * half;
      for (const double off : { 0.0, 1e-14, -1e-14, 1e-10 })
      {
        const auto s = box->SampleAt(glm::dvec3(0.3, 0.1, -0.7) + axes * (at * (1 + off)));
        ASSERT_TRUE(isPlane(s.face)) << s.face;
        ++met[s.face];
      }
    }
    for (std::uint32_t f = 0; f < 26; ++f)
      EXPECT_EQ(met[f] > 0, isPlane(f)) << f;
  }
  const auto cylinder = hasp::MakeCylinder({ 0, 0, 0 }, { 0.3, 0.4, 1.2 }, 0.9);
  const glm::dvec3 up = glm::normalize(glm::dvec3(0.3, 0.4, 1.2));
  const glm::dvec3 out = glm::normalize(glm::cross(up, glm::dvec3(1, 0, 0)));
  for (const double off : { 0.0, 1e-14, 1e-10 })
    EXPECT_LT(cylinder->SampleAt((1.3 + off) * up + (0.9 + off) * out).face, 3);
}

TEST(SolidShapes, FacesGoOnBeyondTheirEdges)
{
  // A plane face is its whole plane, a side its whole cylinder, an edge its whole line.
  const auto box = hasp::MakeBox({}, glm::dmat3(1), { 1, 2, 3 });
  EXPECT_DOUBLE_EQ(box->FaceAt(box->SampleAt({ 1, 0, 0 }).face, { 1.5, 9, -9 }).value, 0.5);
  EXPECT_DOUBLE_EQ(box->FaceAt(box->SampleAt({ 2, 3, 0 }).face, { 2, 3, 99 }).value, std::sqrt(2));
  const auto cylinder = hasp::MakeCylinder({}, { 0, 0, 1 }, 2);
  EXPECT_DOUBLE_EQ(cylinder->FaceAt(0, { 3, 4, 50 }).value, 3);
  EXPECT_DOUBLE_EQ(cylinder->FaceAt(1, { 3, 4, 50 }).value, 49);
  EXPECT_DOUBLE_EQ(cylinder->FaceAt(2, { 3, 4, 50 }).value, -50);
}

TEST(SolidShapes, GradientsOfAllFacesFollowTheirValues)
{
  for (const Named& shape : AllShapes())
  {
    SCOPED_TRACE(shape.name);
    hasp::ExpectGradientsOfFaces(
      *shape.solid, hasp::RandomPlaces(100, 6), hasp::AllFaces(*shape.solid));
  }
}

TEST(SolidShapes, TiesNameTheLowestFaceWhateverTheLastDigit)
{
  const auto slab = hasp::MakeSlab({}, { 0, 0, 1 }, 1);
  const auto box = hasp::MakeBox({}, glm::dmat3(1), { 1, 1, 1 });
  const auto cylinder = hasp::MakeCylinder({}, { 0, 0, 3 }, 2);
  for (const double off : { 0.0, 1e-15, -1e-15 })
  {
    EXPECT_EQ(slab->SampleAt({ 3, 3, off }).face, 0);
    EXPECT_EQ(box->SampleAt({ 1, 1 + off, 0 }).face, box->SampleAt({ 1, 0, 0 }).face);
    EXPECT_EQ(box->SampleAt({ -1, 1 + off, -1 }).face, box->SampleAt({ -1, 0, 0 }).face);
    EXPECT_EQ(cylinder->SampleAt({ 2, 0, 3 + off }).face, 0);
    EXPECT_EQ(cylinder->SampleAt({ 0, 1.5, 2.5 + off }).face, 0);
    EXPECT_EQ(box->SampleAt({ 0.5, 0.5 + off, 0.5 }).face, box->SampleAt({ 1, 0, 0 }).face);
  }
}

TEST(SolidShapes, BoundsOfPlanesEndWhereTheyStandOnAnAxis)
{
  const auto up = hasp::MakePlane({ 0, 0, 3 }, { 0, 0, 2 })->Bounds();
  EXPECT_EQ(up.high, glm::dvec3(Infinite, Infinite, 3));
  EXPECT_EQ(up.low, glm::dvec3(-Infinite));
  const auto slab = hasp::MakeSlab({ 2, 0, 0 }, { -1, 0, 0 }, 1)->Bounds();
  EXPECT_EQ(slab.low.x, 1.5);
  EXPECT_EQ(slab.high.x, 2.5);
  EXPECT_EQ(hasp::MakePlane({}, Tilted)->Bounds().high, glm::dvec3(Infinite));
}

TEST(SolidShapes, AxesThatAreAlmostUprightStretchNothing)
{
  glm::dmat3 axes = Turned;
  axes[1] += 9e-5 * Turned[0];
  axes[2] *= 1 + 4e-5;
  const auto box = hasp::MakeBox({}, axes, { 2, 3, 1 });
  const auto places = hasp::RandomPlaces(2000, 6);
  hasp::ExpectNoSteeperThanPromised(*box, places);
  hasp::ExpectFootPointsOnSurface(*box, places);
}

TEST(SolidShapes, ThinAndSmallAndLargeOnesAreTrue)
{
  // Thinner than any voxel, a screw of 0.05 mm, a plate of 1 m with 0.1 mm of thickness.
  const hasp::SolidPointer shapes[] = { hasp::MakeSlab({ 0, 0, 900 }, Tilted, 1e-3),
    hasp::MakeBox({ 400, 0, 0 }, Turned, { 500, 500, 0.05 }),
    hasp::MakeCylinder({ 0, 0, 0 }, { 0, 1000, 0 }, 0.05),
    hasp::MakeBox({ 0, 0, 0 }, Turned, { 0.025, 0.025, 0.025 }) };
  for (const auto& shape : shapes)
  {
    hasp::ExpectSamplesAgree(*shape, hasp::RandomPlaces(500, 1000));
    hasp::ExpectNoSteeperThanPromised(*shape, hasp::RandomPlaces(500, 1000));
    hasp::ExpectFootPointsOnSurface(*shape, hasp::RandomPlaces(500, 1000));
    hasp::ExpectSamplesAgree(*shape, hasp::RandomPlaces(500, 0.1));
  }
}

TEST(SolidShapes, APlaceThatIsNotFiniteHasAFace)
{
  for (const Named& shape : AllShapes())
    for (const double bad : { std::nan(""), Infinite, -Infinite })
      EXPECT_LT(shape.solid->SampleAt({ 0, bad, 1 }).face, shape.solid->Faces()) << shape.name;
}

} // namespace
