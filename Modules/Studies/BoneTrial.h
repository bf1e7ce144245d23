#pragma once
#include "Studies/ReductionCases.h"
#include "Studies/SimulatedOperator.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace hasp
{

/// Of each body of a broken bone where it stands; none: it is out of the way.
using StandingBodies = std::vector<std::optional<RigidPose>>;

/// A piece of a broken bone, to be put where it belongs before those of its partners that stand.
/// What is no partner, as a joint's other bone, is out of the way.
///
/// The way in is where its faces look that meet what stands, their normals' mean; of a piece that
/// has faces all round, as of the vault, the way back from where it was scanned. It is held at
/// the middle of those faces, the group's origin. Keeps its own hold
/// of the bodies. Throws std::invalid_argument for a body that the bone has not, or that stands.
OperatorTask TaskOf(const ReductionCase& broken, std::size_t body, const StandingBodies& standing);

/// The moved bodies as somebody would take them: next comes always what has the largest faces with
/// what stands already, where it belongs. One that meets nothing comes last.
std::vector<std::size_t> OrderOfPieces(const ReductionCase& broken);

/// What one operator made of a broken bone.
struct BoneTrial
{
  std::vector<std::size_t> pieces;    ///< that were put in place, in this order
  std::vector<RigidPose> bodyInWorld; ///< of each of those, where it was let go
  double seconds = 0.0;               ///< of all, virtual
  int content = 0;                    ///< pieces that the operator left by itself, time not over
  std::uint64_t faults = 0;           ///< ticks beyond the limits or not finite: to be 0
};

/// One operator puts the first `most` pieces of OrderOfPieces in place (>= 1), one after the other,
/// each from StartBefore its place; those that it has let go stand where they are, as
/// well or badly as that is, and those that it has not taken yet are out of the way. `seed` is that
/// of the trial: aims, noise and tries. As PutInPlace, else; WORKER, one core.
BoneTrial PutBoneTogether(const ReductionCase& broken, const OperatorSettings& who,
  const OperatorHelp& help, std::uint64_t seed, std::size_t most = 100);

} // namespace hasp
