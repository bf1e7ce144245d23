#pragma once
#include "View/FragmentWork.h"
#include "View/MeshProp.h"
#include "View/SceneEntries.h"
#include "View/SceneJob.h"

#include <map>
#include <memory>

namespace hasp
{

/// All that a ghost comes from.
struct GhostShape
{
  std::string scan; ///< hash; empty: it cannot be made yet
  std::vector<FragmentShape> fragments;
  double isovalue = 0.0;
  std::optional<MirrorPlane> plane;

  bool operator==(const GhostShape&) const = default;
};

struct GhostEntry
{
  GhostShape shape, failed;
  std::unique_ptr<MeshProp> shown;
};

/// Mirrored ghosts, translucent and blue: made on the WORKER once they are shown, and again when
/// the bone that they mirror, its isovalue or the plane is another. Threads: RENDER.
class GhostProps : public SceneEntries<GhostEntry>
{
public:
  explicit GhostProps(SceneContext& of) : SceneEntries(of), Job(of.jobs) {}

  void Forget(); ///< another plan

  bool Sync() override;
  void ListResources(ResourceList& list) const override;

private:
  struct Made
  {
    vtkSmartPointer<vtkPolyData> mesh;
    std::string fault;
  };
  GhostShape ShapeOf(const PlanMirror& mirror) const;
  static Made Make(VoxelWork& work, const PlanMirror& mirror, const ProgressFunction& progress);
  void Place(PlanId mirror, const GhostEntry& entry);
  void MakeMissing(const std::map<PlanId, GhostShape>& missing);
  void Take(const std::map<PlanId, GhostShape>& asked, const std::map<PlanId, Made>& made);

  SceneJob Job;
  std::map<PlanId, GhostShape> Asked; ///< of the job
};

} // namespace hasp
