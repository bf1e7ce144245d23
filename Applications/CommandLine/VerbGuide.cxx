#include "Failure.h"
#include "Files.h"
#include "GuideCertificate.h"
#include "Session.h"
#include "Verbs.h"
#include "Version.h"
#include "VolumeInput.h"
#include "VtkMessages.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspGuideFilter.h"
#include "vtkHaspOutputFile.h"

#include "Planning/GuideRecipe.h"
#include "Planning/GuideRecipeFile.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <iostream>
#include <memory>
#include <stdexcept>

namespace hasp
{
namespace
{

struct GuideOptions
{
  VolumeChoices volume;
  std::string recipe, output;
  bool check = false;
  double leastShare = 0.95;
};

GuideRecipe ReadRecipe(const std::string& path)
{
  RequireInput(path);
  try
  {
    return ReadGuideRecipe(path);
  }
  catch (const std::exception& error)
  {
    throw Failure(ExitCode::BadInput, FileLabel(path) + ": " + SafeText(error));
  }
}

vtkSmartPointer<vtkPolyData> MakeGuide(
  vtkImageData* volume, const GuideRecipe& recipe, Session& session)
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
  vtkSmartPointer<vtkPolyData> guide = filter->GetOutput();
  session.resources.push_back(
    { "guide", 1024 * guide->GetActualMemorySize(), spent.count(), "made from the recipe" });
  return guide;
}

GuideCertificate Certify(const std::string& stl, vtkImageData* volume, const GuideRecipe& recipe)
{
  try
  {
    return CertifyGuide(stl, volume, recipe);
  }
  catch (const std::exception& error) // what cannot be measured does not hold
  {
    throw Failure(ExitCode::FailedCheck, SafeText(error));
  }
}

/// Prints the certificate; throws Failure: FailedCheck if it does not hold.
void Check(const std::string& stl, vtkImageData* volume, const GuideRecipe& recipe,
  double leastShare, Session& session)
{
  session.progress.Step("measuring the guide as written");
  const auto start = std::chrono::steady_clock::now();
  const GuideCertificate certificate = Certify(stl, volume, recipe);
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  session.resources.push_back({ "certificate", 0, spent.count(), "--check; released again" });
  const std::vector<std::string> faults = FaultsOf(certificate, leastShare);
  session.progress.Wipe();
  if (!session.json)
    std::cout << CertificateText(certificate) << "verdict             "
              << (faults.empty() ? "holds" : "DOES NOT HOLD") << "; at least " << 100.0 * leastShare
              << " % of the inner wall must be within\n";
  nlohmann::ordered_json& json = session.result["certificate"];
  json = { { "passed", faults.empty() }, { "least_share", leastShare },
    { "isovalue", recipe.isovalue } };
  json.update(CertificateJson(certificate));
  json["faults"] = faults;
  json["program"] = std::string("hasp ") + Version() + ", commit " + Commit();
  json["intended_use"] = "research use only, not a medical device";
  if (faults.empty())
    return;
  throw FailedCheck("the guide does not hold and was not kept", faults);
}

void Run(const GuideOptions& options, Session& session)
{
  RequireWritable(options.output, { ".stl" });
  const GuideRecipe recipe = ReadRecipe(options.recipe);
  const LoadedVolume volume = ReadVolume(options.volume, session);
  SayWarnings(volume.passport, session);
  const auto guide = MakeGuide(volume.image, recipe, session);
  const auto inspect = [&](const std::string& pendingFile)
  {
    if (options.check)
      Check(pendingFile, volume.image, recipe, options.leastShare, session);
    else
      session.resources.push_back({ "certificate", 0, 0.0, "no --check was asked for" });
  };
  try
  {
    WriteSurface(guide, options.output, inspect);
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
  verb->add_option("--output", options->output, "The .stl file; its folder must exist")->required();
  verb->add_flag("--check", options->check,
    "Read the file back, print its certificate, and keep it only if that holds");
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
