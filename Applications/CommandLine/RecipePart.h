#pragma once
#include "Evaluation/PartClaims.h"
#include "Failure.h"
#include "Files.h"
#include "Session.h"
#include "VerbWork.h"
#include "vtkHaspFileNames.h"

#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>

class vtkImageData;
namespace CLI
{
class App;
class Option;
}

/// What verbs share that make a part of a volume by a recipe.
namespace hasp
{

/// read(path), its exceptions as Failure: BadInput with the file's label.
template <typename Read>
auto ReadRecipeFile(const std::string& path, const Read& read)
{
  RequireInput(path);
  return Try(ExitCode::BadInput, FileLabel(path) + ": ", [&] { return read(path); });
}

/// Another volume besides IN: labels, or a donor's scan. Its warnings are said. Throws Failure:
/// BadInput.
vtkSmartPointer<vtkImageData> ReadOther(const std::string& path, Session& session);

/// Which part a verb makes, and what is asked of it before it is kept.
struct PartOptions
{
  std::string part; ///< "guide": its name in its file, too
  std::string recipe, output;
  bool check = false, force = false;
  double leastShare = 0.95; ///< of the inner wall that must be within its gap, [0, 1]
  std::string html;         ///< of the certificate's page; empty: none
};

/// --recipe, --output, --check, --force and --html. Returns --output, which is required.
CLI::Option* AddPartOptions(CLI::App& verb, PartOptions& options);

/// --least-share, for parts whose gap to the bone is claimed. Returns it.
CLI::Option* AddLeastShare(CLI::App& verb, double& share);

/// Call before the work begins. Throws Failure: WrongUse for files that cannot be written, and for
/// --force or --html without --check.
void RequirePartOptions(const PartOptions& options);

/// Runs a filter that makes a part called `part`, with progress; lists it among the resources.
/// Throws Failure: BadInput with what the filter reported.
vtkSmartPointer<vtkPolyData> RunPartFilter(
  vtkPolyDataAlgorithm* filter, const std::string& part, Session& session);

/// Writes it as a whole or not at all; its file says the part's name and HashOfFile of the recipe.
/// With --check it is read back first, its certificate printed (CertifyPart), and it is kept only
/// if that holds, or by force: then its file says so. `claims` is asked for with --check alone.
/// Throws Failure: WrongUse, FailedCheck.
void WritePart(vtkPolyData* surface, const PartOptions& options, vtkImageData* bone,
  const std::function<PartClaims()>& claims, Session& session);

} // namespace hasp
