#pragma once
#include "Failure.h"
#include "Files.h"
#include "Session.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspOutputFile.h"

#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"

#include <exception>
#include <string>
#include <vector>

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

/// What --output of a part may end in.
inline const std::vector<std::string> PartEndings = { ".stl", ".3mf", ".ply", ".obj" };

/// What the file of a part says of it: this name, and the hash of the recipe's file, as sha256sum
/// prints it; none in a build without OpenSSL.
PartLabel LabelOfRecipe(const std::string& name, const std::string& recipe);

/// Writes it as a whole or not at all; `inspect` as of WriteSurface. Throws Failure: WrongUse, and
/// what `inspect` throws.
void WritePart(vtkPolyData* part, const std::string& output, Session& session,
  const PartLabel& label = {}, const InspectPart& inspect = {});

} // namespace hasp
