#pragma once
#include "Failure.h"
#include "vtkHaspFileNames.h"

#include "Planning/PlanFile.h"

#include <exception>
#include <new>
#include <string>

/// Plans of the command line. Errors call them "the plan"; names of objects are the user's own
/// words and are not said.
namespace hasp
{

/// What reads, changes or saves a plan: its exceptions as failures of this kind.
template <typename Work>
auto TryPlan(ExitCode code, const Work& work)
{
  try
  {
    return work();
  }
  catch (const Failure&)
  {
    throw;
  }
  catch (const std::bad_alloc&)
  {
    throw; // no fault of the file; the caller says what to do
  }
  catch (const std::exception& error)
  {
    throw Failure(code, SafeText(error)); // names the plan's file, key or object
  }
}

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

/// "guide 8"
std::string CalledObject(const Plan& plan, PlanId id);

} // namespace hasp
