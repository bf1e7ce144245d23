#pragma once
#include "Haptics/HapticStep.h"
#include "Reduction/FractureFit.h"
#include "Studies/OperatorHand.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace hasp
{

struct FracturedBlocks;

/// What somebody who puts fragments in place is like. Checked by PutInPlace.
struct OperatorSettings
{
  OperatorHandSettings hand{};
  double speedMmPerS = 30.0;     ///< of the free hand, [1, 500]
  double turnDegreesPerS = 40.0; ///< of it, [1, 1000]
  double approachMmPerS = 8.0;   ///< as long as nothing is felt, [0.5, 100]
  double aimMm = 2.0;            ///< so far is the place where it aims off the truth, [0, 100]
  double aimDegrees = 3.0;       ///< and turned, [0, 180]
  double pushN = 1.5;            ///< with which it feels, [0.1, 10]
  double comfortN = 3.5;         ///< where more is felt it backs off, > pushN, <= 20
  double yieldS = 0.5;           ///< in which it gives way to what pushes aside, [0.05, 60]
  double searchMm = 0.8;         ///< its first try to the side, [0.01, 20]
  double searchDegrees = 1.5;    ///< and turn, [0, 30]
  double dwellS = 0.35;          ///< of a try, [0.15, 5]
  double deeperMm = 0.02;        ///< less deep than so much is no gain, [0, 5]
  double seesMm = 0.02;          ///< standard deviation of the depth that it reads, [0, 5]
  int patience = 10;             ///< tries without gain before it is content, [1, 1000]
  double stillMmPerS = 3.0;      ///< a tool that is slower stands, [0.1, 100]
  double gapMm = 0.8;            ///< a wider gap, in the middle, is seen: it aims anew, [0.05, 20]
  double givesUpS = 40.0;        ///< in all, [1, 600]
};

/// Somebody of the kind: all that differs between people varies by half of it or so, by the seed.
OperatorSettings MakeOperator(std::uint64_t seed);
/// Throws std::invalid_argument with the value and its legal range.
void CheckOperator(const OperatorSettings& settings);

/// What is to be put together, and what is known of it.
struct OperatorTask
{
  std::function<std::unique_ptr<HapticScene>()> touch; ///< anew for each trial; the tool's axes are
                                                       ///< those of the group
  std::vector<GroupBody> moved;
  FitScene others;                   ///< what gaps are seen to
  RigidPose truth;                   ///< of the group, world: the aim is off from it
  glm::dvec3 push{ 0.0, 0.0, -1.0 }; ///< unit, world: the way in
  /// Less of the group's surface than this before the others, and it is not at its place: the gap
  /// counts as wide. In [0, 1].
  double leastSeen = 0.05;
};
/// Keeps its own hold of the pieces.
OperatorTask TaskOf(const FracturedBlocks& blocks);
/// Before its place: 12 to 18 mm out, up to 5 mm off to any side and turned by up to 15 degrees.
RigidPose StartBefore(const OperatorTask& task, std::uint64_t seed);

/// What the renderer offers in a trial.
struct OperatorHelp
{
  HapticStepSettings step = TouchSteps(); ///< its budget is not asked: all levels that are allowed
  int levels = 99;                        ///< of the shells at most, whatever they have, >= 1
  bool snap = false;                      ///< Snap-to-fit from the approach on
  /// Contact of the defaults, attraction that is felt, and limits of a Falcon-like device.
  static HapticStepSettings TouchSteps();
};

struct OperatorResult
{
  RigidPose pose;       ///< of the group, world, where it was let go
  double seconds = 0.0; ///< virtual
  bool content = false; ///< stopped by itself, with resistance, at rest and no gap seen; else the
                        ///< time was over: no fit
  int tries = 0;        ///< searches to the side
  int lifts = 0;        ///< times that it lifted the fragment off and aimed anew
  double largestForceN = 0.0;  ///< on the device
  std::uint64_t overLimit = 0; ///< ticks with more than the limits: to be 0
  std::uint64_t notFinite = 0; ///< ticks with what is no number: to be 0
  double meanPoints = 0.0;     ///< evaluated in a tick of contact
};

/// Puts a group of fragments in place through HapticStep, by ticks of virtual time: nobody sleeps.
///
/// It carries the fragment before the place where it aims, comes on until it feels it, and holds a
/// light push from then on. It gives way to what pushes aside, tries small moves to the side and
/// turns, keeps one that lets the fragment deeper in and goes on that way, goes back where it does
/// not, with ever smaller tries. It backs off from a force that is too large. It stops where
/// nothing has helped for `patience` tries, the push is opposed, the tool stands still, and no gap
/// is seen; where one is, it lifts the fragment off and aims anew. It never knows the truth but by
/// its aim, and by eyes that see gaps, which are the same whatever levels are felt.
///
/// seed: of the aim, the noise and the tries; noise is a function of time. The same bits always, on
/// one machine (contact kernels differ in last digits). Throws std::invalid_argument with the value
/// and its legal range, for a task without a group, and as HapticStep. WORKER, one core; 5 s of
/// virtual time a second or more with 16'384 points.
OperatorResult PutInPlace(const OperatorTask& task, const RigidPose& start,
  const OperatorSettings& settings, const OperatorHelp& help, std::uint64_t seed);

} // namespace hasp
