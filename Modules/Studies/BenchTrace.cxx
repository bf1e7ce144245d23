#include "Studies/BenchTrace.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hasp
{
namespace
{

constexpr double Unbalanced = 0.2; // of the limits: more than a tick's motion leaves

/// What is left above 5 Hz: less the mean of 200 ms around each sample, whose first zero is there.
std::vector<double> AboveFiveHertz(const std::vector<double>& samples, double tickS)
{
  const auto n = static_cast<std::ptrdiff_t>(samples.size());
  const std::ptrdiff_t half = std::max<std::ptrdiff_t>(1, std::llround(0.1 / tickS));
  if (n < 4 * half)
    return {};
  std::vector<double> sums(samples.size() + 1, 0.0);
  // About the first sample, so that millimetres far from the origin cost no digits.
  for (std::ptrdiff_t i = 0; i < n; ++i)
    sums[i + 1] = sums[i] + (samples[i] - samples[0]);
  std::vector<double> left;
  for (std::ptrdiff_t i = half; i + half < n; ++i)
    left.push_back(
      samples[i] - samples[0] - (sums[i + half] - sums[i - half]) / static_cast<double>(2 * half));
  return left;
}

double Squares(const std::vector<double>& v, std::size_t from, std::size_t to)
{
  double sum = 0.0;
  for (std::size_t i = from; i < to; ++i)
    sum += v[i] * v[i];
  return to > from ? sum / static_cast<double>(to - from) : 0.0;
}

double Variance(const std::vector<double>& v)
{
  double sum = 0.0, squares = 0.0;
  for (const double value : v)
  {
    sum += value - v[0];
    squares += (value - v[0]) * (value - v[0]);
  }
  const auto n = static_cast<double>(v.size());
  return v.empty() ? 0.0 : std::max(0.0, squares / n - sum * sum / (n * n));
}

/// Highest autocorrelation at lags of 2 to 50 ms, after the first that is not positive.
double Correlation(const std::vector<double>& v, double tickS)
{
  const double whole = Squares(v, 0, v.size()) * static_cast<double>(v.size());
  if (whole <= 0.0)
    return 0.0;
  bool fell = false;
  double highest = 0.0;
  for (auto lag = std::max<std::size_t>(1, std::llround(0.002 / tickS));
       lag <= std::min<std::size_t>(v.size() / 2, std::llround(0.05 / tickS)); ++lag)
  {
    double sum = 0.0;
    for (std::size_t i = lag; i < v.size(); ++i)
      sum += v[i] * v[i - lag];
    fell = fell || sum <= 0.0;
    if (fell)
      highest = std::max(highest, sum / whole);
  }
  return highest;
}

} // namespace

BenchTrace::BenchTrace(const BenchScene& scene) : Scene(scene) {}

void BenchTrace::Asked(const Wrench& wrench)
{
  const double force = glm::length(wrench.force), torque = glm::length(wrench.torque);
  this->Sums.finite = this->Sums.finite && std::isfinite(force) && std::isfinite(torque);
  this->Sums.largestForceN = std::max(this->Sums.largestForceN, force);
  this->Sums.largestTorqueNmm = std::max(this->Sums.largestTorqueNmm, torque);
}

void BenchTrace::Balance(double timeS, BenchRenderer& renderer)
{
  if (renderer.Residual() <= Unbalanced)
  {
    this->UnbalancedFromS = -1.0;
    return;
  }
  if (this->UnbalancedFromS < 0.0)
    this->UnbalancedFromS = timeS;
  this->Sums.slowestRecoveryS =
    std::max(this->Sums.slowestRecoveryS, timeS - this->UnbalancedFromS);
}

void BenchTrace::Tick(
  double timeS, const RigidPose& device, const Wrench& motors, BenchRenderer& renderer)
{
  const glm::dvec3 turned =
    RotationVector(device.orientation * glm::conjugate(this->Scene.start.orientation));
  if (this->HasLast)
  {
    // Exact for a wrench held over the tick.
    this->Sums.energyMj -=
      glm::dot(this->Held.force, device.position - this->Last.position) +
      glm::dot(this->Held.torque,
        RotationVector(device.orientation * glm::conjugate(this->Last.orientation)));
    this->Sums.lowestEnergyMj = std::min(this->Sums.lowestEnergyMj, this->Sums.energyMj);
  }
  this->Last = device;
  this->Held = motors;
  this->HasLast = true;
  this->Balance(timeS, renderer);
  const double deep = -renderer.DeepestMm();
  this->Sums.deepestMm = std::max(this->Sums.deepestMm, deep);
  if (timeS < this->Scene.holdFromS)
    return;
  this->Sums.holdDeepestMm = std::max(this->Sums.holdDeepestMm, deep);
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Hold[axis].push_back(device.position[axis]);
    this->Hold[axis + 3].push_back(this->Scene.device.leverMm * turned[axis]);
  }
  this->HoldForce.push_back(glm::length(motors.force));
  if (deep > 0.0)
    this->TouchedAtS = timeS;
  this->Sums.longestFlightS =
    std::max(this->Sums.longestFlightS, timeS - std::max(this->TouchedAtS, this->Scene.holdFromS));
}

