#ifndef PlanReduction_h
#define PlanReduction_h

#include "PlanRebuild.h"                       // for PlanImages
#include "Planning/PlanEdits.h"                // for PoseFragments
#include "Reduction/Assembly.h"                // for AssembledUnit
#include "Reduction/BakeFitBody.h"             // for FitBakeSettings
#include "vtkHaspFiltersSurgicalGuideModule.h" // for export macro

#include <map>    // for surfaces
#include <vector> // for fragments

/// A plan's fragments put together by themselves; free of VTK but for the export macro.
namespace hasp
{

struct PlanReductionSettings
{
  FitBakeSettings bake{};
  AssemblySettings assembly{};
  BoneShareSettings share{};
  /// That are put together, of one scan; empty: all that are kept, of the scan that the reference
  /// is of, and are no donor of a transplant. Locked ones stay where they are.
  std::vector<PlanId> fragments;
  /// Fragment that stays where it is although it is not locked; 0: none.
  PlanId reference = 0;
  /// Fragments of other bones: touched, and not fitted to, such as the cranium where a mandible is
  /// put together. Else a condyle would be drawn to its joint.
  std::vector<PlanId> obstacles;
  std::uint64_t seed = 1; ///< of the starts around each coarse pose
  /// Fragments that are surfaces (SurfaceSource), baked elsewhere, by their ids. Those that are not
  /// here take no part.
  std::map<PlanId, BakedFitBody> surfaces;
};

/// What moves as one: a fragment, or a group's fragments.
struct ReducedUnit
{
  PlanId group = 0; ///< 0: a fragment alone
  std::vector<PlanId> fragments;
  AssembledUnit assembled; ///< groupInWorld: a motion after the poses that the plan has
};

struct PlanReduction
{
  std::vector<ReducedUnit> units; ///< fixed ones first, then in the plan's order
  /// What was made of the fragments, in the order of bodies: to measure by.
  std::vector<PlanId> fragments;
  std::vector<BakedFitBody> bodies;
  double softValue = 0.0; ///< that half levels were measured from
  double bakedMs = 0.0, assembledMs = 0.0;
};

/// Puts the fragments of a plan together from where it has them (Assemble): the poses that it has
/// are the coarse ones. Faces are fitted where the scan saw half (ShareBone), not at the isovalue.
///
/// images   the scan and the segmentations of the fragments
/// Throws std::invalid_argument (settings; no reference: none is locked or named; a fragment that
/// is not there, resected or cut in pieces, or of another scan; nothing to move) and
/// std::runtime_error (a fragment without bone); messages name objects by kind and id, and no text
/// of the plan; Cancelled. Any thread; all cores, the same bits with any number of them. 1 s a
/// fragment, and 25 bytes a voxel of the scan.
VTKHASPFILTERSSURGICALGUIDE_EXPORT PlanReduction ReducePlan(const Plan& plan,
  const PlanImages& images, const PlanReductionSettings& settings = {},
  const ProgressFunction& progress = {});

/// The edit that puts placed units where they were fitted, with proposal `proposals[n]` of unit n
/// instead of the likeliest where that is not 0. No pose for what was not placed, or is fixed.
VTKHASPFILTERSSURGICALGUIDE_EXPORT PoseFragments ReductionEdit(
  const Plan& plan, const PlanReduction& reduction, const std::vector<std::size_t>& proposals = {});

} // namespace hasp

#endif
