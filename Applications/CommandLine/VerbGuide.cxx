#include "GuideClaims.h"
#include "RecipePart.h"
#include "Verbs.h"
#include "VolumeInput.h"
#include "vtkHaspGuideFilter.h"

#include "Planning/GuideRecipeFile.h"

#include "vtkNew.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace hasp
{
namespace
{

struct GuideOptions
{
  VolumeChoices volume;
  std::string recipe, output;
  CheckChoices check;
};

void Run(const GuideOptions& options, Session& session)
{
  RequireWritable(options.output, { ".stl" });
  RequireCheckWithForce(options.check, "guide");
  const GuideRecipe recipe = ReadRecipeFile(options.recipe, ReadGuideRecipe);
  const LoadedVolume volume = ReadVolume(options.volume, session);
  SayWarnings(volume.passport, session);
  vtkNew<vtkHaspGuideFilter> filter;
  filter->SetInputData(volume.image);
  filter->SetRecipe(recipe);
  const vtkSmartPointer<vtkPolyData> guide = RunPartFilter(filter, "guide", session);
  glm::dvec3 axis;
  filter->GetInsertionAxis(&axis.x);
  session.result["insertion_axis"] = { axis.x, axis.y, axis.z };
  WritePart(
    guide, "guide", options.output, options.check, volume.image,
    [&] { return ClaimsOf(recipe, options.check.leastShare, axis); }, session);
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
  AddCheckOptions(*verb, "guide", options->check);
  AddCommonOptions(*verb, session);
  verb->footer("Example: hasp guide head.mha --recipe guide.json --output guide.stl --check\n"
               "Exit codes: 0 done, 1 wrong use, 2 bad input, 3 the guide does not hold.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
