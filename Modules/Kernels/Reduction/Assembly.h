#pragma once
#include "Reduction/FitProposals.h"

#include <optional>
#include <vector>

namespace hasp
{

/// Bodies that move as one, a fragment or a group of them, where they stand before anything is put
/// together.
struct AssemblyUnit
{
  std::vector<GroupBody> bodies; ///< one or more
  RigidPose groupInWorld;        ///< coarse, unless fixed
  bool fixed = false;            ///< the reference: it stays where it is
  /// Units whose faces attract this one's; the others are only touched. Empty: all others. Spreads
  /// go by the list of the first of two.
  std::vector<std::size_t> partners;
};

struct AssemblySettings
{
  ProposalSettings proposals{};
  int rounds = 3; ///< in which all are fitted once more, to all others, [0, 100]
  /// A unit that is in touch with less is not placed: mm^2 of faces, weighted as they attract.
  double leastFacesMm2 = 10.0; ///< >= 0
};

struct AssembledUnit
{
  RigidPose groupInWorld;
  bool placed = false;     ///< or fixed; if not, it is where it was
  int turn = 0;            ///< in which it was placed: 0 fixed, then 1, 2 ...
  FitProposals proposals;  ///< when its turn came; none of fixed ones
  FractureFit fit;         ///< at the end, with its spread
  double within95Mm = 0.0; ///< of it; other proposals count by their shares (FitProposals)
};

/// Puts fragments together, one after the other: next comes the unit that goes most deeply with
/// what stands already (the fixed ones, or the largest unit if none is fixed), and goes where its
/// likeliest proposal is; what does not stand yet is left out. At last all are fitted again, each
/// before all others, so that errors do not pile up.
///
/// Greedy: a unit that goes to a wrong place stays near it. What is `placed` and how wide its
/// spread is say where to look. Throws std::invalid_argument as ProposeFits, and on a partner that
/// is none; Cancelled. Any thread; all cores, the same bits with any number of them. About 0.5 s
/// a unit with few neighbours.
std::vector<AssembledUnit> Assemble(std::span<const AssemblyUnit> units,
  const AssemblySettings& settings = {}, std::uint64_t seed = 1,
  const ProgressFunction& progress = {});

} // namespace hasp
