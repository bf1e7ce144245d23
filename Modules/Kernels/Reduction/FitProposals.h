#pragma once
#include "Reduction/FractureFit.h"

#include <cstdint>
#include <vector>

namespace hasp
{

struct ProposalSettings
{
  FitSettings fit{};
  int starts = 16;            ///< the coarse pose itself and others around it, [1, 100000]
  double startMm = 3.0;       ///< how far the coarse pose may be off, [0, 100]
  double startDegrees = 5.0;  ///< and turned, [0, 180]
  int most = 5;               ///< proposals that are given, [1, 20]
  double apartMm = 0.5;       ///< rms way between two that are not the same fit, (0, 100]
  double gapMm = 0.15;        ///< as MeasureSpread
  double spreadFactor = 0.45; ///< the same
};

/// A local fit, and how likely it is among all that were found.
struct FitProposal
{
  FractureFit fit;
  double share = 1.0;   ///< of all that were found together 1
  double startMm = 0.0; ///< rms way from the coarse pose
  int found = 0;        ///< starts that led to it
};

struct FitProposals
{
  std::vector<FitProposal> proposals; ///< the likeliest first; empty if nothing was touched at all
  /// Of the first proposal, the others counted in by their shares: the truth is no farther off, rms
  /// over the surface, at 95 %. With one proposal its own spread.
  double within95Mm = 0.0;
  /// The likeliest proposal is not twice as likely as the next: look at both.
  bool undecided = false;
};

/// Several local fits around a coarse pose, ranked. Starts: the pose, and others shifted and turned
/// at random (`seed`) within what it may be off, evenly in volume; all go down coarsely, those that
/// meet are one, and the best go on to the end.
///
/// A proposal's share is that of exp(-energy / T - (way / farthest)^2 / 2). T is the noise of
/// energies between two fits, from the number of patches of 5 mm that the best fit's faces have;
/// `way` is from the coarse pose, and `farthest` what that may be off. It is a model; how often it
/// is right is `reduction.top3` and `reduction.coverage` of `hasp report reduction`.
/// Errors as FitFracture; Cancelled. Any thread; all cores, the same bits with any number of them.
/// Some 0.3 s at the defaults.
FitProposals ProposeFits(std::span<const GroupBody> moved, const RigidPose& coarse,
  const FitScene& scene, const ProposalSettings& settings = {}, std::uint64_t seed = 1,
  const ProgressFunction& progress = {});

} // namespace hasp
