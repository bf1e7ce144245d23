#pragma once
#include "Grid/RigidPose.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace hasp
{

/// A haptic device as its motor sees it: a mass, friction, an encoder, a limit. Turns are alike
/// about every axis. Figures of public device tables and of Abbott and Okamura 2005; a model.
struct BenchDevice
{
  const char* name = "Falcon-like";
  double massKg = 0.12;
  double damping = 0.001;   ///< b, N s/mm
  double coulombN = 0.3;    ///< dry friction; 0 hides nothing
  double quantumMm = 0.043; ///< of the encoder; 0: exact
  double forceLimitN = 8.9; ///< by norm
  double leverMm = 30.0;    ///< inertia = mass lever^2, and so on: what a turn feels
  double torqueLimitNmm = 267.0;
};
BenchDevice FalconLike();
BenchDevice TouchLike();   ///< 0.045 kg, 0.3 N s/m, 55 um, 3.3 N
BenchDevice PremiumLike(); ///< 0.16 kg, 1.2 N s/m, 30 um, 22 N

/// A hand that holds it: more mass, and a spring and damper to where it means to be.
struct BenchHand
{
  const char* name = "loose";
  double massKg = 0.05;
  double damping = 0.001; ///< b_h, N s/mm
  double stiffness = 0.1; ///< N/mm
};
BenchHand NoHand(); ///< the device leans by its own weight: the worst
BenchHand LooseHand();
BenchHand FirmHand(); ///< 0.15 kg, 6 N s/m, 0.5 N/mm

/// One stroke of where the hand means to be. Strokes add up.
struct BenchStroke
{
  double atS = 0.0;
  double lastsS = 0.1;
  glm::dvec3 moveMm{ 0.0 };
  glm::dvec3 turn{ 0.0 }; ///< radians, a rotation vector; strokes' vectors add
  bool smooth = true;     ///< minimum jerk; else at one speed
};

/// When the renderer runs, and what goes wrong with it.
struct BenchClock
{
  double tickS = 0.001;
  int delayTicks = 1;     ///< of a wrench, on its way to the motors
  double dropped = 0.0;   ///< share of ticks whose wrench gets lost: the last one is held
  double jitter = 0.0;    ///< share of a tick by which the time between two of them varies, at most
  double pauseAtS = -1.0; ///< the renderer stalls then
  double pauseS = 0.0;
  std::uint32_t seed = 1;
};

struct BenchScene
{
  BenchDevice device;
  BenchHand hand;
  BenchClock clock;
  RigidPose start;               ///< of device, hand and tool
  glm::dvec3 speedMmPerS{ 0.0 }; ///< of the device at the start
  glm::dvec3 leanN{ 0.0 };       ///< a force that always pushes: weight
  std::vector<BenchStroke> strokes;
  double tremorMm = 0.0; ///< at 10 Hz, sideways and along
  double seconds = 3.0;
  double holdFromS = 1.5;      ///< the hold phase is from here to the end
  double deepLimitMm = 1e9;    ///< min(half a voxel, half of half a plate's thickness)
  double throughBelowZ = -1e9; ///< mm: a tool that ends below it went through its plate
  bool pressed = true;         ///< the tool is to touch in the hold phase
  double givenMj = 0.0;        ///< energy that the scene itself puts in: a tool that begins inside
  double recoveryLimitS = 0.05;
};

/// What is on trial: a tool in the renderer's hands.
class BenchRenderer
{
public:
  virtual ~BenchRenderer() = default;
  virtual void Place(const RigidPose& tool) = 0;
  /// What the device is to do from now on. timeS: since the start, for scenes that change.
  virtual Wrench Tick(const RigidPose& device, double timeS) = 0;
  /// The deepest point of the tool as the tick left it, mm, negative inside; what is unbalanced, in
  /// shares of the spring's limit.
  virtual double DeepestMm() = 0;
  virtual double Residual() = 0;
  virtual RigidPose Tool() const = 0;
};

/// Figures of one run.
struct BenchFigures
{
  double rippleMm = 0.0;    ///< RMS over 5 Hz in the hold phase, all axes; turns at the lever
  double spreadMm = 0.0;    ///< the same about its mean, slow motion too
  double growth = 0.0;      ///< ripple of its last third / of its first
  double correlation = 0.0; ///< highest autocorrelation between 20 and 500 Hz
  double forceRipple = 0.0; ///< RMS over 5 Hz / the device's limit
  double holdForceN = 0.0;  ///< mean norm in the hold phase
  double energyMj = 0.0;    ///< at the device's port, at the end
  double lowestEnergyMj = 0.0;
  ///@{
  /// Depths, so positive inside: -DeepestMm(), the largest of the whole run, and in the hold phase.
  double deepestMm = 0.0, holdDeepestMm = 0.0;
  ///@}
  double largestForceN = 0.0, largestTorqueNmm = 0.0;
  double longestFlightS = 0.0;   ///< off in the hold phase: a tool thrown off looks quiet
  double slowestRecoveryS = 0.0; ///< longest time on end that the tool was out of balance
  bool finite = true;
  RigidPose device, tool; ///< at the end
  double cpuS = 0.0;
};

/// Stable, in numbers. Each fault that is found; none: stable.
struct BenchVerdict
{
  /// Ripple over a quantum + 10 um, an envelope that grows, or out of contact for 20 ms while
  /// pressed.
  bool oscillates = false;
  bool givesEnergy = false; ///< E < -1 mJ - what was given; asked without dry friction only
  bool deep = false;        ///< beyond deepLimitMm in the hold phase
  bool through = false;     ///< below throughBelowZ
  bool overLimit = false;   ///< a wrench beyond the device's limits was asked for
  bool notFinite = false;
  bool slow = false; ///< out of balance for more than recoveryLimitS after the first contact

  bool Stable() const
  {
    return !this->oscillates && !this->givesEnergy && !this->deep && !this->through &&
           !this->overLimit && !this->notFinite && !this->slow;
  }
  std::string Faults() const; ///< "stable", or the faults' names
  bool operator==(const BenchVerdict&) const = default;
};

/// Runs hand, device and renderer in virtual time: the mechanics every 20 us by semi-implicit
/// Euler, the renderer once a tick, its wrench held between ticks. Deterministic. WORKER.
/// About 10 ms of CPU for a second of a point on a wall.
BenchFigures RunBench(const BenchScene& scene, BenchRenderer& renderer);
BenchVerdict Judge(const BenchScene& scene, const BenchFigures& figures);

} // namespace hasp
