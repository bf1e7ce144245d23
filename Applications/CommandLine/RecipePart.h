#pragma once
#include "Failure.h"
#include "Files.h"
#include "Session.h"
#include "vtkHaspFileNames.h"

#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"

#include <exception>
#include <string>

/// What verbs share that make a part of a volume by a recipe.
namespace hasp
{

/// read(path), its exceptions as Failure: BadInput with the file's label.
template <typename Read>
auto ReadRecipeFile(const std::string& path, const Read& read)
{
  RequireInput(path);
  try
  {
    return read(path);
  }
  catch (const std::exception& error)
  {
    throw Failure(ExitCode::BadInput, FileLabel(path) + ": " + SafeText(error));
  }
}

/// Runs a filter that makes a part called `part`, with progress; lists it among the resources.
/// Throws Failure: BadInput with what the filter reported.
vtkSmartPointer<vtkPolyData> RunPartFilter(
  vtkPolyDataAlgorithm* filter, const char* part, Session& session);

/// Writes it as a whole or not at all. Throws Failure: WrongUse.
void WritePart(vtkPolyData* part, const std::string& output, Session& session);

} // namespace hasp
