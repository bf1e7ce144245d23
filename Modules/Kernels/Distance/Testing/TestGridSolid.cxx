#include "Distance/GridSolid.h"
#include "Testing/AnalyticCoverage.h"
#include "Testing/SolidPromises.h"

#include "Distance/ChamferDistance.h"
#include "Distance/CoverageDistance.h"
#include "Distance/Csg.h"
#include "Distance/EuclideanDistance.h"
#include "Distance/SolidShapes.h"
#include "Grid/Trilinear.h"

#include <glm/gtc/matrix_transform.hpp>

namespace
{

hasp::GridGeometry Turned(const glm::ivec3& dims, const glm::dvec3& spacing)
{
  hasp::GridGeometry g;
  g.dims = dims;
  g.spacing = spacing;
  g.direction = glm::dmat3(glm::rotate(glm::dmat4(1), 0.5, glm::dvec3(1, 2, 2)));
  g.origin = -g.direction * (0.5 * glm::dvec3(g.Cells()) * spacing);
  return g;
}

std::shared_ptr<std::vector<float>> Sampled(
  const hasp::ImplicitSolid& solid, const hasp::GridGeometry& g)
{
  auto values = std::make_shared<std::vector<float>>();
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i)
        values->push_back(static_cast<float>(solid.At(g.IndexToWorld({ i, j, k }))));
  return values;
}

const hasp::GridGeometry Grid = Turned({ 31, 27, 21 }, { 0.5, 0.6, 0.8 });
const hasp::SolidPointer Ball = hasp::MakeCapsule({ 0.2, 0.1, 0 }, { 0.2, 0.1, 0 }, 5);

TEST(GridSolid, RefusesWhatIsNoDistance)
{
  const auto ball = Sampled(*Ball, Grid);
  EXPECT_THROW(hasp::MakeGridSolid(nullptr, Grid), std::invalid_argument);
  EXPECT_THROW(
    hasp::MakeGridSolid(std::make_shared<std::vector<float>>(5), Grid), std::invalid_argument);
  EXPECT_THROW(
    hasp::MakeGridSolid(std::make_shared<std::vector<float>>(4), Turned({ 2, 2, 1 }, { 1, 1, 1 })),
    std::invalid_argument);
  auto invalid = Grid;
  invalid.spacing.y = 0;
  EXPECT_THROW(hasp::MakeGridSolid(ball, invalid), std::invalid_argument);
  for (const float bad : { std::nanf(""), std::numeric_limits<float>::infinity() })
    for (const std::size_t at : { std::size_t(0), ball->size() / 2, ball->size() - 1 })
    {
      auto broken = std::make_shared<std::vector<float>>(*ball);
      (*broken)[at] = bad;
      EXPECT_THROW(hasp::MakeGridSolid(broken, Grid), std::invalid_argument);
    }
  auto grey = std::make_shared<std::vector<float>>(*ball);
  for (float& value : *grey)
    value *= -200;
  EXPECT_THROW(hasp::MakeGridSolid(grey, Grid), std::invalid_argument);
}

