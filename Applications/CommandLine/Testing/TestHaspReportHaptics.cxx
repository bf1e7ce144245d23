#include "ReportFixture.h"

#include <set>

namespace
{

/// Errors at their bars, ratios at half of them; what this processor or build lacks is named.
TEST_F(HaspReport, HapticsAreFastAndWhereTheyShouldBe)
{
  const HaspRun run = RunHasp({ "report", "haptics", "--quick", "--json", this->Path("h.json"),
    "--html", this->Path("h.html") });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const auto report = Json::parse(ReadBytes(this->Path("h.json")));
  const auto atLeast = [&](const std::string& id, double least)
  {
    const Json row = Row(report, "haptics." + id);
    if (row.contains("absent"))
    {
      EXPECT_NE(row.at("absent").get<std::string>().find(" has no "), std::string::npos) << row;
      return;
    }
    EXPECT_GE(row.at("value").get<double>(), least) << id;
  };
  const auto atMost = [&](const std::string& id, double most)
  {
    const Json row = Row(report, "haptics." + id);
    if (row.contains("absent"))
      return;
    EXPECT_LE(row.at("value").get<double>(), most) << id;
  };
  for (const std::string size : { "", "@256" })
    for (const std::string rival : { "", ".native" })
    {
      atLeast("simd.static.avx2" + rival + size, 1.65);
      atLeast("simd.static.avx512" + rival + size, 2.1);
      atLeast("simd.matrix.avx2" + rival + size, 2.0);
      atLeast("simd.matrix.avx512" + rival + size, 2.5);
    }
  atLeast("levels", 0.5);
  atMost("wrench", 1e-5);
  atMost("wrench.int16", 1e-4);
  atMost("dynamic.error", 0.5);
  atMost("error.falls@press", 1.0);
  atMost("error.falls@fit", 1.0);
  atMost("snap.ripple", 0.02);
  atLeast("coarse.separated", 5.0);
  atLeast("coarse.touching", 0.75);
  for (const char* id : { "simd.dynamic", "points", "points@20000", "snap.ms", "snap.ms@50000",
         "loop.p50", "loop.p99", "loop.p999", "loop.missed" })
    EXPECT_TRUE(Row(report, std::string("haptics.") + id).contains("value")) << id;
  for (const char* id : { "simd.static.avx2", "simd.matrix.avx512", "simd.dynamic", "points",
         "levels", "wrench", "wrench.int16", "dynamic.error", "snap.ms", "snap.ripple",
         "coarse.separated", "coarse.touching" })
  {
    const Json row = Row(report, std::string("haptics.") + id);
    EXPECT_TRUE(row.contains("absent") || row.contains("bar_missed")) << id;
  }
  std::set<std::string> curves;
  for (const Json& curve : report.at("curves"))
    curves.insert(curve.at("id"));
  for (const char* id : { "error.levels@press", "error.levels@fit", "error.budgets@press",
         "error.budgets@fit", "loop.lateness" })
    EXPECT_TRUE(curves.contains(std::string("haptics.") + id)) << id;
  ASSERT_GE(report.at("unused").size(), 2U);
  for (const auto& resource : report.at("unused"))
    EXPECT_EQ(resource.at("bytes"), 0) << resource;
  EXPECT_NE(ReadBytes(this->Path("h.html")).find("<svg"), std::string::npos);
}

} // namespace
