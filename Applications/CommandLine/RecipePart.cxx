#include "RecipePart.h"

#include "PartCertificate.h"
#include "VtkMessages.h"
#include "vtkHaspOutputFile.h"

#include "Planning/GuideRecipeFile.h"
#include "Planning/PlateRecipeFile.h"

#include "vtkImageData.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <new>
#include <string_view>

namespace hasp
{
namespace
{

/// The text of the file's "format"; empty if there is none. What is wrong with a file its own
/// reader says.
std::string FormatOf(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  const nlohmann::json json = nlohmann::json::parse(file, nullptr, false);
  if (!json.is_object() || !json.contains("format") || !json["format"].is_string())
    return {};
  return json["format"].get<std::string>();
}

/// Says in the head of a binary STL file, 80 bytes of text, that it does not hold.
void MarkAsFailed(const std::string& stl, const std::string& part)
{
  constexpr std::string_view words = " DOES NOT HOLD";
  std::string head(80, '\0');
  std::fstream file(stl, std::ios::in | std::ios::out | std::ios::binary);
  file.read(head.data(), 80);
  const std::size_t end = std::min(head.find_last_not_of(std::string_view("\0 ", 2)) + 1,
    head.size() - words.size()); // npos + 1 is 0
  head.replace(end, words.size(), words);
  file.seekp(0);
  file.write(head.data(), 80);
  if (!file.flush())
    throw Failure(ExitCode::WrongUse, "the " + part + " does not hold, and its file cannot say so");
}

/// Prints the certificate; throws Failure: FailedCheck if it does not hold and is not forced.
void Check(const std::string& stl, vtkImageData* bone, const CheckChoices& choices,
  const PartClaims& claims, const std::string& part, Session& session)
{
  const FitCertificate certificate = CertifyPart(ReadBackStl(stl), bone, claims, session);
  if (certificate.Holds())
    return;
  if (!choices.force)
    ThrowFaults(certificate, "the " + part + " does not hold and was not kept");
  MarkAsFailed(stl, part);
  session.result["certificate"]["forced"] = true;
  SayWarning(session, "the " + part + " does not hold; it is kept, and its file says so (--force)");
}

} // namespace

PartRecipe ReadPartRecipe(const std::string& path)
{
  return ReadRecipeFile(path,
    [](const std::string& file) -> PartRecipe
    {
      if (FormatOf(file).starts_with("hasp-plate-recipe-"))
        return ReadPlateRecipe(file);
      return ReadGuideRecipe(file);
    });
}

vtkSmartPointer<vtkPolyData> RunPartFilter(
  vtkPolyDataAlgorithm* filter, const char* part, Session& session)
{
  session.progress.Step(std::string("making the ") + part);
  ShowProgress(session, filter);
  const auto start = std::chrono::steady_clock::now();
  filter->Update();
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  ThrowVtkError(
    ExitCode::BadInput, std::string("no ") + part + " can be made of this recipe and volume");
  vtkSmartPointer<vtkPolyData> made = filter->GetOutput();
  session.resources.push_back(
    { part, 1024 * made->GetActualMemorySize(), spent.count(), "made from the recipe" });
  return made;
}

void AddLeastShare(CLI::App& verb, double& share)
{
  verb
    .add_option("--least-share", share, "Of the inner wall that must be within 0.2 mm of the gap")
    ->check(Within(0.0, 1.0))
    ->capture_default_str();
}

void AddCheckOptions(CLI::App& verb, const char* part, CheckChoices& choices)
{
  verb.add_flag("--check", choices.check,
    "Read the file back, print its certificate, and keep it only if that holds");
  verb.add_flag("--force", choices.force,
    std::string("Keep a ") + part +
      " that does not hold all the same; the head of its file says so");
  AddLeastShare(verb, choices.leastShare);
}

void RequireCheckWithForce(const CheckChoices& choices, const char* part)
{
  if (choices.force && !choices.check)
    throw Failure(ExitCode::WrongUse,
      std::string("--force is for ") + part + "s that --check finds not to hold");
}

void WritePart(vtkPolyData* surface, const char* part, const std::string& output,
  const CheckChoices& choices, vtkImageData* bone, const std::function<PartClaims()>& claims,
  Session& session)
{
  const auto inspect = [&](const std::string& pendingFile)
  {
    if (choices.check)
      Check(pendingFile, bone, choices, claims(), part, session);
    else
      session.resources.push_back({ "certificate", 0, 0.0, "no --check was asked for" });
  };
  try
  {
    WriteSurface(surface, output, inspect);
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
    throw Failure(ExitCode::WrongUse, SafeText(error));
  }
  session.result["output"] = FileLabel(output);
}

} // namespace hasp
