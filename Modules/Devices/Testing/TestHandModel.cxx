#include "Devices/HandModel.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace
{

using namespace hasp;

constexpr std::int64_t Ms = 1'000'000;

HandBody Frictionless(double massKg = 0.12)
{
  return { .massKg = massKg, .viscousNsPerMm = 0.0, .turnViscousNmmSPerRad = 0.0 };
}

TEST(HandModel, WhatIsNoBodyIsRefused)
{
  const double nan = std::nan("");
  const auto refused = [](const HandBody& body, const HandGrip& grip = {})
  { EXPECT_THROW(HandModel(body, grip, HandIntention()), std::invalid_argument); };
  refused({ .massKg = 0.0 });
  refused({ .massKg = nan });
  refused({ .inertiaKgMm2 = { 100, 100, -1 } });
  refused({ .inertiaKgMm2 = { 100, 100, 201 } });
  refused({ .viscousNsPerMm = -1 });
  refused({ .coulombN = nan });
  refused({}, { .springNPerMm = -0.1 });
  refused({}, { .damperNsPerMm = nan });
  refused({ .massKg = 1e-4 }, { .springNPerMm = 1e5 }); // too fast for 20 us
  HandModel model({}, LooseGrip(), HandIntention());
  EXPECT_THROW(model.SetGrip({ .springNPerMm = 1e6 }), std::invalid_argument);
  EXPECT_NO_THROW(model.SetGrip(NoGrip())) << "and the grip before is still there";
}

TEST(HandModel, RestsWhereTheHandIs)
{
  HandModel model({}, FirmGrip(), HandIntention({ { 3, 4, 5 }, TurnBy({ 0.1, 0.2, 0.3 }) }));
  model.Advance(500 * Ms, {});
  EXPECT_EQ(model.Pose().position, glm::dvec3(3, 4, 5));
  EXPECT_LT(glm::length(model.TurnRadPerS()), 1e-12);
  model.Advance(0, { { 1, 1, 1 } }); // a time that has passed
  EXPECT_EQ(model.TimeNs(), 500 * Ms);
}

TEST(HandModel, AForceThatIsNoneDoesNothing)
{
  HandModel model({}, NoGrip(), HandIntention());
  model.Advance(Ms, { { std::nan(""), 1, 1 } });
  model.Advance(2 * Ms, { {}, { 0, std::numeric_limits<double>::infinity(), 0 } });
  EXPECT_EQ(model.Pose().position, glm::dvec3(0.0));
  EXPECT_EQ(model.AppliedWork(), 0.0);
}

/// x(t) after a force is put on a mass with spring and damper: the textbook's, for each kind of
/// damping, by complex roots.
double StepResponse(double mass, double k, double b, double force, double t)
{
  // s^2 + (b/m) s + k/m, in 1/s; N/mm over kg is 1000 / s^2.
  const std::complex<double> half = 500.0 * b / mass,
                             root = std::sqrt(half * half - 1000.0 * k / mass);
  const auto s1 = -half + root, s2 = -half - root;
  return (force / k * (1.0 + (s2 * std::exp(s1 * t) - s1 * std::exp(s2 * t)) / (s1 - s2))).real();
}

TEST(HandModel, AStepOfForceIsAnsweredAsTheTextbookSays)
{
  for (const HandGrip grip :
    { LooseGrip(), FirmGrip(), HandGrip{ .springNPerMm = 0.1, .damperNsPerMm = 0.05 } })
    for (const double mass : { 0.045, 0.15 })
    {
      HandModel model({ .massKg = mass, .viscousNsPerMm = 0.0003 }, grip, HandIntention());
      const double b = grip.damperNsPerMm + 0.0003;
      const glm::dvec3 force(2.0, 0.0, -1.0);
      double worst = 0.0;
      for (int ms = 1; ms <= 300; ++ms)
      {
        model.Advance(ms * Ms, { force });
        const double x = StepResponse(mass, grip.springNPerMm, b, 1.0, 1e-3 * ms);
        worst = std::max(worst, glm::length(model.Pose().position - x * force));
      }
      // The midpoint rule's error, (w h)^2 / 6 of the way for each radian turned, is below 1e-5 of
      // F / k <= 22 mm here: w <= 150/s, h = 20 us, 45 rad.
      EXPECT_LT(worst, 22.0 * 1e-5 * 7) << grip.springNPerMm << " " << mass;
      EXPECT_LT(worst, 1e-3 * glm::length(force) / grip.springNPerMm);
    }
}

TEST(HandModel, HalfTheStepWouldBeAQuarterOfTheError)
{
  // Steps end where Advance ends: asking every 10 us halves them. The order shows the rule is
  // right.
  const HandGrip grip = FirmGrip();
  const auto error = [&](std::int64_t stepNs)
  {
    HandModel model(Frictionless(), grip, HandIntention());
    double worst = 0.0;
    for (std::int64_t now = stepNs; now <= 60 * Ms; now += stepNs)
    {
      model.Advance(now, { { 1, 0, 0 } });
      const double truth = StepResponse(
        0.12, grip.springNPerMm, grip.damperNsPerMm, 1.0, 1e-9 * static_cast<double>(now));
      worst = std::max(worst, std::abs(model.Pose().position.x - truth));
    }
    return worst;
  };
  // The next order's share is w h = 1.3e-3.
  EXPECT_NEAR(error(20'000) / error(10'000), 4.0, 0.01);
}

TEST(HandModel, AReleasedDeviceReachesItsTerminalSpeed)
{
  HandModel model({ .massKg = 0.1, .viscousNsPerMm = 0.002 }, NoGrip(), HandIntention());
  for (int ms = 1; ms <= 400; ++ms)
  {
    model.Advance(ms * Ms, { { 0, 1, 0 } });
    // F / b (1 - exp(-b t / m)): 500 mm/s, 50 ms.
    EXPECT_NEAR(model.VelocityMmPerS().y, 500.0 * (1.0 - std::exp(-ms / 50.0)), 1e-4);
  }
}

TEST(HandModel, DryFrictionHoldsWhatIsWeaker)
{
  // Creep where c tanh(v / creep) balances the force: v = creep atanh(F / c).
  HandModel model({ .viscousNsPerMm = 0.0, .coulombN = 0.4 }, NoGrip(), HandIntention());
  model.Advance(200 * Ms, { { 0.3, 0, 0 } });
  EXPECT_NEAR(model.VelocityMmPerS().x, std::atanh(0.75), 1e-9);
  // And brakes what moves: from 100 mm/s at c/m = 3333 mm/s^2 to rest within 30 ms, plus a tail.
  HandModel sliding({ .viscousNsPerMm = 0.0, .coulombN = 0.4 }, NoGrip(), HandIntention());
  sliding.SetState({}, { 100, 0, 0 }, {});
  sliding.Advance(25 * Ms, {});
  EXPECT_NEAR(sliding.VelocityMmPerS().x, 100.0 - 25e-3 * 0.4 / 0.12 * 1000.0, 1e-3);
  sliding.Advance(40 * Ms, {});
  EXPECT_LT(std::abs(sliding.VelocityMmPerS().x), 1e-6);
  EXPECT_GE(sliding.VelocityMmPerS().x, 0.0) << "friction turns nothing round";
}

TEST(HandModel, ATorqueTurnsAsAForcePushes)
{
  // About one axis the equations are the same: an inertia for a mass.
  const HandGrip grip{ .turnSpringNmmPerRad = 500, .turnDamperNmmSPerRad = 4 };
  const glm::dvec3 axis = glm::normalize(glm::dvec3(1, 2, -2));
  HandModel model(
    { .inertiaKgMm2 = glm::dvec3(120), .turnViscousNmmSPerRad = 1.0 }, grip, HandIntention());
  for (int ms = 1; ms <= 200; ++ms)
  {
    model.Advance(ms * Ms, { {}, 200.0 * axis });
    const double angle = StepResponse(120, 500, 5, 200, 1e-3 * ms);
    EXPECT_LT(glm::length(RotationVector(model.Pose().orientation) - angle * axis), 2e-5) << ms;
  }
}

TEST(HandModel, AFreeBodyKeepsItsSpinAndItsEnergy)
{
  // Three different moments, spun about near the middle one: it tumbles, and its angular momentum
  // in the room stays. A sign or an axis wrong in Euler's equations, and it would not.
  HandBody body = Frictionless();
  body.inertiaKgMm2 = { 60, 100, 150 };
  HandModel model(body, NoGrip(), HandIntention());
  const glm::dvec3 spin(0.02, 20.0, 0.01);
  model.SetState({ {}, TurnBy({ 0.3, 0.2, 0.1 }) }, {}, TurnBy({ 0.3, 0.2, 0.1 }) * spin);
  const auto momentum = [&]
  {
    const glm::dquat& q = model.Pose().orientation;
    return q * (body.inertiaKgMm2 * (glm::conjugate(q) * model.TurnRadPerS()));
  };
  const glm::dvec3 before = momentum();
  const double energy = model.KineticEnergy();
  double least = 1.0;
  for (int ms = 1; ms <= 2000; ++ms)
  {
    model.Advance(ms * Ms, {});
    const glm::dvec3 along = glm::conjugate(model.Pose().orientation) * model.TurnRadPerS();
    least = std::min(least, along.y / glm::length(along));
  }
  EXPECT_LT(least, -0.9) << "it turned over, so this tried something";
  // (w h)^2 = 1.6e-7 an angle, over some tens of radians; the exponential map keeps the rest.
  EXPECT_LT(glm::length(momentum() - before) / glm::length(before), 1e-5);
  EXPECT_NEAR(model.KineticEnergy() / energy, 1.0, 1e-6);
}

TEST(HandModel, AnUndampedGripKeepsItsEnergy)
{
  HandModel model(Frictionless(0.1), { .springNPerMm = 0.5 }, HandIntention());
  model.SetState({ { 10, 0, 0 } }, {}, {});
  model.Advance(1000 * Ms, {});
  const double x = model.Pose().position.x;
  // Each step gains (w h)^4 / 4 of it: 1e-12 here, 50,000 times.
  EXPECT_NEAR((model.KineticEnergy() + 0.25 * x * x) / 25.0, 1.0, 1e-6);
}

TEST(HandModel, AHandFollowsASineWithTheGainOfItsTransferFunction)
{
  const double hz = 4.0, mass = 0.1, k = 0.3, b = 0.003, bv = 0.001;
  HandModel model({ .massKg = mass, .viscousNsPerMm = bv }, { k, b },
    HandIntention({}, { ChirpMotion{ { 5, 0, 0 }, {}, hz, hz, 100.0 } }));
  double most = 0.0;
  for (int ms = 1; ms <= 3000; ++ms)
  {
    model.Advance(ms * Ms, {});
    if (ms > 2000) // swung in: exp(-b t / 2m) of a second is e^-20
      most = std::max(most, model.Pose().position.x);
  }
  const std::complex<double> s(0.0, 2.0 * std::numbers::pi * hz);
  const double gain = std::abs((k + b * s) / (mass / 1000.0 * s * s + (b + bv) * s + k));
  // Looked at once a ms, the crest is missed by up to (w 0.5 ms)^2 / 2 = 8e-5 of it.
  EXPECT_NEAR(most, 5.0 * gain, 1e-4 * 5.0 * gain);
}

TEST(HandModel, WorkIsForceTimesWay)
{
  HandModel model(Frictionless(), NoGrip(), HandIntention());
  model.Advance(100 * Ms, { { 0, 0, 2 } });
  EXPECT_NEAR(model.AppliedWork(), 2.0 * model.Pose().position.z, 1e-9);
  EXPECT_NEAR(model.AppliedWork(), model.KineticEnergy(), 1e-9);
}

TEST(HandModel, TheSameAgainIsTheSameToTheLastBit)
{
  const auto run = []
  {
    HandModel model({ .coulombN = 0.1 }, LooseGrip(),
      HandIntention({}, { MinimumJerkMotion{ { { 20, 5, 0 }, TurnBy({ 0, 0.5, 0 }) }, 0.2 } },
        { .reachMm = 0.1, .reachRad = 0.01, .seed = 3 }));
    for (int ms = 1; ms <= 300; ++ms)
      model.Advance(ms * Ms, { { -model.Pose().position.x, 0, 0 } });
    return model.Pose();
  };
  EXPECT_EQ(run().position, run().position);
  EXPECT_EQ(run().orientation, run().orientation);
}

} // namespace
