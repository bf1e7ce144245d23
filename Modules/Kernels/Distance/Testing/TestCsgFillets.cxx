#include "Distance/Csg.h"
#include "Distance/SolidShapes.h"
#include "Testing/SolidPromises.h"

#include <algorithm>

/// Unions with fillets, and intersections with round edges.
namespace
{

hasp::SolidPointer Box(const glm::dvec3& center, const glm::dvec3& half)
{
  return hasp::MakeBox(center, glm::dmat3(1), half);
}

TEST(CsgFillets, ASmoothUnionIsFilledByAFillet)
{
  const auto floor = hasp::MakePlane({}, { 0, 0, 1 }), wall = hasp::MakePlane({}, { 1, 0, 0 });
  const auto joined = hasp::MakeSmoothUnion(floor, wall, 2);
  // On the crease a quarter of the radius is added, 2 mm off it nothing.
  EXPECT_DOUBLE_EQ(joined->At({ 0, 0, 0 }), -0.5);
  EXPECT_DOUBLE_EQ(joined->At({ 0, 0, 2 }), 0);
  EXPECT_DOUBLE_EQ(joined->At({ 1, 0, 2 }), 1 - 0.125);
  EXPECT_DOUBLE_EQ(joined->At({ 9, 0, 0.5 }), 0.5);
  EXPECT_EQ(joined->Faces(), 3u);
  EXPECT_EQ(joined->SampleAt({ 9, 0, 0 }).face, 0u);
  EXPECT_EQ(joined->SampleAt({ 0, 0, 9 }).face, 1u);
  EXPECT_EQ(joined->SampleAt({ 0.5, 0, 0.5 }).face, 2u);
  // Without a crease at its rims.
  for (const double off : { -1e-7, 1e-7 })
    EXPECT_LT(
      glm::distance(joined->SampleAt({ 0, 0, 2 + off }).gradient, glm::dvec3(1, 0, 0)), 1e-6);
  for (const glm::dvec3& x : hasp::RandomPlaces(2000, 4))
  {
    const double a = floor->At(x), b = wall->At(x), h = std::max(0.0, 1 - std::abs(a - b) / 2);
    ASSERT_NEAR(joined->At(x), std::min(a, b) - h * h * 0.5, 1e-14);
  }
}

TEST(CsgFillets, ASmoothIntersectionLosesItsEdges)
{
  const auto floor = hasp::MakePlane({}, { 0, 0, 1 }), wall = hasp::MakePlane({}, { 1, 0, 0 });
  const auto common = hasp::MakeSmoothIntersection(floor, wall, 2);
  // On the edge a quarter of the radius is taken away, 2 mm before it nothing.
  EXPECT_DOUBLE_EQ(common->At({ 0, 0, 0 }), 0.5);
  EXPECT_DOUBLE_EQ(common->At({ 0, 0, -2 }), 0);
  EXPECT_EQ(common->Faces(), 3u);
  EXPECT_EQ(common->SampleAt({ -0.5, 0, -0.5 }).face, 2u);
  for (const double off : { -1e-7, 1e-7 })
    EXPECT_LT(
      glm::distance(common->SampleAt({ 0, 0, -2 + off }).gradient, glm::dvec3(1, 0, 0)), 1e-6);
  for (const glm::dvec3& x : hasp::RandomPlaces(2000, 4))
  {
    const double a = floor->At(x), b = wall->At(x), h = std::max(0.0, 1 - std::abs(a - b) / 2);
    ASSERT_NEAR(common->At(x), std::max(a, b) + h * h * 0.5, 1e-14);
  }
  const auto rounded = hasp::MakeSmoothIntersection(
    hasp::MakeCapsule({ 1, 0, 0 }, { 1, 0, 0 }, 2), Box({}, { 2, 1, 1 }), 1);
  EXPECT_EQ(rounded->Bounds().low.x, -1);
  EXPECT_EQ(rounded->Bounds().high.x, 2);
  hasp::ExpectSamplesAgree(*rounded, hasp::RandomPlaces(2000, 4));
  hasp::ExpectNoSteeperThanPromised(*rounded, hasp::RandomPlaces(2000, 4));
}

TEST(CsgFillets, BoundsOfASmoothUnionHoldWhatItAdds)
{
  // Tops in one plane: the fillet rises a quarter of the radius above them.
  const auto joined =
    hasp::MakeSmoothUnion(Box({}, { 2, 1, 1 }), Box({ 1, 0, 0 }, { 2, 1, 1 }), 0.8);
  EXPECT_NEAR(joined->At({ 0.5, 0, 1.2 }), 0.0, 1e-12);
  EXPECT_LT(joined->At({ 0.5, 0, 1.19 }), 0.0);
  EXPECT_GE(joined->Bounds().high.z, 1.2);
  hasp::ExpectSamplesAgree(*joined, hasp::RandomPlaces(2000, 4));
}

} // namespace
