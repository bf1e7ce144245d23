#include "HapticTrials.h"
#include "Haptics/CoarsePhase.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "TrialBody.h"

#include "Haptics/ContactForce.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <optional>
#include <utility>

namespace hasp
{
namespace
{

constexpr int Ticks = 200;

/// Ticks of a shell that trembles by 0.1 mm as a hand does before a body like itself: all of its
/// points, or what the coarse phase leaves of them.
class Trembling
{
public:
  Trembling(const TrialBody& body, int points)
    : Shell(body.Shell(points)),
      Map(body.Map()),
      Coarse(this->Shell, this->Map),
      All(UpTo(*this->Shell, this->Shell->Levels() - 1))
  {
    this->Near.reserve(4096);
  }
  ContactSums Feel(double apart, bool coarse)
  {
    ContactSums sums;
    for (int tick = 0; tick < Ticks; ++tick)
    {
      const double a = 0.06 * tick; // 9.5 Hz at 1 kHz
      const RigidPose pose{ { apart + 0.1 * std::sin(a), 0.1 * std::cos(a), 0.0 },
        TurnBy({ 0.0, 0.0, 3.0 + 0.001 * std::sin(a) }) };
      const std::span<const ContactPoints> runs = coarse ? this->Left(pose) : this->All;
      this->Kernels[ContactTerms::Matrix](runs, { pose }, this->Map->View(), {}, sums);
    }
    return sums;
  }

private:
  std::span<const ContactPoints> Left(const RigidPose& pose)
  {
    this->Coarse.Begin(pose, 0.0);
    this->Near.clear();
    for (int level = 0; level < this->Shell->Levels(); ++level)
      for (ContactPoints run : this->Coarse.Near(level))
      {
        run.area = this->All.front().area;
        this->Near.push_back(run);
      }
    return this->Near;
  }

  std::shared_ptr<const PointShell> Shell;
  std::shared_ptr<const DistanceMap> Map;
  CoarsePhase Coarse;
  std::vector<ContactPoints> All, Near;
  const ContactKernels& Kernels = FastestContactKernels();
};

struct Place
{
  const char* name;
  double apart; ///< of the middles, mm more than two radii; NaN: on itself
  std::optional<double> bar;
  const char* text;
};

void AddRow(ReportContext& context, Trembling& shell, const TrialBody& body, const Place& place)
{
  const double apart = std::isnan(place.apart) ? 0.5 : 2.0 * body.Radius() + place.apart;
  ContactSums all, left;
  PairSettings settings;
  settings.pairs = context.settings.quick ? 9 : 31;
  PairedTimes times =
    ComparePairs([&] { return ThreadTimeOf([&] { left = shell.Feel(apart, true); }); },
      [&] { return ThreadTimeOf([&] { all = shell.Feel(apart, false); }); }, settings);
  times.a.wallS /= Ticks;
  times.a.cpuS /= Ticks;
  ReportRow row = CpuRatio(IdAt(std::string("haptics.coarse.") + place.name, body.Size(), 128),
    times, "the same kernels on all points",
    { WrenchError(left.contact, all.contact, body.Radius()), "of the force" },
    std::to_string(body.Size()) + "^3, 20000 points, " + std::to_string(all.contacts / Ticks) +
      " in contact, trembling 0.1 mm; " + place.text,
    true);
  if (place.bar)
    row.bars = { { place.bar, {} } };
  context.report.rows.push_back(row);
}

} // namespace

void TryCoarsePhase(ReportContext& context)
{
  for (const int samples : { 128, 256 })
  {
    const TrialBody body(samples, { 0.297 * samples, 0.0047 * samples, 15.2 });
    Trembling shell(body, 20'000);
    for (const Place& place : { Place{ "separated", 20.0, 10.0, "20 mm off" },
           Place{ "near", 2.0, {}, "2 mm off" }, Place{ "touching", -1.0, 1.5, "1 mm deep; aim 3" },
           Place{ "pressed", -5.0, {}, "5 mm deep" },
           Place{ "inside", std::nan(""), {},
             "on itself, no point is far: what the coarse phase costs" } })
      AddRow(context, shell, body, place);
  }
}

} // namespace hasp
