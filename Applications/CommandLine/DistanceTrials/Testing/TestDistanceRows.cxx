// The trials as the report runs them, at sizes of seconds: their rows hold, and reach their bars.
#include "ContourRivals.h"
#include "DistanceCases.h"
#include "DistanceTrials.h"
#include "RandomTree.h"
#include "Testing/FilledReport.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace
{

using namespace hasp;

using hasp::testing::Row;

Report Filled(const std::function<void(ReportContext&)>& fill)
{
  return hasp::testing::Filled("distance", fill);
}

TEST(DistanceRows, AntiAliasingIsWorthWhatThePapersSay)
{
  const Report report = Filled(TryChamfer);
  EXPECT_EQ(report.rows.size(), 12U);
  for (const char* offset : { "0", "2" })
    EXPECT_FALSE(Missed(Row(report, std::string("distance.rms.chamfer_aa.") + offset))) << offset;
  // Far from the surface the metric's error is most of it.
  EXPECT_GT(*Row(report, "distance.rms.chamfer_aa.5").value, 0.6);
  for (const char* offset : { "0@exact", "2@exact", "5@exact" })
    EXPECT_LT(*Row(report, std::string("distance.offset.") + offset).value, 0.2) << offset;
}

TEST(DistanceRows, ScansAreMeasuredWithoutTheirBordersAndBesideChamfer)
{
  const Report report = Filled(TryScans);
  ASSERT_EQ(report.rows.size(), 3U);
  const double guide = *Row(report, "distance.rms.ct").value;
  EXPECT_LT(guide, 0.05); // the bar, 0.035, at 3 of 27 places
  EXPECT_NEAR(*Row(report, "distance.rms.ct.chamfer").value, 0.08, 0.01); // known of others
  EXPECT_LT(*Row(report, "distance.rms.ct.grey").value, 0.05);
}

TEST(DistanceRows, LibrariesThatAreNotThereAreAbsentAndOthersAreNot)
{
  RivalTransform gone;
  gone.key = "itk";
  gone.name = "ITK";
  gone.absent = "not here";
  gone.exact = true;
  const Report report = Filled([&](ReportContext& context) { TryRivals(context, { gone }); });
  ASSERT_EQ(report.rows.size(), 3U);
  for (const ReportRow& row : report.rows)
    EXPECT_EQ(row.absent, "not here") << row.id;
  const Report real = Filled([](ReportContext& context) { TryRivals(context, { MaurerRival() }); });
  const ReportRow& speed = Row(real, "distance.speed.edt");
  if (speed.absent.empty())
  {
    EXPECT_GT(*speed.value, 0.65);
  } // half the bar
}

TEST(DistanceRows, ContoursOfRandomTreesAreSound)
{
  const Report report = Filled([](ReportContext& context) { TryContour(context, 5); });
  ASSERT_EQ(report.rows.size(), 3U);
  EXPECT_EQ(*Row(report, "contour.manifold").value, 1.0);
  EXPECT_EQ(*Row(report, "contour.fallback").value, 0.0);
  EXPECT_LT(*Row(report, "contour.manifold").error, 0.05); // points lie on the surface, or 1 % off
  EXPECT_EQ(Row(report, "contour.manifold").n, 15);
  const ReportRow& crossing = Row(report, "contour.crossing");
  if (crossing.absent.empty())
    EXPECT_EQ(*crossing.value, 1.0);
  else
    EXPECT_NE(crossing.absent.find("not checked"), std::string::npos);
}

TEST(DistanceRows, SlotsEdgesAndHolesReachTheirBars)
{
  const PlainContour none{ "a plain contour", "not here", {} };
  const Report report = Filled([&](ReportContext& context) { TrySharpness(context, none); });
  ASSERT_EQ(report.rows.size(), 3U);
  for (const ReportRow& row : report.rows)
  {
    EXPECT_FALSE(Missed(row)) << row.id << ' ' << *row.value;
    EXPECT_NE(row.rival.find("not here"), std::string::npos);
  }
}

TEST(DistanceRows, BooleansAreCountedByWhatTheyAre)
{
  BooleanRival rival;
  rival.name = "a rival";
  rival.absent = "not here";
  EXPECT_EQ(Filled([&](ReportContext& context) { TryBooleans(context, rival, 4); }).rows[0].absent,
    "not here");
  rival.absent.clear();
  int runs = 0;
  rival.run = [&](std::uint32_t seed, int depth)
  {
    RandomTreeSettings settings;
    settings.depth = depth;
    settings.meshes = true;
    const double truth = VolumeOf(*SolidOf(RandomTree(seed, settings)), 8.0, 0.1);
    BooleanOutcome outcome{ "", true, true, 0, truth, 0.1 };
    switch (runs++ % 6)
    {
      case 0:
        outcome.ending = "60 s";
        break;
      case 1:
        outcome.closed = outcome.manifold = false;
        break;
      case 2:
        outcome.crossings = 3;
        break;
      case 3:
        outcome.volumeMm3 = 1.011 * truth;
        break;
      case 4:
        outcome.volumeMm3 = std::nan("");
        break;
      default: // the good one
        break;
    }
    return outcome;
  };
  const Report report = Filled([&](ReportContext& context) { TryBooleans(context, rival, 6); });
  const ReportRow& row = report.rows[0];
  EXPECT_NEAR(*row.value, 1.0 / 6.0, 1e-12);
  EXPECT_NE(row.rival.find("1 of 6 good, 1 not closed or no 2-manifold, 1 meet themselves, 2 of "
                           "wrong volume, 1 crashed"),
    std::string::npos)
    << row.rival;
  EXPECT_NE(row.data.find("6 of 6 good"), std::string::npos) << row.data;
  EXPECT_LT(*row.error, 0.01);
}

TEST(DistanceRows, WhatIsUnusedHoldsNothing)
{
  const Report report = Filled(
    [](ReportContext& context)
    {
      AddUnusedDistances(context);
      TryBooleans(context, { "a rival", "not here", {} }, 1); // a report says something
    });
  EXPECT_GE(report.unused.size(), 3U);
}

TEST(DistanceRows, ExtremeCasesComeOutAsPredicted)
{
  const Report report = Filled(
    [](ReportContext& context)
    {
      TryDistanceCases(context);
      TryBooleans(context, { "a rival", "not here", {} }, 1);
    });
  std::set<std::string> ids;
  for (const ReportCase& row : report.stability)
  {
    EXPECT_TRUE(row.pass) << row.id << ' ' << row.testCase << ": " << row.figure;
    EXPECT_TRUE(ids.insert(row.id).second) << row.id;
    EXPECT_FALSE(row.unit.empty()) << row.id;
  }
  EXPECT_GE(ids.size(), 60U);
}

} // namespace
