#pragma once
#include "PlanRebuild.h"
#include "Planning/PlanFile.h"
#include "vtkHaspVolumeFile.h"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace hasp
{

struct Session;

/// The scans and label maps of a plan that are needed, and no others.
struct RunImages
{
  std::vector<LoadedVolume> loaded; ///< what images views
  PlanImages images;
};

/// Scans are found among the files by their hashes; label maps are blobs of the plan, those of a
/// recipe's steps as they were made last, put below `folder` while they are read. Files are told by
/// their places in the command line. Throws Failure: BadInput, with the ids of the volumes that no
/// file is, or of a segmentation whose label map is out of date.
RunImages ReadRunImages(const PlanDocument& document, const std::set<PlanId>& needed,
  const std::vector<std::string>& files, const std::string& planFolder,
  const std::filesystem::path& folder, Session& session);

} // namespace hasp
