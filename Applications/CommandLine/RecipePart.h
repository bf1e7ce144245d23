#pragma once
#include "Evaluation/PartClaims.h"
#include "Failure.h"
#include "Files.h"
#include "Session.h"
#include "vtkHaspFileNames.h"

#include "Planning/GuideRecipe.h"
#include "Planning/PlateRecipe.h"

#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"

#include <exception>
#include <functional>
#include <string>
#include <variant>

class vtkImageData;
namespace CLI
{
class App;
}

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

/// A recipe of what its "format" says; what says nothing is read as a guide's.
using PartRecipe = std::variant<GuideRecipe, PlateRecipe>;
PartRecipe ReadPartRecipe(const std::string& path);

/// Runs a filter that makes a part called `part`, with progress; lists it among the resources.
/// Throws Failure: BadInput with what the filter reported.
vtkSmartPointer<vtkPolyData> RunPartFilter(
  vtkPolyDataAlgorithm* filter, const char* part, Session& session);

/// Whether a part is held to its claims before it is kept.
struct CheckChoices
{
  bool check = false, force = false;
  double leastShare = 0.95; ///< of the inner wall that must be within its gap, [0, 1]
};

/// --check, --force and --least-share of a verb that makes a `part`.
void AddCheckOptions(CLI::App& verb, const char* part, CheckChoices& choices);

/// --least-share alone.
void AddLeastShare(CLI::App& verb, double& share);

/// Throws Failure: WrongUse for --force without --check.
void RequireCheckWithForce(const CheckChoices& choices, const char* part);

/// Writes it as a whole or not at all. With --check the file is read back first, its certificate
/// printed (CertifyPart), and it is kept only if that holds, or by force: then the head of the file
/// says so. `claims` is asked for with --check alone. Throws Failure: WrongUse, FailedCheck.
void WritePart(vtkPolyData* surface, const char* part, const std::string& output,
  const CheckChoices& choices, vtkImageData* bone, const std::function<PartClaims()>& claims,
  Session& session);

} // namespace hasp
