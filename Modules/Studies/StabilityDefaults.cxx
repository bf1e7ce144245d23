#include "Studies/SampledLoop.h"
#include "Studies/StabilityCases.h"

namespace hasp
{
namespace
{

constexpr double VoxelMm = 0.5;

/// The rule that DefaultCoupling follows: half of (b + no hand) / (T/2 + t_d).
void PredictDefault(StabilityRow& row, StabilityCase& made)
{
  row.byDefault = true;
  row.law = "spectral radius of a tick";
  row.figure = SampledLoop(made.scene.device, made.scene.hand, made.scene.clock)
                 .SpringRadius(SpringsInSeries(made.coupling.spring.stiffness, made.stiffness));
  HoldWhenSettled(made.scene, SettlingRate(made.scene.clock, row.figure));
}

} // namespace

// What a device gets if nobody chooses, with and without its dry friction.
void AddDefaultRows(std::vector<StabilityRow>& rows)
{
  for (const BenchDevice& model : { TouchLike(), FalconLike(), PremiumLike() })
    for (const BenchHand& hand : { NoHand(), LooseHand(), FirmHand() })
      for (int delay = 0; delay <= 3; ++delay)
        for (const bool dry : { true, false })
        {
          const BenchDevice device = dry ? model : Frictionless(model);
          BenchClock clock;
          clock.delayTicks = delay;
          StabilityCase made;
          // 30 mm with a firm hand: 15 N, far into the limits of the smaller devices.
          made.scene = PressScene(device, hand, clock, 30.0);
          made.scene.deepLimitMm = 0.5 * VoxelMm;
          made.scene.leanN *= dry ? 2.0 : 1.0; // past its dry friction
          made.body = std::make_shared<WallBody>();
          made.points = FootPoints(3, 10.0);
          made.stiffness = 100.0;
          made.touching = 9.0;
          made.coupling = DefaultCoupling(device, clock, VoxelMm, 7.1);
          StabilityRow row;
          row.id = std::string("default.") + model.name + "." + hand.name + ".d" +
                   std::to_string(delay) + (dry ? ".dry" : ".bare");
          row.text = std::string("defaults of a ") + model.name + " device (" +
                     Figure(model.forceLimitN) + " N), hand " + hand.name + ", delay " +
                     std::to_string(delay) + " ticks, " + (dry ? "with" : "without") +
                     " dry friction";
          PredictDefault(row, made);
          RunQuasiStatic(row, made);
          rows.push_back(std::move(row));
        }
}

// Ticks lost, late and missing altogether, with the default coupling.
void AddClockRows(std::vector<StabilityRow>& rows)
{
  struct Trouble
  {
    const char *id, *text;
    BenchClock clock;
    double meanHold; ///< ticks that a wrench is held, on average, more than one
  };
  const auto with = [](double dropped, double jitter, double pauseS)
  {
    BenchClock clock;
    clock.dropped = dropped;
    clock.jitter = jitter;
    clock.pauseAtS = pauseS > 0.0 ? 0.3 : -1.0;
    clock.pauseS = pauseS;
    return clock;
  };
  const Trouble troubles[] = { { "drop10", "10 % of ticks dropped", with(0.1, 0, 0), 0.11 },
    { "drop30", "30 % of ticks dropped", with(0.3, 0, 0), 0.43 },
    { "jitter50", "times between ticks +-50 %", with(0, 0.5, 0), 0.5 },
    { "jitter90", "times between ticks +-90 %", with(0, 0.9, 0), 0.9 },
    { "pause50", "a pause of 50 ms", with(0, 0, 0.05), 0.0 } };
  for (const Trouble& trouble : troubles)
    for (const BenchHand& hand : { NoHand(), LooseHand(), FirmHand() })
      for (const double contact : { 1.0, 10.0, 100.0 })
      {
        const BenchDevice device = Frictionless(FalconLike());
        StabilityCase made;
        made.scene = PressScene(device, hand, trouble.clock, 10.0);
        made.body = std::make_shared<WallBody>();
        made.points = FootPoints(3, 10.0);
        made.stiffness = contact;
        made.touching = 9.0;
        made.coupling = DefaultCoupling(device, trouble.clock, VoxelMm, 7.1);
        StabilityRow row;
        row.id = std::string("clock.") + trouble.id + ".k" + Figure(contact) + "." + hand.name;
        row.text =
          std::string(trouble.text) + ", contact " + Figure(contact) + " N/mm, hand " + hand.name;
        row.byDefault = true;
        // A wrench that stays longer is a longer tick: (T/2 + t_d) grows by the mean of it.
        const SampledLoop loop(device, hand, trouble.clock);
        row.law = "K (T/2 + t_d + held longer) / (b + b_h)";
        row.figure = SpringsInSeries(made.coupling.spring.stiffness, contact) *
                     (1.5 + trouble.meanHold) * trouble.clock.tickS / loop.damping;
        HoldWhenSettled(
          made.scene, (1.0 - row.figure) * loop.damping * 1000.0 / (2.0 * loop.massKg));
        RunQuasiStatic(row, made);
        rows.push_back(std::move(row));
      }
}

} // namespace hasp
