#include "Report.h"
#include "ReportTerms.h"
#include "SampleReport.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{

using hasp::Report;

/// What the check says about the sample after one change.
std::string FaultsAfter(const std::function<void(Report&)>& change)
{
  Report report = SampleReport();
  change(report);
  std::string all;
  for (const std::string& fault : hasp::ReportFaults(report))
    all += fault + "\n";
  return all;
}

void ExpectFault(const std::function<void(Report&)>& change, const std::string& words)
{
  const std::string faults = FaultsAfter(change);
  EXPECT_NE(faults.find(words), std::string::npos) << "'" << words << "' is not in: " << faults;
}

TEST(Report, TheSampleHolds)
{
  EXPECT_EQ(FaultsAfter([](Report&) {}), "");
}

TEST(Report, ATimeNeedsItsErrorAndTheReverse)
{
  ExpectFault([](Report& r) { r.rows[0].error.reset(); }, "a time without an error");
  ExpectFault([](Report& r) { r.rows[0].timeS.reset(); }, "an error without a time");
  ExpectFault([](Report& r) { r.rows[0].errorUnit.clear(); }, "without a unit");
}

TEST(Report, AMethodNeedsARivalOrTheReasonOfItsAbsence)
{
  ExpectFault(
    [](Report& r)
    {
      r.rows[0].rival.clear();
      r.rows.pop_back();
    },
    "neither a rival");
  // The absent row alone is an answer.
  EXPECT_EQ(FaultsAfter([](Report& r) { r.rows.erase(r.rows.begin()); }), "");
  // Another method's rival is none.
  ExpectFault(
    [](Report& r)
    {
      hasp::ReportRow row;
      row.id = "distance.rms.ct";
      row.value = 0.1;
      r.rows.push_back(row);
    },
    "distance: has neither");
}

TEST(Report, AnIdIsEmittedOnce)
{
  ExpectFault([](Report& r) { r.rows.push_back(r.rows[0]); }, "emitted twice");
  ExpectFault([](Report& r) { r.curves.push_back(r.curves[0]); }, "emitted twice");
  ExpectFault([](Report& r) { r.stability.push_back(r.stability[0]); }, "emitted twice");
  EXPECT_EQ(FaultsAfter(
              [](Report& r)
              {
                r.rows.push_back(r.rows[0]);
                r.rows.back().id += "@cranium";
              }),
    "");
}

TEST(Report, EachIdIsExplained)
{
  ExpectFault([](Report& r) { r.terms.erase(r.terms.begin()); }, "cells.extract: is explained");
  ExpectFault([](Report& r) { r.terms[2].id = "cells.error"; }, "cells.error_time: is explained");
  EXPECT_EQ(FaultsAfter(
              [](Report& r)
              {
                r.rows[0].id = "cells.extract.next@bone";
                r.rows[0].unit = "times as fast";
              }),
    "");
  for (const char* name :
    { "isosurface", "cells", "raycaching", "stability", "haptics", "import", "stereo" })
    EXPECT_TRUE(hasp::Explains(hasp::TermsOf(name).back(), name + std::string(".memory.peak")));
  EXPECT_TRUE(hasp::TermsOf("nonsense").empty());
}

TEST(Report, ARatioSaysWhichWayItIsBetter)
{
  using hasp::Better;
  for (const char* unit : { "ratio", "times as fast" })
    ExpectFault(
      [&](Report& r)
      {
        r.rows[0].unit = unit;
        r.rows[0].better = Better::NotSaid;
      },
      "which way it is better");
  hasp::ReportRow row;
  row.better = Better::Lower;
  EXPECT_EQ(hasp::BetterOf(row), Better::Lower);
  row.bars = { { 3.0, {}, "dB", 4.0 } }; // of another figure
  EXPECT_EQ(hasp::BetterOf(row), Better::Lower);
  row.bars.push_back({ 8.0, {} });
  EXPECT_EQ(hasp::BetterOf(row), Better::Higher);
  row.bars = { { {}, 8.0 } };
  EXPECT_EQ(hasp::BetterOf(row), Better::Lower);
  row.bars = { { 1.0, 1.0 } };
  EXPECT_EQ(hasp::BetterOf(row), Better::NotSaid);
}

