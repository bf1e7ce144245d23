#pragma once
#include "Studies/BenchBodies.h"
#include "Studies/BenchRenderers.h"
#include "Studies/StabilityRows.h"

#include <memory>

namespace hasp
{

/// What a row of points in closed form is made of.
struct StabilityCase
{
  BenchScene scene;
  std::shared_ptr<const ImplicitField> body;
  std::vector<glm::dvec3> points = TipPoints();
  double stiffness = 10.0; ///< sum k over the points that touch at once, N/mm
  double touching = 1.0;   ///< how many those are
  VirtualCouplingSettings coupling;
  QuasiStaticRenderer::Change change;
  double loseFromS = 1e9, loseToS = 1e9;
  double rampInS = 0.0;

  double PointStiffness() const { return this->stiffness / this->touching; }
};

/// "0.25", "100": numbers in ids.
std::string Figure(double value);

/// Sets row.run to a quasi-static coupling before the case's body.
void RunQuasiStatic(StabilityRow& row, StabilityCase made);
void RunExplicit(StabilityRow& row, StabilityCase made, const ExplicitCouplingSettings& coupling);
void RunPenalty(StabilityRow& row, StabilityCase made);

/// A hand that presses `depthMm` below z = 0 at 20 mm/s and stays; without a hand, 0.25 N of
/// weight. Tells the static force in a coupled spring to ground there.
BenchScene PressScene(
  const BenchDevice& device, const BenchHand& hand, const BenchClock& clock, double depthMm = 2.0);
double PressForce(const BenchScene& scene, double stiffness);
/// Puts the hold phase, 1.5 s long, where what decays by `rate` (1/s) has done so: a bounce of a
/// millimetre to a micrometre, e^-7. Slow is not unstable; at most 200 s.
void HoldWhenSettled(BenchScene& scene, double rate);
/// The rate at which a linear loop settles, if it does: -ln(radius) / T.
double SettlingRate(const BenchClock& clock, double radius);
/// Energy that a linear loop gives through the port while it settles: of what bounces, E0, the
/// share r / (1 - r), r = K (T/2 + t_d) / (b + b_h), less what stays in the spring. From the
/// settling rate, since b + b_h - K (T/2 + t_d) = 2 m rate; mJ.
double EnergyGiven(const BenchScene& scene, double stiffness, double rate);
/// Without dry friction, which would hide what the renderer does.
BenchDevice Frictionless(BenchDevice device);
/// And with an encoder of 0.1 um: the linear loop.
BenchDevice Bare(BenchDevice device);

void AddGridRows(std::vector<StabilityRow>& rows);
void AddPenaltyRows(std::vector<StabilityRow>& rows);
void AddDefaultRows(std::vector<StabilityRow>& rows);
void AddPlateRows(std::vector<StabilityRow>& rows);
void AddDeepRows(std::vector<StabilityRow>& rows);
void AddShapeRows(std::vector<StabilityRow>& rows);
void AddClockRows(std::vector<StabilityRow>& rows);
void AddChangeRows(std::vector<StabilityRow>& rows);
void AddEnergyRows(std::vector<StabilityRow>& rows);
void AddStepRows(std::vector<StabilityRow>& rows);
void AddRingRows(std::vector<StabilityRow>& rows);

} // namespace hasp
