#include "Distance/ImplicitShapes.h"
#include "Distance/TetrahedraContour.h"
#include "Evaluation/MeshCheck.h"
#include "Evaluation/SelfIntersections.h"
#include "Grid/AnalyticVolumes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <random>

/// What the distance kernel contours, judged by the evaluation kernel. Here, since neither may know
/// the other.
namespace
{

TEST(ContourMeshes, NeverMeetThemselvesEvenAsFloatsFarFromTheOrigin)
{
  std::mt19937 random(19);
  std::uniform_real_distribution<double> any(-6, 6), size(0.5, 3);
  for (int n = 0; n < 8; ++n)
  {
    // Balls and slabs added and taken away at random; with some noise, so that every case of the
    // tetrahedra and its slivers occur.
    hasp::GridGeometry grid{ glm::ivec3(24), glm::dvec3(-8), glm::dvec3(0.7), glm::dmat3(1) };
    std::vector<float> field(grid.Size(), 1.0F);
    for (int s = 0; s < 12; ++s)
    {
      const glm::dvec3 center(any(random), any(random), any(random));
      const glm::dvec3 normal = glm::normalize(center + 0.1);
      const double r = size(random);
      const auto shape = hasp::SampleAnalytic<float>(
        { "",
          [&](const glm::dvec3& p)
          {
            return s % 3 ? glm::length(p - center) - 1.5 * r
                         : hasp::SlabDistance(p, center, normal, 0.5 * r);
          },
          1 },
        grid, 1, 0);
      for (std::size_t v = 0; v < field.size(); ++v)
        field[v] = s % 3 ? std::min(field[v], shape[v]) : std::max(field[v], -shape[v]);
    }
    if (n % 2)
      for (float& v : field)
        v += static_cast<float>(0.1 * any(random));
    grid.origin += 300.0;
    auto mesh = hasp::ContourTetrahedra({ field.data(), grid });
    for (glm::dvec3& p : mesh.points)
      p = glm::dvec3(glm::vec3(p)); // as an STL file keeps it
    ASSERT_GT(mesh.triangles.size(), 500U);
    ASSERT_TRUE(hasp::CheckMesh(mesh).Sound());
    EXPECT_EQ(hasp::CountSelfIntersections(mesh), 0U) << n;
  }
}

} // namespace
