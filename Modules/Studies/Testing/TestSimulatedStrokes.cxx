#include "Studies/FractureCases.h"
#include "Studies/SimulatedStrokes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace
{

using hasp::BrushStroke;
using hasp::CoarseHint;
using hasp::CoarseTruth;
using hasp::GridGeometry;
using hasp::GridView;
using hasp::Label;
using Labels = std::vector<Label>;

GridGeometry BarGrid()
{
  GridGeometry grid;
  grid.dims = { 100, 24, 20 };
  grid.spacing = { 0.6, 0.8, 1.0 };
  grid.origin = { -20.0, 30.0, 7.0 };
  return grid;
}

/// A bar of bone in two: label 2 up to slice `cut` along x, 3 beyond.
Labels Bar(int cut)
{
  const GridGeometry grid = BarGrid();
  Labels labels(grid.Size(), 0);
  const GridView<Label> view{ labels.data(), grid };
  for (int k = 4; k < 16; ++k)
    for (int j = 5; j < 20; ++j)
      for (int i = 3; i < 97; ++i)
        view(i, j, k) = i < cut ? 2 : 3;
  return labels;
}

GridView<const Label> ViewOf(const Labels& labels)
{
  return { labels.data(), BarGrid() };
}

TEST(CoarseTruth, NonsenseIsRefused)
{
  const Labels bar = Bar(50), none(bar.size(), 0);
  const auto made = [&](auto change)
  {
    hasp::CoarseTruthSettings settings;
    change(settings);
    return CoarseTruth(ViewOf(bar), settings);
  };
  EXPECT_THROW(CoarseTruth{ ViewOf(none) }, std::invalid_argument);
  EXPECT_THROW(made([](auto& s) { s.cellMm = 0.0; }), std::invalid_argument);
  EXPECT_THROW(made([](auto& s) { s.errorMm = -1.0; }), std::invalid_argument);
  EXPECT_THROW(made([](auto& s) { s.wrongShare = 0.0; }), std::invalid_argument);
  GridGeometry other = BarGrid();
  other.dims.x = 50;
  EXPECT_THROW(CoarseTruth(ViewOf(bar)).LargestError({ bar.data(), other }, ViewOf(bar), 1),
    std::invalid_argument);
}

TEST(CoarseTruth, KnowsNothingFinerThanItsCells)
{
  // Cells are 8 voxels along x (4.8 mm): a cut at 50 or at 53 is in the same one.
  const CoarseTruth one(ViewOf(Bar(50))), other(ViewOf(Bar(53))), third(ViewOf(Bar(60)));
  const std::vector<CoarseHint> a = one.Hints(), b = other.Hints(), c = third.Hints();
  ASSERT_EQ(a.size(), 2U);
  ASSERT_EQ(b.size(), 2U);
  for (std::size_t n = 0; n < 2; ++n)
  {
    EXPECT_EQ(a[n].near, b[n].near);
    EXPECT_EQ(a[n].along, b[n].along);
    EXPECT_EQ(a[n].reachMm, b[n].reachMm);
  }
  EXPECT_NE(a[0].reachMm, c[0].reachMm);
}

TEST(CoarseTruth, HintsAreInTheirFragmentAboutAndNotExactly)
{
  hasp::CoarseTruthSettings settings;
  const Labels bar = Bar(50);
  std::vector<glm::dvec3> places;
  for (settings.seed = 1; settings.seed <= 20; ++settings.seed)
    for (const CoarseHint& hint : CoarseTruth(ViewOf(bar), settings).Hints())
    {
      const glm::dvec3 index = BarGrid().WorldToIndex(hint.near);
      EXPECT_EQ(hint.label, index.x < 50.0 ? 2 : 3);
      EXPECT_GT(std::abs(index.x - 50.0) * 0.6, 8.0); // far from the crack
      EXPECT_GT(std::abs(hint.along.x), 0.9);         // the bar's way
      places.push_back(hint.near);
    }
  EXPECT_GT(glm::distance(places[0], places[2]), 0.1);
}

TEST(CoarseTruth, SeesTheLargestErrorAndNoneInTheTruth)
{
  const Labels bar = Bar(50);
  const CoarseTruth known(ViewOf(bar));
  EXPECT_FALSE(known.LargestError(ViewOf(bar), ViewOf(bar), 1));
  Labels result = Bar(70); // 20 slices of 3 are called 2
  const GridView<Label> view{ result.data(), BarGrid() };
  for (int k = 4; k < 16; ++k) // and a smaller error at the other end
    for (int j = 5; j < 20; ++j)
      for (int i = 3; i < 8; ++i)
        view(i, j, k) = 1;
  const auto hint = known.LargestError(ViewOf(result), ViewOf(bar), 1);
  ASSERT_TRUE(hint);
  EXPECT_EQ(hint->label, 3);
  const double x = BarGrid().WorldToIndex(hint->near).x;
  EXPECT_GT(x, 50.0);
  EXPECT_LT(x, 75.0);
}

TEST(SimulatedStrokes, NonsenseIsRefused)
{
  const Labels bar = Bar(50), none(bar.size(), 0);
  const CoarseTruth known(ViewOf(bar));
  const CoarseHint hint = known.Hints()[0];
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(hasp::DrawStroke(ViewOf(bar), hint, { 0, 3.0, 30.0 }), std::invalid_argument);
  EXPECT_THROW(hasp::DrawStroke(ViewOf(bar), hint, { 10, 0.0, 30.0 }), std::invalid_argument);
  EXPECT_THROW(hasp::DrawStroke(ViewOf(bar), hint, { 10, 3.0, nan }), std::invalid_argument);
  EXPECT_THROW(hasp::DrawStroke(ViewOf(none), hint), std::runtime_error);
  const auto truth = [&](const std::vector<BrushStroke>&) { return bar; };
  EXPECT_THROW(hasp::SimulateUser(ViewOf(bar), known, { 1 }, truth), std::invalid_argument);
  EXPECT_THROW(hasp::SimulateUser(
                 ViewOf(bar), known, {}, [](const std::vector<BrushStroke>&) { return Labels(3); }),
    std::invalid_argument);
}

TEST(SimulatedStrokes, AStrokeFollowsItsWayAndKeepsItsLength)
{
  const Labels bar = Bar(50);
  CoarseHint hint = CoarseTruth(ViewOf(bar)).Hints()[0];
  ASSERT_FALSE(hint.way.empty());
  const BrushStroke longer = hasp::DrawStroke(ViewOf(bar), hint);
  EXPECT_GT(hasp::LengthOf(longer), 8.0); // the fragment is 28 mm long
  EXPECT_LE(hasp::LengthOf(hasp::DrawStroke(ViewOf(bar), hint, { 10, 3.0, 5.0 })), 5.0);
  hint.way = { hint.near }; // nowhere to go
  EXPECT_EQ(hasp::DrawStroke(ViewOf(bar), hint).points.size(), 1U);
}

TEST(SimulatedStrokes, TheUserStopsWhenContentOrOutOfStrokes)
{
  const Labels bar = Bar(50), wrong = Bar(75);
  const CoarseTruth known(ViewOf(bar));
  std::vector<std::size_t> strokes;
  const hasp::SimulatedUser content = hasp::SimulateUser(ViewOf(bar), known, {},
    [&](const std::vector<BrushStroke>& drawn)
    {
      strokes.push_back(drawn.size());
      return drawn.size() < 4 ? wrong : bar;
    });
  EXPECT_TRUE(content.content);
  EXPECT_EQ(strokes, (std::vector<std::size_t>{ 2, 3, 4 }));
  EXPECT_EQ(content.labels, bar);
  const hasp::SimulatedUser out = hasp::SimulateUser(
    ViewOf(bar), known, { 5 }, [&](const std::vector<BrushStroke>&) { return wrong; });
  EXPECT_FALSE(out.content);
  EXPECT_EQ(out.strokes.size(), 5U);
  EXPECT_EQ(out.splits, 4);
}

/// Of all strokes that a user draws on a broken jaw: limits, bone under each point, and on the
/// fragment it is meant for.
TEST(SimulatedStrokes, KeepTheirLimitsAndLieOnTheirFragment)
{
  hasp::FractureCaseSettings settings;
  settings.spacingMm = 1.4;
  const hasp::FractureCase broken = hasp::BrokenMandible(settings);
  const hasp::FracturedScan scan = hasp::BreakPhantom(broken.geometry, broken.settings);
  Labels bone(scan.truth.size());
  hasp::ThresholdLabels(GridView<const std::int16_t>{ scan.samples.data(), scan.geometry }, 226.0,
    1e6, { bone.data(), scan.geometry });
  const GridView<const Label> mask{ bone.data(), scan.geometry };
  const GridView<const Label> truth{ scan.truth.data(), scan.geometry };
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
  {
    hasp::CoarseTruthSettings coarse;
    coarse.seed = seed;
    const CoarseTruth known(truth, coarse);
    // A split that calls all bone 3 makes the user correct until the strokes are gone.
    const hasp::SimulatedUser user = hasp::SimulateUser(mask, known, {},
      [&](const std::vector<BrushStroke>&)
      {
        Labels all(bone);
        std::replace(all.begin(), all.end(), Label(1), Label(3));
        return all;
      });
    ASSERT_EQ(user.strokes.size(), 10U);
    std::size_t onLabel = 0, points = 0;
    for (const BrushStroke& stroke : user.strokes)
    {
      EXPECT_LE(stroke.radiusMm, 3.0);
      EXPECT_GT(stroke.radiusMm, 0.0);
      EXPECT_LE(hasp::LengthOf(stroke), 30.0);
      for (const glm::dvec3& point : stroke.points)
      {
        const glm::dvec3 index = scan.geometry.WorldToIndex(point);
        const glm::ivec3 at(glm::round(index));
        ASSERT_LT(glm::distance(index, glm::dvec3(at)), 1e-6);
        ASSERT_EQ(mask(at.x, at.y, at.z), 1);
        const Label there = truth(at.x, at.y, at.z); // 0: noise alone made bone of it
        EXPECT_TRUE(there == stroke.label || there == 0) << "seed " << seed;
        onLabel += there == stroke.label;
        ++points;
      }
    }
    EXPECT_GT(double(onLabel), 0.9 * double(points));
  }
}

} // namespace
