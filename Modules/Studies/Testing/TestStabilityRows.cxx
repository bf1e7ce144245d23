#include "Studies/StabilityRows.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <set>
#include <string>

namespace
{

const std::vector<hasp::StabilityRow>& Rows()
{
  static const std::vector<hasp::StabilityRow> rows = hasp::StabilityRows();
  return rows;
}

std::set<std::string> Families()
{
  std::set<std::string> families;
  for (const hasp::StabilityRow& row : Rows())
  {
    // "grid.explicit.k0.1.", "plate.0.", "default.Touch-like.": a second's work at most
    const std::size_t end =
      row.id.starts_with("grid.") ? row.id.find(".T") : row.id.find('.', row.id.find('.') + 1);
    families.insert(row.id.substr(0, 1 + end));
  }
  return families;
}

TEST(StabilityRows, AreManyAndEachHasItsOwnId)
{
  std::set<std::string> ids;
  for (const hasp::StabilityRow& row : Rows())
  {
    EXPECT_TRUE(ids.insert(row.id).second) << row.id;
    EXPECT_FALSE(row.text.empty()) << row.id;
    EXPECT_FALSE(row.law.empty()) << row.id;
  }
  EXPECT_GE(ids.size(), 300U);
}

// A table on which everything is stable would hold for any law.
TEST(StabilityRows, SaysBothStableAndNot)
{
  int stable = 0, oscillates = 0, through = 0, deep = 0, energy = 0, byDefault = 0;
  for (const hasp::StabilityRow& row : Rows())
  {
    stable += row.predicted.Stable();
    oscillates += row.predicted.oscillates;
    through += row.predicted.through;
    deep += row.predicted.deep;
    energy += row.predicted.givesEnergy;
    byDefault += row.byDefault;
  }
  std::printf("%zu rows: %d stable (%d of them defaults), %d oscillate, %d go through, %d deep, "
              "%d give energy\n",
    Rows().size(), stable, byDefault, oscillates, through, deep, energy);
  EXPECT_GE(stable, 200);
  EXPECT_GE(byDefault, 150);
  EXPECT_GE(oscillates, 80);
  EXPECT_GE(through, 18);
  EXPECT_GE(deep, 30);
  EXPECT_GE(energy, 3);
}

TEST(StabilityRows, DefaultsArePredictedStable)
{
  for (const hasp::StabilityRow& row : Rows())
    if (row.byDefault)
    {
      EXPECT_TRUE(row.predicted.Stable()) << row.id;
      EXPECT_LT(row.figure, row.limit) << row.id;
    }
}

class StabilityFamily : public testing::TestWithParam<std::string>
{
};

TEST_P(StabilityFamily, OutcomeIsThePrediction)
{
  double cpu = 0.0;
  int count = 0;
  for (const hasp::StabilityRow& row : Rows())
  {
    if (!row.id.starts_with(this->GetParam()))
      continue;
    const auto [figures, verdict] = row.run();
    cpu += figures.cpuS;
    ++count;
    EXPECT_TRUE(hasp::AsPredicted(row.predicted, verdict))
      << row.id << ": predicted " << row.predicted.Faults() << ", is " << verdict.Faults() << "; "
      << row.law << ' ' << row.figure << "; ripple " << 1000 * figures.rippleMm << " um, growth "
      << figures.growth << ", off for " << 1000 * figures.longestFlightS << " ms, energy "
      << figures.lowestEnergyMj << " mJ, deep " << figures.holdDeepestMm << " ("
      << figures.deepestMm << ") mm, force " << figures.largestForceN << " N, out of balance "
      << 1000 * figures.slowestRecoveryS << " ms, tool z " << figures.tool.position.z;
  }
  std::printf(
    "%-24s %4d rows, %.1f ms of CPU each\n", this->GetParam().c_str(), count, 1000.0 * cpu / count);
}

INSTANTIATE_TEST_SUITE_P(Table, StabilityFamily, testing::ValuesIn(Families()),
  [](const auto& info)
  {
    std::string name = info.param.substr(0, info.param.size() - 1);
    for (char& letter : name)
      letter = letter == '.' || letter == '-' ? '_' : letter;
    return name;
  });

} // namespace
