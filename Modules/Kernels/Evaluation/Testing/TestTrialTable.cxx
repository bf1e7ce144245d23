#include "Evaluation/TrialTable.h"
#include "PartMeshes.h"

#include <gtest/gtest.h>

#include <memory>

namespace
{

using hasp::FragmentPoses;
using hasp::RigidPose;
using hasp::Trial;
using hasp::TrialCase;
using hasp::TrialMeasure;

std::shared_ptr<const hasp::MeasuredSurface> Plate()
{
  return std::make_shared<hasp::MeasuredSurface>(
    hasp::TriangleMesh{
      { { 0, 0, 0 }, { 9, 0, 0 }, { 9, 9, 0 }, { 0, 9, 0 } }, { { 0, 1, 2 }, { 0, 2, 3 } } },
    200);
}

RigidPose Up(double mm)
{
  return { { 0, 0, mm } };
}

double Of(const hasp::TrialFigures& figures, TrialMeasure measure)
{
  return figures[std::size_t(measure)];
}

TrialCase Case(const std::string& name)
{
  return { name, { { "a", Plate() }, { "b", Plate() } },
    FragmentPoses{ { "a", Up(0) }, { "b", Up(0) } } };
}

TEST(TrialTable, WhatDoesNotBelongTogetherIsRefused)
{
  const std::vector<TrialCase> cases{ Case("one") };
  const Trial trial{ "one", "x", 1, { { "a", Up(1) } } };
  const auto refused = [](const std::vector<TrialCase>& c, const std::vector<Trial>& t)
  { EXPECT_THROW(hasp::MakeTrialTable(c, t), std::invalid_argument); };
  refused({ Case("one"), Case("one") }, {});
  refused({ { "one", {} } }, {});
  refused({ { "one", { { "a", nullptr } } } }, {});
  refused({ { "one", { { "a", Plate() } }, FragmentPoses{ { "c", {} } } } }, {});
  refused(cases, { { "two", "x", 1, {} } });
  refused(cases, { trial, trial });
  refused(cases, { { "one", "x", 1, { { "c", Up(1) } } } });
  refused(cases, { { "one", "x", 1, { { "a", { {}, { 0, 0, 0, 0 } } } } } });
  EXPECT_THROW(hasp::RelativeTo({ { "a", Up(1) } }, "skull"), std::invalid_argument);
  EXPECT_THROW(
    hasp::MakeTrialTable(cases, std::vector<Trial>{ trial }, [](double) { return false; }),
    hasp::Cancelled);
  try
  {
    hasp::MakeTrialTable(cases, std::vector<Trial>{ { "secret", "x", 1, {} } });
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_EQ(std::string(error.what()).find("secret"), std::string::npos);
  }
}

TEST(TrialTable, PairsAreOfOneOperatorOfTwoAndOfTheTruth)
{
  // Heights: operator x 1 and 3 mm, y 10 and 16 mm; differences can be told from each other.
  std::vector<Trial> trials;
  for (const auto& [who, number, mm] :
    { std::tuple("x", 1, 1.0), { "x", 2, 3.0 }, { "y", 1, 10.0 }, { "y", 2, 16.0 } })
    trials.push_back({ "one", who, number, { { "a", Up(mm) }, { "b", Up(-mm) } } });
  const auto table = hasp::MakeTrialTable(std::vector<TrialCase>{ Case("one") }, trials);
  ASSERT_EQ(table.rows.size(), 1U);
  const hasp::TrialRow& row = table.rows[0];
  EXPECT_EQ(row.intraOperator.pairs, 4U); // two fragments
  EXPECT_EQ(row.interOperator.pairs, 8U);
  EXPECT_EQ(row.accuracy.pairs, 8U);
  for (const TrialMeasure mm : { TrialMeasure::SurfaceMeanMm, TrialMeasure::SurfaceMaxMm,
         TrialMeasure::TranslationMm, TrialMeasure::TreMm })
  {
    EXPECT_NEAR(Of(row.intraOperator.mean, mm), (2.0 + 6.0) / 2, 1e-12);
    EXPECT_NEAR(Of(row.intraOperator.most, mm), 6.0, 1e-12);
    EXPECT_NEAR(Of(row.intraOperator.deviation, mm), std::sqrt(16.0 / 3), 1e-12);
    EXPECT_NEAR(Of(row.interOperator.mean, mm), (9.0 + 15.0 + 7.0 + 13.0) / 4, 1e-12);
    EXPECT_NEAR(Of(row.accuracy.mean, mm), 30.0 / 4, 1e-12);
  }
  EXPECT_LT(Of(row.accuracy.most, TrialMeasure::RotationDegrees), 1e-12);
  EXPECT_TRUE(table.missing.empty());
  EXPECT_EQ(table.pairs.size(), 20U);
}

TEST(TrialTable, OverallEveryPairWeighsTheSame)
{
  std::vector<Trial> trials;
  for (int n = 1; n <= 3; ++n) // three pairs of 1, 1 and 2 mm, of each fragment
    trials.push_back({ "one", "x", n, { { "a", Up(n) }, { "b", Up(n) } } });
  for (int n = 1; n <= 2; ++n) // one of 8
    trials.push_back({ "two", "x", n, { { "a", Up(8 * n) }, { "b", Up(8 * n) } } });
  const auto table =
    hasp::MakeTrialTable(std::vector<TrialCase>{ Case("one"), Case("two") }, trials);
  EXPECT_NEAR(Of(table.rows[0].intraOperator.mean, TrialMeasure::TreMm), 4.0 / 3, 1e-12);
  EXPECT_NEAR(Of(table.rows[1].intraOperator.mean, TrialMeasure::TreMm), 8.0, 1e-12);
  EXPECT_NEAR(Of(table.overall.intraOperator.mean, TrialMeasure::TreMm), 12.0 / 4, 1e-12);
  EXPECT_EQ(table.overall.interOperator.pairs, 0U);
  EXPECT_EQ(Of(table.overall.interOperator.mean, TrialMeasure::TreMm), 0.0);
  ASSERT_EQ(table.missing.size(), 1U);
  EXPECT_EQ(table.missing[0].caseName, "two");
  EXPECT_EQ(table.missing[0].trial, 3);
  EXPECT_EQ(table.missing[0].fragment, "");
}

TEST(TrialTable, WhatIsMissingIsSaidAndNotGuessed)
{
  TrialCase one = Case("one"), two = Case("two");
  one.truth->erase("b");
  two.truth.reset();
  const std::vector<Trial> trials{ { "one", "x", 1, { { "a", Up(1) }, { "b", Up(1) } } },
    { "one", "y", 1, { { "a", Up(2) } } }, { "two", "x", 1, { { "a", Up(2) }, { "b", Up(1) } } } };
  const auto table = hasp::MakeTrialTable(std::vector<TrialCase>{ one, two }, trials);
  EXPECT_EQ(table.overall.accuracy.pairs, 2U);
  EXPECT_EQ(table.overall.interOperator.pairs, 1U);
  EXPECT_EQ(table.overall.intraOperator.pairs, 0U);
  ASSERT_EQ(table.missing.size(), 3U);
  EXPECT_EQ(table.missing[0].operatorName, "y"); // who did not place b
  EXPECT_EQ(table.missing[0].fragment, "b");
  EXPECT_EQ(table.missing[1].operatorName, ""); // the truth of b
  EXPECT_EQ(table.missing[1].fragment, "b");
  EXPECT_EQ(table.missing[2].caseName, "two"); // y did not do it at all
  EXPECT_EQ(table.missing[2].fragment, "");
}

TEST(TrialTable, AMovedReferenceIsTakenBack)
{
  const parttest::Motion motion = parttest::AnyMotion(2);
  const RigidPose skull{ motion.to, glm::quat_cast(motion.turn) };
  const FragmentPoses poses =
    hasp::RelativeTo({ { "skull", skull }, { "a", skull * Up(3) } }, "skull");
  ASSERT_EQ(poses.size(), 1U);
  EXPECT_LT(glm::distance(poses.at("a").Place({ 1, 2, 3 }), { 1, 2, 6 }), 1e-12);
}

} // namespace
