#include "Evaluation/SortedLayers.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace
{

using hasp::Layer;

const Layer red{ 1, { 1, 0, 0 }, 0.5, 1 }, green{ 2, { 0, 1, 0 }, 0.25, 2 },
  wall{ 3, { 0, 0, 1 }, 1.0, 3 }, hidden{ 4, { 1, 1, 1 }, 0.5, 4 };

TEST(SortedLayers, AreBlendedInWhateverOrderTheyCome)
{
  const glm::dvec3 white(1.0), right(0.5 + 0.375, 0.5 * 0.25 + 0.375, 0.375);
  for (const auto& layers : { std::vector{ red, green }, std::vector{ green, red } })
    EXPECT_LT(glm::length(hasp::BlendLayers(hasp::SortLayers(layers), white) - right), 1e-15);
}

TEST(SortedLayers, EndAtTheFirstOpaqueOne)
{
  const auto sorted = hasp::SortLayers({ hidden, green, wall, red });
  ASSERT_EQ(sorted.size(), 3U);
  const glm::dvec3 right(0.5, 0.125, 0.375);
  EXPECT_LT(glm::length(hasp::BlendLayers(sorted, glm::dvec3(1)) - right), 1e-15);
}

TEST(SortedLayers, NothingShowsTheBackground)
{
  EXPECT_EQ(hasp::BlendLayers({}, { 0.1, 0.2, 0.3 }), glm::dvec3(0.1, 0.2, 0.3));
}

TEST(SortedLayers, OrderAndNumberTellRaysApart)
{
  EXPECT_TRUE(hasp::SameSurfaces({ red, green }, { red, green }));
  EXPECT_FALSE(hasp::SameSurfaces({ red, green }, { green, red }));
  EXPECT_FALSE(hasp::SameSurfaces({ red, green }, { red }));
}

} // namespace
