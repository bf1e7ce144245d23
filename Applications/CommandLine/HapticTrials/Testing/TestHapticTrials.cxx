#include "DynamicRival.h"
#include "LoopTrial.h"
#include "ReportRegistry.h"
#include "SimdScene.h"
#include "StabilityTrial.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace
{

using namespace hasp;

// Float positions in a volume of 64^3: 1e-5 of a voxel, of depths of 0.3.
constexpr double FloatError = 1e-4;

TEST(HapticTrials, RivalsFeelWhatTheKernelsFeel)
{
  const SimdScene scene(64, 4096);
  for (const ContactTerms terms : { ContactTerms::Force, ContactTerms::Matrix })
  {
    const ContactSums truth = scene.Truth(terms);
    EXPECT_NEAR(truth.contacts, 0.5 * scene.Points(), 0.02 * scene.Points()); // half in contact
    for (const bool native : { false, true })
    {
      const ContactSums rival = scene.Rival(terms, native);
      EXPECT_LT(WrenchError(rival.contact, truth.contact, scene.Radius()), FloatError);
      EXPECT_NEAR(rival.contacts, truth.contacts, 2.0);     // at the very surface
      for (std::size_t n = 0; n < rival.matrix.size(); ++n) // of Force both are 0
        EXPECT_NEAR(rival.matrix[n], truth.matrix[n], FloatError * truth.matrix[20]) << n;
    }
    for (const ContactKernels& kernels : AllContactKernels())
      EXPECT_LT(
        WrenchError(scene.Ours(kernels, terms).contact, truth.contact, scene.Radius()), FloatError)
        << kernels.name;
  }
}

TEST(HapticTrials, AMovingRivalDrawsOnTheSurfaceWhereItTouches)
{
  const TrialBody body(64, BumpyShape(64));
  const rival::Map map{ body.View().data, glm::ivec3(64), glm::vec3(body.View().geometry.origin),
    1.0F };
  rival::o2::DynamicShell shell(map, map, 1500);
  const float apart = 2.0F * static_cast<float>(body.Radius()) - 1.0F;
  for (int tick = 0; tick < 20; ++tick)
    shell.Update({ glm::mat3(1.0F), { apart, 0.0F, 0.0F } }, 100, 4.0F);
  EXPECT_EQ(shell.Points().size(), 1500U); // of 2000: the ring is full
  for (const rival::Point& point : shell.Points())
  {
    const DistanceMap::Sample here = body.Map()->At(glm::dvec3(point.position));
    EXPECT_LT(std::abs(here.mm), 0.02);
    EXPECT_GT(glm::dot(glm::normalize(here.gradient), glm::dvec3(point.normal)), 0.99);
    EXPECT_LT(point.position.x, 0.0F); // on the side that faces the other body
  }
}

TEST(HapticTrials, ErrorsAreSharesOfTheForce)
{
  const Wrench truth{ { 0.0, 3.0, 4.0 }, { 10.0, 0.0, 0.0 } };
  EXPECT_EQ(WrenchError(truth, truth, 10.0), 0.0);
  EXPECT_DOUBLE_EQ(WrenchError({ { 0.5, 3.0, 4.0 }, truth.torque }, truth, 10.0), 0.1);
  EXPECT_DOUBLE_EQ(WrenchError({ truth.force, { 0.0, 0.0, 0.0 } }, truth, 10.0), 0.2);
  const double nan = std::nan("");
  EXPECT_TRUE(std::isnan(WrenchError({ truth.force, { nan, 0.0, 0.0 } }, truth, 10.0)));
  EXPECT_TRUE(std::isnan(WrenchError({ { nan, 0.0, 0.0 }, truth.torque }, truth, 10.0)));
  EXPECT_TRUE(std::isnan(WorseOf(0.1, nan)) && std::isnan(WorseOf(nan, 0.1)));
  EXPECT_EQ(WorseOf(0.1, 0.2), 0.2);
}

TEST(HapticTrials, SizesOfPosesAndIdsAreTold)
{
  for (const RigidPose& pose : FitPoses(60, 3))
  {
    EXPECT_GE(glm::length(pose.position), 0.3);
    EXPECT_LE(glm::length(pose.position), 1.0);
  }
  for (const RigidPose& pose : PressPoses(60, 38.0, 3))
    EXPECT_NEAR(glm::length(pose.position), 75.4, 0.4 + 1e-9);
  EXPECT_EQ(IdAt("haptics.points", 128, 128), "haptics.points");
  EXPECT_EQ(IdAt("haptics.points", 256, 128), "haptics.points@256");
  EXPECT_EQ(FindKernels("no such set"), nullptr);
  EXPECT_STREQ(FindKernels("scalar")->name, "scalar");
}

TEST(HapticTrials, LoopsOfSeveralTurnsAddUp)
{
  NanosecondHistogram early, late;
  for (int n = 0; n < 3; ++n)
    early.Add(10'000);
  late.Add(1'000'000);
  LoopFigures sum;
  sum.Add({ early.Read(), 3, 0, "" });
  sum.Add({ late.Read(), 1, 2, "no priority" });
  EXPECT_EQ(sum.lateness.total, 4U);
  EXPECT_EQ(sum.lateness.leastNs, 10'000);
  EXPECT_EQ(sum.lateness.mostNs, 1'000'000);
  EXPECT_EQ(sum.lateness.Above(100'000), 1U);
  EXPECT_NEAR(sum.lateness.MeanNs(), 257'500.0, 1.0);
  EXPECT_EQ(sum.ticks, 4U);
  EXPECT_EQ(sum.missed, 2U);
  EXPECT_EQ(sum.shortfalls, "no priority");
}

/// The whole table is tried by TestStudies.
TEST(HapticTrials, QuickStabilityTriesOneOfEachFamilyAndOutcome)
{
  Report report;
  report.name = "stability";
  ReportContext context{ report, {}, [](double, const std::string&) {} };
  context.settings.quick = true;
  TryStability(context);
  std::set<std::string> ids;
  int oscillating = 0, stable = 0;
  for (const ReportCase& row : report.stability)
  {
    EXPECT_TRUE(row.pass) << row.id << ' ' << row.testCase;
    EXPECT_TRUE(ids.insert(row.id).second) << row.id;
    EXPECT_TRUE(row.id.starts_with("haptics."));
    EXPECT_FALSE(row.unit.empty()) << row.id;
    oscillating += row.testCase.find("predicted oscillates") != std::string::npos;
    stable += row.testCase.find("predicted stable") != std::string::npos;
  }
  EXPECT_GE(oscillating, 3);
  EXPECT_GE(stable, 8);
  for (const char* id : { "finite", "limit", "slew" })
    for (const char* of : { "@coupling", "@step" })
      EXPECT_TRUE(ids.contains(std::string("haptics.soak.") + id + of)) << id << of;
  EXPECT_TRUE(ReportFaults(report).empty());
}

} // namespace
