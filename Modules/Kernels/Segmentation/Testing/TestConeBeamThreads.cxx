#include "../../Grid/Testing/WithThreads.h"
#include "ConeBeamTruth.h"
#include "Segmentation/ConeBeam.h"

#include <gtest/gtest.h>

namespace
{

TEST(ConeBeamThreads, AnyNumberOfThemGivesTheSameBytes)
{
  hasp::PhantomSettings settings;
  settings.noiseHU = 30.0;
  const hasp::testing::ConeBeamCase head(settings, hasp::PhantomGrid(glm::dvec3(4.0), settings));
  const auto corrected = [&]
  {
    std::vector<float> samples(head.grey.size());
    hasp::CorrectConeBeam(head.View(), { .contrastMm = 20.0, .insideAbove = -100.0 },
      { samples.data(), head.geometry });
    return samples;
  };
  const std::vector<float> one = hasp::testing::WithThreads(1, corrected);
  for (const int threads : { 2, 5 })
    EXPECT_EQ(hasp::testing::WithThreads(threads, corrected), one) << threads;
}

} // namespace
