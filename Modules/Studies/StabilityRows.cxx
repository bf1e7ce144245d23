#include "Studies/StabilityRows.h"
#include "Studies/SampledLoop.h"
#include "Studies/StabilityCases.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace hasp
{

std::string Figure(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

void RunQuasiStatic(StabilityRow& row, StabilityCase made)
{
  row.run = [made = std::move(made)]
  {
    QuasiStaticRenderer renderer(VirtualCoupling(made.coupling),
      { made.points, made.PointStiffness(), *made.body }, made.scene.device,
      made.scene.clock.tickS);
    renderer.OnTick(made.change);
    renderer.LosePoses(made.loseFromS, made.loseToS);
    renderer.RampIn(made.rampInS);
    const BenchFigures figures = RunBench(made.scene, renderer);
    return StabilityRow::Outcome{ figures, Judge(made.scene, figures) };
  };
}

void RunExplicit(StabilityRow& row, StabilityCase made, const ExplicitCouplingSettings& coupling)
{
  row.run = [made = std::move(made), coupling]
  {
    ExplicitRenderer renderer(ExplicitCoupling(coupling),
      { made.points, made.PointStiffness(), *made.body }, made.scene.device,
      made.scene.clock.tickS);
    const BenchFigures figures = RunBench(made.scene, renderer);
    return StabilityRow::Outcome{ figures, Judge(made.scene, figures) };
  };
}

void RunPenalty(StabilityRow& row, StabilityCase made)
{
  row.run = [made = std::move(made)]
  {
    PenaltyRenderer renderer({ made.points, made.PointStiffness(), *made.body });
    const BenchFigures figures = RunBench(made.scene, renderer);
    BenchVerdict verdict = Judge(made.scene, figures);
    verdict.overLimit = false; // there is nothing between it and the motors, which clamp
    return StabilityRow::Outcome{ figures, verdict };
  };
}

BenchDevice Frictionless(BenchDevice device)
{
  device.coulombN = 0.0;
  return device;
}

BenchDevice Bare(BenchDevice device)
{
  device.coulombN = 0.0;
  device.quantumMm = 1e-4;
  return device;
}

void HoldWhenSettled(BenchScene& scene, double rate)
{
  double last = 0.1; // a device that leans falls for this long
  for (const BenchStroke& stroke : scene.strokes)
    last = std::max(last, stroke.atS + stroke.lastsS);
  const double settling = rate > 0.0 ? 7.0 / rate : 0.0;
  scene.holdFromS = std::clamp(last + settling, 1.5, 200.0);
  scene.seconds = scene.holdFromS + 1.5;
}

double SettlingRate(const BenchClock& clock, double radius)
{
  return -std::log(radius) / clock.tickS;
}

double EnergyGiven(const BenchScene& scene, double stiffness, double rate)
{
  const double mass = (scene.device.massKg + scene.hand.massKg) / 1000.0; // N s^2/mm
  const double left = 2.0 * mass * rate / (scene.device.damping + scene.hand.damping);
  const double force = PressForce(scene, stiffness), stored = 0.5 * force * force / stiffness;
  // A weight falls 0.1 mm and then swings about its rest; a hand comes at 20 mm/s.
  const double bounces =
    scene.hand.stiffness > 0.0 ? 0.5 * mass * 20.0 * 20.0 : stored + 0.1 * force;
  return bounces * (1.0 - left) / left - stored;
}

BenchScene PressScene(
  const BenchDevice& device, const BenchHand& hand, const BenchClock& clock, double depthMm)
{
  BenchScene scene;
  scene.device = device;
  scene.hand = hand;
  scene.clock = clock;
  if (hand.stiffness > 0.0)
  {
    scene.start.position.z = 1.0;
    const double way = 1.0 + depthMm;
    scene.strokes = { { 0.0, way / 20.0, { 0.0, 0.0, -way }, {}, false } };
  }
  else
  {
    scene.start.position.z = 0.1;
    scene.leanN.z = -0.25;
  }
  return scene;
}

double PressForce(const BenchScene& scene, double stiffness)
{
  double depth = -scene.start.position.z;
  for (const BenchStroke& stroke : scene.strokes)
    depth -= stroke.moveMm.z;
  const double hand = scene.hand.stiffness;
  return hand > 0.0 ? depth * SpringsInSeries(hand, stiffness) : -scene.leanN.z;
}

std::vector<StabilityRow> StabilityRows()
{
  std::vector<StabilityRow> rows;
  AddGridRows(rows);
  AddPenaltyRows(rows);
  AddDefaultRows(rows);
  AddPlateRows(rows);
  AddDeepRows(rows);
  AddShapeRows(rows);
  AddClockRows(rows);
  AddChangeRows(rows);
  AddEnergyRows(rows);
  AddStepRows(rows);
  AddRingRows(rows);
  return rows;
}

bool AsPredicted(const BenchVerdict& predicted, const BenchVerdict& outcome)
{
  if (outcome.overLimit != predicted.overLimit || outcome.notFinite != predicted.notFinite ||
      outcome.oscillates != predicted.oscillates || outcome.through != predicted.through)
    return false;
  return predicted.oscillates || predicted.through || outcome == predicted;
}

} // namespace hasp
