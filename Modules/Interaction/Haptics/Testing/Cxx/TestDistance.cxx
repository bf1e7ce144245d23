#include "vtkHaspDistance.h"

#include "Grid/AnalyticVolumes.h"
#include "vtkHaspVolumeView.h"

#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace
{

/// Six quadrilaterals, or as many strips of two triangles: 8 x 12 x 20 mm about (5, 0, -3).
vtkNew<vtkPolyData> Brick(bool strips)
{
  vtkNew<vtkPoints> points;
  for (int n = 0; n < 8; ++n)
    points->InsertNextPoint(5 + (n & 1 ? 4 : -4), n & 2 ? 6 : -6, -3 + (n & 4 ? 10 : -10));
  const vtkIdType faces[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
    { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };
  vtkNew<vtkCellArray> cells;
  for (const auto& face : faces)
  {
    const vtkIdType strip[4] = { face[0], face[1], face[3], face[2] };
    cells->InsertNextCell(4, strips ? strip : face);
  }
  vtkNew<vtkPolyData> brick;
  brick->SetPoints(points);
  strips ? brick->SetStrips(cells) : brick->SetPolys(cells);
  return brick;
}

double BrickDistance(const glm::dvec3& p)
{
  const glm::dvec3 q = glm::abs(p - glm::dvec3(5, 0, -3)) - glm::dvec3(4, 6, 10);
  return glm::length(glm::max(q, 0.0)) + std::min(0.0, std::max({ q.x, q.y, q.z }));
}

TEST(Distance, NothingIsRefused)
{
  EXPECT_THROW(hasp::DistanceOfImage(nullptr, 0.0), std::invalid_argument);
  EXPECT_THROW(hasp::DistanceOfSurface(nullptr), std::invalid_argument);
  vtkNew<vtkPolyData> empty;
  EXPECT_THROW(hasp::DistanceOfSurface(empty), std::invalid_argument);
  vtkNew<vtkImageData> noScalars;
  noScalars->SetDimensions(4, 4, 4);
  EXPECT_THROW(hasp::DistanceOfImage(noScalars, 0.0), std::invalid_argument);
}

// Quadrilaterals and strips are cut up: distances at a face's middle, at an edge and inside.
TEST(Distance, PolygonsAndStripsAreCutUp)
{
  for (const bool strips : { false, true })
  {
    const auto brick = Brick(strips);
    EXPECT_EQ(hasp::TrianglesOf(brick).triangles.size(), 12u);
    const hasp::BodyDistance body = hasp::DistanceOfSurface(brick, { .spacingMm = 0.5 });
    const glm::ivec3 dims = body.geometry.dims;
    int held = 0;
    for (std::size_t n = 0; n < body.distances.size(); ++n)
    {
      const glm::dvec3 p = body.geometry.IndexToWorld(
        glm::dvec3(n % dims.x, n / dims.x % dims.y, n / dims.x / dims.y));
      const glm::dvec3 q = glm::abs(p - glm::dvec3(5, 0, -3)) - glm::dvec3(4, 6, 10);
      const bool beforeAFace = int(q.x > -2.5) + int(q.y > -2.5) + int(q.z > -2.5) == 1;
      if (!beforeAFace || std::abs(BrickDistance(p)) > 1.5)
        continue;
      ASSERT_NEAR(body.distances[n], BrickDistance(p), 0.1 * 0.5);
      ++held;
    }
    EXPECT_GT(held, 1000);
  }
}

// A ball in an image that is turned, anisotropic and whose extent does not begin at 0.
TEST(Distance, AnImagesPlaceIsKept)
{
  const glm::dvec3 center(10, 20, 30);
  hasp::GridGeometry grid{ { 40, 36, 30 }, glm::dvec3(0.0), { 0.7, 0.8, 1.0 },
    glm::mat3_cast(glm::angleAxis(0.6, glm::normalize(glm::dvec3(1, 1, 0)))) };
  grid.origin = center - grid.IndexToWorld(0.5 * glm::dvec3(grid.dims - 1));
  const auto ball = hasp::AnalyticSphere(center, 9.0);
  const auto image = hasp::MakeImage(grid, hasp::SampleAnalytic<float>(ball, grid, 1.0, 0.0));
  const hasp::BodyDistance body = hasp::DistanceOfImage(image, 0.0);
  EXPECT_NEAR(body.geometry.spacing.x, 0.7, 1e-12);
  const glm::ivec3 dims = body.geometry.dims;
  double most = 0.0;
  for (std::size_t n = 0; n < body.distances.size(); ++n)
  {
    const double truth = glm::length(body.geometry.IndexToWorld(glm::dvec3(
                                       n % dims.x, n / dims.x % dims.y, n / dims.x / dims.y)) -
                                     center) -
                         9.0;
    if (std::abs(truth) < 2.0)
      most = std::max(most, std::abs(body.distances[n] - truth));
  }
  EXPECT_GT(most, 0.0);
  EXPECT_LT(most, 0.15 * 0.7); // an isosurface of linear cells, 13 of them across the radius
}

} // namespace
