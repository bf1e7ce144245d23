#include "DynamicScene.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstdio>
#include <random>

namespace hasp
{
namespace
{

struct ShellErrors
{
  double force = 0.0, torque = 0.0;
  void Add(const Wrench& wrench, const Wrench& right, double share)
  {
    this->force += share * glm::distance(wrench.force, right.force) / glm::length(right.force);
    this->torque += share * glm::distance(wrench.torque, right.torque) / glm::length(right.torque);
  }
};

void AddRow(ReportContext& context, const DynamicScene& scene, const std::vector<RigidPose>& poses,
  int points)
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
    const Wrench right = scene.Feel(pose, *scene.truth);
    Wrench felt;
    const Timing tick = ThreadTimeOf(
      [&]
      {
        shell.Update(pose, 0.0);
        felt = scene.Feel(pose, shell.Points());
      });
    time.wallS += share * tick.wallS;
    time.cpuS += share * tick.cpuS;
    ofDynamic.Add(felt, right, share);
    ofFixed.Add(scene.Feel(pose, *fixed), right, share);
  }
  ReportRow row;
  row.id = IdAt("haptics.dynamic.error", points, 4096);
  row.value = ofDynamic.force / ofFixed.force;
  row.unit = "of the static shell's error of the force";
  char text[200];
  std::snprintf(text, sizeof text,
    "static shell of %d points: off by %.2g of the force, %.2g of "
    "the torque",
    points, ofFixed.force, ofFixed.torque);
  row.rival = text;
  row.error = ofDynamic.force;
  row.errorUnit = "of the force";
  row.timeS = time.wallS;
  row.cpuS = time.cpuS;
  row.n = static_cast<int>(poses.size());
  std::snprintf(text, sizeof text,
    "128^3, mean of poses pressed 0.5 to 1.5 mm, against %u points; room for %d, %.0f used; of "
    "the torque %.2g; time of a tick at rest; aim 0.25",
    scene.truth->LevelEnd(scene.truth->Levels() - 1), points, alive,
    ofDynamic.torque / ofFixed.torque);
  row.data = text;
  row.bars = { { {}, 0.5 } };
  context.report.rows.push_back(row);
}

} // namespace

void AddDynamicErrors(ReportContext& context, const DynamicScene& scene)
{
  const auto rough = scene.body.Shell(4096, 3);
  std::mt19937_64 random(context.settings.seed);
  std::normal_distribution<double> normal;
  std::vector<RigidPose> poses;
  for (int n = 0; n < (context.settings.quick ? 15 : 60); ++n)
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
    AddRow(context, scene, poses, points);
}

} // namespace hasp
