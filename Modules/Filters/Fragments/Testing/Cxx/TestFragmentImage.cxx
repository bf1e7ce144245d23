// A fragment alone as a volume: whose isosurface it has.
#include "BrokenBall.h"

#include "FragmentImage.h"
#include "Grid/ThreadLimit.h"
#include "Isosurface/ActiveCells.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <set>
#include <string>
#include <tuple>

namespace
{

using hasp::AnyGridView;
using hasp::FragmentImage;
using hasp::FragmentLevel;
using hasp::GridView;
using hasp::testing::BrokenBall;
using hasp::testing::LabelledScan;

constexpr double Isovalue = LabelledScan::Isovalue;

BrokenBall Ball(bool mirrored = false)
{
  return { { 44, 43, 42 }, { 0.5, 0.6, 0.7 }, hasp::testing::SkewAxes(mirrored), 0, 9.0 };
}

FragmentImage ImageOf(const AnyGridView& grey, const GridView<const std::uint16_t>& labels,
  std::uint16_t label, double isovalue = Isovalue)
{
  const std::vector<FragmentLevel> level{ { label, isovalue } };
  return hasp::FragmentImages(grey, labels, level).front();
}
FragmentImage ImageOf(const LabelledScan& scan, std::uint16_t label)
{
  return ImageOf(scan.Grey(), scan.LabelView(), label);
}

AnyGridView ViewOf(const FragmentImage& image)
{
  return std::visit(
    [&]<typename T>(const std::vector<T>& samples) -> AnyGridView {
      return GridView<const T>{ samples.data(), image.geometry };
    },
    image.samples);
}

/// Where the image's first sample is in the scan.
glm::ivec3 FirstIn(const hasp::GridGeometry& scan, const FragmentImage& image)
{
  return glm::ivec3(glm::round(scan.WorldToIndex(image.geometry.origin)));
}

template <typename T>
std::string Refusal(const T& call)
{
  try
  {
    call();
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "nothing was refused";
}

TEST(FragmentImage, WhatIsNoLabelOfTheScanIsRefused)
{
  const BrokenBall ball = Ball();
  hasp::GridGeometry other = ball.scan.Grid;
  other.origin.x += 1.0;
  EXPECT_NE(Refusal(
              [&] {
                ImageOf(ball.scan.Grey(),
                  GridView<const std::uint16_t>{ ball.scan.Labels.data(), other }, 2);
              })
              .find("fragment images: "),
    std::string::npos);
  EXPECT_EQ(Refusal([&] { ImageOf(ball.scan, 0); }),
    "fragment images: label 0 is nothing, and has no image");
  EXPECT_EQ(Refusal(
              [&] {
                ImageOf(ball.scan.Grey(), ball.scan.LabelView(), 2,
                  std::numeric_limits<double>::quiet_NaN());
              }),
    "fragment images: the isovalue of label 2 is nan, must be in [-1e6, 1e6]");
  const std::vector<FragmentLevel> level{ { 2, Isovalue } };
  EXPECT_THROW(hasp::FragmentImages(
                 ball.scan.Grey(), ball.scan.LabelView(), level, [](double) { return false; }),
    hasp::Cancelled);
}

TEST(FragmentImage, ALabelThatIsNotThereHasNoSamples)
{
  EXPECT_EQ(ImageOf(Ball().scan, 7).geometry.Size(), 0U);
}

TEST(FragmentImage, ReachesTwoSamplesBeyondItsLabelOnTheScansGrid)
{
  for (const bool mirrored : { false, true })
  {
    const BrokenBall ball = Ball(mirrored);
    const FragmentImage image = ImageOf(ball.scan, 3);
    glm::ivec3 low(1000), high(-1);
    for (std::size_t n = 0; n < ball.scan.Labels.size(); ++n)
      if (ball.scan.Labels[n] == 3)
      {
        low = glm::min(low, ball.scan.Place(n));
        high = glm::max(high, ball.scan.Place(n));
      }
    EXPECT_EQ(FirstIn(ball.scan.Grid, image), low - 2);
    EXPECT_EQ(image.geometry.dims, high - low + 5);
    EXPECT_EQ(image.geometry.spacing, ball.scan.Grid.spacing);
    EXPECT_EQ(image.geometry.direction, ball.scan.Grid.direction);
    EXPECT_EQ(image.geometry.origin, ball.scan.Grid.IndexToWorld(glm::dvec3(low - 2)));
  }
}

TEST(FragmentImage, EndsWhereTheScanEnds)
{
  LabelledScan scan = hasp::testing::Cuboids(
    1, hasp::testing::GridAt({ 9, 8, 7 }, glm::dvec3(1.0), glm::dmat3(1.0), { 0, 0, 0 }), 20.0);
  EXPECT_EQ(ImageOf(scan, 2).geometry.dims, scan.Grid.dims);
}

// Cells whose bone is all of one label are the scan's, corner for corner; no sample of the other
// label is bone.
TEST(FragmentImage, HasTheScansOwnSamplesWhereItsLabelIsAndNoBoneElsewhere)
{
  const BrokenBall ball = Ball();
  const FragmentImage image = ImageOf(ball.scan, 2);
  const auto& samples = std::get<std::vector<std::int16_t>>(image.samples);
  const GridView<const std::int16_t> view{ samples.data(), image.geometry };
  const glm::ivec3 first = FirstIn(ball.scan.Grid, image);
  const auto grey = std::get<GridView<const std::int16_t>>(ball.scan.Grey());
  int mirrored = 0;
  for (int k = 0; k < image.geometry.dims.z; ++k)
    for (int j = 0; j < image.geometry.dims.y; ++j)
      for (int i = 0; i < image.geometry.dims.x; ++i)
      {
        const glm::ivec3 at = first + glm::ivec3(i, j, k);
        const int scanned = grey(at.x, at.y, at.z);
        const bool own = ball.scan.LabelView()(at.x, at.y, at.z) == 2;
        ASSERT_EQ(view(i, j, k), own || scanned < 226 ? scanned : std::min(452 - scanned, 225));
        mirrored += !own && scanned >= 226;
      }
  EXPECT_GT(mirrored, 1000);
}

// Along the axis that the ball is cut across, half way between two layers of samples that are alike
// on both sides (the ball is symmetric, and samples are rounded to 1 of 400 a mm): to 0.01 voxel.
TEST(FragmentImage, MeetsItsNeighbourHalfWay)
{
  const BrokenBall ball = Ball();
  for (const int label : { 2, 3 })
  {
    const FragmentImage image = ImageOf(ball.scan, std::uint16_t(label));
    const auto& samples = std::get<std::vector<std::int16_t>>(image.samples);
    const GridView<const std::int16_t> view{ samples.data(), image.geometry };
    const glm::ivec3 at(glm::round(image.geometry.WorldToIndex(ball.middle)));
    int crossings = 0;
    for (int i = 1; i < image.geometry.dims.x; ++i)
    {
      const double before = view(i - 1, at.y, at.z) - Isovalue,
                   after = view(i, at.y, at.z) - Isovalue;
      if ((before >= 0.0) == (after >= 0.0))
        continue;
      const double x = i - 1 + before / (before - after);
      const glm::dvec3 place = image.geometry.IndexToWorld({ x, at.y, at.z });
      const double along = glm::dot(place - ball.middle, ball.normal);
      if (std::abs(along) > 4.0) // the ball's own surface
        continue;
      ++crossings;
      EXPECT_NEAR(along / ball.scan.Grid.spacing.x, 0.0, 0.01);
    }
    EXPECT_EQ(crossings, 1) << "label " << label;
  }
}

TEST(FragmentImage, AnExactlyGreyNeighbourIsNoBone)
{
  const hasp::GridGeometry grid{ { 4, 2, 2 }, {}, glm::dvec3(1.0), glm::dmat3(1.0) };
  std::vector<std::uint16_t> labels(grid.Size());
  for (std::size_t n = 0; n < labels.size(); ++n)
    labels[n] = n % 4 < 2 ? 1 : 2;
  const GridView<const std::uint16_t> labelView{ labels.data(), grid };
  const auto expect = [&]<typename T>(const std::vector<T>& samples, double isovalue)
  {
    const FragmentImage image =
      ImageOf(GridView<const T>{ samples.data(), grid }, labelView, 1, isovalue);
    std::visit(
      [&](const auto& values)
      {
        ASSERT_EQ(values.size(), samples.size()); // all within two samples
        for (std::size_t n = 0; n < values.size(); ++n)
        {
          EXPECT_EQ(double(values[n]) >= isovalue, labels[n] == 1) << n;
          if (labels[n] == 1)
          {
            EXPECT_EQ(double(values[n]), double(samples[n]));
          }
        }
      },
      image.samples);
  };
  expect(std::vector<std::int16_t>(grid.Size(), 226), 226.0);
  expect(std::vector<std::int16_t>(grid.Size(), 226), 225.5);
  expect(std::vector<std::int16_t>(grid.Size(), 32767), -32767.0); // 2 iso - v is no int16
  expect(std::vector<std::uint8_t>(grid.Size(), 255), 0.0);        // nor is it a uint8
  expect(std::vector<std::uint16_t>(grid.Size(), 65535), 1.0);
  expect(std::vector<float>(grid.Size(), 0.25F), 0.25);
  expect(std::vector<float>(grid.Size(), std::numeric_limits<float>::infinity()), 0.1);
}

// All cells of the scan's surface that are of one fragment alone are that fragment's, and no others
// lie on the ball's own surface.
TEST(FragmentImage, ActiveCellsAwayFromTheBorderAreTheScans)
{
  const BrokenBall ball = Ball();
  const auto cellsOf = [](const AnyGridView& grey)
  { return hasp::ExtractActiveCells(grey, hasp::MinMaxBlocks(grey), Isovalue); };
  const auto places = [&](const hasp::ClusteredCells& cells, int side)
  {
    std::set<std::tuple<int, int, int>> found;
    for (std::size_t n = 0; n < cells.Count(); ++n)
    {
      const glm::dvec3 world =
        cells.geometry.IndexToWorld(glm::dvec3(cells.Cell(n)) + glm::dvec3(0.5));
      if (side * glm::dot(world - ball.middle, ball.normal) < 1.2) // two voxels from the border
        continue;
      const glm::ivec3 at(glm::round(ball.scan.Grid.WorldToIndex(world) - 0.5));
      found.emplace(at.x, at.y, at.z);
    }
    return found;
  };
  const hasp::ClusteredCells all = cellsOf(ball.scan.Grey());
  for (const int label : { 2, 3 })
  {
    const FragmentImage image = ImageOf(ball.scan, std::uint16_t(label));
    const int side = label == 2 ? -1 : 1;
    const auto found = places(cellsOf(ViewOf(image)), side);
    EXPECT_GT(found.size(), 500U);
    EXPECT_EQ(found, places(all, side));
  }
}

/// A block of bone of one grey value that a blade has cut aslant: label 1 is what is before it,
/// label 2 what is behind; dust has none.
struct SawnBlock
{
  hasp::GridGeometry grid{ hasp::testing::GridAt(
    { 40, 36, 32 }, { 0.5, 0.6, 0.7 }, hasp::testing::SkewAxes(true), { 4, 5, 6 }) };
  std::vector<std::int16_t> samples = std::vector<std::int16_t>(grid.Size(), 1000);
  std::vector<std::uint16_t> labels = std::vector<std::uint16_t>(grid.Size());
  hasp::SawnBox box;

  explicit SawnBlock(double kerfMm)
  {
    this->box.middle = { 4.1, 5.2, 5.9 };
    this->box.axes =
      glm::mat3_cast(glm::angleAxis(1.1, glm::normalize(glm::dvec3(0.3, 1.0, -0.4))));
    this->box.half = { 100, 100, 0.5 * kerfMm };
    for (std::size_t n = 0; n < this->labels.size(); ++n)
      if (const double z = this->Across(this->Place(n)); std::abs(z) > this->box.half.z)
        this->labels[n] = z < 0.0 ? 1 : 2;
  }
  glm::dvec3 Place(std::size_t n) const
  {
    const glm::ivec3& dims = this->grid.dims;
    const int at = int(n);
    return this->grid.IndexToWorld({ at % dims.x, at / dims.x % dims.y, at / dims.x / dims.y });
  }
  double Across(const glm::dvec3& world) const
  {
    return glm::dot(world - this->box.middle, this->box.axes[2]);
  }
  FragmentImage Image(std::uint16_t label) const
  {
    const std::vector<FragmentLevel> level{ { label, Isovalue, { this->box } } };
    return hasp::FragmentImages(GridView<const std::int16_t>{ this->samples.data(), this->grid },
      { this->labels.data(), this->grid }, level)
      .front();
  }
};

/// Calls visit(place) where edges between neighbouring samples meet the isosurface, and returns how
/// many do.
int EachCrossing(const FragmentImage& image, const std::function<void(const glm::dvec3&)>& visit)
{
  const auto& samples = std::get<std::vector<std::int16_t>>(image.samples);
  const GridView<const std::int16_t> view{ samples.data(), image.geometry };
  const glm::ivec3 dims = image.geometry.dims;
  int count = 0;
  for (int k = 0; k + 1 < dims.z; ++k)
    for (int j = 0; j + 1 < dims.y; ++j)
      for (int i = 0; i + 1 < dims.x; ++i)
        for (int axis = 0; axis < 3; ++axis)
        {
          glm::dvec3 at(i, j, k);
          const double a = view(i, j, k) - Isovalue;
          const double b = view(i + (axis == 0), j + (axis == 1), k + (axis == 2)) - Isovalue;
          if ((a >= 0.0) == (b >= 0.0))
            continue;
          at[axis] += a / (a - b);
          visit(image.geometry.IndexToWorld(at));
          ++count;
        }
  return count;
}

// Grey values are whole numbers, 774 of them over a cell: a thousandth of a millimetre, but for the
// one that dust keeps to the isovalue. Within the box by a kerf that is a tenth of a voxel, too.
TEST(FragmentImage, ASawnFaceIsPlane)
{
  for (const double kerf : { 0.05, 0.4, 1.5 })
  {
    const SawnBlock block(kerf);
    for (const int label : { 1, 2 })
    {
      double worst = 0.0;
      const double face = label == 1 ? -0.5 * kerf : 0.5 * kerf;
      const int crossings = EachCrossing(block.Image(std::uint16_t(label)),
        [&](const glm::dvec3& p) { worst = std::max(worst, std::abs(block.Across(p) - face)); });
      EXPECT_GT(crossings, 1500);
      EXPECT_LT(worst, 0.003) << "kerf " << kerf << ", label " << label;
    }
  }
}

// Bone whose values differ from place to place, as marrow's and cortex' do: the face is within a
// quarter of a voxel, where voxels alone would be off by a half.
TEST(FragmentImage, ASawnFaceOfUnevenBoneIsNearlyPlane)
{
  SawnBlock block(0.7);
  for (std::size_t n = 0; n < block.samples.size(); ++n)
    block.samples[n] = std::int16_t(n * 7919 % 1009 < 500 ? 700 : 1200);
  double worst = 0.0;
  EachCrossing(block.Image(1),
    [&](const glm::dvec3& p) { worst = std::max(worst, std::abs(block.Across(p) + 0.35)); });
  EXPECT_LT(worst, 0.25 * 0.5);
}

// What lies in the box and has the label has not been cut: beyond a blade's reach.
TEST(FragmentImage, BoneOfTheLabelInABoxIsWhole)
{
  SawnBlock block(1.5);
  std::fill(block.labels.begin(), block.labels.end(), std::uint16_t(1));
  EXPECT_EQ(EachCrossing(block.Image(1), [](const glm::dvec3&) {}), 0);
}

TEST(FragmentImage, IsTheSameOnAnyNumberOfThreads)
{
  const BrokenBall ball = Ball();
  const FragmentImage many = ImageOf(ball.scan, 2);
  hasp::WithThreadLimit(1, [&] { EXPECT_EQ(ImageOf(ball.scan, 2).samples, many.samples); });
}

} // namespace
