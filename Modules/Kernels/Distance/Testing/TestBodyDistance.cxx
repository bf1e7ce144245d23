#include "Distance/BodyDistance.h"
#include "Distance/MeshCoverage.h"
#include "Testing/AnalyticCoverage.h"

#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace
{

using hasp::BodyDistance;
using hasp::BodyDistanceSettings;
using hasp::GridGeometry;
using hasp::TriangleMesh;

/// A box whose middle is `center`, its axes turned; signed distance in closed form, minus it for
/// AnalyticVolume.
struct TurnedBox
{
  glm::dvec3 center, half;
  glm::dmat3 axes;

  double Distance(const glm::dvec3& p) const
  {
    const glm::dvec3 q = glm::abs(glm::transpose(this->axes) * (p - this->center)) - this->half;
    return glm::length(glm::max(q, 0.0)) + std::min(0.0, std::max({ q.x, q.y, q.z }));
  }
  hasp::AnalyticVolume Volume() const
  {
    return { "box", [box = *this](const glm::dvec3& p) { return -box.Distance(p); }, 1.0 };
  }
  TriangleMesh Mesh() const
  {
    TriangleMesh mesh;
    for (int n = 0; n < 8; ++n)
      mesh.points.push_back(
        this->center +
        this->axes * (this->half * glm::dvec3(n & 1 ? 1 : -1, n & 2 ? 1 : -1, n & 4 ? 1 : -1)));
    for (const glm::uvec4& face : { glm::uvec4{ 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 },
           { 2, 6, 7, 3 }, { 0, 2, 3, 1 }, { 4, 5, 7, 6 } })
    {
      mesh.triangles.push_back({ face.x, face.y, face.z });
      mesh.triangles.push_back({ face.x, face.z, face.w });
    }
    return mesh;
  }
};

TurnedBox AnyBox()
{
  return { { 3, -7, 11 }, { 6, 10, 14 },
    glm::mat3_cast(glm::angleAxis(0.7, glm::normalize(glm::dvec3(1, 2, -1)))) };
}

/// Longitudes and latitudes; no point is shared between triangles.
TriangleMesh Ball(const glm::dvec3& center, double radius, int parts)
{
  TriangleMesh mesh;
  const auto at = [&](int i, int j)
  {
    const double u = std::numbers::pi * (i % (2 * parts)) / parts, v = std::numbers::pi * j / parts;
    const double r = j == 0 || j == parts ? 0.0 : std::sin(v);
    return center + radius * glm::dvec3(r * std::cos(u), r * std::sin(u), std::cos(v));
  };
  for (int j = 0; j < parts; ++j)
    for (int i = 0; i < 2 * parts; ++i)
      for (const auto& corners : { std::array{ at(i, j), at(i, j + 1), at(i + 1, j + 1) },
             std::array{ at(i, j), at(i + 1, j + 1), at(i + 1, j) } })
      {
        const auto first = static_cast<unsigned>(mesh.points.size());
        mesh.points.insert(mesh.points.end(), corners.begin(), corners.end());
        mesh.triangles.push_back({ first, first + 1, first + 2 });
      }
  return mesh;
}

/// Anisotropic, turned about a skew axis; its middle at `middle`.
GridGeometry SkewGrid(const glm::ivec3& dims, const glm::dvec3& spacing, const glm::dvec3& middle)
{
  GridGeometry g{ dims, glm::dvec3(0.0), spacing,
    glm::mat3_cast(glm::angleAxis(0.8, glm::normalize(glm::dvec3(1.0, -2.0, 0.5)))) };
  g.origin = middle - g.IndexToWorld(0.5 * glm::dvec3(dims - 1));
  return g;
}

std::string Refusal(const auto& call)
{
  try
  {
    call();
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "nothing was refused";
}

TEST(MeshCoverage, WhatIsNoClosedMeshIsRefused)
{
  TriangleMesh open = AnyBox().Mesh();
  const GridGeometry grid{ { 60, 60, 60 }, glm::dvec3(-27, -37, -19), glm::dvec3(1),
    glm::dmat3(1) };
  EXPECT_NO_THROW(hasp::MeshCoverage(open, grid));
  EXPECT_NE(Refusal([&] { hasp::MeshCoverage(open, grid, 0); }).find("[1, 16]"), std::string::npos);
  open.triangles.pop_back();
  EXPECT_NE(Refusal([&] { hasp::MeshCoverage(open, grid); }).find("not closed"), std::string::npos);
  // A lid is missing that lines along x never meet: closed as they see it, its hole at z = 14.
  TriangleMesh lidless = TurnedBox{ { 3, -7, 0 }, { 6, 10, 14 }, glm::dmat3(1) }.Mesh();
  lidless.triangles.resize(10);
  const std::string said = Refusal([&] { hasp::MeshCoverage(lidless, grid); });
  EXPECT_NE(said.find("not closed"), std::string::npos) << said;
  EXPECT_NE(said.find("14.000000) mm"), std::string::npos) << said;
  TriangleMesh wrong = AnyBox().Mesh();
  std::swap(wrong.triangles[3].y, wrong.triangles[3].z);
  const std::string turned = Refusal([&] { hasp::MeshCoverage(wrong, grid); });
  EXPECT_NE(turned.find("wound against each other"), std::string::npos) << turned;
  wrong = AnyBox().Mesh();
  wrong.triangles[3].y = 8;
  EXPECT_NE(
    Refusal([&] { hasp::MeshCoverage(wrong, grid); }).find("point 8 of 8"), std::string::npos);
  wrong = AnyBox().Mesh();
  wrong.points[2].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(Refusal([&] { hasp::MeshCoverage(wrong, grid); }).find("finite"), std::string::npos);
}

// A box along the grid: shares are products of overlaps. Faces lie between lines, on lines, and on
// the faces of voxels.
TEST(MeshCoverage, BoxAlongTheGridIsExact)
{
  const GridGeometry grid{ { 12, 12, 12 }, glm::dvec3(0), glm::dvec3(1), glm::dmat3(1) };
  for (const double from : { 2.2, 2.5, 2.0, 2.375 })
  {
    const double to = from + 4.3;
    const TurnedBox box{ glm::dvec3(0.5 * (from + to)), glm::dvec3(0.5 * (to - from)),
      glm::dmat3(1) };
    const auto coverage = hasp::MeshCoverage(box.Mesh(), grid, 16);
    const auto overlap = [&](int i)
    { return std::clamp(std::min(to, i + 0.5) - std::max(from, i - 0.5), 0.0, 1.0); };
    double volume = 0.0;
    for (int n = 0; n < 12 * 12 * 12; ++n)
    {
      const double truth = overlap(n % 12) * overlap(n / 12 % 12) * overlap(n / 144);
      // Of 16 lines one may be in or out at either end.
      EXPECT_NEAR(coverage[n], truth, 2.0 / 16.0) << n << " from " << from;
      volume += coverage[n];
    }
    EXPECT_NEAR(volume, std::pow(to - from, 3.0), 0.03 * std::pow(to - from, 3.0)) << from;
  }
}

// Farther than integers count, before the grid, beyond it, and on both sides of it.
TEST(MeshCoverage, WhatLiesFarFromTheGridIsNotInIt)
{
  const GridGeometry grid{ { 6, 6, 6 }, glm::dvec3(0), glm::dvec3(1), glm::dmat3(1) };
  for (const double middle : { -3e10, 3e10, 0.0 })
  {
    const TurnedBox box{ { middle, 2, 2 }, { 2e10, 40, 40 }, glm::dmat3(1) };
    const auto coverage = hasp::MeshCoverage(box.Mesh(), grid);
    for (const float share : coverage)
      ASSERT_EQ(share, middle == 0.0 ? 1.0F : 0.0F) << middle;
  }
}

TEST(MeshCoverage, WindingsTheWrongWayRoundAndTwiceCountOnce)
{
  const GridGeometry grid = SkewGrid({ 50, 40, 40 }, { 0.9, 1.1, 1.4 }, { 3, -7, 11 });
  const TriangleMesh mesh = AnyBox().Mesh();
  const auto coverage = hasp::MeshCoverage(mesh, grid);
  TriangleMesh inward = mesh, twice = mesh;
  for (glm::uvec3& t : inward.triangles)
    std::swap(t.x, t.y);
  twice.triangles.insert(twice.triangles.end(), mesh.triangles.begin(), mesh.triangles.end());
  const auto other = hasp::MeshCoverage(inward, grid);
  EXPECT_EQ(coverage.size(), other.size());
  for (std::size_t n = 0; n < coverage.size(); ++n)
    ASSERT_NEAR(coverage[n], other[n], 1e-6);
  EXPECT_EQ(hasp::MeshCoverage(twice, grid), coverage);
  double volume = 0.0;
  for (const float share : coverage)
    volume += share * 0.9 * 1.1 * 1.4;
  EXPECT_NEAR(volume, 8.0 * 6.0 * 10.0 * 14.0, 20.0); // 0.3 %
}

TEST(BodyDistance, BadSettingsAndBodiesAreRefusedBeforeMemoryIsTaken)
{
  const TriangleMesh box = AnyBox().Mesh();
  EXPECT_NE(Refusal([&] { hasp::DistanceOfMesh(box, { .spacingMm = -1.0 }); }).find("-1.0"),
    std::string::npos);
  EXPECT_NE(Refusal([&] { hasp::DistanceOfMesh(box, { .bandMm = std::nan("") }); }).find("band"),
    std::string::npos);
  EXPECT_NE(Refusal([&] { hasp::DistanceOfMesh({}); }).find("no triangles"), std::string::npos);
  // 2e12 samples: nobody has that.
  const std::string tooLarge =
    Refusal([&] { hasp::DistanceOfMesh(box, { .spacingMm = 0.003, .bandMm = 1.0 }); });
  ASSERT_NE(tooLarge.find("with a spacing of "), std::string::npos) << tooLarge;
  const double advised = std::stod(tooLarge.substr(tooLarge.find("with a spacing of ") + 18));
  EXPECT_GT(advised, 0.003);
  EXPECT_LT(advised, 0.3);
  const std::vector<float> nothing(27, 0.0F);
  const hasp::GridView<const float> empty{ nothing.data(),
    { glm::ivec3(3), glm::dvec3(0), glm::dvec3(1), glm::dmat3(1) } };
  EXPECT_NE(
    Refusal([&] { hasp::DistanceOfVolume(empty, 1.0); }).find("no sample"), std::string::npos);
  EXPECT_NE(
    Refusal([&] { hasp::DistanceOfVolume(empty, INFINITY); }).find("finite"), std::string::npos);
  // Thinner than any voxel that it could be seen in.
  const TurnedBox leaf{ glm::dvec3(0.1), { 20, 20, 1e-5 }, glm::dmat3(1) };
  EXPECT_NE(Refusal([&] { hasp::DistanceOfMesh(leaf.Mesh(), { .spacingMm = 2 }); }).find("thin"),
    std::string::npos);
}

TEST(BodyDistance, ProgressGrowsAndCancels)
{
  double last = -1.0;
  int calls = 0;
  hasp::DistanceOfMesh(AnyBox().Mesh(), { .spacingMm = 1.5 },
    [&](double share)
    {
      EXPECT_GE(share, last);
      last = share;
      ++calls;
      return true;
    });
  EXPECT_NEAR(last, 1.0, 1e-9);
  EXPECT_GT(calls, 10);
  for (int most = 1; most < calls; most += calls / 5)
  {
    int seen = 0;
    EXPECT_THROW(hasp::DistanceOfMesh(
                   AnyBox().Mesh(), { .spacingMm = 1.5 }, [&](double) { return ++seen < most; }),
      hasp::Cancelled);
    EXPECT_EQ(seen, most) << "nothing goes on after it was cancelled";
  }
}

// Held: what the header says. Error in spacings, of samples within three of them of the surface.
void ExpectError(const char* what, const BodyDistance& body, const hasp::AnalyticVolume& truth,
  double rms, double most)
{
  const hasp::DistanceError error = hasp::ErrorOf(body.distances, truth, body.geometry, 3.0);
  std::printf("%-28s %9zu samples: rms %.4f  p99 %.4f  most %.4f spacings\n", what,
    body.distances.size(), error.rms, error.p99, error.most);
  EXPECT_GT(error.rms, 0.0) << what << ": there are samples near the surface";
  EXPECT_LE(error.rms, rms) << what;
  EXPECT_LE(error.most, most) << what;
}

TEST(BodyDistance, BallsAreWithinTheStatedError)
{
  const glm::dvec3 center(3, -7, 11);
  const hasp::AnalyticVolume ball = hasp::AnalyticSphere(center, 12.0);
  // 144 parts: chords lie at most 0.7e-3 mm inside the ball.
  ExpectError("ball, mesh", hasp::DistanceOfMesh(Ball(center, 12.0, 144), { .spacingMm = 0.6 }),
    ball, 0.03, 0.15);
  const GridGeometry grid = SkewGrid({ 50, 36, 28 }, { 0.6, 0.9, 1.2 }, center);
  const auto samples = hasp::SampleAnalytic<float>(ball, grid, 1.0, 0.0);
  ExpectError("ball, anisotropic volume",
    hasp::DistanceOfVolume(hasp::GridView<const float>{ samples.data(), grid }, 0.0), ball, 0.03,
    0.15);
}

/// Of samples within three spacings of a box whose nearest point of it lies three spacings and more
/// from its edges (0), or closer to one edge (1), or to several (2).
std::array<hasp::DistanceError, 3> ErrorsOf(const BodyDistance& body, const TurnedBox& box)
{
  const double h = body.geometry.spacing.x;
  std::array<std::vector<double>, 3> errors;
  const glm::ivec3 dims = body.geometry.dims;
  for (std::size_t n = 0; n < body.distances.size(); ++n)
  {
    const glm::ivec3 at(n % dims.x, n / dims.x % dims.y, n / dims.x / dims.y);
    const glm::dvec3 p = body.geometry.IndexToWorld(at);
    const double truth = box.Distance(p);
    if (std::abs(truth) > 3.0 * h)
      continue;
    const glm::dvec3 q = box.half - glm::abs(glm::transpose(box.axes) * (p - box.center));
    const int near = int(q.x < 3.0 * h) + int(q.y < 3.0 * h) + int(q.z < 3.0 * h);
    errors[std::max(0, near - 1)].push_back(std::abs(body.distances[n] - truth) / h);
  }
  std::array<hasp::DistanceError, 3> all;
  for (int kind = 0; kind < 3; ++kind)
  {
    for (const double e : errors[kind])
    {
      all[kind].rms += e * e / double(errors[kind].size());
      all[kind].most = std::max(all[kind].most, e);
    }
    all[kind].rms = std::sqrt(all[kind].rms);
  }
  return all;
}

TEST(BodyDistance, TurnedBoxesAreWithinTheStatedError)
{
  const TurnedBox box = AnyBox();
  const auto hold = [&](const char* what, const BodyDistance& body, auto rms, auto most)
  {
    const auto errors = ErrorsOf(body, box);
    for (int kind = 0; kind < 3; ++kind)
    {
      std::printf("%-24s %-8s rms %.4f  most %.4f spacings\n", what,
        std::array{ "faces", "edges", "corners" }[kind], errors[kind].rms, errors[kind].most);
      EXPECT_GT(errors[kind].rms, 0.0) << what << ": there are samples";
      EXPECT_LE(errors[kind].rms, rms[kind]) << what << " " << kind;
      EXPECT_LE(errors[kind].most, most[kind]) << what << " " << kind;
    }
  };
  hold("box, mesh", hasp::DistanceOfMesh(box.Mesh(), { .spacingMm = 0.6 }),
    std::array{ 0.02, 0.3, 0.35 }, std::array{ 0.45, 1.6, 1.6 });
  const GridGeometry grid = SkewGrid({ 80, 56, 42 }, { 0.6, 0.9, 1.2 }, box.center);
  const auto samples = hasp::SampleAnalytic<float>(box.Volume(), grid, 1.0, 0.0);
  // The volume's own trilinear surface rounds edges off, the more the larger its spacings.
  hold("box, anisotropic volume",
    hasp::DistanceOfVolume(hasp::GridView<const float>{ samples.data(), grid }, 0.0),
    std::array{ 0.02, 0.35, 0.5 }, std::array{ 0.45, 1.6, 1.6 });
}

TEST(BodyDistance, TheGridHoldsTheBodyAndItsBand)
{
  const TurnedBox box = AnyBox();
  const BodyDistance body = hasp::DistanceOfMesh(box.Mesh(), { .spacingMm = 1.0, .bandMm = 5.0 });
  const glm::ivec3 dims = body.geometry.dims;
  for (std::size_t n = 0; n < body.distances.size(); ++n)
  {
    const glm::ivec3 at(n % dims.x, n / dims.x % dims.y, n / dims.x / dims.y);
    if (glm::any(glm::equal(at, glm::ivec3(0))) || glm::any(glm::equal(at, dims - 1)))
    {
      ASSERT_GE(body.distances[n], 5.0);
    }
  }
  EXPECT_LT(body.distances.size(), 60u * 60u * 60u) << "and not much more";
}

// What is cut off by the volume's border is closed there.
TEST(BodyDistance, ABodyAtTheVolumesBorderIsClosed)
{
  const std::vector<float> full(20 * 20 * 20, 1.0F);
  const GridGeometry grid{ glm::ivec3(20), glm::dvec3(0), glm::dvec3(1), glm::dmat3(1) };
  const BodyDistance body =
    hasp::DistanceOfVolume(hasp::GridView<const float>{ full.data(), grid }, 0.5);
  const TurnedBox box{ glm::dvec3(9.5), glm::dvec3(9.5), glm::dmat3(1) };
  // Of five lines across half a voxel two or three are inside: a tenth of a spacing.
  ExpectError("a full volume", body, box.Volume(), 0.2, 0.5);
}

} // namespace
