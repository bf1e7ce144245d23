#include "Grid/GreyLevels.h"
#include "Grid/Phantom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

/// The phantom with some noise, each value changed.
template <typename T, typename Change>
hasp::GreyLevels Levels(const Change& change, hasp::PhantomSettings settings = {})
{
  settings.noiseHU = 15.0;
  const auto g = hasp::PhantomGrid({ 4, 4, 4 }, settings);
  std::vector<T> samples;
  for (const std::int16_t hu : hasp::SamplePhantom(g, settings))
    samples.push_back(static_cast<T>(change(double(hu))));
  return hasp::FindGreyLevels(hasp::GridView<const T>{ samples.data(), g });
}

TEST(GreyLevels, PhantomInHounsfieldUnitsIsNotDenied)
{
  const auto levels = Levels<std::int16_t>([](double hu) { return hu; });
  ASSERT_TRUE(levels.air && levels.softTissue);
  EXPECT_NEAR(*levels.air, -1000.0, 10.0);     // a bin
  EXPECT_NEAR(*levels.softTissue, 40.0, 20.0); // soft steps towards bone pull the mean up
  EXPECT_FALSE(levels.DeniesHounsfield());
}

TEST(GreyLevels, PaddingAroundTheScannedCircleIsNotAir)
{
  hasp::PhantomSettings settings;
  const auto g = hasp::PhantomGrid({ 4, 4, 4 }, settings);
  auto samples = hasp::SamplePhantom(g, settings);
  for (int k = 0, n = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i, ++n)
        if (std::hypot(2.0 * i / g.dims.x - 1.0, 2.0 * j / g.dims.y - 1.0) > 0.98)
          samples[n] = -3024;
  const auto levels = hasp::FindGreyLevels(hasp::GridView<const std::int16_t>{ samples.data(), g });
  ASSERT_TRUE(levels.air);
  EXPECT_NEAR(*levels.air, -1000.0, 10.0);
  EXPECT_FALSE(levels.DeniesHounsfield());
}

TEST(GreyLevels, ScaledAndShiftedValuesAreDeniedWithTheirNumbers)
{
  const auto shifted = Levels<std::int16_t>([](double hu) { return hu + 1024.0; });
  ASSERT_TRUE(shifted.air);
  EXPECT_NEAR(*shifted.air, 24.0, 15.0);
  EXPECT_TRUE(shifted.airIsElsewhere);
  const auto scaled = Levels<float>([](double hu) { return 0.6 * hu; });
  ASSERT_TRUE(scaled.air);
  EXPECT_NEAR(*scaled.air, -600.0, 15.0);
  EXPECT_TRUE(scaled.airIsElsewhere);
  const auto steep = Levels<float>([](double hu) { return 1.3 * hu; });
  ASSERT_TRUE(steep.air);
  EXPECT_NEAR(*steep.air, -1300.0, 15.0);
  EXPECT_TRUE(steep.airIsElsewhere);
  // Air where HU have it, tissue not: cone beam scans that were calibrated on air alone.
  const auto weak = Levels<std::int16_t>([](double hu) { return 0.6 * (hu + 1000.0) - 1000.0; });
  ASSERT_TRUE(weak.softTissue);
  EXPECT_NEAR(*weak.softTissue, -376.0, 20.0);
  EXPECT_TRUE(weak.softIsElsewhere);
  EXPECT_FALSE(weak.airIsElsewhere);
}

TEST(GreyLevels, ScaleTooNarrowToTellAirFromTissueDeniesNothing)
{
  const auto levels =
    Levels<std::uint8_t>([](double hu) { return std::clamp((hu + 1000.0) / 8.0, 0.0, 255.0); });
  EXPECT_FALSE(levels.air);
  EXPECT_FALSE(levels.DeniesHounsfield());
}

TEST(GreyLevels, WhatHoldsNoAirDeniesNothing)
{
  // Cropped inside the head: tissue and bone only.
  hasp::PhantomSettings settings;
  hasp::GridGeometry g;
  g.dims = { 40, 40, 20 };
  g.origin = { -40, -30, 20 };
  g.spacing = { 2, 2, 2 };
  const auto samples = hasp::SamplePhantom(g, settings);
  EXPECT_FALSE(hasp::FindGreyLevels(hasp::GridView<const std::int16_t>{ samples.data(), g })
                 .DeniesHounsfield());
  // A cast of plaster, and nothing at all.
  EXPECT_FALSE(Levels<std::int16_t>(
    [](double hu) {
      return hu > -500.0 ? 1600.0 : -1000.0;
    }).DeniesHounsfield());
  const std::vector<float> zeros(g.Size(), 0.0F);
  EXPECT_FALSE(
    hasp::FindGreyLevels(hasp::GridView<const float>{ zeros.data(), g }).DeniesHounsfield());
}

} // namespace
