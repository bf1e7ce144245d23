#pragma once
#include "PlanRebuild.h"
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

/// Scans are found among the files by their hashes; label maps are blobs of the plan, put below
/// `folder` while they are read. Files are told by their places in the command line. Throws
/// Failure: BadInput, with the ids of the volumes that no file is.
RunImages ReadRunImages(const Plan& plan, const std::set<PlanId>& needed,
  const std::vector<std::string>& files, const std::string& planFolder,
  const std::filesystem::path& folder, Session& session);

} // namespace hasp
