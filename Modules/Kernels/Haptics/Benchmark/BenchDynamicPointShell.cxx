// The dynamic point shell: what a tick costs, how soon a contact is covered, and how wrong its
// wrench is beside a static shell's of as many points.
// Usage: BenchKernelDynamicPointShell [poses of the error rows, default 60]
//
// Microseconds of processor time, one core. Errors: of force and torque, relative to a static shell
// of 262,144 points; means over poses in which two bumpy balls, 128 samples wide, touch by 0.5 to
// 1.5 mm. The dynamic shell has room for as many points as the static one has; it uses fewer.
#include "Benchmark/DynamicTicks.h"
#include "Haptics/DynamicPointShell.h"
#include "Haptics/PointShell.h"
#include "Haptics/Testing/SampledDistance.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

namespace
{

using namespace hasp;
using namespace hasp::testing;

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

struct Quartiles
{
  double low, middle, high;
};
Quartiles QuartilesOf(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t last = values.size() - 1;
  return { values[last / 4], values[last / 2], values[last * 3 / 4] };
}

/// Of one way: rounds of both, one after the other, so that what else the machine does meets both.
void ReportTicks(int samples, ticks::Way way, const char* name)
{
  const auto lanes = ticks::lanes::Make(samples), plain = ticks::plain::Make(samples);
  constexpr int Rounds = 41, TicksARound = 48;
  std::vector<double> update, both, lanesUpdate, lanesEvaluate, plainUpdate, plainEvaluate;
  double apart = 0.0, largest = 0.0;
  unsigned points = 0, contacts = 0;
  for (int round = -1; round < Rounds; ++round) // the first one fills the shell
  {
    ticks::Tick fast, slow;
    for (int n = 0; n < TicksARound; ++n)
    {
      const int number = (round + 1) * TicksARound + n;
      const ticks::Tick a = lanes->Run(way, number), b = plain->Run(way, number);
      fast.updateUs += a.updateUs / TicksARound;
      fast.evaluateUs += a.evaluateUs / TicksARound;
      slow.updateUs += b.updateUs / TicksARound;
      slow.evaluateUs += b.evaluateUs / TicksARound;
      const glm::dvec3 x(a.force[0], a.force[1], a.force[2]), y(b.force[0], b.force[1], b.force[2]);
      apart = std::max(apart, glm::distance(x, y));
      largest = std::max(largest, glm::length(y));
      points = a.points;
      contacts = a.contacts;
    }
    if (round < 0)
      continue;
    lanesUpdate.push_back(fast.updateUs);
    lanesEvaluate.push_back(fast.evaluateUs);
    plainUpdate.push_back(slow.updateUs);
    plainEvaluate.push_back(slow.evaluateUs);
    update.push_back(slow.updateUs / fast.updateUs);
    both.push_back((slow.updateUs + slow.evaluateUs) / (fast.updateUs + fast.evaluateUs));
  }
  const Quartiles u = QuartilesOf(update), q = QuartilesOf(both);
  std::printf("%4d %-12s %7.1f %7.1f  %7.1f %7.1f   %5.2f %5.2f %5.2f   %5.2f %5.2f %5.2f  %6u %5u"
              "  %7.1e\n",
    samples, name, QuartilesOf(plainUpdate).middle, QuartilesOf(plainEvaluate).middle,
    QuartilesOf(lanesUpdate).middle, QuartilesOf(lanesEvaluate).middle, u.low, u.middle, u.high,
    q.low, q.middle, q.high, points, contacts, largest > 0.0 ? apart / largest : 0.0);
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
  std::printf(
    "us a tick (medians)    -O2: update, evaluate  vectors: both   update's ratio (quartiles)"
    "  whole ratio  points touching  forces apart\n");
  for (const int samples : { 128, 256 })
  {
    ReportTicks(samples, ticks::Way::Along, "100 mm/s");
    ReportTicks(samples, ticks::Way::Jumps, "jumps");
    ReportTicks(samples, ticks::Way::Isovalue, "isovalue");
  }
  ReportErrors(poses);
  return 0;
}
