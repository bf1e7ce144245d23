#include "Grid/Testing/WithThreads.h"
#include "Segmentation/RandomWalker.h"
#include "Segmentation/SharpWalker.h"
#include "Testing/RandomBone.h"

#include <gtest/gtest.h>

namespace
{

using hasp::Label;
using hasp::testing::RandomBone;
using hasp::testing::WithThreads;

TEST(SegmentationThreads, WalksAreTheSameToTheLastBit)
{
  const RandomBone bone({ 70, 60, 40 }, glm::dvec3(0.5, 0.5, 1.0), 0.8, 41); // several blocks
  const auto walk = [&]
  {
    const auto graph = bone.Graph({ .crack = 0.0 }); // noise is full of dark lines
    hasp::RandomWalker walker(graph);
    walker.SetSeeds({ { 100, 2 }, { 50000, 3 }, { 90000, 4 } });
    EXPECT_LT(walker.Solve({ .tolerance = 5e-3 }).work, 5.0); // ends locally
    walker.Solve({ .tolerance = 1e-4 });
    std::vector<double> all;
    for (std::int32_t n = 0; n < graph->Nodes(); n += 7)
      all.push_back(walker.Probability(n, 3));
    return all;
  };
  const std::vector<double> one = WithThreads(1, walk);
  EXPECT_EQ(WithThreads(2, walk), one);
  EXPECT_EQ(WithThreads(4, walk), one);
}

TEST(SegmentationThreads, LeastCutsAreTheSameToTheLastBit)
{
  const RandomBone bone({ 70, 60, 40 }, glm::dvec3(0.5, 0.5, 1.0), 0.8, 41);
  const auto cut = [&]
  {
    const hasp::SharpWalker walker(bone.Graph({ .crack = 0.0 }));
    return walker.Solve({ { 100, 2 }, { 50000, 3 }, { 90000, 4 }, { 90001, 2 } }, 1.3).labels;
  };
  const std::vector<Label> one = WithThreads(1, cut);
  EXPECT_EQ(WithThreads(2, cut), one);
  EXPECT_EQ(WithThreads(4, cut), one);
}

} // namespace
