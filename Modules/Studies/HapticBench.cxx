#include "Studies/HapticBench.h"
#include "Studies/BenchTrace.h"
#include "Studies/CpuSeconds.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <random>

namespace hasp
{
namespace
{

constexpr double StepS = 20e-6;
constexpr double Metre = 1000.0;    // mm; N = kg m/s^2
constexpr double StictionMmS = 1.0; // dry friction is full at a few of it

struct Wanted
{
  glm::dvec3 move{ 0.0 }, speed{ 0.0 }, turn{ 0.0 }, turning{ 0.0 };
};

/// Where the hand means to be, beyond its start.
Wanted Intention(const BenchScene& scene, double t)
{
  Wanted wanted;
  for (const BenchStroke& stroke : scene.strokes)
  {
    const double u = std::clamp((t - stroke.atS) / stroke.lastsS, 0.0, 1.0);
    const bool moves = u > 0.0 && u < 1.0;
    const double way = stroke.smooth ? u * u * u * (10.0 - u * (15.0 - 6.0 * u)) : u;
    const double rate =
      !moves ? 0.0 : (stroke.smooth ? 30.0 * u * u * (1.0 - u) * (1.0 - u) : 1.0) / stroke.lastsS;
    wanted.move += way * stroke.moveMm;
    wanted.speed += rate * stroke.moveMm;
    wanted.turn += way * stroke.turn;
    wanted.turning += rate * stroke.turn;
  }
  if (scene.tremorMm > 0.0)
  {
    const double w = 2.0 * std::numbers::pi * 10.0;
    const glm::dvec3 axis(0.6, 0.0, 0.8);
    wanted.move += scene.tremorMm * std::sin(w * t) * axis;
    wanted.speed += scene.tremorMm * w * std::cos(w * t) * axis;
  }
  return wanted;
}

glm::dvec3 Clamped(const glm::dvec3& v, double limit)
{
  const double length = glm::length(v);
  return length > limit ? v * (limit / length) : v;
}

/// Hand and device together, between two ticks.
class Mechanics
{
public:
  Mechanics(const BenchScene& scene)
    : Scene(scene),
      Pose(scene.start),
      Speed(scene.speedMmPerS),
      MassKg(scene.device.massKg + scene.hand.massKg),
      Turns(std::any_of(scene.strokes.begin(), scene.strokes.end(),
        [](const BenchStroke& stroke) { return stroke.turn != glm::dvec3(0.0); }))
  {
  }

  void Step(double t, double dt, const Wrench& motors)
  {
    const BenchDevice& device = this->Scene.device;
    const BenchHand& hand = this->Scene.hand;
    const Wanted wanted = Intention(this->Scene, t);
    const double lever2 = device.leverMm * device.leverMm;
    const glm::dvec3 force =
      motors.force + this->Scene.leanN +
      hand.stiffness * (this->Scene.start.position + wanted.move - this->Pose.position) +
      hand.damping * (wanted.speed - this->Speed) - device.damping * this->Speed -
      this->Dry(this->Speed, device.coulombN);
    this->Speed += force * (dt * Metre / this->MassKg);
    this->Pose.position += this->Speed * dt;

    const bool turning =
      this->Turns || this->Turning != glm::dvec3(0.0) || motors.torque != glm::dvec3(0.0);
    if (!turning)
      return;
    const glm::dquat goal = TurnBy(wanted.turn) * this->Scene.start.orientation;
    const glm::dvec3 torque =
      motors.torque +
      lever2 * (hand.stiffness * RotationVector(goal * glm::conjugate(this->Pose.orientation)) +
                 hand.damping * (wanted.turning - this->Turning) - device.damping * this->Turning) -
      device.leverMm * this->Dry(device.leverMm * this->Turning, device.coulombN);
    this->Turning += torque * (dt * Metre / (this->MassKg * lever2));
    this->Pose.orientation = glm::normalize(TurnBy(this->Turning * dt) * this->Pose.orientation);
  }

