#include "Grid/AnalyticVolumes.h"
#include "Isosurface/ActiveCells.h"
#include "Isosurface/ClusterCulling.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <array>
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

/// A pair of eyes: heads tilted and turned, eyes at one place, near and far apart, in the volume.
std::array<glm::dmat4, 2> RandomEyes(std::mt19937& random, int n)
{
  std::uniform_real_distribution<double> any(-30, 100), tilt(-1, 1);
  const double apart[] = { 0.0, 0.5, 6.0, 150.0 };
  const glm::dvec3 head(any(random), any(random), any(random));
  const glm::dvec3 up(tilt(random), tilt(random), tilt(random) + 0.01);
  const glm::dvec3 right(tilt(random), tilt(random), tilt(random));
  const auto eye = [&](double side)
  {
    return glm::perspective(0.6, 4.0 / 3, 0.5, 150.0) *
           glm::lookAt(head + side * apart[n % 4] * right, glm::dvec3(35, 30, 25), up);
  };
  return { eye(-0.5), eye(0.5) };
}

TEST(ClusterCulling, TwoEyesGetWhatEachGetsByItself)
{
  const auto cells = Gyroid();
  std::mt19937 random(43);
  std::size_t points = 0, rectangles = 0, culled = 0, different = 0;
  for (int n = 0; n < 40; ++n)
  {
    const auto eyes = RandomEyes(random, n);
    const double limit = n % 3 == 0 ? 8.0 : 64.0, margin = n % 5 == 0 ? 0.5 : 0.0;
    const auto both = CullClusters(cells, eyes, { 640, 480 }, limit, margin);
    ASSERT_EQ(both.size(), 2U);
    for (int eye = 0; eye < 2; ++eye)
    {
      const auto alone = CullClusters(cells, eyes[eye], { 640, 480 }, limit, margin);
      EXPECT_EQ(both[eye].points, alone.points) << n;
      EXPECT_EQ(both[eye].rectangles, alone.rectangles) << n;
      EXPECT_EQ(both[eye].culled, alone.culled) << n;
      points += alone.points.size();
      rectangles += alone.rectangles.size();
      culled += alone.culled;
    }
    different += both[0].points != both[1].points;
  }
  EXPECT_GT(points, 1000U);
  EXPECT_GT(rectangles, 1000U);
  EXPECT_GT(culled, 1000U);
  EXPECT_GT(different, 15U);
}

TEST(ClusterCulling, WithoutPointsAllVisibleCellsAreRectangles)
{
  const auto cells = Gyroid();
  const glm::dmat4 clip = glm::ortho(-100.0, 100.0, -100.0, 100.0, -200.0, 200.0);
  const auto visible = CullClusters(cells, clip, { 500, 500 }, 0.0);
  EXPECT_TRUE(visible.points.empty());
  EXPECT_EQ(visible.rectangles.size(), cells.clusters.size());
}

TEST(ClusterCulling, RunsFromFrontToBack)
{
  const auto cells = Gyroid();
  const glm::dmat4 clips[] = { glm::perspective(0.6, 1.0, 10.0, 300.0) *
                                 glm::lookAt(
                                   glm::dvec3(150, 90, 60), glm::dvec3(35), glm::dvec3(0, 0, 1)),
    glm::ortho(-60.0, 60.0, -60.0, 60.0, -10.0, 300.0) *
      glm::lookAt(glm::dvec3(-70, 60, 60), glm::dvec3(35), glm::dvec3(0, 0, 1)) };
  for (const glm::dmat4& clip : clips)
  {
    const auto visible = CullClusters(cells, clip, { 500, 500 }, 64.0);
    ASSERT_GT(visible.points.size(), 500U);
    const auto depth = [&](std::uint32_t c)
    { return (clip * glm::dvec4(glm::dvec3(cells.clusters[c].Origin()) + 4.0, 1)).z; };
    double nearest = 1e9, farthest = -1e9;
    for (const std::uint32_t c : visible.points)
    {
      nearest = std::min(nearest, depth(c));
      farthest = std::max(farthest, depth(c));
    }
    for (std::size_t n = 1; n < visible.points.size(); ++n)
      ASSERT_GE(
        depth(visible.points[n]) - depth(visible.points[n - 1]), -(farthest - nearest) / 4095);
  }
}

TEST(ClusterCulling, BoxesFitTheirActiveCells)
{
  std::mt19937 random(3);
  for (int n = 0; n < 200; ++n)
  {
    hasp::CellCluster cluster;
    glm::uvec3 first(8), last(0);
    for (unsigned k = random() % 4; k < 4; ++k)
    {
      const glm::uvec3 cell(random() % 8, random() % 8, random() % 8);
      cluster.active[cell.z] |= std::uint64_t(1) << (cell.y * 8 + cell.x);
      first = glm::min(first, cell);
      last = glm::max(last, cell);
    }
    const std::uint32_t state = hasp::UnseenState(cluster);
    EXPECT_EQ(hasp::glsl::HaspFirstActive(state), first);
    EXPECT_EQ(hasp::glsl::HaspLastActive(state), last);
    for (std::uint32_t viewer = 0; viewer < hasp::glsl::HaspViewers; ++viewer)
    {
      EXPECT_EQ(hasp::glsl::HaspViewerBits(state, viewer), 0U);
      const auto seen = hasp::glsl::HaspWithViewerBits(state, viewer, hasp::glsl::HaspSeen);
      EXPECT_EQ(hasp::glsl::HaspViewerBits(seen, viewer), hasp::glsl::HaspSeen);
      EXPECT_EQ(hasp::glsl::HaspWithViewerBits(seen, viewer, 0U), state);
    }
  }
}

TEST(ClusterCulling, PartsFitTheirBlocksAndAreAllThereIs)
{
  const auto cells = Gyroid();
  EXPECT_THROW(DivideClusters(cells, hasp::LeastBlockBytes - 1), std::invalid_argument);
  EXPECT_EQ(DivideClusters(cells, 128 << 20).size(), 1U);
  EXPECT_TRUE(hasp::DivideClusters({}, 128 << 20).empty());
  for (const std::size_t bytes : { hasp::LeastBlockBytes, std::size_t(100000) })
  {
    const auto parts = DivideClusters(cells, bytes);
    EXPECT_GT(parts.size(), 1U);
    std::size_t next = 0;
    for (const hasp::ClusterPart& part : parts)
    {
      EXPECT_EQ(part.first, next);
      EXPECT_GT(part.end, part.first);
      next = part.end;
      EXPECT_EQ(part.first * sizeof(hasp::CellCluster) % 256, 0U);
      EXPECT_EQ(part.firstWord * 4 % 256, 0U);
      EXPECT_LE((part.end - part.first) * sizeof(hasp::CellCluster), bytes);
      EXPECT_LE((part.endWord - part.firstWord) * 4, bytes);
      for (std::size_t c = part.first; c < part.end; ++c)
      {
        const hasp::CellCluster& cluster = cells.clusters[c];
        EXPECT_GE(cluster.firstWord, part.firstWord);
        // a pair of corners is read as two words
        const std::size_t bits = std::size_t(cluster.CornerCount() - 1) * cluster.Width();
        EXPECT_LT(cluster.firstWord + bits / 32 + 1, part.endWord);
      }
    }
    EXPECT_EQ(next, cells.clusters.size());
  }
}

} // namespace
