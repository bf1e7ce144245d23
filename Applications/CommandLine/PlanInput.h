#pragma once
#include "VerbWork.h"
#include "vtkHaspFileNames.h"

#include "Planning/PlanFile.h"
#include "Planning/PlanLists.h"

#include <string>

/// Plans of the command line. Errors call them "the plan"; names of objects are the user's own
/// words and are not said.
namespace hasp
{

/// A plan's folder, NAME.hasp, or its plan.json alone, which is only read.
bool IsPlanFolder(const std::string& path);
/// Where the plan's blobs are: the folder, or that of plan.json.
std::string PlanFolder(const std::string& path);

/// Throws Failure: BadInput.
PlanDocument OpenPlan(const std::string& path);
/// Throws Failure: WrongUse.
void StorePlan(const std::string& folder, const PlanDocument& document);

/// The whole file as text. Throws Failure: BadInput above 64 MiB and where it cannot be read.
std::string ReadText(const std::string& path);

} // namespace hasp
