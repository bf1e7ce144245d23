#include "Studies/SampledLoop.h"

#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace hasp
{
namespace
{

constexpr double Metre = 1000.0;
constexpr double StepS = 20e-6;

using State = std::vector<double>; // x, v, then forces on their way, oldest first, then the tool's

/// A tick of device and hand under `force`, as the bench moves them.
void Move(const SampledLoop& loop, State& s, double force)
{
  const int steps = static_cast<int>(std::lround(loop.tickS / StepS));
  const double dt = loop.tickS / steps;
  for (int step = 0; step < steps; ++step)
  {
    s[1] += (force - loop.damping * s[1] - loop.handStiffness * s[0]) * dt * Metre / loop.massKg;
    s[0] += s[1] * dt;
  }
}

/// The force on the motors when `fresh` enters the line.
double Delayed(const SampledLoop& loop, State& s, double fresh)
{
  if (loop.delayTicks == 0)
    return fresh;
  const double held = s[2];
  for (int i = 0; i + 1 < loop.delayTicks; ++i)
    s[2 + i] = s[3 + i];
  s[1 + loop.delayTicks] = fresh;
  return held;
}

/// Largest |eigenvalue| of a linear tick: the growth of its powers, by squaring 2^24 times.
double Radius(std::size_t n, const std::function<void(State&)>& tick)
{
  std::vector<double> a(n * n);
  for (std::size_t column = 0; column < n; ++column)
  {
    State s(n, 0.0);
    s[column] = 1.0;
    tick(s);
    for (std::size_t row = 0; row < n; ++row)
      a[row * n + column] = s[row];
  }
  double logarithm = 0.0, power = 1.0; // of what was divided out
  for (int squaring = 0; squaring < 24; ++squaring)
  {
    double norm = 0.0;
    for (const double value : a)
      norm += value * value;
    norm = std::sqrt(norm);
    if (norm == 0.0)
      return 0.0;
    for (double& value : a)
      value /= norm;
    logarithm += std::log(norm) / power;
    std::vector<double> square(n * n, 0.0);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < n; ++k)
        for (std::size_t j = 0; j < n; ++j)
          square[i * n + j] += a[i * n + k] * a[k * n + j];
    a = square;
    power *= 2.0;
  }
  return std::exp(logarithm);
}

} // namespace

SampledLoop::SampledLoop(const BenchDevice& device, const BenchHand& hand, const BenchClock& clock)
  : massKg(device.massKg + hand.massKg),
    damping(device.damping + hand.damping),
    handStiffness(hand.stiffness),
    tickS(clock.tickS),
    delayTicks(clock.delayTicks)
{
}

double SampledLoop::SpringRadius(double stiffness) const
{
  return Radius(2 + static_cast<std::size_t>(this->delayTicks),
    [&](State& s) { Move(*this, s, Delayed(*this, s, -stiffness * s[0])); });
}

double SampledLoop::ExplicitRadius(
  const ExplicitCouplingSettings& coupling, double contactStiffness) const
{
  const std::size_t tool = 2 + static_cast<std::size_t>(this->delayTicks);
  const double k = coupling.spring.stiffness, b = coupling.damping, dt = coupling.tickS;
  return Radius(tool + 3, [&](State& s) { // tool, its speed, the device a tick ago
    const double speed = (s[0] - s[tool + 2]) / dt;
    const double pull = k * (s[0] - s[tool]) + b * (speed - s[tool + 1]);
    s[tool + 2] = s[0];
    s[tool + 1] += (pull - contactStiffness * s[tool]) * dt * Metre / coupling.massKg;
    s[tool] += dt * s[tool + 1];
    Move(*this, s, Delayed(*this, s, -pull));
  });
}

double SampledLoop::CriticalSpring() const
{
  double low = 1e-4, high = 1e4;
  for (int i = 0; i < 60; ++i)
  {
    const double middle = std::sqrt(low * high);
    (this->SpringRadius(middle) < 1.0 ? low : high) = middle;
  }
  return low;
}

double SampledLoop::FormulaSpring() const
{
  return StableStiffness(this->damping, this->tickS, this->delayTicks * this->tickS, 1.0);
}

} // namespace hasp
