#include "Evaluation/SelfIntersections.h"

#include <gtest/gtest.h>

namespace
{

TEST(SelfIntersections, TwoTetrahedraThroughEachOtherAreFound)
{
  hasp::TriangleMesh mesh{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } } };
  EXPECT_EQ(hasp::CountSelfIntersections(mesh), 0U);
  for (int n = 0; n < 4; ++n)
    mesh.points.push_back(mesh.points[n] + glm::dvec3(0.1, 0.13, 0.17));
  for (int n = 0; n < 4; ++n)
    mesh.triangles.push_back(mesh.triangles[n] + 4U);
  EXPECT_GT(hasp::CountSelfIntersections(mesh), 0U);
}

TEST(SelfIntersections, MeshesItCannotReadAreRefused)
{
  const hasp::TriangleMesh flat{ { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } }, { { 0, 1, 2 } } };
  EXPECT_THROW(hasp::CountSelfIntersections(flat), std::invalid_argument);
  const hasp::TriangleMesh turned{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { 0, 1, 2 }, { 0, 1, 3 } } };
  EXPECT_THROW(hasp::CountSelfIntersections(turned), std::invalid_argument);
}

} // namespace
