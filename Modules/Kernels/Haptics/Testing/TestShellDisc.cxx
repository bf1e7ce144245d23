#include "Haptics/ShellDisc.h"
#include "Haptics/Testing/ShellOfPoints.h"

#include <gtest/gtest.h>

#include <array>

namespace
{

using hasp::ShellDisc;
using hasp::ShellOfPoints;

TEST(ShellDisc, AreThePointsWithoutThePadding)
{
  ShellOfPoints shell;
  std::vector<float> areas(16, 0.5F);
  shell.Add({ 1, 2, 3 }, { 0, 0, 1 });
  shell.Add({ -4, 5, 6 }, { 0, -1, 0 });
  areas[1] = 0.25F;
  std::array<ShellDisc, 16> discs{};
  ASSERT_EQ(hasp::CopyDiscs(shell.Get(0.0F, areas), 3, discs), 2U);
  EXPECT_EQ(discs[0].center, glm::vec3(1, 2, 3));
  EXPECT_EQ(discs[1].normal, glm::vec3(0, -1, 0));
  EXPECT_EQ(discs[0].areaMm2, 0.5F);
  EXPECT_EQ(discs[1].areaMm2, 0.25F);
  EXPECT_EQ(discs[1].level, 3U);
  EXPECT_EQ(discs[2].areaMm2, 0.0F) << "padding";
}

TEST(ShellDisc, ShareOneAreaAndStopWhereThereIsNoRoom)
{
  ShellOfPoints shell;
  for (int n = 0; n < 20; ++n)
    shell.Add({ n, 0, 0 }, { 1, 0, 0 });
  std::array<ShellDisc, 18> discs{};
  ASSERT_EQ(hasp::CopyDiscs(shell.Get(2.0F), 0, discs), 18U);
  EXPECT_EQ(discs[17].center.x, 17.0F);
  EXPECT_EQ(discs[17].areaMm2, 2.0F);
  EXPECT_EQ(hasp::CopyDiscs({}, 0, discs), 0U);
}

} // namespace
