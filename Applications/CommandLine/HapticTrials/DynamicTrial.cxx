#include "DynamicRival.h"
#include "DynamicScene.h"
#include "HapticTrials.h"
#include "Haptics/ContactForce.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "SimdScene.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace hasp
{
namespace
{

/// To and fro along the other body's side, pressed in by about 1 mm. At 100 mm/s blocks come and go
/// now and then; at 1 m/s in each tick.
struct Way
{
  RigidPose start;
  double mmPerS = 100.0;

  RigidPose At(int tick) const
  {
    const double mm = 0.05 * this->mmPerS; // 50 ms of it either way
    RigidPose pose = this->start;
    pose.position.y += mm * std::sin(0.02 * tick);
    return pose;
  }
};

class Moving
{
public:
  Moving(const DynamicScene& scene, const Way& way)
    : Scene(scene),
      Path(way),
      Shell(scene.volume, scene.body.Map(), glm::dvec3(0.0))
  {
  }
  /// The next ticks; returns the last one's wrench.
  Wrench Go(int ticks)
  {
    Wrench felt;
    for (int n = 0; n < ticks; ++n, ++this->Tick)
    {
      const RigidPose pose = this->Path.At(this->Tick);
      this->Shell.Update(pose, 0.0);
      felt = this->Scene.Feel(pose, this->Shell.Points());
      const DynamicPointShell::Facts& facts = this->Shell.LastTick();
      this->Drawn += facts.drawn;
      this->Alive += facts.points;
    }
    return felt;
  }
  RigidPose Pose() const { return this->Path.At(this->Tick - 1); }
  double AreaOfPoint() const
  {
    const DynamicPointShell::Facts& facts = this->Shell.LastTick();
    return facts.areaMm2 / std::max(1U, facts.points);
  }

  int Tick = 0;
  double Drawn = 0.0, Alive = 0.0;

private:
  const DynamicScene& Scene;
  Way Path;
  DynamicPointShell Shell;
};

class MovingRival
{
public:
  MovingRival(const DynamicScene& scene, const Way& way, int draws, std::size_t room)
    : Path(way),
      Map{ scene.body.View().data, glm::ivec3(scene.body.Size()),
        glm::vec3(scene.body.View().geometry.origin), 1.0F },
      Shell(this->Map, this->Map, room),
      Draws(draws)
  {
  }
  Wrench Go(int ticks, float areaOfPoint)
  {
    rival::Sums felt;
    for (int n = 0; n < ticks; ++n, ++this->Tick)
    {
      const RigidPose pose = this->Path.At(this->Tick);
      const rival::Pose at{ glm::mat3(glm::mat3_cast(pose.orientation)), glm::vec3(pose.position) };
      this->Shell.Update(at, this->Draws, 4.0F);
      felt = rival::o2::Force(
        this->Shell.Points(), at, this->Map, ContactSettings{}.stiffness * areaOfPoint);
    }
    return { glm::dvec3(felt.force), glm::dvec3(felt.torque) };
  }

private:
  Way Path;
  rival::Map Map;
  rival::o2::DynamicShell Shell;
  int Draws, Tick = 0;
};

void AddSpeed(ReportContext& context, const DynamicScene& scene, int mmPerS)
{
  constexpr int Ticks = 100, Settling = 628; // twice to and fro
  const std::string id = IdAt("haptics.simd.dynamic", mmPerS, 100);
  if (AllContactKernels().size() == 1)
  {
    context.report.rows.push_back(
      AbsentRow(id, "plain code that draws and evaluates as many", WhyNoKernels("vectors")));
    return;
  }
  const Way way{ scene.Touching(
                   glm::dvec3(1.0, 0.0, 0.0), TurnBy({ 0.0, 0.0, 3.0 }), *scene.truth, 1.0),
    static_cast<double>(mmPerS) };
  Moving ours(scene, way);
  ours.Go(Settling);
  ours.Drawn = ours.Alive = 0.0;
  ours.Go(Settling);
  const int draws = static_cast<int>(std::lround(ours.Drawn / Settling));
  const auto alive = static_cast<std::size_t>(std::lround(ours.Alive / Settling));
  MovingRival rival(scene, way, draws, alive);
  const auto area = static_cast<float>(ours.AreaOfPoint());
  rival.Go(ours.Tick, area);
  double error = 0.0, rivals = 0.0;
  constexpr int Checks = 20;
  for (int n = 0; n < Checks; ++n)
  {
    const Wrench felt = ours.Go(37), theirs = rival.Go(37, area);
    const Wrench right = scene.Feel(ours.Pose(), *scene.truth);
    error += WrenchError(felt, right, scene.body.Radius()) / Checks;
    rivals += WrenchError(theirs, right, scene.body.Radius()) / Checks;
  }
  PairSettings settings;
  settings.pairs = context.settings.quick ? 9 : 31;
  PairedTimes times = ComparePairs([&] { return ThreadTimeOf([&] { ours.Go(Ticks); }); },
    [&] { return ThreadTimeOf([&] { rival.Go(Ticks, area); }); }, settings);
  times.a.wallS /= Ticks;
  times.a.cpuS /= Ticks;
  char text[220];
  std::snprintf(text, sizeof text,
    "array of structures, linear float volume, glm, g++ -O2: draws and evaluates as many; off by "
    "%.2g of the force",
    rivals);
  const bool barred = mmPerS == 100; // faster is told, not asked for
  char data[200];
  std::snprintf(data, sizeof data,
    "128^3, to and fro at %d mm/s pressed in by 1 mm, %d points drawn a tick, %zu evaluated; %s",
    mmPerS, draws, alive, barred ? "aim 5" : "few of the ring live, and all of it is evaluated");
  ReportRow row = CpuRatio(id, times, text, { error, "of the force" }, data, true);
  if (barred)
    row.bars = { { 2.5, {} } };
  context.report.rows.push_back(row);
}

} // namespace

void TryDynamicShell(ReportContext& context)
{
  const DynamicScene scene(context.settings.quick ? 65'536 : 262'144);
  for (const int mmPerS : { 100, 1000 })
    AddSpeed(context, scene, mmPerS);
  AddDynamicErrors(context, scene);
}

} // namespace hasp
