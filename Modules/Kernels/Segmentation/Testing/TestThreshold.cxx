#include "Grid/Phantom.h"
#include "Segmentation/ThresholdPresets.h"
#include "Segmentation/ThresholdProposal.h"
#include "Testing/RandomLabels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

namespace
{

using hasp::GreyHistogram;
using hasp::ThresholdProposal;

GreyHistogram HistogramOf(const std::vector<float>& samples)
{
  return hasp::CountGreyValues(hasp::GridView<const float>{
    samples.data(), hasp::testing::PlainGrid({ int(samples.size()), 1, 1 }) });
}

struct Normal
{
  double share, mean, deviation;
};

/// A mixture in closed form: a million values, in bins of one from -4000 to 12000.
GreyHistogram Mixture(const std::vector<Normal>& parts, double scale = 1.0, double offset = 0.0)
{
  GreyHistogram histogram{ offset - 4000.5 * scale, scale, std::vector<std::uint64_t>(16000) };
  for (const Normal& part : parts)
    for (std::size_t b = 0; b < histogram.counts.size(); ++b)
    {
      const auto below = [&](double value)
      { return 0.5 * std::erfc((part.mean - value) / part.deviation / std::sqrt(2.0)); };
      const double low = double(b) - 4000.5;
      histogram.counts[b] +=
        std::uint64_t(std::llround(1e6 * part.share * (below(low + 1.0) - below(low))));
    }
  return histogram;
}

const std::vector<Normal> Head{ { 0.55, -1000, 40 }, { 0.37, 40, 40 }, { 0.08, 900, 200 } };

TEST(ThresholdPresets, AreThoseInUse)
{
  const auto presets = hasp::ThresholdPresets();
  ASSERT_EQ(presets.size(), 8U);
  EXPECT_EQ(std::string(presets[0].name), "bone");
  EXPECT_EQ(presets[0].lowest, 226);
  EXPECT_EQ(presets[0].highest, 3071);
  for (const hasp::ThresholdPreset& preset : presets)
    EXPECT_LT(preset.lowest, preset.highest) << preset.name;
}

TEST(GreyHistogram, CountsEachSampleOnce)
{
  const std::vector<std::int16_t> samples{ -32768, 5, 5, 5, 32767, 6 };
  const GreyHistogram wide = hasp::CountGreyValues(
    hasp::GridView<const std::int16_t>{ samples.data(), hasp::testing::PlainGrid({ 3, 2, 1 }) });
  ASSERT_EQ(wide.counts.size(), 65536U);
  EXPECT_EQ(wide.Middle(0), -32768.0);
  EXPECT_EQ(wide.counts[32768 + 5], 3U);
  EXPECT_EQ(wide.counts.front() + wide.counts.back() + wide.counts[32768 + 6], 3U);
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = HUGE_VALF;
  EXPECT_TRUE(HistogramOf({ nan, infinity, -infinity }).counts.empty());
  EXPECT_EQ(HistogramOf({ 7.5F, nan, 7.5F }).counts, std::vector<std::uint64_t>{ 2 });
  std::uint64_t sum = 0;
  for (const std::uint64_t count : HistogramOf({ 0.1F, nan, 0.2F, 0.7F }).counts)
    sum += count;
  EXPECT_EQ(sum, 3U);
  EXPECT_THROW(hasp::CountGreyValues(
                 hasp::GridView<const float>{ &nan, hasp::testing::PlainGrid({ 1, 1, 1 }) },
                 [](double) { return false; }),
    hasp::Cancelled);
}

TEST(GreyHistogram, AValueFarOffTakesNoDigitsFromTheOthers)
{
  std::mt19937 random(5);
  std::normal_distribution<float> normal(100.0F, 20.0F);
  std::vector<float> samples(200000);
  for (float& sample : samples)
    sample = normal(random);
  samples[77] = 3e38F;
  samples[78] = -3e38F;
  const GreyHistogram histogram = HistogramOf(samples);
  EXPECT_GT(histogram.counts.size(), 256U);
  EXPECT_LT(histogram.binWidth, 1.0);
  samples.assign(200000, 0.0F); // nearly constant: ends, and keeps what there is
  samples[5] = 1e30F;
  EXPECT_GE(HistogramOf(samples).counts.size(), 1U);
}

TEST(GreyHistogram, ReachesFromEndToEndOfFloat)
{
  constexpr float most = std::numeric_limits<float>::max();
  std::vector<float> samples;
  for (int n = 0; n < 3000; ++n)
    samples.push_back(n % 3 == 0 ? -most : n % 3 == 1 ? 1e38F : most);
  const GreyHistogram histogram = HistogramOf(samples);
  EXPECT_EQ(histogram.counts.front(), 1000U);
  EXPECT_EQ(histogram.counts.back(), 1000U);
  EXPECT_NEAR(histogram.Middle(0) / most, -1.0, 1e-4); // a bin is 2 / 65,536
  EXPECT_NEAR(histogram.Middle(histogram.counts.size() - 1) / most, 1.0, 1e-4);
  const ThresholdProposal found = hasp::ProposeThreshold(histogram);
  EXPECT_NEAR(found.threshold / most, 0.5 + 0.5 * 1e38 / most, 1e-3);
  EXPECT_NEAR(found.softTissue / most, 1e38 / most, 1e-3);
  EXPECT_NEAR(found.bone / most, 1.0, 1e-3);
  const GreyHistogram same = HistogramOf({ most, most });
  EXPECT_EQ(same.counts, std::vector<std::uint64_t>{ 2 });
}

TEST(ThresholdProposal, NonsenseIsRefused)
{
  EXPECT_THROW(hasp::ProposeThreshold(GreyHistogram{}), std::invalid_argument);
  EXPECT_THROW(hasp::ProposeThreshold(HistogramOf({ 3, 3, 3 })), std::invalid_argument);
  EXPECT_THROW(
    hasp::ProposeThreshold(HistogramOf({ std::nanf(""), HUGE_VALF })), std::invalid_argument);
  for (const int classes : { 1, 4, -3 })
    EXPECT_THROW(hasp::ProposeThreshold(Mixture(Head), { classes }), std::invalid_argument);
}

TEST(ThresholdProposal, PartsFewValuesMidway)
{
  for (const int classes : { 2, 3 })
  {
    const ThresholdProposal two =
      hasp::ProposeThreshold(HistogramOf({ 10, 10, 10, 50 }), { classes });
    EXPECT_NEAR(two.threshold, 30.0, 0.01); // bins of 40 / 65536
    EXPECT_NEAR(two.boneShare, 0.25, 1e-12);
    EXPECT_GT(two.separation, 1e4);
  }
  EXPECT_NEAR(hasp::ProposeThreshold(HistogramOf({ -1000, 40, 1000 })).threshold, 520.0, 0.1);
  // One voxel of bone among very many.
  std::vector<float> rare(100000, 0.0F);
  rare[7] = 100.0F;
  EXPECT_NEAR(hasp::ProposeThreshold(HistogramOf(rare)).threshold, 50.0, 0.1);
}

TEST(ThresholdProposal, IsBayesThresholdWhereClassesAreAlike)
{
  const ThresholdProposal found =
    hasp::ProposeThreshold(Mixture({ { 0.3, -1000, 80 }, { 0.35, 0, 80 }, { 0.35, 800, 80 } }));
  EXPECT_NEAR(found.threshold, 400.0, 4.0); // a bin of 1,024 is 2.5
  EXPECT_NEAR(found.softTissue, 0.0, 4.0);
  EXPECT_NEAR(found.bone, 800.0, 4.0);
  EXPECT_NEAR(found.separation, 10.0, 0.1);
  EXPECT_NEAR(found.boneShare, 0.35, 1e-3);
  // Two, and no air.
  EXPECT_NEAR(
    hasp::ProposeThreshold(Mixture({ { 0.5, 0, 80 }, { 0.5, 800, 80 } }), { 2 }).threshold, 400.0,
    4.0);
}

TEST(ThresholdProposal, IsNearBayesThresholdWhereClassesAreUnlike)
{
  // Bayes' threshold of Head, where 0.37 N(40, 40) = 0.08 N(900, 200), is 185; Otsu's, which lies
  // between the means, is above 400.
  EXPECT_NEAR(hasp::ProposeThreshold(Mixture(Head)).threshold, 185.0, 0.05 * (900.0 - 40.0));
}

TEST(ThresholdProposal, GoesAlongWithScaleAndShift)
{
  const double plain = hasp::ProposeThreshold(Mixture(Head)).threshold;
  for (const auto& [scale, offset] :
    { std::pair{ 0.75, 200.0 }, { 1e-4, 0.0 }, { 1e6, -1e7 }, { 1.0, 1e8 } })
    EXPECT_NEAR(hasp::ProposeThreshold(Mixture(Head, scale, offset)).threshold,
      plain * scale + offset, 1e-3 * scale);
}

TEST(ThresholdProposal, StandsPaddingAndMetal)
{
  const double plain = hasp::ProposeThreshold(Mixture(Head)).threshold;
  for (const double value : { -3024.0, -2000.0 })
  {
    GreyHistogram padded = Mixture(Head);
    padded.counts[std::size_t(value + 4000)] += 400000;
    EXPECT_NEAR(hasp::ProposeThreshold(padded).threshold, plain, 20.0) << value;
    padded.counts[std::size_t(value + 3900)] += 5; // a dead voxel below it
    EXPECT_NEAR(hasp::ProposeThreshold(padded).threshold, plain, 20.0) << value;
  }
  for (const double share : { 0.001, 0.005, 0.009 })
  {
    std::vector<Normal> metal = Head;
    metal.push_back({ share, 8000, 300 });
    const ThresholdProposal found = hasp::ProposeThreshold(Mixture(metal));
    // Metal cut to the brightest bone draws the middle towards it; still little bone is lost.
    EXPECT_NEAR(found.threshold, plain, 130.0) << share;
  }
}

/// Dice of each threshold with what the preset for bone finds in a scan in HU without noise and
/// metal: the best, and that of one.
struct DiceOfThresholds
{
  double best = 0.0, bestThreshold = 0.0;
  double atProposal = 0.0;
  ThresholdProposal proposal;
};

DiceOfThresholds OnPhantom(const hasp::PhantomSettings& settings)
{
  const hasp::GridGeometry grid = hasp::PhantomGrid(glm::dvec3(4.0), settings);
  const std::vector<std::int16_t> samples = hasp::SamplePhantom(grid, settings);
  hasp::PhantomSettings clean;
  clean.blurMm = settings.blurMm;
  const std::vector<std::int16_t> truth = hasp::SamplePhantom(grid, clean);
  std::vector<double> in(65536), out(65536);
  double all = 0.0;
  for (std::size_t v = 0; v < samples.size(); ++v)
  {
    const bool inside = truth[v] >= 226;
    ++(inside ? in : out)[std::size_t(samples[v] + 32768)];
    all += inside;
  }
  DiceOfThresholds dice;
  dice.proposal =
    hasp::ProposeThreshold(hasp::GridView<const std::int16_t>{ samples.data(), grid });
  double hit = 0.0, miss = 0.0;
  for (int value = 32767; value >= -32768; --value)
  {
    hit += in[std::size_t(value + 32768)];
    miss += out[std::size_t(value + 32768)];
    const double now = 2.0 * hit / (hit + miss + all);
    if (now > dice.best)
    {
      dice.best = now;
      dice.bestThreshold = value;
    }
    if (value >= dice.proposal.threshold)
      dice.atProposal = now;
  }
  return dice;
}

TEST(ThresholdProposal, IsNearlyTheBestOfAllOnThePhantom)
{
  hasp::PhantomSettings ct;
  ct.blurMm = glm::dvec3(0.4);
  ct.noiseHU = 40.0;
  hasp::PhantomSettings metal = ct;
  metal.metal.on = true;
  hasp::PhantomSettings coneBeam = ct;
  coneBeam.coneBeam.on = true;
  coneBeam.noiseHU = 60.0;
  for (const hasp::PhantomSettings& settings : { ct, metal, coneBeam })
  {
    const DiceOfThresholds dice = OnPhantom(settings);
    EXPECT_GT(dice.best, 0.93);
    EXPECT_GT(dice.atProposal, dice.best - 0.005)
      << dice.proposal.threshold << " where " << dice.bestThreshold << " is best";
    EXPECT_GT(dice.proposal.separation, 2.0);
  }
}

} // namespace
