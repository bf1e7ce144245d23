#pragma once
#include "Grid/Progress.h"
#include "Haptics/SeatByContact.h"
#include "Tools/PartOnBone.h"

#include <memory>

namespace hasp
{

class PartWork;

/// The test fit of a part (thesis 4.2): what it touches when it is put on.

/// Makes the part anew, for the bone that it is held to: the whole scan's or a fragment's alone, as
/// the plan has it, and of that what lies around the part and its way. Throws as PartWork, and
/// where nothing is claimed of such a part: it is put on nothing. WORKER.
std::shared_ptr<const PartOnBone> MakePartOnBone(
  PartWork& work, PlanId object, const ProgressFunction& progress);

struct PartSeat
{
  Seat seat;
  double pointMm = 0.0; ///< how far apart the part's points are at most
};

/// Pushes it on by contact (SeatByContact.h), from PartOnBone::LiftMm off, without turning it.
/// Points are the part's triangles, halved until they are PointMm apart, and their corners;
/// distances are of the bone, sampled MapMm apart at most: about 0.03 of that off on smooth bone.
/// Throws what SeatByContact and DistanceOfVolume throw; Cancelled. Any thread; seconds, mostly for
/// the distances.
PartSeat SeatPart(const PartOnBone& body, const ProgressFunction& progress);

} // namespace hasp