TEST(Report, TwoReportsDoNotShareAnId)
{
  const std::vector<Report> twins{ SampleReport(), SampleReport() };
  EXPECT_EQ(hasp::ReportFaults(twins).size(), 2u); // both rows
  EXPECT_TRUE(hasp::ReportFaults(std::vector<Report>{ SampleReport() }).empty());
}

TEST(Report, FiguresAreFinite)
{
  ExpectFault([](Report& r) { r.rows[0].value = std::nan(""); }, "not finite");
  ExpectFault([](Report& r) { r.curves[0].points[1].second = INFINITY; }, "not finite");
  ExpectFault([](Report& r) { r.stability[0].figure = std::nan(""); }, "not finite");
  // What blew up may say so, as long as it does not pass.
  EXPECT_EQ(FaultsAfter(
              [](Report& r)
              {
                r.stability[0].figure = std::nan("");
                r.stability[0].pass = false;
              }),
    "");
}

TEST(Report, ATimedRatioHasNinePairsAndQuartiles)
{
  ExpectFault([](Report& r) { r.rows[0].n = 8; }, "fewer than 9 pairs");
  ExpectFault([](Report& r) { r.rows[0].q3.reset(); }, "without quartiles");
}

TEST(Report, AbsentIsAbsent)
{
  ExpectFault([](Report& r) { r.rows[1].value = 1.0; }, "either a value or the reason");
  ExpectFault([](Report& r) { r.rows[1].absent.clear(); }, "either a value or the reason");
  ExpectFault([](Report& r) { r.rows[1].rival.clear(); }, "which rival is absent");
}

TEST(Report, ABarIsMissedBeyondItsEnds)
{
  hasp::ReportRow row;
  row.value = 0.5;
  EXPECT_FALSE(Missed(row));
  for (const auto& [bar, missed] :
    { std::pair(hasp::ReportBar{ 0.5, {} }, false), { { 0.51, {} }, true }, { { {}, 0.5 }, false },
      { { {}, 0.49 }, true }, { { 0.4, 0.6 }, false }, { { 0.4, 0.6, "dB", 0.7 }, true },
      { { {}, 1.0, "dB", 0.7 }, false }, { { {}, 1.0, "dB", std::nan("") }, true } })
  {
    row.bars = { { 0.0, {} }, bar };
    EXPECT_EQ(Missed(row), missed) << bar.least.value_or(-1) << " " << bar.most.value_or(-1);
  }
  row.value.reset();
  row.bars = { { 0.0, {} } };
  EXPECT_TRUE(Missed(row));
}

TEST(Report, ABarSaysSomethingOfAFigure)
{
  ExpectFault([](Report& r) { r.rows[0].bars = { {} }; }, "a bar that says nothing");
  ExpectFault([](Report& r) { r.rows[1].bars = { { 1.0, {} } }; }, "a bar that says nothing");
  ExpectFault(
    [](Report& r) {
      r.rows[0].bars = { { std::nan(""), {} } };
    },
    "a bar that says nothing");
  EXPECT_EQ(FaultsAfter([](Report& r) { r.rows[0].bars = { { 9.0, {} } }; }), "") << "missed";
}

TEST(Report, UnusedMeansZero)
{
  ExpectFault([](Report& r) { r.unused[0].bytes = 1; }, "listed as unused");
  ExpectFault([](Report& r) { r.unused[0].milliseconds = 0.1; }, "listed as unused");
}

TEST(Report, SayingNothingIsAFault)
{
  Report empty;
  empty.name = "cells";
  EXPECT_EQ(hasp::ReportFaults(empty).size(), 1u);
}

TEST(Report, TheMachineIsNamed)
{
  const hasp::ReportMachine machine = hasp::ThisMachine();
  EXPECT_FALSE(machine.cpu.empty());
  EXPECT_FALSE(machine.simd.empty());
  EXPECT_GE(machine.cores, 1);
}

} // namespace
