#include "BrokenPieces.h"
#include "Studies/FractureCases.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>
#include <stdexcept>

namespace
{

using hasp::FractureCase;
using hasp::FractureCaseSettings;
using hasp::FracturedScan;
using hasp::GridView;
using hasp::Label;
using hasp::testing::PiecesOf;

/// Each label is there and, but for crumbs, one piece.
void ExpectOnePieceEach(const FracturedScan& scan, double crumbs)
{
  const std::vector<std::size_t> counts = hasp::CountLabels({ scan.truth.data(), scan.geometry });
  ASSERT_EQ(counts.size(), scan.names.size() + 2);
  EXPECT_EQ(counts[1], 0U);
  std::vector<std::size_t> largest(counts.size(), 0);
  const auto pieces = PiecesOf(
    scan.geometry, [&](std::size_t v) { return scan.truth[v] != 0; },
    [&](std::size_t a, std::size_t b) { return scan.truth[a] == scan.truth[b]; });
  for (const auto& piece : pieces)
    largest[scan.truth[piece[0]]] = std::max(largest[scan.truth[piece[0]]], piece.size());
  for (std::size_t label = 2; label < counts.size(); ++label)
    EXPECT_GE(double(largest[label]), (1.0 - crumbs) * double(counts[label]))
      << scan.names[label - 2];
}

std::vector<std::vector<std::size_t>> ThresholdPieces(const FracturedScan& scan)
{
  return PiecesOf(scan.geometry, [&](std::size_t v) { return scan.samples[v] >= 226; });
}

FracturedScan Scanned(FractureCase broken)
{
  broken.settings.scanner.noiseHU = 0.0;
  return hasp::BreakPhantom(broken.geometry, broken.settings);
}

TEST(FractureCases, NonsenseIsRefused)
{
  FractureCaseSettings coarse;
  coarse.spacingMm = 3.0;
  EXPECT_THROW(hasp::BrokenHead(coarse), std::invalid_argument);
  EXPECT_THROW(hasp::BrokenMandible(coarse), std::invalid_argument);
  EXPECT_THROW(hasp::ShatteredBall(1, 10.0, 0.5, 1), std::invalid_argument);
  EXPECT_THROW(hasp::ShatteredBall(60, 10.0, 0.0, 1), std::invalid_argument);
  EXPECT_THROW(hasp::TinyFragment({ 1.0, 0.0, 1.0 }), std::invalid_argument);
  hasp::GridGeometry grid;
  grid.dims = { 3, 3, 3 };
  const std::vector<std::int16_t> air(27, -1000);
  const GridView<const std::int16_t> view{ air.data(), grid };
  EXPECT_THROW(hasp::PlantedCuts(view, std::vector<std::uint8_t>(27, 0)), std::invalid_argument);
  EXPECT_THROW(hasp::PlantedCuts(view, std::vector<std::uint8_t>(26, 1)), std::invalid_argument);
}

TEST(FractureCases, TheMandibleIsBrokenAndAThresholdDoesNotPartIt)
{
  FractureCaseSettings settings;
  settings.spacingMm = 1.2;
  const FracturedScan scan = Scanned(hasp::BrokenMandible(settings));
  ExpectOnePieceEach(scan, 0.01);
  const auto pieces = ThresholdPieces(scan);
  ASSERT_GE(pieces.size(), 2U);
  EXPECT_LE(pieces.size(), 2U); // cranium and mandible: five labels, two pieces
  std::set<Label> inLargest;
  for (const auto& piece : pieces)
    inLargest.insert(scan.truth[piece[0]]);
  // What the threshold shows is what has a label.
  for (std::size_t v = 0; v < scan.truth.size(); ++v)
    ASSERT_EQ(scan.truth[v] != 0, scan.samples[v] >= 226);
}

TEST(FractureCases, NoToothIsCut)
{
  FractureCaseSettings settings;
  settings.spacingMm = 1.0;
  const FractureCase broken = hasp::BrokenMandible(settings);
  const FracturedScan scan = Scanned(broken);
  const hasp::AnalyticSolid teeth =
    hasp::PhantomSolid(broken.settings.scanner, hasp::PhantomPart::LowerTeeth);
  const int row = scan.geometry.dims.x, slice = row * scan.geometry.dims.y;
  const auto deep = [&](std::size_t v)
  {
    const int n = static_cast<int>(v);
    return scan.truth[v] > 2 &&
           teeth.Bound(scan.geometry.IndexToWorld({ n % row, n % slice / row, n / slice })).mm <
             -1.0;
  };
  const auto pieces = PiecesOf(scan.geometry, deep);
  EXPECT_GE(pieces.size(), 13U);
  for (const auto& piece : pieces)
    for (const std::size_t v : piece)
      ASSERT_EQ(scan.truth[v], scan.truth[piece[0]]);
}

TEST(FractureCases, TheHeadIsInSixAndMovedPiecesStillTouch)
{
  FractureCaseSettings settings;
  settings.spacingMm = 2.0;
  settings.moved = true;
  const FracturedScan scan = Scanned(hasp::BrokenHead(settings));
  EXPECT_EQ(scan.names[0], "cranium");
  ExpectOnePieceEach(scan, 0.02);
  EXPECT_LT(ThresholdPieces(scan).size(), 6U);
}

TEST(FractureCases, ConeBeamKeepsTheTruthWithinItsField)
{
  FractureCaseSettings settings;
  settings.spacingMm = 2.0;
  const FracturedScan ct = Scanned(hasp::BrokenMandible(settings));
  settings.coneBeam = true;
  const FractureCase broken = hasp::BrokenMandible(settings);
  const FracturedScan cone = hasp::BreakPhantom(broken.geometry, broken.settings);
  EXPECT_EQ(cone.names, ct.names);
  std::size_t other = 0, bone = 0;
  for (std::size_t v = 0; v < ct.truth.size(); ++v)
  {
    bone += ct.truth[v] != 0;
    other += cone.truth[v] != ct.truth[v]; // crowns of metal, and what the field leaves out
  }
  EXPECT_LT(double(other), 0.15 * double(bone));
  EXPECT_NE(cone.samples, ct.samples);
}

TEST(FractureCases, CutsArePlantedInAScan)
{
  hasp::PhantomSettings head;
  head.blurMm = glm::dvec3(1.0);
  const hasp::GridGeometry grid = hasp::PhantomGrid(glm::dvec3(2.5), head);
  const std::vector<std::int16_t> intact = hasp::SamplePhantom(grid, head);
  const GridView<const std::int16_t> view{ intact.data(), grid };
  const std::vector<std::uint8_t> named = hasp::LargestBone(view, 226.0);
  const auto pieces = PiecesOf(grid, [&](std::size_t v) { return intact[v] >= 226; });
  EXPECT_EQ(std::accumulate(named.begin(), named.end(), std::size_t(0)), pieces[0].size());
  const FracturedScan scan = hasp::BreakScan(view, hasp::PlantedCuts(view, named), named);
  ASSERT_EQ(scan.names.size(), 4U);
  ExpectOnePieceEach(scan, 0.02);
  std::size_t lowered = 0;
  for (std::size_t v = 0; v < intact.size(); ++v)
  {
    ASSERT_LE(scan.samples[v], intact[v]);
    ASSERT_TRUE(scan.truth[v] == 0 || named[v] != 0);
    lowered += scan.samples[v] < intact[v];
  }
  EXPECT_GT(lowered, 500U);
  EXPECT_LT(lowered, named.size() / 20);
}

TEST(FractureCases, SixtyFragmentsAreAllThereAndHoldTogether)
{
  const FracturedScan scan = hasp::ShatteredBall(60, 9.0, 0.75, 3);
  const std::vector<std::size_t> counts = hasp::CountLabels({ scan.truth.data(), scan.geometry });
  ASSERT_EQ(counts.size(), 62U);
  for (std::size_t label = 2; label < counts.size(); ++label)
    EXPECT_GE(counts[label], 40U);
  EXPECT_EQ(ThresholdPieces(scan).size(), 1U);
}

TEST(FractureCases, TheTinyFragmentHasEightVoxels)
{
  const FracturedScan scan = hasp::TinyFragment({ 0.1, 1.0, 10.0 });
  EXPECT_EQ(hasp::CountLabels({ scan.truth.data(), scan.geometry })[3], 8U);
  EXPECT_EQ(ThresholdPieces(scan).size(), 1U);
}

} // namespace
