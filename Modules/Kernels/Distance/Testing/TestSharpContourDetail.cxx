#include "Distance/Csg.h"
#include "Distance/SharpContour.h"
#include "Distance/SolidShapes.h"
#include "Distance/SolidSweeps.h"
#include "Evaluation/MeshCheck.h"
#include "Testing/SlottedBlock.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace
{

/// How far the triangles' centroids are off the solid's own surface, in cells of the grid.
struct Centroids
{
  double worst = 0;
  std::size_t far = 0; ///< further than the 0.08 of a cell that most keep to
  std::size_t triangles = 0;
};

Centroids CentroidsOf(const hasp::ImplicitSolid& solid, const glm::dvec3& half, double spacing)
{
  const hasp::GridGeometry grid{ glm::ivec3(glm::ceil(2.0 * half / spacing)) + 1, -half,
    glm::dvec3(spacing), glm::dmat3(1) };
  const auto mesh = hasp::SharpContour(solid, grid);
  EXPECT_TRUE(hasp::CheckMesh(mesh).Sound());
  Centroids centroids;
  centroids.triangles = mesh.triangles.size();
  for (const glm::uvec3& t : mesh.triangles)
  {
    const double off =
      std::abs(solid.At((mesh.points[t.x] + mesh.points[t.y] + mesh.points[t.z]) / 3.0)) / spacing;
    centroids.worst = std::max(centroids.worst, off);
    centroids.far += off > 0.08;
  }
  return centroids;
}

TEST(SharpContourDetail, EngravedTextHasNoNotches)
{
  // Strokes of 2.5 to 5 cells: their round walls bend within a cell, beside an edge. At 0.15 mm the
  // plate's top lies along grid points, and at depths of 0.05 and 0.1 mm walls hang over.
  const auto plate = hasp::MakeStadium({ -11, 0, 0 }, { 11, 0, 0 }, { 0, 0, 1 }, 4.0, 1.5);
  for (const double depth : { 0.0, 0.05, 0.1 })
  {
    const auto text =
      hasp::MakeText("HASP", { -8, -1.5, 0.75 - depth }, { 1, 0, 0 }, { 0, 1, 0 }, 3.0, 0.5);
    const auto solid = hasp::MakeDifference(plate, text);
    for (const double spacing : { 0.2, 0.15, 0.1 })
    {
      const auto off = CentroidsOf(*solid, { 15.4, 4.4, 1.2 }, spacing);
      SCOPED_TRACE(testing::Message() << depth << " " << spacing);
      EXPECT_LE(off.worst, 0.16);
      EXPECT_LE(off.far, off.triangles / 5000);
    }
  }
}

TEST(SharpContourDetail, EngravedCapsulesHaveNoNotches)
{
  const auto box = hasp::MakeBox({}, glm::dmat3(1), { 3.03, 3.07, 1.01 });
  for (const unsigned seed : { 1U, 2U, 3U, 27U }) // 27: the worst of 40
  {
    std::mt19937 random(seed);
    const auto any = [&] { return 2.0 * double(random()) / double(std::mt19937::max()) - 1.0; };
    std::vector<hasp::SolidPointer> parts;
    for (int n = 0; n < 12; ++n)
    {
      const double x = any(), y = any(), z = any(), u = any(), v = any(), w = any();
      const glm::dvec3 a(2.5 * x, 2.5 * y, 1.0 + 0.2 * z);
      parts.push_back(hasp::MakeCapsule(a, a + glm::dvec3(u, v, 0.1 * w), 0.25));
    }
    const auto solid = hasp::MakeDifference(box, hasp::MakeUnion(parts));
    for (const double spacing : { 0.2, 0.15, 0.1 })
    {
      const auto off = CentroidsOf(*solid, { 3.6, 3.6, 1.4 }, spacing);
      SCOPED_TRACE(testing::Message() << seed << " " << spacing);
      EXPECT_LE(off.worst, 0.22);
      EXPECT_LE(off.far, off.triangles / 2400);
    }
  }
}

/// How far the farthest point of a mesh stands out of its solid, in cells.
double StandsOut(const hasp::ImplicitSolid& solid, double spacing)
{
  const double half = 6.0;
  const hasp::GridGeometry grid{ glm::ivec3(int(2.0 * half / spacing) + 1), glm::dvec3(-half),
    glm::dvec3(spacing), glm::dmat3(1) };
  double most = 0.0;
  for (const glm::dvec3& point : hasp::SharpContour(solid, grid).points)
    most = std::max(most, solid.At(point) / spacing);
  return most;
}

TEST(SharpContourDetail, NothingStandsOutOfASolid)
{
  constexpr double Spacing = 0.5;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(-0.5, 0.5);
  double thick = 0.0, thin = 0.0;
  for (int n = 0; n < 100; ++n)
  {
    const auto axes = hasp::AnyAxes(random);
    const glm::dvec3 at(any(random), any(random), any(random));
    // A kerf of 2.4 cells and a drill of 4 through a block; a wall of less than a cell.
    const auto kerf = hasp::MakeSlab(at, axes[0], 2.4 * Spacing);
    const glm::dvec3 on = at + 2.5 * axes[0];
    const auto drill = hasp::MakeCylinder(on - 9.0 * axes[2], on + 9.0 * axes[2], 2.0 * Spacing);
    const auto block = hasp::MakeBox(at, axes, { 4.0, 3.0, 2.0 });
    const auto parts = hasp::MakeDifference(hasp::MakeDifference(block, kerf), drill);
    thick = std::max(thick, StandsOut(*parts, Spacing));
    const double half = 0.5 * Spacing * (0.2 + 0.2 * (n % 3));
    thin = std::max(thin, StandsOut(*hasp::MakeBox(at, axes, { 4.0, 3.0, half }), Spacing));
  }
  RecordProperty("thick", std::to_string(thick));
  RecordProperty("thin", std::to_string(thin));
  EXPECT_LE(thick, 0.16);
  EXPECT_LE(thin, 0.05);
}

/// Area of triangles that look into the solid, squares of the grid's cells.
double TurnedArea(const hasp::ImplicitSolid& solid, const hasp::TriangleMesh& mesh, double spacing)
{
  double area = 0.0;
  for (const glm::uvec3& t : mesh.triangles)
  {
    const glm::dvec3 &a = mesh.points[t.x], &b = mesh.points[t.y], &c = mesh.points[t.z];
    const glm::dvec3 normal = 0.5 * glm::cross(b - a, c - a);
    if (glm::dot(normal, solid.SampleAt((a + b + c) / 3.0).gradient) < 0.0)
      area += glm::length(normal) / (spacing * spacing);
  }
  return area;
}

TEST(SharpContourDetail, BevelsNarrowerThanACellAreNotFolded)
{
  // Wedges whose tips are cut off a share of a cell wide: two creases in one tetrahedron. 20 cells
  // of bevel in each; with one center 0.009 to 0.13 squares of
  // cells were turned on each cell of it.
  constexpr double Spacing = 0.4;
  constexpr int Turns = 10;
  for (const double degrees : { 40.0, 60.0 })
    for (const double width : { 0.2, 0.5, 0.8 })
      for (const bool round : { false, true })
      {
        SCOPED_TRACE(testing::Message() << degrees << " degrees, " << width << " " << round);
        std::mt19937 random(5);
        double turned = 0.0;
        for (int n = 0; n < Turns; ++n)
        {
          const auto axes = hasp::AnyAxes(random);
          const double half = glm::radians(0.5 * degrees);
          const glm::dvec3 tip = 0.37 * axes[0] + 0.11 * axes[1];
          const glm::dvec3 up = std::sin(half) * axes[0] + std::cos(half) * axes[1],
                           down = std::sin(half) * axes[0] - std::cos(half) * axes[1];
          const double cut = 0.5 * width * Spacing / std::tan(half);
          const auto side = round ? hasp::MakeCylinder(tip - 7.0 * up - 20.0 * axes[2],
                                      tip - 7.0 * up + 20.0 * axes[2], 7.0)
                                  : hasp::MakePlane(tip, up);
          const auto solid = hasp::MakeIntersection({ side, hasp::MakePlane(tip, down),
            hasp::MakePlane(tip - cut * axes[0], axes[0]), hasp::MakeBox({}, axes, { 3, 3, 4 }) });
          const hasp::GridGeometry grid{ glm::ivec3(27), glm::dvec3(-5.2), glm::dvec3(Spacing),
            glm::dmat3(1) };
          const auto mesh = hasp::SharpContour(*solid, grid);
          EXPECT_TRUE(hasp::CheckMesh(mesh).Sound());
          turned += TurnedArea(*solid, mesh, Spacing);
        }
        RecordProperty("turned", std::to_string(turned));
        EXPECT_LE(turned, 0.005 * 20.0 * Turns);
      }
}

} // namespace
