#include "Distance/MeshCoverage.h"
#include "Distance/SheetMesh.h"
#include "Evaluation/MeshCheck.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace
{

using glm::dvec3;
using hasp::MeshCheck;
using hasp::MeshRims;
using hasp::TriangleMesh;

/// A disc of 10 mm in z = 3, wound so that +z is outside.
TriangleMesh Disc(int parts = 96)
{
  TriangleMesh mesh;
  mesh.points.push_back({ 0, 0, 3 });
  for (int n = 0; n < parts; ++n)
  {
    const double a = 2.0 * glm::pi<double>() * n / parts;
    mesh.points.push_back({ 10.0 * std::cos(a), 10.0 * std::sin(a), 3 });
    mesh.triangles.push_back({ 0, 1 + unsigned(n), 1 + unsigned((n + 1) % parts) });
  }
  return mesh;
}

/// A sphere of 12 mm from latitude `from` to the pole, radians, wound outward; its pole is points
/// that are equal but for rounding.
TriangleMesh Cap(double from)
{
  TriangleMesh mesh;
  constexpr unsigned Round = 128, Up = 80;
  for (unsigned u = 0; u <= Up; ++u)
    for (unsigned r = 0; r < Round; ++r)
    {
      const double a = 2.0 * glm::pi<double>() * r / Round;
      const double b = from + (0.5 * glm::pi<double>() - from) * u / Up;
      mesh.points.push_back(
        12.0 * dvec3(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)));
    }
  for (unsigned u = 0; u < Up; ++u)
    for (unsigned r = 0; r < Round; ++r)
    {
      const unsigned a = u * Round + r, b = u * Round + (r + 1) % Round;
      mesh.triangles.push_back({ a, b, b + Round });
      mesh.triangles.push_back({ a, b + Round, a + Round });
    }
  return mesh;
}

TEST(SheetMesh, NonsenseIsRefused)
{
  for (const double mm : { 0.0, -1.0, 101.0, std::nan("") })
    EXPECT_THROW(hasp::SheetMesh(Disc(), { mm }), std::invalid_argument) << mm;
  EXPECT_THROW(hasp::SheetMesh({}, {}), std::invalid_argument);
  TriangleMesh bad = Disc();
  bad.points[3].y = std::nan("");
  EXPECT_THROW(hasp::SheetMesh(bad, {}), std::invalid_argument);
  EXPECT_THROW(hasp::FindRims(bad), std::invalid_argument);
  bad = Disc();
  bad.triangles[3].y = 1000;
  EXPECT_THROW(hasp::SheetMesh(bad, {}), std::invalid_argument);
  TriangleMesh line; // no area
  line.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } };
  line.triangles = { { 0, 1, 2 } };
  EXPECT_THROW(hasp::SheetMesh(line, {}), std::invalid_argument);
}

TEST(SheetMesh, ADiscIsASlabBehindItsFaceOrAboutIt)
{
  TriangleMesh disc = Disc();
  const double area = 0.5 * 96 * 100.0 * std::sin(2.0 * glm::pi<double>() / 96);
  for (const bool behind : { true, false })
    for (const double up : { 1.0, -1.0 }) // outside is +z, then -z
    {
      const TriangleMesh sheet = hasp::SheetMesh(disc, { 3.0, behind });
      const MeshCheck check = hasp::CheckMesh(sheet);
      EXPECT_TRUE(check.Sound());
      EXPECT_NEAR(check.volumeMm3, 3.0 * area, 1e-9 * area);
      double low = 1e9, high = -1e9;
      for (const dvec3& p : sheet.points)
      {
        low = std::min(low, p.z);
        high = std::max(high, p.z);
      }
      EXPECT_NEAR(low, behind ? (up > 0.0 ? 0.0 : 3.0) : 1.5, 1e-12);
      EXPECT_NEAR(high, behind ? (up > 0.0 ? 3.0 : 6.0) : 4.5, 1e-12);
      for (glm::uvec3& t : disc.triangles)
        std::swap(t.y, t.z);
    }
}

