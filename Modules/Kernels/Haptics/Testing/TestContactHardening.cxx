// Closed forms of contact that hardens with depth, held by the reference and by every kernel that
// this processor runs; and what the step makes of it: fine tools do not sink in.
#include "Haptics/ContactForce.h"
#include "StepScenes.h"
#include "Testing/ContactReaders.h"
#include "Testing/WallAndPatch.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace hasp;
using namespace hasp::testing;

constexpr double C = 40.0, Hard = 0.35;

double Pressure(double deep) // per k
{
  const double u = std::min(deep, Hard) / Hard;
  return std::min(deep, Hard) * (1.0 + C * std::pow(u, 4)) +
         std::max(0.0, deep - Hard) * (1.0 + 5.0 * C);
}
double Slope(double deep)
{
  return 1.0 + 5.0 * C * std::pow(std::min(deep, Hard) / Hard, 4);
}
/// Simpson's rule of 1000 pieces: what the formula of the kernels is held against.
double Energy(double deep)
{
  double sum = 0.0;
  for (int n = 0; n < 1000; ++n)
  {
    const double from = deep * n / 1000.0, to = deep * (n + 1) / 1000.0;
    sum += (Pressure(from) + 4.0 * Pressure(0.5 * (from + to)) + Pressure(to)) * (to - from) / 6.0;
  }
  return sum;
}

TEST(ContactHardening, PressureSlopeAndEnergyOfAPatch)
{
  Scene scene(SkewGrid({ 50, 32, 22 }), 8.0, WallMm);
  ShellOfPoints patch = Patch();
  const double area = 0.225, k = 0.2, total = area * static_cast<double>(patch.Count());
  const ContactSettings settings{ .stiffness = static_cast<float>(k),
    .hardening = static_cast<float>(C),
    .hardMm = static_cast<float>(Hard) };
  for (const bool own : { false, true })
  {
    const std::vector<float> areas(own ? patch.Count() : 0, static_cast<float>(area));
    const ContactPoints points = patch.Get(own ? 0.0F : static_cast<float>(area), areas);
    for (const double deep : { 0.05, 0.2, 0.34, 0.36, 0.5, 2.0 })
    {
      const RigidPose pose = PatchAt(-deep);
      const glm::dvec3 force = k * total * Pressure(deep) * WallNormal;
      const glm::dvec3 torque = glm::cross(pose.Turn({ 1.0, 0.0, 2.0 }), force);
      for (const Reader& reader : scene.Readers)
        for (const ContactTerms terms : AllTerms)
        {
          const ContactSums sums = reader.feel(terms, points, pose, settings);
          // A depth that is off by the reader's share of half a millimetre, times the slope.
          const double off = reader.tolerance * 0.5 * Slope(deep) + 1e-6 * Pressure(deep);
          const double within = k * total * off;
          ExpectNear(sums.contact.force, force, within, reader.name);
          ExpectNear(sums.contact.torque, torque, 4.0 * within, reader.name);
          EXPECT_NEAR(
            sums.energy, k * total * Energy(deep), k * total * (off * deep + 1e-6 * Energy(deep)))
            << reader.name << deep;
          if (terms != ContactTerms::Force)
          {
            const double stiff = sums.matrix[0] + sums.matrix[6] + sums.matrix[11];
            EXPECT_NEAR(stiff, k * total * Slope(deep), 5.0 * reader.tolerance * stiff)
              << reader.name << deep;
          }
        }
    }
  }
}

/// A foot of a given area on the ground, dragged far below it.
hasp::HapticTick Pressed(double areaMm2, const HapticStepSettings& settings)
{
  std::vector<SurfacePoint> points;
  const float side = std::sqrt(static_cast<float>(areaMm2));
  for (int n = 0; n < 64; ++n)
    points.push_back(
      { { side * ((n % 8 + 0.5F) / 8 - 0.5F), side * ((n / 8 + 0.5F) / 8 - 0.5F), 0.0F },
        { 0, 0, -1 } });
  auto scene = std::make_unique<HapticScene>(
    std::vector<HapticShell>{ { PointShell::OfPoints(points, areaMm2, glm::dvec3(0.0)), {} } },
    std::vector<HapticBody>{ { Ground(), {} } });
  HapticStep step = Ready(settings, std::move(scene));
  for (int n = 0; n < 400; ++n)
    step.Tick(At(0, 0, 5.0 - 0.1 * n)); // to 35 mm below
  return Ticks(step, At(0, 0, -35), 100);
}

// The law without it: F_sat < depth sum k, which a fine tool breaks.
TEST(ContactHardening, FineToolsAreHeldWithinHalfAVoxelAtTheForceLimit)
{
  HapticStepSettings settings = Settings();
  settings.contact.stiffness = ContactSettings().stiffness;
  const double half = 0.35; // of the smallest spacing, 0.7 mm
  const double limit = settings.coupling.spring.forceLimit;
  for (const double area : { 1.0, 3.0, 30.0, 400.0 })
  {
    const HapticTick tick = Pressed(area, settings);
    EXPECT_NEAR(tick.onDevice.force.z, limit, 0.01 * limit) << "it is the limit that is felt";
    EXPECT_LT(-tick.sums.deepestMm, half) << area;
    EXPECT_GT(-tick.sums.deepestMm, 0.0) << area;
    EXPECT_EQ(tick.status, 0U) << area;
  }
  settings.leastContactMm2 = 0.0; // 4 N / 0.05 N/mm: beyond what the map knows
  EXPECT_LT(Pressed(1.0, settings).tool.position.z, -10.0) << "what it is for";
}

// A force that depends on the pose alone gives back what it took: in, about on a corner, which is a
// small contact, and out as a foot that stands flat.
TEST(ContactHardening, PumpsNoEnergyBetweenSmallAndLargeContacts)
{
  HapticStepSettings settings = Settings();
  settings.contact.stiffness = ContactSettings().stiffness;
  HapticStep step = Ready(settings, GroundScene());
  hasp::PassivityObserver observer;
  const auto drive = [&](const RigidPose& from, const RigidPose& to)
  {
    for (int n = 1; n <= 4000; ++n)
    {
      const double share = n / 4000.0;
      const glm::dvec3 turn =
        RotationVector(from.orientation) * (1.0 - share) + RotationVector(to.orientation) * share;
      const RigidPose device{ glm::mix(from.position, to.position, share), TurnBy(turn) };
      observer.Tick(device, step.Tick(device).onDevice);
    }
  };
  const RigidPose above = At(0, 0, 15);
  const RigidPose tilted{ { 0, 0, 4 }, TurnBy({ 0.5, 0.4, 0 }) }, flat = At(0, 0, -8);
  drive(At(0, 0, 5), above);
  for (int round = 0; round < 2; ++round)
  {
    drive(above, tilted);
    drive(tilted, flat);
    drive(flat, above);
  }
  // A wrench held for a tick: K v^2 T / 2 of each second, 0.33 (20 mm / 4 s)^2, 0.004 mJ a way.
  EXPECT_GT(observer.Lowest(), -0.1);
  EXPECT_NEAR(observer.Energy(), 0.0, 0.1);
}

} // namespace
