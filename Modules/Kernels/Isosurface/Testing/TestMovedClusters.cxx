// Clusters of moved cells are culled only if every cell of theirs, where it is moved to, is out of
// view.
#include "Grid/AnalyticVolumes.h"
#include "Isosurface/ActiveCells.h"
#include "Isosurface/CellAttributes.h"
#include "Isosurface/MovedClusters.h"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>

namespace
{

struct Scene
{
  hasp::GridGeometry geometry{ { 60, 50, 40 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  hasp::ClusteredCells cells;
  std::vector<std::uint32_t> moveOfLabel{ 0, 1, 2 };
  std::vector<glm::dmat4> moves{ glm::dmat4(1),
    glm::translate(glm::dmat4(1), glm::dvec3(80, 0, -20)),
    glm::rotate(glm::dmat4(1), 2.0, glm::normalize(glm::dvec3(1, 2, 3))) };
  Scene()
  {
    const auto samples =
      hasp::SampleAnalytic<float>(hasp::AnalyticGyroid(14), this->geometry, 100, 0);
    const hasp::AnyGridView grid = hasp::GridView<const float>{ samples.data(), this->geometry };
    this->cells = ExtractActiveCells(grid, hasp::MinMaxBlocks(grid), 0);
    std::vector<std::uint8_t> labels;
    for (std::size_t n = 0; n < samples.size(); ++n)
      labels.push_back(n % 60 < 13 ? 1 : n % 60 < 30 ? 2 : n % 60 < 45 ? 200 : 0);
    AddLabels(this->cells, hasp::GridView<const std::uint8_t>{ labels.data(), this->geometry });
  }
};

TEST(MovedClusters, AreCulledWithNoneOfTheirCellsInView)
{
  const Scene s;
  const hasp::MovedClusters moved(s.cells, s.moveOfLabel, s.moves.size());
  const glm::dmat4 view = glm::perspective(0.5, 1.0, 5.0, 90.0) *
                          glm::lookAt(glm::dvec3(60, 20, 80), glm::dvec3(70, 25, 0), { 0, 1, 0 });
  const auto visible = moved.Cull(view, s.moves, { 200, 200 }, 64);
  std::vector<bool> drawn(s.cells.clusters.size(), false);
  std::size_t listed = 0;
  for (const auto* list : { &visible.points, &visible.rectangles })
  {
    EXPECT_TRUE(std::is_sorted(list->begin(), list->end()));
    for (const std::uint32_t c : *list)
    {
      EXPECT_FALSE(drawn[c]) << "in both lists";
      drawn[c] = true;
      ++listed;
    }
  }
  EXPECT_EQ(listed + visible.culled, s.cells.clusters.size());
  EXPECT_GT(visible.culled, 20U);
  std::size_t inView = 0;
  for (std::size_t n = 0; n < s.cells.Count(); ++n)
  {
    const std::uint16_t label = s.cells.labels[n];
    const glm::dmat4 clip = view * s.moves[label < 3 ? s.moveOfLabel[label] : 0];
    const glm::dvec4 p = clip * glm::dvec4(glm::dvec3(s.cells.Cell(n)) + 0.5, 1.0);
    if (!(std::max({ std::abs(p.x), std::abs(p.y), std::abs(p.z) }) <= p.w))
      continue;
    ++inView;
    ASSERT_TRUE(drawn[s.cells.ClusterOf(n)]) << "cell " << n << " of label " << label;
  }
  EXPECT_GT(inView, 100U);
}

TEST(MovedClusters, TwoEyesGetWhatEachGetsByItself)
{
  const Scene s;
  const hasp::MovedClusters moved(s.cells, s.moveOfLabel, s.moves.size());
  for (const double apart : { 0.0, 3.0, 60.0 })
  {
    const auto eye = [&](double x)
    {
      return glm::perspective(0.5, 1.0, 5.0, 90.0) *
             glm::lookAt(glm::dvec3(60 + x, 20, 80), glm::dvec3(70, 25, 0), { 0.3, 1, 0 });
    };
    const glm::dmat4 eyes[] = { eye(0.0), eye(apart) };
    const auto both = moved.Cull(eyes, s.moves, { 200, 200 }, 8);
    ASSERT_EQ(both.size(), 2U);
    for (int n = 0; n < 2; ++n)
    {
      const auto alone = moved.Cull(eyes[n], s.moves, { 200, 200 }, 8);
      EXPECT_EQ(both[n].points, alone.points) << apart;
      EXPECT_EQ(both[n].rectangles, alone.rectangles) << apart;
      EXPECT_EQ(both[n].culled, alone.culled) << apart;
      EXPECT_GT(alone.points.size() + alone.rectangles.size(), 10U);
    }
  }
}

TEST(MovedClusters, WithoutMovesAreThoseOfCullClusters)
{
  const Scene s;
  const glm::dmat4 view = glm::perspective(0.4, 1.0, 5.0, 90.0) *
                          glm::lookAt(glm::dvec3(20, 20, 80), glm::dvec3(10, 25, 0), { 0, 1, 0 });
  const std::vector<std::uint32_t> none;
  const std::vector<glm::dmat4> still{ glm::dmat4(1) };
  const auto visible = hasp::MovedClusters(s.cells, none, 1).Cull(view, still, { 200, 200 }, 20);
  auto truth = CullClusters(s.cells, view, { 200, 200 }, 20);
  std::sort(truth.points.begin(), truth.points.end());
  std::sort(truth.rectangles.begin(), truth.rectangles.end());
  EXPECT_EQ(visible.points, truth.points);
  EXPECT_EQ(visible.rectangles, truth.rectangles);
  EXPECT_EQ(visible.culled, truth.culled);
  EXPECT_GT(truth.culled, 0U);
}

TEST(MovedClusters, WrongInputIsRefused)
{
  Scene s;
  const hasp::MovedClusters moved(s.cells, s.moveOfLabel, 3);
  EXPECT_THROW(
    moved.Cull(glm::dmat4(1), { s.moves.data(), 2 }, { 9, 9 }, 1), std::invalid_argument);
  EXPECT_THROW(hasp::MovedClusters(s.cells, s.moveOfLabel, 2), std::invalid_argument);
  EXPECT_THROW(hasp::MovedClusters(s.cells, {}, 0), std::invalid_argument);
  s.cells.labels.clear();
  EXPECT_THROW(hasp::MovedClusters(s.cells, s.moveOfLabel, 3), std::invalid_argument);
}

} // namespace