BenchFigures BenchTrace::Figures() const
{
  BenchFigures figures = this->Sums;
  const double tickS = this->Scene.clock.tickS;
  double ripple = 0.0, spread = 0.0, first = 0.0, last = 0.0, strongest = 0.0;
  for (const std::vector<double>& axis : this->Hold)
  {
    const std::vector<double> left = AboveFiveHertz(axis, tickS);
    const std::size_t n = left.size();
    const double squares = Squares(left, 0, n);
    ripple += squares;
    spread += Variance(axis);
    first += Squares(left, 0, n / 3);
    last += Squares(left, n - n / 3, n);
    if (squares > strongest)
    {
      strongest = squares;
      figures.correlation = Correlation(left, tickS);
    }
  }
  figures.rippleMm = std::sqrt(ripple);
  figures.spreadMm = std::sqrt(spread);
  figures.growth = first > 0.0 ? std::sqrt(last / first) : 0.0;
  const std::vector<double> force = AboveFiveHertz(this->HoldForce, tickS);
  figures.forceRipple = std::sqrt(Squares(force, 0, force.size())) / this->Scene.device.forceLimitN;
  if (!this->HoldForce.empty())
    figures.holdForceN = std::accumulate(this->HoldForce.begin(), this->HoldForce.end(), 0.0) /
                         static_cast<double>(this->HoldForce.size());
  return figures;
}

BenchVerdict Judge(const BenchScene& scene, const BenchFigures& figures)
{
  const double most = scene.device.quantumMm + 0.010;
  BenchVerdict verdict;
  verdict.notFinite = !figures.finite;
  // An envelope that grows will get there; quanta alone make it wander at small size.
  verdict.oscillates = !(figures.rippleMm < most) ||
                       (figures.growth > 2.0 && figures.rippleMm > 0.5 * most) ||
                       (scene.pressed && figures.longestFlightS > 0.020);
  verdict.givesEnergy =
    scene.device.coulombN == 0.0 && figures.lowestEnergyMj < -1.0 - scene.givenMj;
  verdict.deep = figures.holdDeepestMm > scene.deepLimitMm;
  verdict.through = figures.tool.position.z < scene.throughBelowZ;
  verdict.overLimit = figures.largestForceN > scene.device.forceLimitN * (1.0 + 1e-9) ||
                      figures.largestTorqueNmm > scene.device.torqueLimitNmm * (1.0 + 1e-9);
  verdict.slow = figures.slowestRecoveryS > scene.recoveryLimitS;
  return verdict;
}

std::string BenchVerdict::Faults() const
{
  std::string faults;
  const auto add = [&](bool found, const char* name)
  {
    if (!found)
      return;
    if (!faults.empty())
      faults += '+';
    faults += name;
  };
  add(this->oscillates, "oscillates");
  add(this->givesEnergy, "energy");
  add(this->deep, "deep");
  add(this->through, "through");
  add(this->overLimit, "over limit");
  add(this->notFinite, "not finite");
  add(this->slow, "slow");
  return faults.empty() ? "stable" : faults;
}

} // namespace hasp
