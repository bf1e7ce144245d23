#include "Studies/SampledLoop.h"
#include "Studies/StabilityCases.h"

#include <algorithm>
#include <cmath>

namespace hasp
{
namespace
{

/// A firm hand that means to be 40 mm beyond z = 0: it meets the plate at this speed and then leans
/// on a coupling in full saturation.
BenchScene Impact(double metresPerS, const BenchDevice& device)
{
  BenchScene scene;
  scene.device = device;
  scene.hand = FirmHand();
  scene.start.position.z = 5.0;
  scene.speedMmPerS.z = -1000.0 * metresPerS;
  scene.strokes = { { 0.0, 0.045 / metresPerS, { 0.0, 0.0, -45.0 }, {}, false } };
  return scene;
}

} // namespace

// A plate of thickness 2h pushes back with h sum k at most. It is held by what pulls less, and as
// deep as what it pulls: F_sat / sum k. Sub-steps and speed do not enter.
void AddPlateRows(std::vector<StabilityRow>& rows)
{
  for (const double thickness : { 0.2, 1.0, 5.0 })
    for (const double speed : { 0.1, 1.0, 3.0 })
      for (const double share : { 0.4, 0.9, 1.1, 2.0 })
      {
        constexpr double Middle = 4.0; // N: h sum k
        StabilityCase made;
        made.scene = Impact(speed, Frictionless(FalconLike()));
        made.scene.deepLimitMm = 0.25 * thickness;
        made.scene.throughBelowZ = -0.25 * thickness;
        auto plate = std::make_shared<PlateBody>();
        plate->half = 0.5 * thickness;
        made.body = plate;
        made.points = FootPoints(3, 10.0);
        made.stiffness = Middle / plate->half;
        made.touching = 9.0;
        made.coupling = DefaultCoupling(made.scene.device, made.scene.clock, 0.25 * thickness, 7.1);
        made.coupling.spring.forceLimit = share * Middle;
        // What went through is out of the plate, but not out of the hand's reach.
        made.scene.pressed = share < 1.0;
        StabilityRow row;
        row.id = "plate." + Figure(thickness) + "mm.v" + Figure(speed) + ".F" + Figure(share);
        row.text = "plate of " + Figure(thickness) + " mm met at " + Figure(speed) +
                   " m/s, F_sat " + Figure(share) + " of h sum k";
        row.law = "F_sat / (h sum k)";
        row.figure = share;
        row.predicted.through = share > 1.0;
        row.predicted.deep = share > 0.5;
        RunQuasiStatic(row, made);
        rows.push_back(std::move(row));
      }
}

// The tool begins 10 mm inside. It leaves by travel * steps a tick, whatever the stiffness.
void AddDeepRows(std::vector<StabilityRow>& rows)
{
  for (const double stiffness : { 1.0, 10.0, 100.0 })
    for (const BenchHand& hand : { NoHand(), LooseHand(), FirmHand() })
      for (const double depth : { 2.0, 10.0 })
      {
        StabilityCase made;
        made.scene.device = Frictionless(FalconLike());
        made.scene.hand = hand;
        made.scene.start.position.z = -depth;
        made.scene.leanN.z = hand.stiffness > 0.0 ? 0.0 : -0.25;
        made.rampInS = 0.5; // as after a start, which is when a tool is found inside
        made.body = std::make_shared<WallBody>();
        made.stiffness = stiffness;
        made.coupling = DefaultCoupling(made.scene.device, made.scene.clock, 0.5, 7.1);
        const CouplingSpring& spring = made.coupling.spring;
        HoldWhenSettled(
          made.scene, SettlingRate(made.scene.clock,
                        SampledLoop(made.scene.device, hand, made.scene.clock)
                          .SpringRadius(SpringsInSeries(spring.stiffness, stiffness))));
        // The spring is drawn by all of the depth while the device is still there.
        made.scene.givenMj = spring.forceLimit * spring.forceLimit / spring.stiffness *
                             std::log(std::cosh(spring.stiffness * depth / spring.forceLimit));
        const double perTick = made.coupling.travelMm * made.coupling.steps;
        StabilityRow row;
        row.id = "deep." + Figure(depth) + "mm.k" + Figure(stiffness) + "." + hand.name;
        row.text = "begins " + Figure(depth) + " mm inside, contact " + Figure(stiffness) +
                   " N/mm, hand " + hand.name;
        row.law = "ticks to leave / 50";
        row.figure = depth / perTick / 50.0;
        row.predicted.slow = row.figure > 1.0;
        RunQuasiStatic(row, made);
        rows.push_back(std::move(row));
      }
}

} // namespace hasp