TEST(GridSolid, RefusesFieldsOfOtherSlopes)
{
  const auto said = [](double scale, const hasp::SolidPointer& solid = Ball)
  {
    auto values = Sampled(*solid, Grid);
    for (float& value : *values)
      value = float(value * scale);
    try
    {
      hasp::MakeGridSolid(values, Grid);
    }
    catch (const std::invalid_argument& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(said(0.7), "");
  EXPECT_EQ(said(1.3), "");
  EXPECT_NE(said(0.1).find("less than 0.5 mm a mm"), std::string::npos); // cm
  EXPECT_NE(said(-0.25).find("signed distances"), std::string::npos);    // a scan, scaled
  // Not above 3 anywhere: distances in voxels of 0.4 mm.
  const hasp::SolidPointer plane = hasp::MakePlane({ 0, 0, 0 }, { 1, 2, 3 });
  EXPECT_NE(said(1.0 / 0.4, plane).find("more than 2 mm a mm"), std::string::npos);
}

/// A wall, turned, a plate with an end, and a ball smaller than a cell.
hasp::SolidPointer ThinParts(double mm)
{
  return hasp::MakeUnion(
    { hasp::MakeIntersection({ hasp::MakeSlab({ 0.1, 0.2, 0.3 }, { 1, 2, 3 }, mm),
        hasp::MakeBox({ 0, 0, 0 }, glm::dmat3(1), { 6, 6, 6 }) }),
      hasp::MakeSlab({ 0, 0, 4.03 }, { 0, 0, 1 }, mm),
      hasp::MakeCapsule({ -5.6, 5.1, -5 }, { -5.5, 5.1, -5 }, 0.5 * mm) });
}

TEST(GridSolid, TakesDistancesOfThinWallsBandsAndNoise)
{
  // Cells of 0.5 x 0.6 x 0.8 mm, and of 0.4 x 0.4 x 2.
  for (const hasp::GridGeometry& grid : { Grid, Turned({ 41, 41, 9 }, { 0.4, 0.4, 2.0 }) })
    for (const double mm : { 0.05, 0.2, 0.4, 0.8, 1.6, 3.0 })
    {
      const auto exact = Sampled(*ThinParts(mm), grid);
      EXPECT_NO_THROW(hasp::MakeGridSolid(exact, grid)) << mm;
      std::mt19937 random(3);
      std::normal_distribution<float> any(0.0F, 0.08F); // 0.2 voxels
      auto noisy = std::make_shared<std::vector<float>>(*exact);
      auto band = std::make_shared<std::vector<float>>(*exact);
      for (float& value : *noisy)
        value += std::clamp(any(random), -0.16F, 0.16F);
      for (float& value : *band)
        value = std::clamp(value, -0.8F, 0.8F); // two voxels of 0.4 mm
      EXPECT_NO_THROW(hasp::MakeGridSolid(noisy, grid)) << mm;
      EXPECT_NO_THROW(hasp::MakeGridSolid(band, grid)) << mm;
    }
}

TEST(GridSolid, TakesWhatAllTransformsMake)
{
  const hasp::GridGeometry grid{ { 33, 33, 17 }, { -6.4, -6.4, -6.4 }, { 0.4, 0.4, 0.8 },
    glm::dmat3(1) };
  for (const double mm : { 0.5, 0.8, 1.6 }) // thinner is no coverage
  {
    const hasp::SolidPointer parts = ThinParts(mm);
    const hasp::AnalyticVolume volume{ "", [&](const glm::dvec3& p) { return -parts->At(p); }, 1 };
    const std::vector<float> coverage = hasp::AnalyticCoverage(volume, grid);
    const std::vector<float> grey = hasp::SampleAnalytic<float>(volume, grid, 1000.0, 226.0);
    std::vector<std::uint8_t> mask;
    for (const float share : coverage)
      mask.push_back(share >= 0.5F);
    const auto taken = [&](std::vector<float> distance, const char* how)
    {
      if (std::isfinite(distance[0])) // else nothing is inside
      {
        EXPECT_NO_THROW(hasp::MakeGridSolid(
          std::make_shared<const std::vector<float>>(std::move(distance)), grid))
          << how << " " << mm;
      }
    };
    taken(hasp::CoverageDistance(grid, coverage), "coverage");
    taken(hasp::CoverageDistanceBand(grid, coverage), "band");
    taken(hasp::ChamferDistance(grid, coverage), "chamfer");
    taken(hasp::CoverageDistance(grid, std::vector<float>(mask.begin(), mask.end())), "mask");
    taken(hasp::SignedEuclideanDistance(grid, mask), "Euclidean");
    taken(hasp::GreyDistance(hasp::GridView<const float>{ grey.data(), grid }, 226.0), "grey");
  }
}

TEST(GridSolid, KeepsThePromisesOfASolid)
{
  const auto solid = hasp::MakeGridSolid(Sampled(*Ball, Grid), Grid);
  const auto places = hasp::RandomPlaces(3000, 11);
  hasp::ExpectSamplesAgree(*solid, places);
  hasp::ExpectNoSteeperThanPromised(*solid, places);
  // Of a ball in its middle, steeper elsewhere not at all.
  EXPECT_GT(solid->Steepness(), 1.0);
  EXPECT_LT(solid->Steepness(), std::sqrt(3.0));
}

TEST(GridSolid, MeasuresHowSteepItIs)
{
  // Linear fields by their gradient, what is below 1 as 1, and one cell alone is not overlooked.
  const auto linear = [](const glm::dvec3& slope, bool oneCell)
  {
    auto values = std::make_shared<std::vector<float>>();
    for (int k = 0; k < Grid.dims.z; ++k)
      for (int j = 0; j < Grid.dims.y; ++j)
        for (int i = 0; i < Grid.dims.x; ++i)
          values->push_back(!oneCell || (i > 29 && j > 25 && k > 19)
                              ? float(glm::dot(slope, glm::dvec3(i, j, k) * Grid.spacing))
                              : 0.0F);
    return hasp::MakeGridSolid(values, Grid)->Steepness();
  };
  EXPECT_NEAR(linear({ 0.9, -0.8, 0.7 }, false), std::sqrt(0.81 + 0.64 + 0.49), 1e-5);
  EXPECT_NEAR(linear({ 0, 0, 2.5 }, false), 2.5, 1e-5);
  EXPECT_EQ(linear({ 0.3, 0.3, -0.3 }, false), 1.0);
  EXPECT_THROW(linear({ 0, 0, 0.5 }, true), std::invalid_argument); // 10 mm at the last sample
}

TEST(GridSolid, IsTrilinearWithinTheGrid)
{
  const auto values = Sampled(*Ball, Grid);
  const auto solid = hasp::MakeGridSolid(values, Grid);
  int met = 0;
  for (const glm::dvec3& x : hasp::RandomPlaces(2000, 9))
  {
    const auto truth = hasp::SampleTrilinear(
      hasp::GridView<const float>{ values->data(), Grid }, Grid.WorldToIndex(x));
    if (!truth)
      continue;
    ++met;
    ASSERT_NEAR(solid->FaceAt(0, x).value, *truth, 1e-9);
    if (glm::length(x) > 5.5) // the border may be nearer
      continue;
    ASSERT_NEAR(solid->At(x), *truth, 1e-9);
    // Trilinear between samples of a ball, h^2 / (8 R) a direction in which it is curved, in all
    // (0.36 + 0.64) / (8 * 4) at 1 mm below its surface at most.
    ASSERT_TRUE(*truth < -1.0 || std::abs(*truth - Ball->At(x)) < 0.032);
  }
  EXPECT_GT(met, 500);
}

TEST(GridSolid, GradientsFollowTheValues)
{
  const auto solid = hasp::MakeGridSolid(Sampled(*Ball, Grid), Grid);
  std::vector<glm::dvec3> places;
  for (const glm::dvec3& x : hasp::RandomPlaces(3000, 11))
  {
    // Off the faces between cells, where the gradient jumps.
    const glm::dvec3 index = Grid.WorldToIndex(x), from = glm::abs(index - glm::round(index));
    if (std::min({ from.x, from.y, from.z }) > 1e-3)
      places.push_back(x);
  }
  hasp::ExpectGradientsOfFaces(*solid, places, { 0 });
}

TEST(GridSolid, WhatReachesTheBorderIsCutOffThere)
{
  const auto everything =
    hasp::MakeGridSolid(std::make_shared<std::vector<float>>(Grid.Size(), -3.0F), Grid);
  const glm::dvec3 half = 0.5 * glm::dvec3(Grid.Cells()) * Grid.spacing;
  const auto box = hasp::MakeBox({}, Grid.direction, half);
  for (const glm::dvec3& x : hasp::RandomPlaces(2000, 11))
  {
    ASSERT_NEAR(everything->At(x), std::max(box->At(x), -3.0), 1e-9);
    if (box->At(x) > 0)
    {
      ASSERT_EQ(everything->SampleAt(x).face, 1 + box->SampleAt(x).face);
      ASSERT_NEAR(everything->FaceAt(1 + box->SampleAt(x).face, x).value, box->At(x), 1e-9);
    }
  }
  const auto nothing =
    hasp::MakeGridSolid(std::make_shared<std::vector<float>>(Grid.Size(), 3.0F), Grid);
  for (const glm::dvec3& x : hasp::RandomPlaces(500, 20))
    ASSERT_GT(nothing->At(x), 0.0);
}

TEST(GridSolid, BeyondTheBorderItIsABoundOfTheDistance)
{
  // A ball that ends 0.8 mm before the border: the nearest place of the grid is c, and a solid in a
  // convex box is no nearer than by Pythagoras' theorem.
  const hasp::GridGeometry grid = Turned({ 25, 25, 25 }, glm::dvec3(0.5));
  const auto ball = hasp::MakeCapsule({}, {}, 5.2);
  const auto solid = hasp::MakeGridSolid(Sampled(*ball, grid), grid);
  const auto box = hasp::MakeBox({}, grid.direction, 0.5 * glm::dvec3(grid.Cells()) * grid.spacing);
  constexpr double Trilinear = 0.02; // h^2 / (8 R) a direction
  int outside = 0;
  for (const glm::dvec3& x : hasp::RandomPlaces(4000, 14))
    if (const auto beyond = box->SampleAt(x); beyond.value > 0.0)
    {
      ++outside;
      const double there = ball->At(x - beyond.value * beyond.gradient);
      ASSERT_NEAR(solid->At(x), std::hypot(there, beyond.value), Trilinear);
      ASSERT_LT(solid->At(x), ball->At(x) + Trilinear);
      // No distance is above there + beyond, and that no more than sqrt(2) times their hypotenuse.
      ASSERT_GT(solid->At(x), (ball->At(x) - Trilinear) * std::sqrt(0.5) - Trilinear);
    }
  EXPECT_GT(outside, 2000);
  hasp::ExpectSamplesAgree(*solid, hasp::RandomPlaces(3000, 14));
  hasp::ExpectNoSteeperThanPromised(*solid, hasp::RandomPlaces(3000, 14));
}

TEST(GridSolid, KeepsItsPromisesWhereItIsCutOff)
{
  // Cut by the border on one side, near to it on the other.
  const auto ball = hasp::MakeCapsule({ 4, 0, 0 }, { 4, 0, 0 }, 5.2);
  const auto solid = hasp::MakeGridSolid(Sampled(*ball, Grid), Grid);
  const auto places = hasp::RandomPlaces(4000, 14);
  hasp::ExpectSamplesAgree(*solid, places);
  hasp::ExpectNoSteeperThanPromised(*solid, places);
  std::vector<glm::dvec3> smooth; // off the faces of cells, and where the ball meets the border
  for (const glm::dvec3& x : places)
  {
    const glm::dvec3 index = Grid.WorldToIndex(x), from = glm::abs(index - glm::round(index));
    const glm::dvec3 nearest =
      Grid.IndexToWorld(glm::clamp(index, glm::dvec3(0), glm::dvec3(Grid.Cells())));
    if (std::min({ from.x, from.y, from.z }) > 1e-3 && std::abs(ball->At(nearest)) > 0.1)
      smooth.push_back(x);
  }
  hasp::ExpectGradientsOfFaces(*solid, smooth, { 0 });
}

TEST(GridSolid, JoinsShapesInATree)
{
  const auto bone = hasp::MakeGridSolid(Sampled(*Ball, Grid), Grid);
  const auto hole = hasp::MakeCylinder({ 0, 0, -9 }, { 0, 0, 9 }, 1);
  const auto drilled = hasp::MakeDifference(bone, hole);
  EXPECT_NEAR(drilled->At({ 0, 0, 0 }), 1.0, 1e-9);
  EXPECT_NEAR(drilled->At({ 1, 0, 0 }), 0.0, 1e-9);
  EXPECT_EQ(drilled->SampleAt({ 1.001, 0, 0 }).face, bone->Faces());
  EXPECT_EQ(drilled->Steepness(), bone->Steepness());
  hasp::ExpectSamplesAgree(*drilled, hasp::RandomPlaces(1000, 11));
  hasp::ExpectNoSteeperThanPromised(*drilled, hasp::RandomPlaces(1000, 11));
}

TEST(GridSolid, APlaceThatIsNotFiniteHasAFace)
{
  const auto solid = hasp::MakeGridSolid(Sampled(*Ball, Grid), Grid);
  for (const double bad : { std::nan(""), std::numeric_limits<double>::infinity(), -1e300, 1e300 })
    EXPECT_LT(solid->SampleAt({ 0, bad, 1 }).face, solid->Faces());
}

} // namespace
