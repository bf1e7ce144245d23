#include "Grid/LabelGrid.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

namespace
{

using Labels = std::vector<std::uint16_t>;

hasp::GridGeometry Scan()
{
  const glm::dvec3 row = glm::normalize(glm::dvec3(0.9, 0.3, -0.2));
  const glm::dvec3 column = glm::normalize(glm::cross(glm::dvec3(0.1, 0.4, 1.0), row));
  return { { 9, 7, 8 }, { -31.5, 12.25, 100.5 }, { 0.5, 0.75, 1.25 },
    glm::dmat3(row, column, glm::cross(row, column)) };
}

/// The same samples of a part of the grid.
hasp::GridGeometry Part(const hasp::GridGeometry& grid, glm::ivec3 first, glm::ivec3 dims)
{
  hasp::GridGeometry part = grid;
  part.origin = grid.IndexToWorld(first);
  part.dims = dims;
  return part;
}

/// The same samples with axes in the order 2, 0, 1, the last of these reversed.
hasp::GridGeometry Turned(const hasp::GridGeometry& grid)
{
  hasp::GridGeometry turned = grid;
  for (int a = 0; a < 3; ++a)
  {
    const int from = (a + 2) % 3;
    turned.dims[a] = grid.dims[from];
    turned.spacing[a] = grid.spacing[from];
    turned.direction[a] = grid.direction[from];
  }
  turned.direction[2] *= -1.0;
  turned.origin = grid.IndexToWorld({ 0, grid.dims.y - 1, 0 });
  return turned;
}

/// Each sample its own label.
Labels Counted(const hasp::GridGeometry& grid)
{
  Labels labels(grid.Size());
  for (std::size_t n = 0; n < labels.size(); ++n)
    labels[n] = static_cast<std::uint16_t>(65535 - n);
  return labels;
}

Labels Placed(const hasp::GridGeometry& from, const Labels& labels, const hasp::GridGeometry& scan)
{
  Labels placed(scan.Size(), 77); // of an earlier use
  hasp::PlaceLabels("test", { labels.data(), from }, { placed.data(), scan });
  return placed;
}

/// Sample by sample, through the world: the label of the nearest sample within 0.01 mm, else 0.
Labels ByWorld(const hasp::GridGeometry& from, const Labels& labels, const hasp::GridGeometry& scan)
{
  Labels placed(scan.Size());
  for (int k = 0; k < scan.dims.z; ++k)
    for (int j = 0; j < scan.dims.y; ++j)
      for (int i = 0; i < scan.dims.x; ++i)
        for (int z = 0; z < from.dims.z; ++z)
          for (int y = 0; y < from.dims.y; ++y)
            for (int x = 0; x < from.dims.x; ++x)
              if (glm::distance(scan.IndexToWorld({ i, j, k }), from.IndexToWorld({ x, y, z })) <
                  0.01)
                placed[(std::size_t(k) * scan.dims.y + j) * scan.dims.x + i] =
                  labels[(std::size_t(z) * from.dims.y + y) * from.dims.x + x];
  return placed;
}

std::string Refusal(
  const hasp::GridGeometry& from, const Labels& labels, const hasp::GridGeometry& scan)
{
  try
  {
    Placed(from, labels, scan);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

TEST(LabelGrid, LabelsBesideTheScansSamplesAreRefused)
{
  const hasp::GridGeometry scan = Scan();
  const Labels labels(scan.Size());
  const auto says = [&](const char* words, const std::function<void(hasp::GridGeometry&)>& change)
  {
    hasp::GridGeometry grid = Part(scan, { 0, 0, 0 }, { 5, 5, 5 });
    change(grid);
    const std::string text = Refusal(grid, labels, scan);
    EXPECT_NE(text.find("test: the labels are of another grid"), text.npos) << text;
    EXPECT_NE(text.find(words), text.npos) << text;
    EXPECT_NE(text.find("resample them"), text.npos) << text;
  };
  says("their spacing is (", [](auto& grid) { grid.spacing.z += 0.01; });
  says("mm beside its samples", [](auto& grid) { grid.origin.y += 0.2; });
  says("their origin is (", [](auto& grid) { grid.origin.y = 1e300; });
  says("mm beside its samples",
    [](auto& grid)
    {
      const glm::dvec3 x = grid.direction[0];
      grid.direction[0] = std::cos(0.02) * x + std::sin(0.02) * grid.direction[1];
      grid.direction[1] = std::cos(0.02) * grid.direction[1] - std::sin(0.02) * x;
    });
  hasp::GridGeometry grid = scan;
  grid.spacing.y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(Refusal(grid, labels, scan), "");
  grid = scan;
  grid.origin += glm::dvec3(0.0, 1e-4, 0.0); // decimals of a header
  EXPECT_EQ(Refusal(grid, labels, scan), "");
}

TEST(LabelGrid, ALabelOutsideOfTheScanIsRefusedAndNothingElseIs)
{
  const hasp::GridGeometry scan = Scan();
  const hasp::GridGeometry larger = Part(scan, { -2, -1, 0 }, scan.dims + glm::ivec3(3, 1, 2));
  Labels labels(larger.Size());
  labels[(std::size_t(3) * larger.dims.y + 1) * larger.dims.x + 2] = 5; // the scan's (0, 0, 3)
  const Labels placed = Placed(larger, labels, scan);
  Labels truth(scan.Size());
  truth[std::size_t(3) * scan.dims.y * scan.dims.x] = 5;
  EXPECT_EQ(placed, truth);
  labels[0] = labels[1] = 9;
  EXPECT_NE(
    Refusal(larger, labels, scan).find("2 samples with labels lie outside"), std::string::npos);
}

TEST(LabelGrid, CroppedAndTurnedLabelsComeToLieInTheirPlaces)
{
  const hasp::GridGeometry scan = Scan();
  const hasp::GridGeometry whole = Part(scan, { 0, 0, 0 }, scan.dims);
  const hasp::GridGeometry part = Part(scan, { 2, 1, 3 }, { 4, 5, 2 });
  for (const hasp::GridGeometry& from : { whole, part, Turned(scan), Turned(part),
         Turned(Turned(part)), Part(scan, { 8, 6, 7 }, { 1, 1, 1 }) })
  {
    const Labels labels = Counted(from), placed = Placed(from, labels, scan);
    EXPECT_EQ(placed, ByWorld(from, labels, scan));
    std::size_t there = 0;
    for (const std::uint16_t label : placed)
      there += label != 0;
    EXPECT_EQ(there, labels.size());
  }
}

TEST(LabelGrid, CancellingThrowsAndSaysHowFar)
{
  const hasp::GridGeometry scan = Scan();
  const Labels labels = Counted(scan);
  Labels placed(scan.Size());
  EXPECT_THROW(hasp::PlaceLabels("test", { labels.data(), scan }, { placed.data(), scan },
                 [](double) { return false; }),
    hasp::Cancelled);
  double last = -1.0;
  hasp::PlaceLabels("test", { labels.data(), scan }, { placed.data(), scan },
    [&](double share)
    {
      EXPECT_GE(share, last);
      last = share;
      return true;
    });
  EXPECT_EQ(last, 1.0);
}

} // namespace
