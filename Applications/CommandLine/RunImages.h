#pragma once
#include "PlanRebuild.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace hasp
{

struct Session;

/// The scans and label maps of a plan that are needed, and no others.
struct RunImages
{
  std::map<PlanId, vtkSmartPointer<vtkImageData>> loaded; ///< what images views
  PlanImages images;

  void Add(PlanId id, vtkImageData* image);
};

/// The scans, found among the files by their hashes. Files are told by their places in the command
/// line. Throws Failure: BadInput, with the ids of the volumes that no file is.
RunImages ReadScans(const Plan& plan, const std::set<PlanId>& needed,
  const std::vector<std::string>& files, Session& session);

} // namespace hasp
