#include "Haptics/Solve6.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

hasp::Symmetric6 Diagonal(const hasp::Vector6& d)
{
  hasp::Symmetric6 matrix{};
  for (std::size_t i = 0; i < 6; ++i)
    matrix[hasp::UpperIndex(i, i)] = d[i];
  return matrix;
}

/// Adds k j j^T.
void Add(hasp::Symmetric6& matrix, double k, const hasp::Vector6& j)
{
  for (std::size_t row = 0; row < 6; ++row)
    for (std::size_t column = row; column < 6; ++column)
      matrix[hasp::UpperIndex(row, column)] += k * j[row] * j[column];
}

double Largest(const hasp::Vector6& v)
{
  double largest = 0.0;
  for (const double value : v)
    largest = std::max(largest, std::abs(value));
  return largest;
}

TEST(Solve6, IndexRunsThroughTheUpperTriangle)
{
  std::size_t expected = 0;
  for (std::size_t row = 0; row < 6; ++row)
    for (std::size_t column = row; column < 6; ++column)
      EXPECT_EQ(hasp::UpperIndex(row, column), expected++);
  EXPECT_EQ(expected, 21U);
}

TEST(Solve6, WhatHasNoAnswerSaysSoAndGivesZero)
{
  const hasp::Vector6 right{ 1, 2, 3, 4, 5, 6 };
  const hasp::Vector6 one{ 1, 1, 1, 1, 1, 1 };
  hasp::Vector6 x;
  const auto refused = [&](const hasp::Symmetric6& matrix, const hasp::Vector6& b, double length)
  {
    x = one;
    return !hasp::Solve6(matrix, b, length, x) && Largest(x) == 0.0;
  };
  EXPECT_TRUE(refused(Diagonal({ 1, 1, 1, 1, 1, -1 }), right, 10.0));
  EXPECT_TRUE(refused(hasp::Symmetric6{}, right, 10.0)) << "nothing holds anything";
  EXPECT_TRUE(refused(Diagonal({ 1, 1, NaN, 1, 1, 1 }), right, 10.0));
  EXPECT_TRUE(refused(Diagonal({ 1, 1, 1, 1, 1, HUGE_VAL }), right, 10.0));
  EXPECT_TRUE(refused(Diagonal(one), { 1, 2, NaN, 4, 5, 6 }, 10.0));
  EXPECT_TRUE(refused(Diagonal(one), { 1, 2, HUGE_VAL, 4, 5, 6 }, 10.0));
  EXPECT_TRUE(refused(Diagonal(one), right, 0.0));
  EXPECT_TRUE(refused(Diagonal(one), right, -1.0));
  EXPECT_TRUE(refused(Diagonal(one), right, NaN));
}

TEST(Solve6, DiagonalIsDivided)
{
  hasp::Vector6 x;
  ASSERT_TRUE(
    hasp::Solve6(Diagonal({ 1, 2, 4, 100, 200, 400 }), { 1, 2, 4, 300, 600, 1200 }, 10.0, x));
  const hasp::Vector6 expected{ 1, 1, 1, 3, 3, 3 };
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(x[i], expected[i], 1e-11); // the regularisation's 1e-12 of the stiffness
}

// (I + v v^T)^-1 = I - v v^T / (1 + v.v): a full matrix with a known inverse (Sherman, Morrison).
TEST(Solve6, KnownInverseOfAFullMatrix)
{
  const hasp::Vector6 v{ 0.3, -1.1, 0.7, 2.0, -0.4, 0.9 }, b{ 1, -2, 3, -4, 5, -6 };
  hasp::Symmetric6 matrix = Diagonal({ 1, 1, 1, 1, 1, 1 });
  Add(matrix, 1.0, v);
  double vv = 0.0, vb = 0.0;
  for (int i = 0; i < 6; ++i)
    vv += v[i] * v[i], vb += v[i] * b[i];
  hasp::Vector6 x;
  ASSERT_TRUE(hasp::Solve6(matrix, b, 1.0, x));
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(x[i], b[i] - v[i] * vb / (1.0 + vv), 2e-11); // condition 8 times 2e-12
}

