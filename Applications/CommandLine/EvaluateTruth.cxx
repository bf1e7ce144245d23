#include "EvaluateTruth.h"

#include "Failure.h"
#include "Studies/FractureCaseFile.h"
#include "vtkHaspFileNames.h"

#include <filesystem>
#include <stdexcept>

namespace hasp
{

std::vector<TrueFragment> ReadTruth(const std::string& path)
{
  std::vector<TrueFragment> fragments;
  try
  {
    const FractureCaseTruth truth = ReadFractureCase(std::filesystem::path(path).parent_path());
    for (const FractureCaseFragment& fragment : truth.fragments)
      fragments.push_back({ fragment.label, fragment.name, TrueReduction(truth, fragment.label) });
    for (const Label label : truth.fixed)
      fragments.push_back({ label, "", RigidPose{} });
  }
  catch (const std::exception& error) // its keys, and no text of it
  {
    throw Failure(
      ExitCode::BadInput, FileLabel(path) + " of a case's truth: " + std::string(error.what()));
  }
  return fragments;
}

} // namespace hasp
