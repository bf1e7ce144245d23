#include "Studies/SampledLoop.h"
#include "Studies/StabilityCases.h"

namespace hasp
{
namespace
{

constexpr double HalfVoxelMm = 0.3;
constexpr double CouplingNPerMm = 0.9;
// Stable while S T^2/m < 4, but a tool that bounces meets the wall as deep as v T at one tick and
// leaves at v (S T^2/m - 1): from 2 on it depends on how hard it is pressed. With 100 g no row is
// there.
constexpr double ToolKg = 0.1;

struct Spot
{
  BenchHand hand;
  double tickMs;
  int delay;
  double contact;

  std::string Id() const
  {
    return std::string("k") + Figure(this->contact) + ".T" + Figure(this->tickMs) + "." +
           this->hand.name + ".d" + std::to_string(this->delay);
  }
  std::string Text() const
  {
    return std::string("contact ") + Figure(this->contact) + " N/mm, tick " + Figure(this->tickMs) +
           " ms, hand " + this->hand.name + ", delay " + std::to_string(this->delay) + " ticks";
  }
  StabilityCase Case() const
  {
    BenchClock clock;
    clock.tickS = 0.001 * this->tickMs;
    clock.delayTicks = this->delay;
    StabilityCase made;
    // Pressed so that it does not bounce, and far from every limit: the linear loop.
    made.scene = PressScene(Bare(FalconLike()), this->hand, clock, 6.0);
    made.scene.device.forceLimitN = made.scene.device.torqueLimitNmm = 1e3;
    made.scene.deepLimitMm = HalfVoxelMm;
    made.body = std::make_shared<WallBody>();
    made.stiffness = this->contact;
    made.coupling.spring = { CouplingNPerMm, 900.0 * CouplingNPerMm, 100.0, 1e3 };
    made.coupling.travelMm = 1.0;
    return made;
  }
};

/// What both couplings share: a loop settles under radius 1, and a soft wall is deep.
void Predict(StabilityRow& row, const Spot& spot, StabilityCase& made, double radius)
{
  const double rate = SettlingRate(made.scene.clock, radius);
  const double series = SpringsInSeries(CouplingNPerMm, spot.contact);
  HoldWhenSettled(made.scene, rate);
  row.law = "spectral radius of a tick";
  row.figure = radius;
  row.predicted.oscillates = radius >= 1.0;
  const double force = PressForce(made.scene, series);
  row.predicted.deep = force / spot.contact > HalfVoxelMm;
  row.predicted.givesEnergy = EnergyGiven(made.scene, series, rate) > 1.0;
}

void AddQuasiStatic(std::vector<StabilityRow>& rows, const Spot& spot)
{
  StabilityCase made = spot.Case();
  StabilityRow row;
  row.id = "grid.quasistatic." + spot.Id();
  row.text = "quasi-static coupling 0.9 N/mm, " + spot.Text();
  // The device feels coupling and contact in series.
  Predict(row, spot, made,
    SampledLoop(made.scene.device, spot.hand, made.scene.clock)
      .SpringRadius(SpringsInSeries(CouplingNPerMm, spot.contact)));
  RunQuasiStatic(row, made);
  rows.push_back(std::move(row));
}

void AddExplicit(std::vector<StabilityRow>& rows, const Spot& spot)
{
  StabilityCase made = spot.Case();
  ExplicitCouplingSettings coupling;
  coupling.spring = made.coupling.spring;
  coupling.tickS = made.scene.clock.tickS;
  coupling.massKg = ToolKg;
  StabilityRow row;
  row.id = "grid.explicit." + spot.Id();
  row.text = "explicit tool of 100 g on 0.9 N/mm and 1 N s/m, " + spot.Text();
  Predict(row, spot, made,
    SampledLoop(made.scene.device, spot.hand, made.scene.clock)
      .ExplicitRadius(coupling, spot.contact));
  RunExplicit(row, made, coupling);
  rows.push_back(std::move(row));
}

} // namespace

void AddGridRows(std::vector<StabilityRow>& rows)
{
  for (const bool explicitTool : { false, true })
    for (const double contact : { 0.1, 1.0, 10.0, 100.0 })
      for (const double tickMs : { 0.25, 1.0, 4.0 })
        for (const BenchHand& hand : { NoHand(), LooseHand(), FirmHand() })
          for (int delay = 0; delay <= 3; ++delay)
            (explicitTool ? AddExplicit : AddQuasiStatic)(rows, { hand, tickMs, delay, contact });
}

// No coupling: the device meets the wall's own stiffness. A third under and over the limit.
void AddPenaltyRows(std::vector<StabilityRow>& rows)
{
  for (const BenchDevice& device : { FalconLike(), TouchLike() })
    for (const BenchHand& hand : { LooseHand(), FirmHand() })
      for (int delay = 1; delay <= 2; ++delay)
        for (const double share : { 0.67, 1.33 })
        {
          BenchClock clock;
          clock.delayTicks = delay;
          StabilityCase made;
          made.scene = PressScene(Bare(device), hand, clock);
          made.scene.device.forceLimitN = 1e3; // the linear loop
          made.body = std::make_shared<WallBody>();
          const SampledLoop loop(device, hand, clock);
          made.stiffness = share * loop.CriticalSpring();
          StabilityRow row;
          row.id = std::string("penalty.") + device.name + "." + hand.name + ".d" +
                   std::to_string(delay) + "." + Figure(share);
          row.text = "no coupling, wall of " + Figure(share) + " of the limit, " + device.name +
                     ", hand " + hand.name + ", delay " + std::to_string(delay) + " ticks";
          row.law = "spectral radius of a tick";
          row.figure = loop.SpringRadius(made.stiffness);
          row.predicted.oscillates = row.figure >= 1.0;
          HoldWhenSettled(made.scene, SettlingRate(clock, row.figure));
          RunPenalty(row, made);
          rows.push_back(std::move(row));
        }
}

} // namespace hasp
