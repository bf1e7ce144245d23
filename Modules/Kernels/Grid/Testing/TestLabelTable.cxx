#include "Grid/LabelTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace
{

template <typename T>
std::vector<std::uint16_t> LabelsOf(const std::vector<T>& samples)
{
  hasp::GridGeometry grid;
  grid.dims = { static_cast<int>(samples.size()), 1, 1 };
  return hasp::LabelsOf(hasp::GridView<const T>{ samples.data(), grid });
}

TEST(LabelTable, LabelsThatOccurAreThoseOfASet)
{
  EXPECT_TRUE(LabelsOf(std::vector<std::uint16_t>(5)).empty());
  EXPECT_EQ(LabelsOf(std::vector<std::uint8_t>{ 255, 255, 0, 255, 1 }),
    (std::vector<std::uint16_t>{ 1, 255 }));
  std::mt19937 random(4);
  std::vector<std::uint16_t> samples(700'000); // several pieces of work
  for (std::uint16_t& sample : samples)
    sample = static_cast<std::uint16_t>(random() % 9 == 0 ? 0 : random());
  samples.front() = 65535;
  const std::vector<std::uint16_t> found = LabelsOf(samples);
  std::sort(samples.begin(), samples.end());
  samples.erase(std::unique(samples.begin(), samples.end()), samples.end());
  samples.erase(samples.begin()); // 0
  EXPECT_EQ(found, samples);
}

TEST(LabelTable, WhatNobodyNamedIsAddedBehindWhatIsNamed)
{
  const hasp::LabelTable named{ { 7, "jaw", { 1, 2, 3 }, false } };
  const hasp::LabelTable table = hasp::WithUnnamedLabels(named, { 1, 2, 7, 65535 });
  ASSERT_EQ(table.size(), 4U);
  EXPECT_EQ(table[0], named[0]);
  EXPECT_EQ(table[1].name, "Bone");
  EXPECT_EQ(table[2].name, "Fragment 2");
  EXPECT_EQ(table[3].value, 65535);
  EXPECT_TRUE(table[3].bone);
  EXPECT_EQ(hasp::WithUnnamedLabels(named, {}), named);
}

TEST(LabelTable, SixtyFragmentsHaveColoursThatCanBeToldApart)
{
  for (int a = 1; a <= 60; ++a)
    for (int b = 1; b < a; ++b)
    {
      const auto one = hasp::UnnamedLabel(static_cast<std::uint16_t>(a)).colour;
      const auto other = hasp::UnnamedLabel(static_cast<std::uint16_t>(b)).colour;
      int apart = 0;
      for (int c = 0; c < 3; ++c)
        apart = std::max(apart, std::abs(int(one[c]) - int(other[c])));
      EXPECT_GT(apart, a - b < 5 ? 60 : 0) << a << " " << b;
    }
}

} // namespace
