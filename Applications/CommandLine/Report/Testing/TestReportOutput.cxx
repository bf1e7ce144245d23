#include "ReportChart.h"
#include "ReportHtml.h"
#include "ReportJson.h"
#include "ReportText.h"
#include "SampleReport.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <stdexcept>

namespace
{

using nlohmann::json;

TEST(ReportJson, HasTheKeysThatReadersExpect)
{
  const json report = json::parse(hasp::ReportJson(SampleReport()));
  EXPECT_EQ(report.at("report"), "cells");
  EXPECT_EQ(report.at("seed"), 1);
  EXPECT_EQ(report.at("quick"), false);
  EXPECT_EQ(report.at("machine").at("cores"), 2);
  EXPECT_EQ(report.at("machine").at("simd"), "AVX2");
  const json row = report.at("rows").at(0);
  EXPECT_EQ(row, (json{ { "id", "cells.extract" }, { "value", 0.8 }, { "unit", "ratio" },
                   { "better", "lower" }, { "rival", "vtkFlyingEdges3D 9.1, normals on" },
                   { "error", 0.001 }, { "error_unit", "voxel" }, { "time_s", 0.12 }, { "q1", 0.7 },
                   { "q3", 0.9 }, { "n", 9 }, { "data", "sphere@64" } }));
  EXPECT_FALSE(report.at("rows").at(1).contains("value"));
  EXPECT_EQ(report.at("rows").at(1).at("absent"), "HASP_ENABLE_EMBREE is OFF");
  EXPECT_EQ(report.at("curves").at(0).at("points"), (json{ { 1.0, 0.1 }, { 10.0, 0.001 } }));
  EXPECT_EQ(report.at("stability").at(0).at("case"), "1 x 1 x 2 voxels");
  EXPECT_EQ(report.at("unused").at(0),
    (json{ { "resource", "second eye" }, { "bytes", 0 }, { "ms", 0.0 } }));
}

TEST(ReportJson, AnEmptyReportStillHasItsLists)
{
  const json report = json::parse(hasp::ReportJson(hasp::Report{}));
  for (const char* list : { "rows", "curves", "stability", "unused" })
    EXPECT_TRUE(report.at(list).is_array()) << list;
}

TEST(ReportJson, QuickRowsAreMarked)
{
  hasp::Report report = SampleReport();
  report.quick = true;
  EXPECT_EQ(json::parse(hasp::ReportJson(report)).at("rows").at(0).at("quick"), true);
}

TEST(ReportJson, RefusesWhatJsonCannotSay)
{
  hasp::Report report = SampleReport();
  report.rows[0].value = std::nan("");
  EXPECT_THROW(hasp::ReportJson(report), std::invalid_argument);
}

TEST(ReportJson, BarsSayWhetherTheyAreMissed)
{
  hasp::Report report = SampleReport();
  EXPECT_FALSE(json::parse(hasp::ReportJson(report)).at("rows").at(0).contains("bar_missed"));
  report.rows[0].bars = { { {}, 0.8 }, { 33.0, {}, "dB", 40.0 } };
  json row = json::parse(hasp::ReportJson(report)).at("rows").at(0);
  EXPECT_EQ(row.at("bar_missed"), false);
  EXPECT_EQ(row.at("bars"), json::parse(R"([{"most": 0.8, "missed": false},
    {"of": "dB", "figure": 40.0, "least": 33.0, "missed": false}])"));
  report.rows[0].bars[0].most = 0.7;
  report.rows[0].bars[1].figure = std::nan("");
  row = json::parse(hasp::ReportJson(report)).at("rows").at(0);
  EXPECT_EQ(row.at("bar_missed"), true);
  EXPECT_EQ(row.at("bars"), json::parse(R"([{"most": 0.7, "missed": true},
    {"of": "dB", "figure": null, "least": 33.0, "missed": true}])"));
}

/// Not "nan", which is no JSON: the row beside says that it does not pass.
TEST(ReportJson, WhatBlewUpIsNull)
{
  hasp::Report report = SampleReport();
  report.stability[0].figure = std::nan("");
  EXPECT_THROW(hasp::ReportJson(report), std::invalid_argument) << "it passes";
  report.stability[0].pass = false;
  const std::string text = hasp::ReportJson(report);
  EXPECT_TRUE(json::parse(text).at("stability").at(0).at("figure").is_null());
  EXPECT_EQ(text.find("nan"), std::string::npos);
}

TEST(ReportJson, SeveralReportsAreAnArray)
{
  const std::vector<hasp::Report> one{ SampleReport() }, two{ SampleReport(), SampleReport() };
  EXPECT_TRUE(json::parse(hasp::ReportJson(one)).is_object());
  EXPECT_EQ(json::parse(hasp::ReportJson(two)).size(), 2u);
}

TEST(ReportText, SaysEveryFigureOnALine)
{
  const std::string text = hasp::ReportText(SampleReport());
  EXPECT_NE(text.find("[0.7, 0.9] n 9  error 0.001 voxel  time 0.12 s"), std::string::npos) << text;
  EXPECT_NE(text.find("absent: HASP_ENABLE_EMBREE is OFF (Embree"), std::string::npos) << text;
  EXPECT_NE(text.find("0 bytes, 0 ms"), std::string::npos) << text;
}

TEST(ReportText, SaysWhichWayIsBetterAndWhatIdsStandFor)
{
  hasp::Report report = SampleReport();
  for (const bool higher : { false, true })
  {
    report.rows[0].better = higher ? hasp::Better::Higher : hasp::Better::Lower;
    const std::string text = hasp::ReportText(report), page = hasp::ReportHtml({ report });
    const std::string better = higher ? "higher" : "lower";
    EXPECT_NE(text.find("0.8 ratio         (" + better + " is better) ["), std::string::npos)
      << text;
    EXPECT_NE(page.find("0.8 ratio</td><td>" + better + "</td>"), std::string::npos) << page;
    for (const std::string& output : { text, page })
    {
      EXPECT_NE(output.find(hasp::LegendText()), std::string::npos) << output;
      EXPECT_NE(output.find("time from the volume to the cells"), std::string::npos) << output;
      EXPECT_EQ(output.find("not in this report"), std::string::npos) << output;
    }
  }
  report.rows[0].better = hasp::Better::NotSaid;
  EXPECT_EQ(hasp::ReportText(report).find("is better)"), std::string::npos);
}

TEST(ReportText, FlagsBarsThatAreMissed)
{
  hasp::Report report = SampleReport();
  EXPECT_EQ(hasp::ReportText(report).find("  bar"), std::string::npos);
  EXPECT_EQ(hasp::ReportText(report).find("missed their bar"), std::string::npos);
  const auto said = [&](
                      bool missed, const std::vector<hasp::ReportBar>& bars, const std::string& bar)
  {
    report.rows[0].bars = bars;
    const std::string text = hasp::ReportText(report), page = hasp::ReportHtml({ report });
    const std::string sum = missed ? "1 of 1: cells.extract\n" : "0 of 1\n";
    EXPECT_NE(text.find("  " + bar + "\n"), std::string::npos) << text;
    EXPECT_NE(text.find("rows that missed their bar: " + sum), std::string::npos) << text;
    EXPECT_NE(page.find((missed ? "<td class=\"bad\">" : "<td>") + bar), std::string::npos);
  };
  said(false, { { 0.8, {} } }, "bar: at least 0.8");
  said(true, { { {}, 0.7 } }, "bar missed: at most 0.7");
  said(true, { { 0.8, 0.8 }, { 33, {}, "dB", 30.5 } },
    "bar missed: exactly 0.8, dB 30.5 at least 33 (missed)");
  said(false, { { -0.6, -0.4, "slope", -0.5 } }, "bar: slope -0.5 -0.6 to -0.4");
}

TEST(ReportHtml, HoldsEveryFigureAndNothingFromElsewhere)
{
  const std::string page = hasp::ReportHtml({ SampleReport() });
  for (const char* text : { "cells.extract", "0.7 – 0.9", "absent: HASP_ENABLE_EMBREE",
         "as predicted", "second eye", "Test &lt;CPU&gt;", "<polyline", "not a medical device" })
    EXPECT_NE(page.find(text), std::string::npos) << text;
  for (const char* text : { "http", "<script", "<CPU>", "src=" })
    EXPECT_EQ(page.find(text), std::string::npos) << text;
}

TEST(ReportChart, PlacesPointsOnLogarithmicAxes)
{
  // Times 1 and 10 are the ends of one decade: left end 78 and right end 640 - 170 pixels.
  const std::string svg = hasp::ErrorTimeChart(SampleReport().curves);
  EXPECT_NE(svg.find("<circle cx=\"78\" cy=\"16\""), std::string::npos) << svg;
  EXPECT_NE(svg.find("<circle cx=\"470\" cy=\"328\""), std::string::npos) << svg;
  EXPECT_NE(svg.find("mesh: 2 ms, 0.1 voxel"), std::string::npos) << svg;
}

TEST(ReportChart, OnePointIsEnoughAndNoneIsNone)
{
  EXPECT_EQ(hasp::ErrorTimeChart({}), "");
  EXPECT_EQ(hasp::ErrorTimeChart({ { "a", "b", "s", "mm", {} } }), "");
  const std::string svg = hasp::ErrorTimeChart({ { "a", "b", "s", "mm", { { 0.0, 0.0 } } } });
  EXPECT_NE(svg.find("<circle"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

} // namespace