// Contacts of 0.01 to 1e6 N/mm on bodies of 1 mm to 10 m, held by a coupling: what the tick solves.
TEST(Solve6, ResidualIsSmallOnEveryScaleAndStiffness)
{
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (const double length : { 1.0, 30.0, 1e4 })
    for (const double stiffness : { 0.01, 1.0, 1e3, 1e6 })
      for (int trial = 0; trial < 50; ++trial)
      {
        hasp::Symmetric6 matrix =
          Diagonal({ 1, 1, 1, length * length, length * length, length * length });
        for (int point = 0; point < 12; ++point)
        {
          hasp::Vector6 j;
          for (int i = 0; i < 6; ++i)
            j[i] = normal(random) * (i < 3 ? 1.0 : length);
          Add(matrix, stiffness, j);
        }
        hasp::Vector6 right, x;
        for (int i = 0; i < 6; ++i)
          right[i] = normal(random) * (i < 3 ? 1.0 : length);
        ASSERT_TRUE(hasp::Solve6(matrix, right, length, x));
        const hasp::Vector6 product = hasp::Multiply6(matrix, x);
        for (int i = 0; i < 6; ++i)
          // |A x - b| <= 1e-12 mean(A) |x|, and |x| <= |b| / 1 N/mm: stiffness * 12 points * 1e-12.
          EXPECT_NEAR(product[i] / (i < 3 ? 1.0 : length), right[i] / (i < 3 ? 1.0 : length),
            1e-12 * (1.0 + 20.0 * stiffness) * 10.0)
            << length << ' ' << stiffness;
      }
}

TEST(Solve6, ScaleOfLengthsChangesNothing)
{
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  hasp::Symmetric6 small = Diagonal({ 1, 1, 1, 1, 1, 1 }), large = small;
  for (std::size_t i = 3; i < 6; ++i)
    large[hasp::UpperIndex(i, i)] = 1e8; // the same body, 1e4 times as large
  for (int point = 0; point < 12; ++point)
  {
    hasp::Vector6 j, grown;
    for (int i = 0; i < 6; ++i)
      j[i] = normal(random), grown[i] = j[i] * (i < 3 ? 1.0 : 1e4);
    Add(small, 5.0, j);
    Add(large, 5.0, grown);
  }
  const hasp::Vector6 right{ 1, 2, 3, 4, 5, 6 }, grown{ 1, 2, 3, 4e4, 5e4, 6e4 };
  hasp::Vector6 x, y;
  ASSERT_TRUE(hasp::Solve6(small, right, 1.0, x));
  ASSERT_TRUE(hasp::Solve6(large, grown, 1e4, y));
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(x[i], y[i] * (i < 3 ? 1.0 : 1e4), 1e-9 * Largest(x)); // rounding, condition 1e3
}

// Points on the x axis pushed along z: nothing holds the turn about x, and nothing pushes it.
TEST(Solve6, CollinearPointsLeaveTheTurnAboutTheirLineAlone)
{
  hasp::Symmetric6 matrix{};
  for (const double at : { -10.0, 0.0, 5.0, 10.0 })
  {
    Add(matrix, 2.0, { 0, 0, 1, 0, -at, 0 }); // r x g
    Add(matrix, 2.0, { 0, 1, 0, 0, 0, at });
    Add(matrix, 2.0, { 1, 0, 0, 0, 0, 0 });
  }
  const hasp::Vector6 moved{ 0.1, 0.2, 0.3, 0.0, 0.01, -0.02 };
  hasp::Vector6 x;
  ASSERT_TRUE(hasp::Solve6(matrix, hasp::Multiply6(matrix, moved), 10.0, x));
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(x[i], moved[i], 1e-11);
  EXPECT_EQ(x[3], 0.0);
  // The coupling's own stiffness settles it where something does push.
  for (std::size_t i = 0; i < 6; ++i)
    matrix[hasp::UpperIndex(i, i)] += i < 3 ? 0.5 : 50.0;
  ASSERT_TRUE(hasp::Solve6(matrix, { 0, 0, 0, 5, 0, 0 }, 10.0, x));
  EXPECT_NEAR(x[3], 0.1, 1e-10);
}

} // namespace
