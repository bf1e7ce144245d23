// The trials as the report runs them, at sizes of seconds: their rows hold, and say what they are.
#include "ReductionTrials.h"
#include "Studies/Testing/BlockCase.h"
#include "Testing/FilledReport.h"
#include "TrialRows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace
{

using namespace hasp;

using hasp::testing::Row;

Report Filled(const std::function<void(ReportContext&)>& fill)
{
  return hasp::testing::Filled("reduction", fill);
}

/// A tetrahedron of 10 mm.
std::shared_ptr<const MeasuredSurface> Corner()
{
  TriangleMesh mesh;
  mesh.points = { { 0, 0, 0 }, { 10, 0, 0 }, { 0, 10, 0 }, { 0, 0, 10 } };
  mesh.triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } };
  return std::make_shared<const MeasuredSurface>(mesh, 1000);
}

TEST(ReductionRows, PrecisionAndAccuracyAreTheTablesOwn)
{
  const std::vector<TrialCase> cases{ { "one", { { "piece", Corner() } },
    FragmentPoses{ { "piece", {} } } } };
  const auto trial = [](const char* who, int number, const glm::dvec3& shift) {
    return Trial{ "one", who, number, { { "piece", { shift } } } };
  };
  const std::vector<Trial> trials{ trial("a", 1, { 0, 0, 0 }), trial("a", 2, { 0.3, 0, 0 }),
    trial("b", 1, { 0, 0.4, 0 }), trial("b", 2, { 0, 0.4, 0 }) };
  const TrialTable table = MakeTrialTable(cases, trials);
  const Report report =
    Filled([&](ReportContext& context) { AddTrialRows(context, table, "by hand"); });
  // Of a shift the mean way of places is the shift: 0.3 and 0; 0.4, 0.4, 0.5, 0.5; 0, 0.3, 0.4,
  // 0.4.
  EXPECT_NEAR(*Row(report, "reduction.precision.intra.tre").value, 0.15, 1e-12);
  EXPECT_NEAR(*Row(report, "reduction.precision.inter.tre").value, 0.45, 1e-12);
  EXPECT_NEAR(*Row(report, "reduction.accuracy.tre").value, 0.275, 1e-12);
  EXPECT_EQ(Row(report, "reduction.precision.intra").n, 2);
  EXPECT_EQ(Row(report, "reduction.precision.inter").n, 4);
  EXPECT_EQ(Row(report, "reduction.accuracy").n, 4);
  EXPECT_EQ(*Row(report, "reduction.precision.inter").value,
    table.overall.interOperator.mean[std::size_t(TrialMeasure::SurfaceMeanMm)]);
  EXPECT_EQ(
    *Row(report, "reduction.accuracy@case1").value, *Row(report, "reduction.accuracy").value);
  EXPECT_EQ(*Row(report, "reduction.accuracy.rotation").value, 0.0);
  EXPECT_NE(
    Row(report, "reduction.accuracy@case1").data.find("mean way of places"), std::string::npos);
  for (const ReportRow& row : report.rows)
    EXPECT_TRUE(row.bars.empty()) << row.id; // printed, and no more
}

TEST(ReductionRows, WithoutATruthThereIsNoAccuracy)
{
  const std::vector<TrialCase> cases{ { "one", { { "piece", Corner() } } } };
  const std::vector<Trial> trials{ { "one", "a", 1, { { "piece", {} } } },
    { "one", "a", 2, { { "piece", {} } } } };
  const Report report = Filled([&](ReportContext& context)
    { AddTrialRows(context, MakeTrialTable(cases, trials), "by hand"); });
  EXPECT_EQ(report.rows.size(), 6U);
  for (const ReportRow& row : report.rows)
    EXPECT_TRUE(row.id.starts_with("reduction.precision.intra")) << row.id;
}

TEST(ReductionRows, SimulatedOperatorsFillTheTable)
{
  const Report report =
    Filled([&](ReportContext& context) { TryPrecision(context, { BlockCase() }); });
  const ReportRow& accuracy = Row(report, "reduction.accuracy");
  EXPECT_EQ(accuracy.n, 6); // three operators, twice, one piece
  EXPECT_EQ(Row(report, "reduction.precision.intra").n, 3);
  EXPECT_EQ(Row(report, "reduction.precision.inter").n, 12);
  EXPECT_LT(*accuracy.value, 1.0);                                     // pieces begin 12 mm away
  EXPECT_GT(*Row(report, "reduction.precision.inter.tre").value, 0.0); // they are not the same
  EXPECT_NE(accuracy.data.find("6 trials of 6 pieces"), std::string::npos) << accuracy.data;
  EXPECT_NE(accuracy.data.find("; 0 ticks beyond limits"), std::string::npos) << accuracy.data;
}

TEST(ReductionRows, ExtremeCasesComeOutAsPredicted)
{
  const Report report = Filled(TryReductionExtremes);
  std::set<std::string> ids;
  for (const ReportCase& row : report.stability)
  {
    EXPECT_TRUE(row.pass) << row.id << ' ' << row.testCase << ": " << row.figure;
    EXPECT_TRUE(ids.insert(row.id).second) << row.id;
    EXPECT_FALSE(row.unit.empty()) << row.id;
  }
  EXPECT_GE(ids.size(), 8U);
}

} // namespace
