#include "Studies/SampledLoop.h"
#include "Studies/StabilityCases.h"

#include <cmath>

namespace hasp
{
namespace
{

constexpr double ChangeAtS = 1.0;

StabilityCase Pressing(const BenchHand& hand, double stiffness)
{
  StabilityCase made;
  made.scene = PressScene(Frictionless(FalconLike()), hand, {}, 10.0);
  made.body = std::make_shared<WallBody>();
  made.points = FootPoints(3, 10.0);
  made.stiffness = stiffness;
  made.touching = 9.0;
  made.coupling = DefaultCoupling(made.scene.device, made.scene.clock, 0.5, 7.1);
  return made;
}

void Add(std::vector<StabilityRow>& rows, const std::string& id, const std::string& text,
  const BenchHand& hand, StabilityCase made)
{
  StabilityRow row;
  row.id = "change." + id + "." + hand.name;
  row.text = text + ", hand " + hand.name;
  row.byDefault = true;
  row.law = "spectral radius of a tick, at most";
  row.figure = SampledLoop(made.scene.device, hand, made.scene.clock)
                 .SpringRadius(made.coupling.spring.stiffness);
  HoldWhenSettled(made.scene, SettlingRate(made.scene.clock, row.figure));
  made.scene.holdFromS += ChangeAtS;
  made.scene.seconds += ChangeAtS;
  RunQuasiStatic(row, made);
  rows.push_back(std::move(row));
}

/// Contact from one stiffness to another between two ticks.
StabilityCase Stiffness(const BenchHand& hand, double from, double to)
{
  StabilityCase made = Pressing(hand, from);
  made.change = [point = to / 9.0](double t, FieldContact& contact, VirtualCoupling&)
  {
    if (t >= ChangeAtS)
      contact.SetStiffness(point);
  };
  return made;
}

/// Another body under the tool, from one tick to the next.
StabilityCase Body(const BenchHand& hand, std::shared_ptr<const ImplicitField> body)
{
  StabilityCase made = Pressing(hand, 10.0);
  made.change = [body](double t, FieldContact& contact, VirtualCoupling&)
  {
    if (t >= ChangeAtS)
      contact.SetField(*body);
  };
  return made;
}

StabilityCase Limit(const BenchHand& hand, double share)
{
  StabilityCase made = Pressing(hand, 10.0);
  made.change = [share](double t, FieldContact&, VirtualCoupling& coupling)
  {
    if (t < ChangeAtS || t > ChangeAtS + 0.0009)
      return;
    CouplingSpring spring = coupling.GetSettings().spring;
    spring.forceLimit *= share;
    coupling.SetSpring(spring);
  };
  return made;
}

/// The integral of K v^2 over a minimum-jerk stroke to `depth` and back, with the slope that a
/// saturating spring has there; N mm / s.
double StiffnessTimesSquaredSpeed(const CouplingSpring& spring, double depth, double strokeS)
{
  double sum = 0.0;
  constexpr int Steps = 1000;
  for (int i = 0; i < Steps; ++i)
  {
    const double u = (i + 0.5) / Steps;
    const double way = depth * u * u * u * (10.0 - u * (15.0 - 6.0 * u));
    const double speed = depth * 30.0 * u * u * (1.0 - u) * (1.0 - u) / strokeS;
    const double slope = 1.0 / std::cosh(spring.stiffness * way / spring.forceLimit);
    sum += 2.0 * spring.stiffness * slope * slope * speed * speed * strokeS / Steps;
  }
  return sum;
}

} // namespace

// What changes while it is touched, at once: statics change, stability does not.
void AddChangeRows(std::vector<StabilityRow>& rows)
{
  for (const BenchHand& hand : { NoHand(), LooseHand(), FirmHand() })
  {
    Add(rows, "stiffness.up", "contact 1 to 100 N/mm while touched", hand,
      Stiffness(hand, 1.0, 100.0));
    Add(rows, "stiffness.down", "contact 100 to 1 N/mm while touched", hand,
      Stiffness(hand, 100.0, 1.0));
    auto higher = std::make_shared<WallBody>();
    higher->height = 1.0;
    Add(rows, "scene.higher", "a wall 1 mm higher while touched", hand, Body(hand, higher));
    auto lower = std::make_shared<WallBody>();
    lower->height = -1.0;
    Add(rows, "scene.lower", "a wall 1 mm lower while touched", hand, Body(hand, lower));
    auto ball = std::make_shared<BallBody>();
    ball->radius = 20.0;
    ball->center.z = -20.0;
    Add(rows, "scene.ball", "a ball for a wall while touched", hand, Body(hand, ball));
    Add(rows, "limit.down", "a third of the coupling's limit while touched", hand,
      Limit(hand, 1.0 / 3.0));
    Add(rows, "limit.up", "1.5 times the coupling's limit while touched", hand, Limit(hand, 1.5));
    StabilityCase lost = Pressing(hand, 10.0);
    lost.loseFromS = 0.98;
    lost.loseToS = 1.0;
    Add(rows, "pose.nan", "poses that are not numbers for 20 ms", hand, lost);
  }
}

// The energy of a force that is held for a tick and late by t_d, while a hand goes in and out:
// K (T/2 + t_d) times the integral of v^2. It has to stay under 1 mJ where the device rubs off
// none.
void AddEnergyRows(std::vector<StabilityRow>& rows)
{
  for (int delay = 0; delay <= 3; ++delay)
    for (const double strokeS : { 0.1, 0.4, 1.0 })
    {
      constexpr double Depth = 10.0;
      BenchClock clock;
      clock.delayTicks = delay;
      StabilityCase made;
      made.scene.device = Frictionless(FalconLike());
      made.scene.hand = FirmHand();
      made.scene.hand.stiffness = 5.0; // a hand that goes where it means to
      made.scene.hand.damping = 0.03;
      made.scene.clock = clock;
      made.scene.start.position.z = 0.2;
      made.scene.strokes = { { 0.1, strokeS, { 0.0, 0.0, -Depth } },
        { 0.1 + strokeS, strokeS, { 0.0, 0.0, Depth } } };
      made.scene.holdFromS = 2.3;
      made.scene.seconds = 3.5;
      made.scene.pressed = false;
      made.body = std::make_shared<WallBody>();
      made.stiffness = 100.0;
      made.coupling = DefaultCoupling(made.scene.device, clock, 0.5, 7.1);
      StabilityRow row;
      row.id = "energy.d" + std::to_string(delay) + ".t" + Figure(strokeS);
      row.text = "10 mm in and out in " + Figure(2.0 * strokeS) + " s, delay " +
                 std::to_string(delay) + " ticks";
      row.law = "(T/2 + t_d) int K v^2, mJ";
      row.figure = (0.5 + delay) * clock.tickS *
                   StiffnessTimesSquaredSpeed(made.coupling.spring, Depth, strokeS);
      row.predicted.givesEnergy = row.figure > row.limit;
      RunQuasiStatic(row, made);
      rows.push_back(std::move(row));
    }
}

} // namespace hasp
