#include "Studies/BenchBodies.h"
#include "Studies/BenchRenderers.h"
#include "Studies/SampledLoop.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <ostream>

namespace
{

/// A device that hides nothing: no dry friction, an encoder of 0.1 um, motors without a limit.
hasp::BenchDevice Bare(hasp::BenchDevice device)
{
  device.coulombN = 0.0;
  device.quantumMm = 1e-4;
  device.forceLimitN = 1e9;
  return device;
}

hasp::BenchScene Press(
  const hasp::BenchDevice& device, const hasp::BenchHand& hand, int delay, double depthMm)
{
  hasp::BenchScene scene;
  scene.device = device;
  scene.hand = hand;
  scene.clock.delayTicks = delay;
  scene.start.position.z = 5.0;
  const double way = 5.0 + depthMm;
  scene.strokes = { { 0.0, way / 20.0, { 0, 0, -way }, {}, false } }; // at 20 mm/s
  return scene;
}

double Bisect(double low, double high, const std::function<bool(double)>& stays)
{
  for (int i = 0; i < 7; ++i) // to 1 % of an interval that is a factor of 4
  {
    const double middle = std::sqrt(low * high);
    (stays(middle) ? low : high) = middle;
  }
  return low;
}

const hasp::WallBody Wall;

hasp::BenchFigures RunPenalty(const hasp::BenchScene& scene, double stiffness)
{
  hasp::PenaltyRenderer renderer({ hasp::TipPoints(), stiffness, Wall });
  return RunBench(scene, renderer);
}

hasp::BenchFigures RunQuasiStatic(const hasp::BenchScene& scene, double coupling)
{
  hasp::VirtualCouplingSettings settings;
  settings.spring = { coupling, 900 * coupling, 1e6, 1e6 };
  hasp::QuasiStaticRenderer renderer(hasp::VirtualCoupling(settings),
    { hasp::TipPoints(), 100.0, Wall }, scene.device, scene.clock.tickS);
  return RunBench(scene, renderer);
}

struct Measured // N/mm: formula, direct penalty, quasi-static with contact of 100 N/mm
{
  const char* name;
  hasp::BenchDevice device;
  hasp::BenchHand hand;
  double penalty[3], quasiStatic[3];
};

void PrintTo(const Measured& row, std::ostream* out)
{
  *out << row.name;
}

class HapticBenchTable : public testing::TestWithParam<Measured>
{
};

// What a one-axis trial measured: pressed to 2 mm, unstable from 60 um of spread on. Where a light
// press bounces in small (no delay) that is above the limit of the linear loop. Two programs, the
// same physics: 15 % for the shape of the approach.
TEST_P(HapticBenchTable, CriticalStiffnessIsTheMeasuredOne)
{
  const Measured& row = this->GetParam();
  const hasp::BenchDevice device = Bare(row.device);
  for (int delay = 0; delay < 3; ++delay)
  {
    const hasp::BenchScene scene = Press(device, row.hand, delay, 2.0);
    const double formula = hasp::SampledLoop(device, row.hand, scene.clock).FormulaSpring();
    const double penalty = Bisect(0.5 * formula, 2.0 * formula,
      [&](double k) { return RunPenalty(scene, k).spreadMm < 0.060; });
    const double coupling = Bisect(0.5 * formula, 2.0 * formula,
      [&](double k) { return RunQuasiStatic(scene, k).spreadMm < 0.060; });
    std::printf("%-18s delay %d: formula %6.2f  penalty %6.2f (%5.2f)  "
                "quasi-static %6.2f (%5.2f) N/mm\n",
      row.name, delay, formula, penalty, row.penalty[delay], coupling, row.quasiStatic[delay]);
    EXPECT_NEAR(penalty / row.penalty[delay], 1.0, 0.15);
    EXPECT_NEAR(coupling / row.quasiStatic[delay], 1.0, 0.15);
  }
}

// Pressed so that it does not bounce, the ripple grows from the very stiffness on, within 3 %, that
// the transition of a tick says; and a quasi-static coupling is a spring in series with its
// contact.
TEST_P(HapticBenchTable, RippleGrowsFromTheExactLimitOn)
{
  const Measured& row = this->GetParam();
  const hasp::BenchDevice device = Bare(row.device);
  for (int delay = 0; delay < 3; ++delay)
  {
    const hasp::BenchScene scene = Press(device, row.hand, delay, 20.0);
    const double exact = hasp::SampledLoop(device, row.hand, scene.clock).CriticalSpring();
    for (const double share : { 0.97, 1.03 })
    {
      const double k = share * exact;
      EXPECT_EQ(RunPenalty(scene, k).growth < 1.0, share < 1.0) << share << " of " << exact;
      // k = coupling * 100 / (coupling + 100)
      EXPECT_EQ(RunQuasiStatic(scene, k * 100.0 / (100.0 - k)).growth < 1.0, share < 1.0)
        << share << " of " << exact << " in series";
    }
  }
}

// Pressed far beyond any limit: what leaves is the device's, with a ramp and without.
TEST(CoupledRenderer, LimitsAreThoseOfItsDevice)
{
  for (const hasp::BenchDevice& device :
    { hasp::TouchLike(), hasp::FalconLike(), hasp::PremiumLike() })
    for (const double rampInS : { -1.0, 0.0, 0.1 })
    {
      hasp::VirtualCouplingSettings settings;
      settings.spring = { 1.0, 900.0, 1e3, 1e5 };
      hasp::QuasiStaticRenderer renderer(
        hasp::VirtualCoupling(settings), { hasp::TipPoints(), 100.0, Wall }, device, 0.001);
      if (rampInS >= 0.0)
        renderer.RampIn(rampInS);
      renderer.Place({});
      hasp::RigidPose pressed;
      pressed.position.z = -50.0;
      hasp::Wrench out;
      for (int tick = 0; tick < 500; ++tick)
        out = renderer.Tick(pressed, 0.001 * tick);
      EXPECT_NEAR(out.force.z, device.forceLimitN, 1e-9) << device.name << " " << rampInS;
    }
}

INSTANTIATE_TEST_SUITE_P(Facts, HapticBenchTable,
  testing::Values(Measured{ "Falcon-like, loose", hasp::FalconLike(), hasp::LooseHand(),
                    { 5.68, 1.24, 0.72 }, { 5.80, 1.25, 0.72 } },
    Measured{ "Falcon-like, firm", hasp::FalconLike(), hasp::FirmHand(), { 15.6, 4.62, 2.82 },
      { 17.6, 4.84, 2.90 } },
    Measured{ "Touch-like, loose", hasp::TouchLike(), hasp::LooseHand(), { 2.78, 0.83, 0.48 },
      { 2.78, 0.84, 0.48 } },
    Measured{ "Touch-like, firm", hasp::TouchLike(), hasp::FirmHand(), { 13.4, 4.21, 2.53 },
      { 15.1, 4.40, 2.59 } }));

} // namespace
