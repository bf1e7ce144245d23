#include "Grid/AnalyticVolumes.h"
#include "Isosurface/ActiveCells.h"
#include "Isosurface/ClusterCulling.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <random>

namespace
{

hasp::ClusteredCells Gyroid()
{
  const hasp::GridGeometry g{ { 70, 70, 70 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  const auto samples = hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticGyroid(23), g, 100, 0);
  const hasp::AnyGridView grid = hasp::GridView<const std::int16_t>{ samples.data(), g };
  return ExtractActiveCells(grid, hasp::MinMaxBlocks(grid), 0);
}

TEST(ClusterCulling, LosesNoCellThatCanBeSeenAndMakesNoPointThatWouldBeDropped)
{
  const auto cells = Gyroid();
  std::mt19937 random(41);
  std::uniform_real_distribution<double> any(-30, 100);
  const glm::ivec2 viewport(640, 480);
  std::size_t points = 0, rectangles = 0, culled = 0;
  for (int n = 0; n < 30; ++n) // eyes in and around the volume
  {
    const glm::dvec3 eye(any(random), any(random), any(random));
    const glm::dmat4 clip = glm::perspective(0.6, 640.0 / 480, 0.5, 500.0) *
                            glm::lookAt(eye, glm::dvec3(35), glm::dvec3(0, 0.1, 1));
    const auto visible = CullClusters(cells, clip, viewport, 64.0);
    std::vector<char> kind(cells.Count(), 0);
    const auto mark = [&](const std::vector<std::uint32_t>& clusters, char with)
    {
      for (const std::uint32_t c : clusters)
        std::fill_n(
          kind.begin() + cells.clusters[c].firstCell, cells.clusters[c].CellCount(), with);
    };
    mark(visible.points, 'p');
    mark(visible.rectangles, 'r');
    culled += visible.culled;
    for (std::size_t c = 0; c < cells.Count(); ++c)
    {
      // Truth: a cell is on screen if one of 27 points of it is; its centre decides for points.
      bool seen = false;
      double lowX = 1e9, highX = -1e9;
      for (int q = 0; q < 27; ++q)
      {
        const glm::dvec3 at = glm::dvec3(cells.Cell(c)) + glm::dvec3(q % 3, q / 3 % 3, q / 9) * 0.5;
        const glm::dvec4 p = clip * glm::dvec4(at, 1);
        const bool on =
          p.w > 0 && glm::all(glm::lessThanEqual(glm::abs(glm::dvec3(p)), glm::dvec3(p.w)));
        seen |= on;
        lowX = std::min(lowX, p.x / p.w);
        highX = std::max(highX, p.x / p.w);
        ASSERT_TRUE(on || q != 13 || kind[c] != 'p') << "a point whose centre is off-screen";
      }
      ASSERT_TRUE(!seen || kind[c] != 0) << "a visible cell is lost";
      if (kind[c] == 'p')
      {
        ASSERT_LE((highX - lowX) * 320, 64.0);
        ++points;
      }
      rectangles += kind[c] == 'r';
    }
  }
  EXPECT_GT(points, 1000U);
  EXPECT_GT(rectangles, 1000U);
  EXPECT_GT(culled, 100U);
}

TEST(ClusterCulling, WithoutPointsAllVisibleCellsAreRectangles)
{
  const auto cells = Gyroid();
  const glm::dmat4 clip = glm::ortho(-100.0, 100.0, -100.0, 100.0, -200.0, 200.0);
  const auto visible = CullClusters(cells, clip, { 500, 500 }, 0.0);
  EXPECT_TRUE(visible.points.empty());
  EXPECT_EQ(visible.rectangles.size(), cells.clusters.size());
}

} // namespace
