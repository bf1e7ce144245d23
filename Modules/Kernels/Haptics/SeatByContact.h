#pragma once
#include "Grid/Progress.h"
#include "Grid/RigidPose.h"
#include "Haptics/HapticScene.h"
#include "Haptics/PointShell.h"

#include <cstddef>
#include <span>

namespace hasp
{

struct SeatSettings
{
  glm::dvec3 withdrawal{ 0.0, 0.0, 1.0 }; ///< unit, world: the part lifts off along it
  double liftMm = 30.0; ///< the push begins so far off its planned place, [0, 1000]
  double pressMm = 3.0; ///< and goes on beyond that at most so far, [0, 1000]
  /// A point touches where bone's surface is nearer than this; within every map's range. 0: as
  /// soon as a hand would feel it. Below 0: only so deep in bone, for parts that were planned
  /// without a gap, whose every wall along the way would touch for a digit. Above 0 points touch
  /// sooner: what is stopped at 0 and is this far off shall be stopped.
  double touchMm = 0.0;
};

/// Where a part comes to rest that is put on.
struct Seat
{
  /// It touches, and not before its planned place: depthMm >= 0. A part that touches nothing has no
  /// seat.
  bool seats = false;
  bool touched = false; ///< false: nothing on all of the way; of what follows only depthMm is set
  /// Of the first touch: the way beyond its planned place, against the withdrawal; below 0 it is
  /// stopped so far before. -liftMm: it touches already where the push begins (it was not lifted
  /// far enough, or not off). Without a touch pressMm: so far, and farther. mm.
  double depthMm = 0.0;
  glm::dvec3 partAt{ 0.0 }; ///< the part's point that touches first, where it is planned; world
  glm::dvec3 boneAt{ 0.0 }; ///< where it touches: partAt - depthMm * withdrawal
  std::size_t bone = 0;     ///< the one that it touches
  /// Points of the part that touch no more than TogetherMm of way later, were it to go on: few of a
  /// part that would rock.
  std::size_t points = 0;
  static constexpr double TogetherMm = 0.05;
};

/// The test fit of a part before it is printed (thesis 4.2): pushes it against bone, straight along
/// its withdrawal direction and without a turn, until it touches. What it touches with are all
/// points of all levels, and what it touches the distance maps: the contact that a hand feels with
/// the same shell and maps (HapticScene), where distances fall below touchMm. So undercuts stop it
/// on its way.
///
/// partInWorld  of the shell's axes, as the part is planned
/// bones        none, or a shell without points: nothing is touched
///
/// No tunnels: each point goes by no more than its distance to bone (MapClearance), so that bone as
/// thin as maps can show stops it; nearer than an eighth of the smallest spacing s it goes by that,
/// and what it only grazes may be missed: (s / 8)^2 / (8 r) deep of bone as round as a ball of
/// radius r, some micrometres. The touch is found within 0.001 mm of way.
/// Error of depthMm: of the map's surface (BodyDistance.h; a distance transform's error, and
/// about s^2 / (4 r) that interpolation takes from a ball) over the cosine of the bone's normal
/// with the withdrawal: walls along the way are known least well. And bone between the points,
/// which lie d apart, is met up to d^2 / (8 r) too late, r of bone or part: take points of the
/// part's mesh (Evaluation/MeshSamples.h) where its edges shall touch, which shells of a distance
/// round.
///
/// Throws std::invalid_argument, with what is wrong, its value and its range: a withdrawal that is
/// not unit within 1e-3, settings out of range, poses that are none (IsPose), a bone without a map;
/// Cancelled. Any thread; one core; memory: 8 bytes for each point that is near the first touch.
/// Some milliseconds for 16,384 points (TestSeatByContact records them), some tenths of a second
/// for the 240,000 of a guide's own mesh (TestGuideSeat).
Seat SeatByContact(const PointShell& part, const RigidPose& partInWorld,
  std::span<const HapticBody> bones, const SeatSettings& settings,
  const ProgressFunction& progress = {});

} // namespace hasp
