#pragma once
#include "PlanRebuild.h"
#include "Planning/PlanFile.h"
#include "Segmenter.h"
#include "vtkHaspVolumeFile.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// Label maps between a plan's folder and memory. WORKER; nothing is kept between calls. All throw
/// std::runtime_error (disk, a damaged file), std::invalid_argument (a recipe), Cancelled; texts
/// name objects by kind and id.
namespace hasp
{

class ScanShelf;

/// Stores a label map as plans have it, .nrrd without the names of labels; its SHA-256.
std::string StoreLabelMap(const std::filesystem::path& folder, vtkImageData* labels);
/// A label map that a recipe's steps made, as the plan keeps it.
struct MadeLabelMap
{
  vtkSmartPointer<vtkImageData> labels;
  DerivedPart part; ///< for PlanSession::KeepMade: the same as `hasp run` keeps
  std::vector<SegmentationFinding> findings; ///< one a step
  double voxelMm3 = 0.0;
};

/// Makes the label map of a segmentation with steps by its recipe, of the scan that it is of, and
/// stores it in the plan's folder.
MadeLabelMap MakeLabelMap(const Plan& plan, PlanId segmentation, vtkImageData* scan,
  const std::filesystem::path& folder, const ProgressFunction& progress);

/// A plan as a WORKER takes it along, with its scans.
struct PlanSnapshot
{
  /// Of now. RENDER.
  PlanSnapshot(const PlanDocument& document, const ScanShelf& scans, std::filesystem::path folder);

  Plan plan;
  std::vector<DerivedPart> parts;
  std::map<PlanId, vtkSmartPointer<vtkImageData>> scans; ///< of volumes, as far as in memory
  std::filesystem::path folder;
};

/// What fragments are made of, in memory.
struct SnapshotImages
{
  std::map<PlanId, vtkSmartPointer<vtkImageData>> owned; ///< what images views
  PlanImages images;
  std::vector<DerivedPart> made; ///< label maps that had to be made: for KeepMade
};

/// The scans and label maps of these fragments; maps that are not in date are made. Throws
/// std::runtime_error where a scan is not in memory.
SnapshotImages ImagesOfFragments(const PlanSnapshot& snapshot, const std::vector<PlanId>& fragments,
  const ProgressFunction& progress);

} // namespace hasp
