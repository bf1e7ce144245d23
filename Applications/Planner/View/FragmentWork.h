#pragma once
#include "PlanRebuild.h"
#include "Planning/Plan.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace hasp
{

struct DerivedPart;
struct SceneContext;

/// All that a fragment's voxels come from: equal ones are equal voxels.
struct FragmentShape
{
  std::string scan;                    ///< hash
  std::string map;                     ///< blob of the label map; empty: it is no label's
  std::vector<FragmentSource> sources; ///< from the fragment to the whole bone
  std::vector<std::pair<Osteotomy, double>> cuts; ///< through the bones between; blade and reach
  std::vector<glm::dvec3> siblings; ///< of pieces, seeds of older ones: each is one alone

  bool operator==(const FragmentShape&) const = default;
};

/// The label maps of a plan that are in date, by segmentation: the blobs that hold them.
std::map<PlanId, std::string> LabelMapBlobs(const Plan& plan, std::span<const DerivedPart> parts);

/// Of a fragment of a scan. No scan: its label map is not in date, so that it has no voxels yet.
FragmentShape ShapeOfFragment(
  const Plan& plan, PlanId fragment, const std::map<PlanId, std::string>& labelMaps);

/// What a WORKER takes along to find the voxels of fragments.
struct VoxelWork
{
  /// Of now, with the scans that are in memory. RENDER.
  explicit VoxelWork(const SceneContext& scene);

  Plan plan;
  std::filesystem::path folder;
  std::map<PlanId, std::string> blobs;                            ///< LabelMapBlobs
  std::map<std::string, vtkSmartPointer<vtkImageData>> labelMaps; ///< by blob
  std::map<PlanId, vtkSmartPointer<vtkImageData>> scans;          ///< what images views
  PlanImages images;

  /// Reads the label maps that these fragments need, unless they are there, and puts them among the
  /// images. Throws std::runtime_error (disk, damage), Cancelled. WORKER.
  void ReadLabelMaps(std::span<const PlanId> fragments, const ProgressFunction& progress);
};

/// What became of fragments.
struct MadeFragments
{
  std::map<PlanId, vtkSmartPointer<vtkImageData>> images; ///< of those that have voxels
  std::map<PlanId, std::string> faults; ///< "fragment 7: …, which says what to do"
  std::map<std::string, vtkSmartPointer<vtkImageData>> labelMaps; ///< all, those that were read too
};

/// The voxels of each fragment alone (FragmentImages). Throws Cancelled; all else is a fault of
/// the fragments, memory too. WORKER.
MadeFragments MakeFragments(
  VoxelWork work, const std::vector<PlanId>& fragments, const ProgressFunction& progress);

} // namespace hasp
