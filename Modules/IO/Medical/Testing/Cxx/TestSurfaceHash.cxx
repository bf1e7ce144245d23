#include "vtkHaspSurfaceHash.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace
{

using hasp::SurfaceHash;
using hasp::TriangleMesh;

/// A tetrahedron.
TriangleMesh Body()
{
  return { { { 0, 0, 0 }, { 10.1, 0, 0 }, { 0, 9.7, 0 }, { 0, 0, 3.3 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } } };
}

TEST(SurfaceHash, BadMeshesAreRefused)
{
  TriangleMesh bad = Body();
  bad.triangles[2].y = 4;
  EXPECT_THROW(SurfaceHash(bad), std::invalid_argument);
  bad = Body();
  bad.points[1].z = std::nan("");
  EXPECT_THROW(SurfaceHash(bad), std::invalid_argument);
  bad.points[1].z = 1e300;
  EXPECT_THROW(SurfaceHash(bad), std::invalid_argument);
}

TEST(SurfaceHash, IsThatOfTheTrianglesAndOfNoOrder)
{
  const std::string hash = SurfaceHash(Body());
  EXPECT_EQ(hash.size(), 64U);
  EXPECT_EQ(hash.find_first_not_of("0123456789abcdef"), std::string::npos);
  TriangleMesh other = Body();
  std::reverse(other.triangles.begin(), other.triangles.end());
  for (glm::uvec3& t : other.triangles)
    t = { t.y, t.z, t.x };
  other.points[0].x = -0.0;
  EXPECT_EQ(SurfaceHash(other), hash);
  TriangleMesh soup; // as an STL file has it, in float32
  for (const glm::uvec3& t : Body().triangles)
  {
    const auto first = unsigned(soup.points.size());
    for (int n = 0; n < 3; ++n)
      soup.points.emplace_back(glm::vec3(Body().points[t[n]]));
    soup.triangles.push_back({ first, first + 1, first + 2 });
  }
  EXPECT_EQ(SurfaceHash(soup), hash);
}

TEST(SurfaceHash, OtherTrianglesHaveAnother)
{
  const std::string hash = SurfaceHash(Body());
  TriangleMesh other = Body();
  other.points[1].x = std::nextafter(float(other.points[1].x), 100.0F);
  EXPECT_NE(SurfaceHash(other), hash);
  other = Body();
  std::swap(other.triangles[0].x, other.triangles[0].y); // wound the other way round
  EXPECT_NE(SurfaceHash(other), hash);
  other = Body();
  other.triangles.push_back(other.triangles[0]);
  EXPECT_NE(SurfaceHash(other), hash);
  other = Body();
  other.triangles.pop_back();
  EXPECT_NE(SurfaceHash(other), hash);
}

} // namespace
