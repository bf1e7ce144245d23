// Colours that are kept at lattice corners: means of what was added, rounded rightly, never beyond
// their range.
#include "Isosurface/LightBlocks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace
{

using hasp::ColorMean;
using hasp::LightBlockFinder;
using hasp::LightBlocks;
using hasp::LightPlace;
using hasp::LightSpot;

/// A table with the blocks of one place made.
struct Kept
{
  LightBlocks blocks{ 64, LightBlocks::Of::Colors };

  LightSpot At(const LightPlace& place)
  {
    std::vector<LightBlocks::Key> missing;
    LightBlockFinder looking(&this->blocks);
    this->blocks.ListMissing(looking, place, missing);
    for (const LightBlocks::Key key : missing)
      this->blocks.Make(key);
    LightBlockFinder finder(&this->blocks);
    return this->blocks.Find(finder, place);
  }
};

const LightPlace Corner{ { 8, 9, 10 }, glm::vec3(0.0F), 3, 4 };
const LightPlace Between{ { 8, 9, 10 }, glm::vec3(0.25F, 0.5F, 0.875F), 3, 4 };

TEST(LightBlockColors, NothingAddedIsNothingKnown)
{
  Kept kept;
  LightBlockFinder finder(&kept.blocks);
  const LightSpot none = kept.blocks.Find(finder, Corner);
  EXPECT_FALSE(none.whole);
  EXPECT_EQ(kept.blocks.MeanColor(none).samples, 0.0F);
  kept.blocks.AddColor(none, glm::vec3(1.0F), 0.0F); // left out
  const LightSpot spot = kept.At(Corner);
  EXPECT_TRUE(spot.whole);
  EXPECT_EQ(kept.blocks.MeanColor(spot).samples, 0.0F);
  EXPECT_EQ(kept.blocks.MeanColor(spot).color, glm::vec3(0.0F));
}

TEST(LightBlockColors, TheMeanIsWhatWasAdded)
{
  for (const LightPlace& place : { Corner, Between })
  {
    Kept kept;
    const LightSpot spot = kept.At(place);
    glm::dvec3 sum(0.0);
    std::mt19937 random(1);
    for (int n = 1; n <= 200; ++n)
    {
      // Whole steps of 1/64, so nothing is rounded.
      const glm::vec3 color = glm::vec3(random() % 640, random() % 8000, random() % 64) / 64.0F;
      kept.blocks.AddColor(spot, color, 0.0F);
      sum += glm::dvec3(color);
      const ColorMean mean = kept.blocks.MeanColor(spot);
      // Weights are of 128: of a place between corners some are rounded.
      double squares = 0.0;
      for (const std::uint8_t w : spot.weights)
        squares += double(w) * w / (128.0 * 128.0);
      ASSERT_NEAR(mean.samples, n * squares, 1e-4 * n);
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(mean.color[c], sum[c] / n, 1e-5 * (1.0 + sum[c] / n)) << n;
    }
  }
}

TEST(LightBlockColors, RoundingIsRightOnAverage)
{
  Kept kept;
  const LightSpot spot = kept.At(Corner);
  const glm::vec3 color(0.3F / 64.0F, 5.7F / 64.0F, 0.01F / 64.0F);
  constexpr int Samples = 4096;
  for (int n = 0; n < Samples; ++n)
    kept.blocks.AddColor(spot, color, (static_cast<float>(n) + 0.5F) / Samples);
  const ColorMean mean = kept.blocks.MeanColor(spot);
  for (int c = 0; c < 3; ++c) // even rounds: within one sample's step
    EXPECT_NEAR(mean.color[c], color[c], 1.5 / Samples / 64.0);
  EXPECT_EQ(mean.samples, float(Samples));
}

TEST(LightBlockColors, WhatIsBrighterThan127CountsAsThat)
{
  Kept kept;
  const LightSpot spot = kept.At(Corner);
  const float infinity = std::numeric_limits<float>::infinity();
  for (int n = 0; n < 1000; ++n)
    kept.blocks.AddColor(spot, { 1e6F, infinity, 127.0F }, 0.999F);
  const ColorMean mean = kept.blocks.MeanColor(spot);
  EXPECT_NEAR(mean.color.r, 127.0, 1.01 / 64.0);
  EXPECT_NEAR(mean.color.g, 127.0, 1.01 / 64.0);
  EXPECT_NEAR(mean.color.b, 127.0, 1.01 / 64.0);
}

TEST(LightBlockColors, WhatIsNoNumberOrNegativeAddsBlack)
{
  Kept kept;
  const LightSpot spot = kept.At(Corner);
  const float nan = std::nanf("");
  kept.blocks.AddColor(spot, { nan, -1.0F, 1.0F }, 0.5F);
  kept.blocks.AddColor(spot, { 2.0F, -std::numeric_limits<float>::infinity(), nan }, 0.5F);
  const ColorMean mean = kept.blocks.MeanColor(spot);
  EXPECT_EQ(mean.color, glm::vec3(1.0F, 0.0F, 0.5F));
  EXPECT_EQ(mean.samples, 2.0F);
}

TEST(LightBlockColors, SumsThatAreFullEnoughKeepTheirMean)
{
  for (const float bright : { 17.0F, LightBlocks::BrightestColor })
  {
    Kept kept;
    const LightSpot spot = kept.At(Corner);
    for (int n = 0; n < 60'000; ++n) // far more than fit
      kept.blocks.AddColor(spot, glm::vec3(bright), 0.0F);
    EXPECT_EQ(kept.blocks.MeanColor(spot).color, glm::vec3(bright));
    EXPECT_GT(kept.blocks.MeanColor(spot).samples, 15'000.0F * 17.0F / bright);
    EXPECT_LT(kept.blocks.MeanColor(spot).samples, 60'000.0F);
  }
}

TEST(LightBlockColors, AgeKeepsMeans)
{
  Kept kept;
  const LightSpot spot = kept.At(Between), other = kept.At({ { 100, 9, 10 }, {}, 3, 4 });
  for (int n = 0; n < 500; ++n)
    kept.blocks.AddColor(spot, { 1.0F, 0.25F, 90.0F }, 0.5F);
  kept.blocks.AddColor(other, { 1.0F, 2.0F, 3.0F }, 0.0F); // fewer than the age
  kept.blocks.Age(16.0F);
  const ColorMean aged = kept.blocks.MeanColor(spot);
  EXPECT_NEAR(aged.color.r, 1.0, 1e-3); // whole numbers of 16 * 128: 1/2048 of a step, and NEAR it
  EXPECT_NEAR(aged.color.g, 0.25, 1e-3);
  EXPECT_NEAR(aged.color.b, 90.0, 1e-3);
  EXPECT_LE(aged.samples, 16.0F);
  EXPECT_GT(aged.samples, 8.0F);
  EXPECT_EQ(kept.blocks.MeanColor(other).color, glm::vec3(1.0F, 2.0F, 3.0F));
  EXPECT_EQ(kept.blocks.MeanColor(other).samples, 1.0F);
  // What comes then soon outweighs it: after as many samples as it counts for, it is half of it.
  const ColorMean before = kept.blocks.MeanColor(spot);
  const auto more = [&](int n)
  {
    for (int k = 0; k < n; ++k)
      kept.blocks.AddColor(spot, glm::vec3(0.0F), 0.0F);
  };
  more(1000);
  EXPECT_LT(kept.blocks.MeanColor(spot).color.b, 0.3 * before.color.b);
  // A body that moves for a thousand pictures: the loss of whole numbers does not add up.
  Kept moving;
  const LightSpot place = moving.At(Corner);
  for (int frame = 0; frame < 1000; ++frame)
  {
    for (int n = 0; n < 4; ++n)
      moving.blocks.AddColor(place, glm::vec3(0.5F), 0.5F);
    moving.blocks.Age(16.0F);
  }
  EXPECT_NEAR(moving.blocks.MeanColor(place).color.r, 0.5, 1e-3);
}

TEST(LightBlockColors, ForgetLeavesNothing)
{
  Kept kept;
  LightSpot spot = kept.At(Corner);
  kept.blocks.AddColor(spot, glm::vec3(5.0F), 0.0F);
  kept.blocks.Forget();
  spot = kept.At(Corner); // the same memory
  EXPECT_EQ(kept.blocks.MeanColor(spot).samples, 0.0F);
  kept.blocks.AddColor(spot, glm::vec3(2.0F), 0.0F);
  EXPECT_EQ(kept.blocks.MeanColor(spot).color, glm::vec3(2.0F));
  // By a box, in units of level 0: corner 8 of level 3 is at 64.
  kept.blocks.Forget(glm::dvec3(0.0), glm::dvec3(30.0));
  EXPECT_EQ(kept.blocks.MeanColor(kept.At(Corner)).samples, 1.0F);
  kept.blocks.Forget(glm::dvec3(60.0), glm::dvec3(90.0));
  EXPECT_EQ(kept.blocks.MeanColor(kept.At(Corner)).samples, 0.0F);
}

TEST(LightBlockColors, BytesAreSixteenACorner)
{
  EXPECT_EQ(LightBlocks(64, LightBlocks::Of::Colors).Bytes(), 64 * (8 + 4 + 64 * 16));
}

} // namespace
