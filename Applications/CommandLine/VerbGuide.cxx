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
  PartOptions part{ .part = "guide" };
};

void Run(const GuideOptions& options, Session& session)
{
  RequirePartOptions(options.part);
  const GuideRecipe recipe = ReadRecipeFile(options.part.recipe, ReadGuideRecipe);
  const LoadedVolume volume = ReadVolume(options.volume, session);
  SayWarnings(volume.passport, session);
  vtkNew<vtkHaspGuideFilter> filter;
  filter->SetInputData(volume.image);
  filter->SetRecipe(recipe);
  const vtkSmartPointer<vtkPolyData> guide = RunPartFilter(filter, "guide", session);
  glm::dvec3 axis;
  filter->GetInsertionAxis(&axis.x);
  session.result["insertion_axis"] = { axis.x, axis.y, axis.z };
  WritePart(guide, options.part, volume.image,
    [&] { return ClaimsOf(recipe, options.part.leastShare, axis); }, session);
}

} // namespace

void AddGuideVerb(CLI::App& app, Session& session)
{
  auto options = std::make_shared<GuideOptions>();
  CLI::App* verb = app.add_subcommand("guide", "Make a surgical guide from a CT and a recipe");
  AddVolumeOptions(*verb, options->volume);
  AddPartOptions(*verb, options->part);
  AddCommonOptions(*verb, session);
  verb->footer("Example: hasp guide head.mha --recipe guide.json --output guide.stl --check\n"
               "Exit codes: 0 done, 1 wrong use, 2 bad input, 3 the guide does not hold.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
