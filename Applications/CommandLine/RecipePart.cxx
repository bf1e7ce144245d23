#include "RecipePart.h"

#include "CertificatePage.h"
#include "PartCertificate.h"
#include "PartFormats.h"
#include "VolumeInput.h"
#include "VtkMessages.h"
#include "vtkHaspOutputFile.h"

#include "vtkImageData.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <chrono>
#include <optional>

namespace hasp
{
namespace
{

/// A part as it was read back, and what was found of it.
struct CheckedPart
{
  PrintedPart part;
  FitCertificate certificate;
};

} // namespace

vtkSmartPointer<vtkImageData> ReadOther(const std::string& path, Session& session)
{
  VolumeChoices choices;
  choices.input = path;
  const LoadedVolume volume = ReadVolume(choices, session);
  SayWarnings(volume.passport, session);
  return volume.image;
}

vtkSmartPointer<vtkPolyData> RunPartFilter(
  vtkPolyDataAlgorithm* filter, const std::string& part, Session& session)
{
  session.progress.Step("making the " + part);
  ShowProgress(session, filter);
  const auto start = std::chrono::steady_clock::now();
  filter->Update();
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  ThrowVtkError(ExitCode::BadInput, "no " + part + " can be made of this recipe and volume");
  vtkSmartPointer<vtkPolyData> made = filter->GetOutput();
  session.resources.push_back(
    { part, 1024 * made->GetActualMemorySize(), spent.count(), "made from the recipe" });
  return made;
}

CLI::Option* AddLeastShare(CLI::App& verb, double& share)
{
  return verb
    .add_option("--least-share", share, "Of the inner wall that must be within 0.2 mm of the gap")
    ->check(Within(0.0, 1.0))
    ->capture_default_str();
}

CLI::Option* AddPartOptions(CLI::App& verb, PartOptions& options)
{
  verb.add_option("--recipe", options.recipe, "The .json file that says what to make")->required();
  CLI::Option* output = verb.add_option(
    "--output", options.output, "The .stl, .3mf, .ply or .obj file; its folder must exist");
  verb.add_flag("--check", options.check,
    "Read the file back, print its certificate, and keep it only if that holds");
  verb.add_flag("--force", options.force,
    "Keep what --check finds not to hold all the same: exit code 0, and its file says so");
  verb.add_option("--html", options.html,
    "Write the certificate, with pictures, to this .html file, whether it holds or not");
  return output->required();
}

void RequirePartOptions(const PartOptions& options)
{
  RequireWritable(options.output, PartEndings());
  if (options.force && !options.check)
    throw Failure(ExitCode::WrongUse, "--force is for parts that --check finds not to hold");
  if (options.html.empty())
    return;
  if (!options.check)
    throw Failure(ExitCode::WrongUse, "--html is the page of what --check finds");
  RequireWritable(options.html, { ".html" });
}

void WritePart(vtkPolyData* surface, const PartOptions& options, vtkImageData* bone,
  const std::function<PartClaims()>& claims, Session& session)
{
  std::optional<CheckedPart> checked;
  const auto writePage = [&](const std::string& file, const std::string& fate)
  {
    WriteCertificatePage(checked->part.mesh, bone, checked->certificate,
      { options.html, file, options.recipe, fate }, session);
  };
  const auto inspect = [&](const std::string& pendingFile)
  {
    if (!options.check)
      return PartVerdict::Holds;
    checked.emplace(CheckedPart{ { ReadBack(pendingFile, session) }, {} });
    checked->certificate = CertifyPart(checked->part, bone, claims(), session);
    if (checked->certificate.Holds())
      return PartVerdict::Holds;
    if (options.force)
      return PartVerdict::DoesNotHold;
    writePage(pendingFile, "The " + options.part + " was not kept.");
    throw Faulty(checked->certificate, "the " + options.part + " does not hold and was not kept");
  };
  const PartLabel label{ .name = options.part, .hash = HashOfFile(options.recipe) };
  Try(ExitCode::WrongUse, "", [&] { WriteSurface(surface, options.output, label, inspect); });
  session.result["output"] = FileLabel(options.output);
  if (!checked)
  {
    SayWarning(session, "the " + options.part + " is not certified; use --check");
    return session.resources.push_back({ "certificate", 0, 0.0, "no --check was asked for" });
  }
  if (checked->certificate.Holds())
    return writePage(options.output, "");
  writePage(options.output, "It was forced: the " + options.part +
                              " is kept although it does not hold, and its file says so.");
  session.result["certificate"]["forced"] = true;
  SayWarning(
    session, Faulty(checked->certificate,
               "the " + options.part + " does not hold; it is kept, and its file says so (--force)")
               .what());
}

} // namespace hasp