TEST(SheetMesh, ABowlsWallIsAShellToTheRim)
{
  const TriangleMesh sheet = hasp::SheetMesh(Cap(0.0), { 4.0, true });
  const MeshCheck check = hasp::CheckMesh(hasp::WeldPoints(sheet));
  EXPECT_EQ(check.borderEdges, 0U);
  EXPECT_EQ(check.turnedEdges, 0U);
  const double truth = 2.0 / 3.0 * glm::pi<double>() * (1728.0 - 512.0);
  EXPECT_NEAR(check.volumeMm3, truth, 0.005 * truth); // chords of 128 parts, and the rim's tilt
  for (const dvec3& p : sheet.points)
  {
    const double r = glm::length(p);
    EXPECT_TRUE(std::abs(r - 12.0) < 1e-9 || std::abs(r - 8.0) < 0.01) << r;
  }
}

TEST(SheetMesh, PointsThatAreNotSharedAreTheSameSheet)
{
  const TriangleMesh shared = Cap(0.3);
  TriangleMesh soup; // as an STL file has it
  for (const glm::uvec3& t : shared.triangles)
  {
    const auto first = unsigned(soup.points.size());
    for (int n = 0; n < 3; ++n)
      soup.points.push_back(shared.points[t[n]]);
    soup.triangles.push_back({ first, first + 1, first + 2 });
  }
  const MeshCheck one = hasp::CheckMesh(hasp::SheetMesh(shared, { 2.0 }));
  const MeshCheck other = hasp::CheckMesh(hasp::SheetMesh(soup, { 2.0 }));
  EXPECT_EQ(one.triangles, other.triangles);
  EXPECT_NEAR(one.volumeMm3, other.volumeMm3, 1e-6);
}

TEST(SheetMesh, ABendThatIsTooTightIsOneBody)
{
  const TriangleMesh sheet = hasp::SheetMesh(Cap(0.0), { 20.0, true }); // the back turns inside out
  hasp::GridGeometry grid;
  grid.dims = { 34, 34, 34 };
  grid.origin = dvec3(-16.5);
  const std::vector<float> coverage = hasp::MeshCoverage(sheet, grid); // refuses what is not closed
  for (int k = 0; k < 34; ++k)
    for (int j = 0; j < 34; ++j)
      for (int i = 0; i < 34; ++i)
      {
        const dvec3 p = grid.IndexToWorld({ i, j, k });
        if (p.z > 1.0 && glm::length(p) < 10.5)
        {
          ASSERT_EQ(coverage[(k * 34 + j) * 34 + i], 1.0F) << p.x << " " << p.y << " " << p.z;
        }
      }
}

TEST(MeshRims, AClosedMeshHasNoneAndHolesAreCounted)
{
  EXPECT_EQ(hasp::FindRims(hasp::SheetMesh(Disc(), { 1.0 })).edges, 0U);
  const MeshRims disc = hasp::FindRims(Disc());
  EXPECT_EQ(disc.edges, 96U);
  EXPECT_EQ(disc.loops, 1U);
  EXPECT_NEAR(disc.longestMm, 96 * 20.0 * std::sin(glm::pi<double>() / 96), 1e-9);
  EXPECT_NEAR(disc.at.z, 3.0, 1e-12);
  TriangleMesh holes = Cap(-0.5 * glm::pi<double>() + 1e-3); // nearly a sphere: a hole at its foot
  EXPECT_EQ(hasp::FindRims(holes).loops, 1U);
  holes.triangles.erase(holes.triangles.begin() + 9000); // and one of a triangle
  const MeshRims two = hasp::FindRims(holes);
  EXPECT_EQ(two.loops, 2U);
  EXPECT_EQ(two.edges, 128U + 3U);
}

} // namespace
