#pragma once
#include "View/CellProp.h"
#include "View/FragmentWork.h"
#include "View/SceneEntries.h"
#include "View/SceneJob.h"

#include <map>
#include <memory>
#include <set>

namespace hasp
{

struct FragmentEntry
{
  FragmentShape shape; ///< of what is shown
  PlanId volume = 0;
  std::unique_ptr<CellProp> shown;
  FragmentShape failed; ///< that no voxels could be found of
};

/// Fragments of scans: each its own voxels' isosurface, where the reduction has it. Of a divided
/// one its pieces are shown, and itself until they are there, and again when they are undone.
/// Voxels are found on the WORKER, of all fragments that miss them in one job, and again when what
/// they come from has changed (FragmentShape), never when they move; until then the old ones stay.
///
/// Threads: RENDER.
class FragmentProps : public SceneEntries<FragmentEntry>
{
public:
  explicit FragmentProps(SceneContext& of) : SceneEntries(of), Job(of.jobs) {}

  vtkImageData* ImageOf(PlanId fragment) const;
  /// A fragment of the volume is there, seen or not.
  bool HasAny(PlanId volume) const;
  /// Some are, and no voxels are being found.
  bool AreThere() const;
  void Forget(); ///< another plan: other objects by the same ids

  bool Sync() override;
  void ListResources(ResourceList& list) const override;

private:
  using Shapes = std::map<PlanId, FragmentShape>;

  bool IsThere(const Plan& plan, PlanId fragment) const;
  bool HasPieces(const Plan& plan, PlanId fragment) const;
  void Place(const Plan& plan, const PlanFragment& fragment);
  void MakeMissing(const Shapes& missing);
  void Take(const Shapes& asked, const MadeFragments& made);

  SceneJob Job;
  Shapes Asked; ///< of the job
};

} // namespace hasp
