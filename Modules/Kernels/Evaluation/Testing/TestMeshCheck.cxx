#include "Evaluation/MeshCheck.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

hasp::TriangleMesh Tetrahedron(const glm::dvec3& at = {})
{
  return { { at, at + glm::dvec3(1, 0, 0), at + glm::dvec3(0, 1, 0), at + glm::dvec3(0, 0, 1) },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } } };
}

hasp::TriangleMesh Both(hasp::TriangleMesh a, const hasp::TriangleMesh& b)
{
  const auto base = static_cast<unsigned>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const glm::uvec3& t : b.triangles)
    a.triangles.push_back(t + base);
  return a;
}

TEST(MeshCheck, ATetrahedronIsSound)
{
  const auto c = hasp::CheckMesh(Tetrahedron({ 100, -50, 7 }));
  EXPECT_TRUE(c.Sound());
  EXPECT_EQ(c.pieces, 1U);
  EXPECT_NEAR(c.volumeMm3, 1.0 / 6, 1e-12);
  EXPECT_NEAR(c.areaMm2, 1.5 + std::sqrt(3.0) / 2, 1e-12);
}

TEST(MeshCheck, EveryFaultIsCounted)
{
  auto open = Tetrahedron();
  open.triangles.pop_back();
  EXPECT_EQ(hasp::CheckMesh(open).borderEdges, 3U);
  EXPECT_FALSE(hasp::CheckMesh(open).Closed());

  auto turned = Tetrahedron();
  std::swap(turned.triangles[1].x, turned.triangles[1].y);
  EXPECT_EQ(hasp::CheckMesh(turned).turnedEdges, 3U);
  EXPECT_FALSE(hasp::CheckMesh(turned).Outward());

  auto inward = Tetrahedron();
  for (auto& t : inward.triangles)
    std::swap(t.x, t.y);
  EXPECT_EQ(hasp::CheckMesh(inward).turnedEdges, 0U);
  EXPECT_FALSE(hasp::CheckMesh(inward).Outward());

  auto crowded = Tetrahedron();
  crowded.points.emplace_back(1, 1, 1);
  crowded.triangles.emplace_back(0, 1, 4);
  EXPECT_EQ(hasp::CheckMesh(crowded).crowdedEdges, 1U);
  EXPECT_FALSE(hasp::CheckMesh(crowded).TwoManifold());

  auto degenerate = Tetrahedron();
  degenerate.triangles.emplace_back(0, 0, 1);
  EXPECT_EQ(hasp::CheckMesh(degenerate).degenerate, 1U);
  auto flat = Tetrahedron();
  flat.points.emplace_back(2, 0, 0);
  flat.triangles.emplace_back(0, 1, 4); // on one line
  EXPECT_EQ(hasp::CheckMesh(flat).degenerate, 1U);
}

TEST(MeshCheck, TwoPiecesThatShareAPointArePinched)
{
  const auto apart = Both(Tetrahedron(), Tetrahedron({ 1, 0, 0 }));
  EXPECT_TRUE(hasp::CheckMesh(apart).Sound());
  const auto welded = hasp::WeldPoints(apart);
  EXPECT_EQ(welded.points.size(), 7U);
  const auto c = hasp::CheckMesh(welded);
  EXPECT_EQ(c.pinchedPoints, 1U);
  EXPECT_EQ(c.pieces, 2U);
  EXPECT_FALSE(c.TwoManifold());
}

TEST(MeshCheck, EmptyIsNotSoundAndBadIndicesThrow)
{
  EXPECT_FALSE(hasp::CheckMesh({}).Sound());
  auto bad = Tetrahedron();
  bad.triangles[0].x = 9;
  EXPECT_THROW(hasp::CheckMesh(bad), std::invalid_argument);
  bad = Tetrahedron();
  bad.points[2].y = std::nan("");
  EXPECT_THROW(hasp::WeldPoints(bad), std::invalid_argument);
}

} // namespace
