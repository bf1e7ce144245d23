// The dynamic point shell: what a tick costs, how soon a contact is covered, and how wrong its
// wrench is beside a static shell's of as many points.
// Usage: BenchKernelDynamicPointShell [poses of the error rows, default 60]
//
// Microseconds of processor time, one core. Errors: of force and torque, relative to a static shell
// of 262,144 points; means over poses in which two bumpy balls, 128 samples wide, touch by 0.5 to
// 1.5 mm. The dynamic shell has room for as many points as the static one has; it uses fewer.
#include "Haptics/DynamicPointShell.h"
#include "Haptics/PointShell.h"
#include "Haptics/Testing/SampledDistance.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <vector>

namespace
{

using namespace hasp;
using namespace hasp::testing;

double ProcessorMicroseconds()
{
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e6 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_nsec);
}

/// A body that touches itself: its distances, its map, and a volume for shells.
struct Body
{
  std::shared_ptr<SampledDistance> field;
  std::shared_ptr<const DistanceMap> map;
  ShellVolume volume;

  explicit Body(int samples)
    : field(std::make_shared<SampledDistance>(
        BumpyBall(0.35 * samples, 0.02 * samples), CubeGrid(samples))),
      map(std::make_shared<DistanceMap>(this->field->View()))
  {
    this->volume.grid = this->field->View();
    this->volume.blocks = std::make_shared<MinMaxBlocks>(this->volume.grid);
    this->volume.owner = this->field;
    this->volume.insideAbove = false;
  }
};

Wrench Evaluate(const DistanceMap& map, const RigidPose& pose, const ContactPoints& points)
{
  Wrench sum;
  for (std::uint32_t n = 0; n < points.count; ++n)
  {
    if (points.x[n] == ContactPoints::FarAway)
      continue;
    const glm::dvec3 place = pose.Place({ points.x[n], points.y[n], points.z[n] });
    const double mm = map.At(place).mm;
    if (mm >= 0.0)
      continue;
    const double area = points.areas != nullptr ? points.areas[n] : points.area;
    const glm::dvec3 force = mm * area * pose.Turn({ points.nx[n], points.ny[n], points.nz[n] });
    sum += { force, glm::cross(place - pose.position, force) };
  }
  return sum;
}

/// In some direction, just touching, then pressed in by `deep`.
RigidPose TouchingPose(
  const Body& body, const ContactPoints& points, std::mt19937& random, double deep)
{
  std::normal_distribution<double> normal;
  const auto draw = [&] { return glm::dvec3(normal(random), normal(random), normal(random)); };
  const glm::dvec3 way = glm::normalize(draw());
  RigidPose pose{ way, TurnBy(glm::normalize(draw()) * std::abs(normal(random))) };
  const double width = body.field->geometry.dims.x;
  double near = 0.5 * width, far = width;
  while (far - near > 0.01)
  {
    pose.position = 0.5 * (near + far) * way;
    const bool touches = glm::length(Evaluate(*body.map, pose, points).force) > 0.0;
    (touches ? near : far) = 0.5 * (near + far);
  }
  pose.position = (near - deep) * way;
  return pose;
}

void ReportTicks(int samples)
{
  const Body body(samples);
  DynamicPointShell shell(body.volume, body.map, {});
  double jump = 0.0, filling = 0.0, rest = 0.0, moving = 0.0, isovalue = 0.0;
  const auto tick = [&](const RigidPose& pose)
  {
    const double start = ProcessorMicroseconds();
    shell.Update(pose, 0.0);
    return ProcessorMicroseconds() - start;
  };
  constexpr int Rounds = 20;
  for (int round = 0; round < Rounds; ++round)
  {
    const double a = round;
    RigidPose pose{ 0.69 * samples * glm::dvec3(std::cos(a), std::sin(a), 0.0), TurnBy({}) };
    jump += tick(pose) / Rounds;
    for (int n = 0; n < 10; ++n)
      filling += tick(pose) / (10 * Rounds);
    for (int n = 0; n < 60; ++n)
      tick(pose);
    for (int n = 0; n < 10; ++n)
      rest += tick(pose) / (10 * Rounds);
    for (int n = 0; n < 50; ++n)
    {
      pose.position += glm::dvec3(-0.1 * std::sin(a), 0.1 * std::cos(a), 0.0); // 100 mm/s
      moving += tick(pose) / (50 * Rounds);
    }
    shell.SetIsovalue(round % 2 == 0 ? 0.5 : 0.0);
    isovalue += tick(pose) / Rounds;
  }
  std::printf(
    "%4d  jump %6.0f   filling %6.0f   at rest %6.1f   100 mm/s %6.1f   another isovalue %6.0f\n",
    samples, jump, filling, rest, moving, isovalue);
}

void ReportErrors(int poses)
{
  const Body body(128);
  const auto truth = PointShell::OfSurface(body.field->View(), {}, { 262'144, 262'144, 7 });
  const auto rough = PointShell::OfSurface(body.field->View(), {}, { 65'536, 65'536, 1 });
  std::mt19937 random(1);
  std::vector<RigidPose> touching;
  for (int n = 0; n < poses; ++n)
    touching.push_back(TouchingPose(body, rough->Level(0), random, 0.5 + 0.5 * (n % 3)));
  std::printf(
    "points   static: force   torque   dynamic: points   force   torque   dynamic/static\n");
  for (const int points : { 1024, 4096, 16'384 })
  {
    const auto fixed = PointShell::OfSurface(body.field->View(), {}, { points, points, 1 });
    DynamicPointShellSettings settings;
    settings.points = points;
    glm::dvec2 ofFixed(0.0), ofDynamic(0.0);
    double alive = 0.0;
    for (const RigidPose& pose : touching)
    {
      DynamicPointShell shell(body.volume, body.map, {}, settings);
      for (int n = 0; n < 80; ++n)
        shell.Update(pose, 0.0);
      alive += static_cast<double>(shell.LastTick().points) / poses;
      const Wrench right = Evaluate(*body.map, pose, truth->Level(0));
      const auto off = [&](const ContactPoints& p)
      {
        const Wrench w = Evaluate(*body.map, pose, p);
        return glm::dvec2(glm::distance(w.force, right.force) / glm::length(right.force),
                 glm::distance(w.torque, right.torque) / glm::length(right.torque)) /
               static_cast<double>(poses);
      };
      ofFixed += off(fixed->Level(0));
      ofDynamic += off(shell.Points());
    }
    std::printf("%6d          %7.4f  %7.4f           %7.0f %7.4f  %7.4f     %5.2f %5.2f\n", points,
      ofFixed.x, ofFixed.y, alive, ofDynamic.x, ofDynamic.y, ofDynamic.x / ofFixed.x,
      ofDynamic.y / ofFixed.y);
  }
}

} // namespace

int main(int argc, char** argv)
{
  const int poses = argc > 1 ? std::atoi(argv[1]) : 60;
  if (poses < 1 || poses > 10'000)
  {
    std::fprintf(stderr, "poses: 1 to 10000\n");
    return 2;
  }
  std::printf("us a tick, 16,384 points' room, 512 a tick\n");
  for (const int samples : { 128, 256 })
    ReportTicks(samples);
  ReportErrors(poses);
  return 0;
}
