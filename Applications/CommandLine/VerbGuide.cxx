#include "Failure.h"
#include "Files.h"
#include "GuideClaims.h"
#include "PartCertificate.h"
#include "RecipeInput.h"
#include "Session.h"
#include "Verbs.h"
#include "VolumeInput.h"
#include "VtkMessages.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspGuideFilter.h"
#include "vtkHaspOutputFile.h"

#include "Planning/GuideRecipe.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <map>
#include <memory>
#include <stdexcept>
#include <string_view>

namespace hasp
{
namespace
{

struct GuideOptions
{
  VolumeChoices volume;
  std::string recipe, output, preview, caseLabel;
  BodySide side = BodySide::None;
  bool check = false, force = false;
  double leastShare = 0.95;
};

struct Guide
{
  vtkSmartPointer<vtkPolyData> surface;
  glm::dvec3 insertionAxis;
};

/// The field alone, 0.8 mm apart or as the recipe's grid: what `hasp render` draws as clustered
/// cells.
void WritePreview(
  vtkImageData* volume, const GuideRecipe& recipe, const std::string& path, Session& session)
{
  session.progress.Step("sampling the guide");
  vtkNew<vtkHaspGuideFilter> filter;
  filter->SetInputData(volume);
  filter->SetRecipe(recipe);
  const auto start = std::chrono::steady_clock::now();
  const vtkSmartPointer<vtkImageData> preview =
    filter->MakePreview(std::max(0.8, recipe.spacingMm));
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  ThrowVtkError(ExitCode::BadInput, "no guide can be made of this recipe and volume");
  session.resources.push_back(
    { "preview", 1024 * preview->GetActualMemorySize(), spent.count(), "sampled from the recipe" });
  WriteVolume(preview, path);
  session.result["preview"] = FileLabel(path);
}

Guide MakeGuide(vtkImageData* volume, const GuideRecipe& recipe, Session& session)
{
  session.progress.Step("making the guide");
  vtkNew<vtkHaspGuideFilter> filter;
  ShowProgress(session, filter);
  filter->SetInputData(volume);
  filter->SetRecipe(recipe);
  const auto start = std::chrono::steady_clock::now();
  filter->Update();
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  ThrowVtkError(ExitCode::BadInput, "no guide can be made of this recipe and volume");
  Guide guide{ filter->GetOutput(), {} };
  filter->GetInsertionAxis(&guide.insertionAxis.x);
  session.resources.push_back({ "guide", 1024 * guide.surface->GetActualMemorySize(), spent.count(),
    "made from the recipe" });
  const glm::dvec3& axis = guide.insertionAxis;
  session.result["insertion_axis"] = { axis.x, axis.y, axis.z };
  return guide;
}

/// Says in the head of a binary STL file, 80 bytes of text, that it does not hold.
void MarkAsFailed(const std::string& stl)
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
    throw Failure(ExitCode::WrongUse, "the guide does not hold, and its file cannot say so");
}

/// Prints the certificate; throws Failure: FailedCheck if it does not hold and is not forced.
void Check(const std::string& stl, vtkImageData* volume, const GuideOptions& options,
  const PartClaims& claims, Session& session)
{
  const FitCertificate certificate = CertifyPart(ReadBackStl(stl), volume, claims, session);
  if (certificate.Holds())
    return;
  if (!options.force)
    ThrowFaults(certificate, "the guide does not hold and was not kept");
  MarkAsFailed(stl);
  session.result["certificate"]["forced"] = true;
  SayWarning(session, "the guide does not hold; it is kept, and its file says so (--force)");
}

void Run(const GuideOptions& options, Session& session)
{
  if (options.preview.empty())
    RequireWritable(options.output, { ".stl" });
  else
    RequireWritable(options.preview, { ".mha" });
  if (options.force && !options.check)
    throw Failure(ExitCode::WrongUse, "--force is for guides that --check finds not to hold");
  GuideRecipe recipe = ReadRecipe(options.recipe);
  if (!options.caseLabel.empty() || options.side != BodySide::None)
    recipe = WithCaseLabels(std::move(recipe), options.caseLabel, options.side, "");
  const LoadedVolume volume = ReadVolume(options.volume, session);
  SayWarnings(volume.passport, session);
  if (!options.preview.empty())
    return WritePreview(volume.image, recipe, options.preview, session);
  const Guide guide = MakeGuide(volume.image, recipe, session);
  const auto inspect = [&](const std::string& pendingFile)
  {
    if (options.check)
      Check(pendingFile, volume.image, options,
        ClaimsOf(recipe, options.leastShare, guide.insertionAxis), session);
    else
      session.resources.push_back({ "certificate", 0, 0.0, "no --check was asked for" });
  };
  try
  {
    WriteSurface(guide.surface, options.output, inspect);
  }
  catch (const Failure&)
  {
    throw;
  }
  catch (const std::exception& error)
  {
    throw Failure(ExitCode::WrongUse, SafeText(error));
  }
  session.result["output"] = FileLabel(options.output);
}

} // namespace

void AddGuideVerb(CLI::App& app, Session& session)
{
  auto options = std::make_shared<GuideOptions>();
  CLI::App* verb = app.add_subcommand("guide", "Make a surgical guide from a CT and a recipe");
  AddVolumeOptions(*verb, options->volume);
  verb->add_option("--recipe", options->recipe, "The .json file that says what to make")
    ->required();
  CLI::Option_group* files = verb->add_option_group("Result", "One of");
  files->add_option("--output", options->output, "The .stl file; its folder must exist");
  files->add_option("--preview", options->preview,
    "An .mha file of the guide's field instead, within a second: hasp render draws it, --isovalue "
    "0");
  files->require_option(1);
  verb->add_option("--case-label", options->caseLabel, "What labels of the kind case say");
  verb->add_option("--side", options->side, "Of the body, on the same labels")
    ->transform(CLI::CheckedTransformer(
      std::map<std::string, BodySide>{ { "left", BodySide::Left }, { "right", BodySide::Right } }));
  verb->add_flag("--check", options->check,
    "Read the file back, print its certificate, and keep it only if that holds");
  verb->add_flag("--force", options->force,
    "Keep a guide that does not hold all the same; the head of its file says so");
  verb
    ->add_option("--least-share", options->leastShare,
      "Of the inner wall that must be within 0.2 mm of the gap")
    ->check(Within(0.0, 1.0))
    ->capture_default_str();
  AddCommonOptions(*verb, session);
  verb->footer("Example: hasp guide head.mha --recipe guide.json --output guide.stl --check\n"
               "Exit codes: 0 done, 1 wrong use, 2 bad input, 3 the guide does not hold.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
