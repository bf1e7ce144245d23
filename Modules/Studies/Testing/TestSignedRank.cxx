#include "Studies/SignedRank.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace
{

/// 1, 2, ... n, of which the smallest ones are below zero such that their ranks sum to `below`.
std::vector<double> WithSum(int n, int below)
{
  std::vector<double> differences;
  for (int rank = n; rank > 0; --rank)
  {
    const bool negative = rank <= below;
    below -= negative ? rank : 0;
    differences.push_back(negative ? -rank : rank);
  }
  return differences;
}

TEST(SignedRank, WhatIsNoNumberIsRefused)
{
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(), HUGE_VAL })
    EXPECT_THROW(hasp::TestSignedRanks(std::vector<double>{ 1.0, bad }), std::invalid_argument);
  EXPECT_EQ(hasp::TestSignedRanks({}).p, 1.0);
  EXPECT_EQ(hasp::TestSignedRanks(std::vector<double>{ 0.0, 0.0 }).n, 0);
}

// The largest sums that are significant at 5 % and 1 %, both sides: Wilcoxon and Wilcox 1964, as
// all textbooks print them.
TEST(SignedRank, CriticalSumsAreThePublishedOnes)
{
  struct Row
  {
    int n, fivePercent, onePercent;
  };
  for (const Row& row : { Row{ 8, 3, 0 }, Row{ 10, 8, 3 }, Row{ 12, 13, 7 }, Row{ 15, 25, 15 },
         Row{ 20, 52, 37 }, Row{ 25, 89, 68 }, Row{ 30, 137, 109 } })
  {
    const auto p = [&](int sum) { return hasp::TestSignedRanks(WithSum(row.n, sum)).p; };
    EXPECT_LE(p(row.fivePercent), 0.05) << row.n;
    EXPECT_GT(p(row.fivePercent + 1), 0.05) << row.n;
    EXPECT_LE(p(row.onePercent), 0.01) << row.n;
    EXPECT_GT(p(row.onePercent + 1), 0.01) << row.n;
  }
  EXPECT_DOUBLE_EQ(hasp::TestSignedRanks(WithSum(5, 0)).p, 2.0 / 32.0);
}

// All 2^n signs, one after the other, with the same mean ranks.
TEST(SignedRank, TiesAreCountedAsAllSignsSay)
{
  const std::vector<double> differences{ 1, -1, 2, 2, -2, 3, 0, 5, 5, 5, -1 };
  const hasp::SignedRank found = hasp::TestSignedRanks(differences);
  const std::vector<double> ranks{ 2, 2, 2, 5, 5, 5, 7, 9, 9, 9 };
  EXPECT_EQ(found.n, 10);
  EXPECT_DOUBLE_EQ(found.below, 2 + 2 + 5);
  EXPECT_DOUBLE_EQ(found.above, 55 - 9);
  int extreme = 0;
  for (unsigned signs = 0; signs < 1024; ++signs)
  {
    double sum = 0.0;
    for (unsigned n = 0; n < 10; ++n)
      sum += (signs >> n & 1U) != 0 ? ranks[n] : 0.0;
    extreme += sum <= 9.0 || sum >= 46.0;
  }
  EXPECT_NEAR(found.p, extreme / 1024.0, 1e-12);
}

TEST(SignedRank, ManyDifferencesGoOnAsTheExactOnesDo)
{
  std::vector<double> differences;
  for (int n = 1; n <= 200; ++n)
    differences.push_back(n % 5 < 2 ? -n : n);
  const double exact = hasp::TestSignedRanks(differences).p;
  differences.push_back(201 * 1.0);
  const double normal = hasp::TestSignedRanks(differences).p;
  EXPECT_LT(normal, exact); // one more above zero
  EXPECT_GT(normal, 0.4 * exact);
}

} // namespace
