#include "DynamicRival.h"
#include "Haptics/DynamicPointShell.h"
#include "HapticTrials.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "SimdScene.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

namespace hasp
{
namespace
{

/// A body that touches one like itself.
struct DynamicScene
{
  TrialBody body{ 128, { 44.8, 2.56, 6.0 } };
  ShellVolume volume;

  DynamicScene()
  {
    this->volume.grid = this->body.View();
    this->volume.blocks = std::make_shared<MinMaxBlocks>(this->volume.grid);
    this->volume.insideAbove = false;
  }
  Wrench Feel(const RigidPose& pose, const ContactPoints& points) const
  {
    ContactSums sums;
    FastestContactKernels()[ContactTerms::Force](
      points, { pose }, this->body.Map()->View(), {}, sums);
    return sums.contact;
  }
  Wrench Feel(const RigidPose& pose, const PointShell& shell) const
  {
    Wrench sum;
    for (const ContactPoints& run : UpTo(shell, shell.Levels() - 1))
      sum += this->Feel(pose, run);
    return sum;
  }
  /// Along `way`, just touching, then pressed in by `deep`.
  RigidPose Touching(const glm::dvec3& way, const glm::dquat& turn, const PointShell& shell,
    double deep) const
  {
    double near = 0.5 * this->body.Size(), far = this->body.Size();
    while (far - near > 0.01)
    {
      const double middle = 0.5 * (near + far);
      const bool touches = glm::length(this->Feel({ middle * way, turn }, shell).force) > 0.0;
      (touches ? near : far) = middle;
    }
    return { (near - deep) * way, turn };
  }
};

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
      const rival::Pose at{ glm::mat3(glm::mat3_cast(pose.orientation)),
        glm::vec3(pose.position) };
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

void AddSpeed(
  ReportContext& context, const DynamicScene& scene, const PointShell& truth, int mmPerS)
{
  constexpr int Ticks = 100, Settling = 628; // twice to and fro
  const Way way{ scene.Touching(
                   glm::dvec3(1.0, 0.0, 0.0), TurnBy({ 0.0, 0.0, 3.0 }), truth, 1.0),
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
    const Wrench right = scene.Feel(ours.Pose(), truth);
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
  char data[160];
  std::snprintf(data, sizeof data,
    "128^3, to and fro at %d mm/s pressed in by 1 mm, %d points drawn a tick, %zu evaluated; "
    "aim 5",
    mmPerS, draws, alive);
  ReportRow row =
    CpuRatio(IdAt("haptics.simd.dynamic", mmPerS, 100), times, text,
      { error, "of the force" }, data, true);
  row.bars = { { 2.5, {} } };
  context.report.rows.push_back(row);
}

struct ShellErrors
{
  double force = 0.0, torque = 0.0;
  void Add(const Wrench& wrench, const Wrench& right, double share)
  {
    this->force += share * glm::distance(wrench.force, right.force) / glm::length(right.force);
    this->torque += share * glm::distance(wrench.torque, right.torque) / glm::length(right.torque);
  }
};

void AddErrors(ReportContext& context, const DynamicScene& scene, const PointShell& truth,
  const std::vector<RigidPose>& poses, int points)
{
  const auto fixed = scene.body.Shell(points);
  DynamicPointShellSettings settings;
  settings.points = points;
  ShellErrors ofFixed, ofDynamic;
  double alive = 0.0;
  Timing time;
  const double share = 1.0 / static_cast<double>(poses.size());
  for (const RigidPose& pose : poses)
  {
    DynamicPointShell shell(scene.volume, scene.body.Map(), glm::dvec3(0.0), settings);
    for (int n = 0; n < 80; ++n)
      shell.Update(pose, 0.0);
    alive += share * shell.LastTick().points;
    const Wrench right = scene.Feel(pose, truth);
    Wrench felt;
    time = ThreadTimeOf(
      [&]
      {
        shell.Update(pose, 0.0);
        felt = scene.Feel(pose, shell.Points());
      });
    ofDynamic.Add(felt, right, share);
    ofFixed.Add(scene.Feel(pose, *fixed), right, share);
  }
  ReportRow row;
  row.id = IdAt("haptics.dynamic.error", points, 4096);
  row.value = ofDynamic.force / ofFixed.force;
  row.unit = "error of the dynamic / of the static shell";
  char text[200];
  std::snprintf(text, sizeof text, "static shell of %d points: off by %.2g of the force, %.2g of "
                                   "the torque",
    points, ofFixed.force, ofFixed.torque);
  row.rival = text;
  row.error = ofDynamic.force;
  row.errorUnit = "of the force";
  row.timeS = time.wallS;
  row.cpuS = time.cpuS;
  row.n = static_cast<int>(poses.size());
  std::snprintf(text, sizeof text,
    "128^3, poses pressed 0.5 to 1.5 mm, against %u points; room for %d, %.0f used; of the torque "
    "%.2g; aim 0.25",
    truth.LevelEnd(truth.Levels() - 1), points, alive, ofDynamic.torque / ofFixed.torque);
  row.data = text;
  row.bars = { { {}, 0.5 } };
  context.report.rows.push_back(row);
}

} // namespace

void TryDynamicShell(ReportContext& context)
{
  const bool quick = context.settings.quick;
  const DynamicScene scene;
  const auto truth = scene.body.Shell(quick ? 65'536 : 262'144, 7);
  for (const int mmPerS : { 100, 1000 })
    AddSpeed(context, scene, *truth, mmPerS);
  const auto rough = scene.body.Shell(4096, 3);
  std::mt19937_64 random(context.settings.seed);
  std::normal_distribution<double> normal;
  std::vector<RigidPose> poses;
  for (int n = 0; n < (quick ? 15 : 60); ++n)
  {
    double d[7];
    for (double& draw : d)
      draw = normal(random);
    const glm::dvec3 way = glm::normalize(glm::dvec3(d[0], d[1], d[2]));
    const glm::dvec3 axis = glm::normalize(glm::dvec3(d[3], d[4], d[5]));
    poses.push_back(
      scene.Touching(way, TurnBy(axis * std::abs(d[6])), *rough, 0.5 + 0.5 * (n % 3)));
  }
  for (const int points : { 1024, 4096, 16'384 })
    AddErrors(context, scene, *truth, poses, points);
}

} // namespace hasp
