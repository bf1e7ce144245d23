// The plane of symmetry of the phantom's head, which is known.
#include "Distance/Coverage.h"
#include "ImplantFixture.h"
#include "MirrorFit.h"

#include <glm/trigonometric.hpp>

#include <random>

using namespace implanttest;

namespace
{

constexpr double LowestMm = -1000.0; // all of the head

/// Fits, and holds the plane to x = 0 of the head's own axes: those of `turn`'s inverse.
void ExpectTruePlane(const Scan& scan, const glm::dmat3& turn)
{
  const auto keep = hasp::KeepLargePieces(scan.View(), HalfWayHU, 100.0);
  const hasp::MirrorPlane plane = hasp::FitMirrorPlane(scan.View(), HalfWayHU, keep);
  const glm::dvec3 normal = plane.normal * turn, point = plane.point * turn; // back
  const double tilt = glm::degrees(std::acos(std::min(std::abs(normal.x), 1.0)));
  EXPECT_LT(tilt, 0.2);
  // At the middle of the vault, not where the point happens to be.
  EXPECT_NEAR(glm::dot(normal, point), 0.0, 0.2);
  EXPECT_NEAR(glm::dot(normal, point - glm::dvec3(0, 0, 50)), 0.0, 0.2);
}

/// The same samples, said to lie turned.
void Turn(Scan& scan, const glm::dmat3& turn)
{
  scan.grid.origin = turn * scan.grid.origin;
  scan.grid.direction = turn * scan.grid.direction;
}

glm::dmat3 TurnOf(double degrees, const glm::dvec3& about)
{
  return glm::dmat3(glm::rotate(glm::dmat4(1.0), glm::radians(degrees), glm::normalize(about)));
}

TEST(MirrorFit, IsTrueInSpiteOfTheHoleAndNoise)
{
  ExpectTruePlane(Scan(1.5, LowestMm), glm::dmat3(1.0));
  ExpectTruePlane(Scan(1.5, LowestMm, 60.0), glm::dmat3(1.0));
}

TEST(MirrorFit, IsTrueForTheVaultAlone)
{
  ExpectTruePlane(Scan(1.5, 0.0), glm::dmat3(1.0));
}

TEST(MirrorFit, FindsATurnedHead)
{
  const Scan straight(1.5, LowestMm, 30.0);
  for (const glm::dvec3& about : { glm::dvec3(0, 0, 1), glm::dvec3(0, 1, 0), glm::dvec3(1, 2, -3) })
  {
    Scan scan = straight;
    const glm::dmat3 turn = TurnOf(24.0, about);
    Turn(scan, turn);
    ExpectTruePlane(scan, turn);
  }
}

TEST(MirrorFit, AJawThatStandsAsideDoesNotPullIt)
{
  Scan scan(1.5, LowestMm);
  const hasp::GridGeometry& g = scan.grid;
  const auto above = int((-75.0 - g.origin.z) / g.spacing.z); // of the body and the lower teeth
  constexpr int aside = 4;                                    // 6 mm
  const std::vector<std::int16_t> straight = scan.samples;
  for (int k = 0; k < above; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i)
      {
        const std::size_t row = (std::size_t(k) * g.dims.y + j) * g.dims.x;
        scan.samples[row + i] = straight[row + std::max(i - aside, 0)];
      }
  ASSERT_NE(scan.samples, straight);
  ExpectTruePlane(scan, glm::dmat3(1.0));
}

TEST(MirrorFit, AScanThatIsTooLargeIsRefusedBeforeMemoryIsTaken)
{
  const std::vector<std::int16_t> samples(8, 1000);
  const hasp::GridView<const std::int16_t> scan{ samples.data(),
    { glm::ivec3(2), {}, glm::dvec3(1200), glm::dmat3(1) } };
  try
  {
    hasp::FitMirrorPlane(scan, HalfWayHU, std::vector<std::uint8_t>(8, 1));
    ADD_FAILURE() << "not refused";
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find("crop the scan"), std::string::npos) << error.what();
  }
}

TEST(MirrorFit, BoneUnlikeItsMirrorImageIsNamed)
{
  // Balls of many sizes, anywhere.
  Scan scan(2.0, LowestMm);
  const hasp::GridGeometry& g = scan.grid;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(-0.8, 0.8), size(8.0, 20.0);
  std::vector<glm::dvec4> balls;
  const glm::dvec3 middle = g.IndexToWorld(0.5 * glm::dvec3(g.Cells()));
  for (int n = 0; n < 12; ++n)
  {
    const glm::dvec3 way(share(random), share(random), share(random));
    balls.emplace_back(middle + way * 0.5 * glm::dvec3(g.Cells()) * g.spacing, size(random));
  }
  for (std::size_t n = 0; n < scan.samples.size(); ++n)
  {
    const glm::dvec3 p = g.IndexToWorld({ double(n % g.dims.x), double(n / g.dims.x % g.dims.y),
      double(n / (std::size_t(g.dims.x) * g.dims.y)) });
    double depth = -20.0;
    for (const glm::dvec4& ball : balls)
      depth = std::max(depth, ball.w - glm::distance(p, glm::dvec3(ball)));
    scan.samples[n] = std::int16_t(HalfWayHU + 100.0 * std::min(depth, 5.0));
  }
  const auto keep = hasp::KeepLargePieces(scan.View(), HalfWayHU, 100.0);
  try
  {
    hasp::FitMirrorPlane(scan.View(), HalfWayHU, keep);
    ADD_FAILURE() << "balls anywhere have a mirror plane";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()).find("give the mirror plane"), std::string::npos);
  }
}

} // namespace