  const RigidPose& Device() const { return this->Pose; }
  /// What its encoders tell.
  RigidPose Read() const
  {
    const double q = this->Scene.device.quantumMm;
    if (q <= 0.0)
      return this->Pose;
    const auto rounded = [](const glm::dvec3& v, double quantum)
    {
      return glm::dvec3(
               std::round(v.x / quantum), std::round(v.y / quantum), std::round(v.z / quantum)) *
             quantum;
    };
    RigidPose read{ rounded(this->Pose.position, q), this->Pose.orientation };
    if (this->Pose.orientation != this->Scene.start.orientation)
      read.orientation =
        TurnBy(rounded(RotationVector(this->Pose.orientation), q / this->Scene.device.leverMm));
    return read;
  }
  bool Finite() const
  {
    return glm::length(this->Pose.position) < 1e7 && glm::length(this->Turning) < 1e7;
  }

private:
  static glm::dvec3 Dry(const glm::dvec3& speed, double most)
  {
    return most == 0.0
             ? glm::dvec3(0.0)
             : speed * (most / std::sqrt(glm::dot(speed, speed) + StictionMmS * StictionMmS));
  }

  const BenchScene& Scene;
  RigidPose Pose;
  glm::dvec3 Speed, Turning{ 0.0 };
  double MassKg;
  bool Turns;
};

/// The wrenches on their way to the motors.
class DelayLine
{
public:
  explicit DelayLine(int ticks) : Line(static_cast<std::size_t>(ticks)) {}
  Wrench Pass(const Wrench& in)
  {
    this->Line.push_back(in);
    const Wrench out = this->Line.front();
    this->Line.pop_front();
    return out;
  }

private:
  std::deque<Wrench> Line;
};

} // namespace

BenchDevice FalconLike()
{
  return {};
}
BenchDevice TouchLike()
{
  return { "Touch-like", 0.045, 0.0003, 0.15, 0.055, 3.3, 30.0, 99.0 };
}
BenchDevice PremiumLike()
{
  return { "Premium-like", 0.16, 0.0012, 0.2, 0.030, 22.0, 30.0, 660.0 };
}
BenchHand NoHand()
{
  return { "none", 0.0, 0.0, 0.0 };
}
BenchHand LooseHand()
{
  return {};
}
BenchHand FirmHand()
{
  return { "firm", 0.15, 0.006, 0.5 };
}

BenchFigures RunBench(const BenchScene& scene, BenchRenderer& renderer)
{
  const double began = CpuSeconds();
  const BenchClock& clock = scene.clock;
  Mechanics mechanics(scene);
  DelayLine line(clock.delayTicks);
  BenchTrace trace(scene);
  std::mt19937 random(clock.seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  renderer.Place(scene.start);

  const double dt = clock.tickS / std::max(1.0, std::round(clock.tickS / StepS));
  const auto steps = static_cast<std::int64_t>(std::llround(scene.seconds / dt));
  const auto perTick = static_cast<double>(std::llround(clock.tickS / dt));
  Wrench motors;
  double next = 0.0; // in steps
  std::int64_t tick = 0;
  for (std::int64_t step = 0; step < steps; ++step)
  {
    const double t = static_cast<double>(step) * dt;
    if (static_cast<double>(step) >= next)
    {
      const bool lost = clock.dropped > 0.0 && share(random) < clock.dropped;
      ++tick;
      next = static_cast<double>(tick) * perTick;
      if (clock.jitter > 0.0) // half of it each, about its nominal time: they do not add up
        next = std::max(static_cast<double>(step + 1),
          next + clock.jitter * (2.0 * share(random) - 1.0) * 0.5 * perTick);
      const bool paused = t >= clock.pauseAtS && t < clock.pauseAtS + clock.pauseS;
      if (!paused)
      {
        const Wrench asked = renderer.Tick(mechanics.Read(), t);
        trace.Asked(asked);
        if (!lost)
        {
          motors = line.Pass(asked);
          motors = { Clamped(motors.force, scene.device.forceLimitN),
            Clamped(motors.torque, scene.device.torqueLimitNmm) };
        }
      }
      trace.Tick(t, mechanics.Device(), motors, renderer);
    }
    mechanics.Step(t, dt, motors);
    if (!mechanics.Finite())
      break;
  }
  BenchFigures figures = trace.Figures();
  figures.finite = figures.finite && mechanics.Finite();
  figures.device = mechanics.Device();
  figures.tool = renderer.Tool();
  figures.cpuS = CpuSeconds() - began;
  return figures;
}

} // namespace hasp
