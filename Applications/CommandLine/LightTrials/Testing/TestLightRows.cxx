// The trials as the report runs them, on a ball: their rows hold, and say what they are.
#include "LightScenes.h"
#include "LightTrials.h"
#include "Testing/FilledReport.h"

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

namespace
{

using namespace hasp;

using hasp::testing::Row;

constexpr double Radius = 25.0;

Report Filled(const std::function<void(ReportContext&)>& fill)
{
  return hasp::testing::Filled("light", fill);
}

/// 64 x 32 quads about the axis.
TriangleMesh Ball()
{
  TriangleMesh mesh;
  for (int row = 0; row <= 32; ++row)
    for (int column = 0; column < 64; ++column)
    {
      const double down = glm::pi<double>() * row / 32, turn = glm::two_pi<double>() * column / 64;
      mesh.points.push_back(Radius * glm::dvec3(std::sin(down) * std::cos(turn),
                                       std::sin(down) * std::sin(turn), std::cos(down)));
    }
  for (std::uint32_t row = 0; row < 32; ++row)
    for (std::uint32_t column = 0; column < 64; ++column)
    {
      const std::uint32_t a = 64 * row + column, b = 64 * row + (column + 1) % 64;
      mesh.triangles.push_back({ a, a + 64, b });
      mesh.triangles.push_back({ b, a + 64, b + 64 });
    }
  return mesh;
}

LightData BallData()
{
  return { "", "a ball", CellsOf(AnalyticSphere({ 0, 0, 0 }, Radius), 32, 30.0), Ball(), 2.0 };
}

/// Light/TriangleTracer.h in the place of who is better.
RayRival SlowRival(const LightData& data)
{
  const auto tracer = std::make_shared<const TriangleTracer>(LitMesh{ data.mesh, {}, {} });
  const auto trace = [tracer](std::span<const WorldRay> rays, std::span<float> t)
  {
    for (std::size_t n = 0; n < rays.size(); ++n)
    {
      const auto hit = tracer->Trace(rays[n].origin, rays[n].direction, 0.0);
      t[n] = hit ? static_cast<float>(hit->t) : std::numeric_limits<float>::infinity();
    }
  };
  return { "Light/TriangleTracer.h, one core", trace, trace };
}

/// Rows with an error, a time and a rival, of at most twice what their bar says: that a bar is
/// missed is for the report to say.
void ExpectNearTheirBars(const Report& report, const std::set<std::string>& expected)
{
  std::set<std::string> ids;
  for (const ReportRow& row : report.rows)
  {
    ids.insert(row.id);
    ASSERT_EQ(row.bars.size(), 1U) << row.id;
    EXPECT_LE(*row.value, 2.0 * *row.bars[0].most) << row.id;
    EXPECT_TRUE(row.timeS && row.error && !row.rival.empty()) << row.id;
  }
  EXPECT_EQ(ids, expected);
}

TEST(LightRows, FurnacesAreOneAndTheWorstIsTold)
{
  const Report report = Filled(
    [](ReportContext& context)
    {
      MeasureFurnace(context, 512);
      AddWorstLight(context, "light.furnace");
    });
  ExpectNearTheirBars(report, { "light.furnace", "light.furnace.diffuse", "light.furnace.coat",
                                "light.furnace.metal", "light.furnace.concave" });
  double worst = 0.0;
  for (const char* kind : { "diffuse", "coat", "metal", "concave" })
    worst = std::max(worst, *Row(report, std::string("light.furnace.") + kind).value);
  EXPECT_EQ(*Row(report, "light.furnace").value, worst);
}

TEST(LightRows, SphereAndReciprocityHold)
{
  const Report report = Filled(
    [](ReportContext& context)
    {
      MeasureSphere(context);
      MeasureReciprocity(context);
    });
  ExpectNearTheirBars(report, { "light.sphere", "light.sphere.sky", "light.reciprocity" });
}

TEST(LightRows, ExtremesStayNearTheirBars)
{
  const Report report = Filled(
    [](ReportContext& context)
    {
      MeasureLightExtremes(context);
      MeasureLightScales(context);
      AddUnusedLight(context);
    });
  ExpectNearTheirBars(
    report, { "light.extreme.pixel", "light.extreme.pixel.mean", "light.extreme.black",
              "light.extreme.inside", "light.extreme.small", "light.extreme.large",
              "light.extreme.spacing" });
  EXPECT_GT(*Row(report, "light.extreme.pixel").value, 0.0); // the pixel is met
  EXPECT_EQ(report.unused.size(), 5U);
}

TEST(LightRows, ABallHasNoIncrements)
{
  const LightData data = BallData();
  const Report report = Filled([&](ReportContext& context) { MeasureEnergy(context, data); });
  // Convex: all light comes at once, and is the albedo's share.
  EXPECT_NEAR(*Row(report, "light.energy").value, 1.0, 1e-6);
}

TEST(LightRows, EvenPointsSayTimeAndError)
{
  LightData data = BallData(); // but for a ball openness has no noise
  data.cells = CellsOf(AnalyticGyroid(24.0), 32, 24.0);
  const Report report = Filled([&](ReportContext& context) { MeasureSobol(context, data, 24); });
  for (const char* id : { "light.sobol.ao", "light.sobol.bounce1", "light.sobol.bounce3" })
  {
    const ReportRow& row = Row(report, id);
    EXPECT_EQ(row.n, 9) << id;
    EXPECT_GT(*row.error, 0.0) << id;
    // Beyond the square root of random points; so there are fewer for the same error.
    EXPECT_LT(*Row(report, id + std::string(".slope")).value, -0.55) << id;
    EXPECT_LT(*row.value, 1.0) << id;
  }
  EXPECT_EQ(report.curves.size(), 6U);
}

TEST(LightRows, RaysMeetTheSameSurface)
{
  const LightData data = BallData();
  const Report report = Filled(
    [&](ReportContext& context)
    {
      MeasureRays(context, data, SlowRival(data));
      AddWorstLight(context, "light.rays");
    });
  for (const char* id : { "light.rays.ao", "light.rays.bounces" })
    EXPECT_LT(*Row(report, id).error, 0.01) << id; // convex: what leaves meets nothing
  EXPECT_LT(*Row(report, "light.rays.paths").error, 0.01);
  EXPECT_GT(*Row(report, "light.rays.rate").value, 0.0);
  EXPECT_LE(*Row(report, "light.rays").value, *Row(report, "light.rays.ao").value);
}

TEST(LightRows, KeptLightIsHeldAgainstPathsOfTheSameError)
{
  const LightData data = BallData();
  const Report report = Filled(
    [&](ReportContext& context) {
      MeasureHybrid(context, data, { 32, 64, 16 });
    });
  double before = std::numeric_limits<double>::infinity();
  for (const char* id : { "light.hybrid.still.1", "light.hybrid.still.4", "light.hybrid.still" })
  {
    const ReportRow& row = Row(report, id);
    EXPECT_EQ(row.n, 9) << id;
    EXPECT_LT(*row.error, before) << id; // a view that stays becomes better
    before = *row.error;
  }
  EXPECT_EQ(Row(report, "light.hybrid.moving").bars.size(), 1U);
  EXPECT_EQ(report.curves.size(), 3U);
}

} // namespace
