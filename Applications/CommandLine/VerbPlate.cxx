#include "PlateClaims.h"
#include "RecipePart.h"
#include "Verbs.h"
#include "VolumeInput.h"
#include "vtkHaspPlateFilter.h"

#include "Planning/PlateRecipe.h"
#include "Planning/PlateRecipeFile.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <iostream>
#include <memory>
#include <vector>

namespace hasp
{
namespace
{

struct PlateOptions
{
  VolumeChoices volume;
  PartOptions part{ .part = "plate" };
  std::string labels;
};

std::vector<ScrewAxis> ScrewsOf(vtkPolyData* plate)
{
  vtkDataArray* tuples = plate->GetFieldData()->GetArray("ScrewAxes");
  std::vector<ScrewAxis> screws;
  for (vtkIdType n = 0; n < tuples->GetNumberOfTuples(); ++n)
  {
    const double* s = tuples->GetTuple(n);
    screws.push_back({ { s[0], s[1], s[2] }, { s[3], s[4], s[5] } });
  }
  return screws;
}

/// Where each screw goes in, and along what.
void SayScrews(const std::vector<ScrewAxis>& screws, Session& session)
{
  nlohmann::ordered_json& list = session.result["screws"] = nlohmann::ordered_json::array();
  for (std::size_t n = 0; n < screws.size(); ++n)
  {
    const auto& [outer, axis] = screws[n];
    list.push_back(
      { { "outer_mm", { outer.x, outer.y, outer.z } }, { "axis", { axis.x, axis.y, axis.z } } });
    char text[200];
    std::snprintf(text, sizeof text,
      "screws[%d]  through (%.2f, %.2f, %.2f) mm, out of the bone along (%.4f, %.4f, %.4f)\n",
      int(n), outer.x, outer.y, outer.z, axis.x, axis.y, axis.z);
    if (!session.json)
      std::cout << text;
  }
}

void Run(const PlateOptions& options, Session& session)
{
  RequirePartOptions(options.part);
  const PlateRecipe recipe = ReadRecipeFile(options.part.recipe, ReadPlateRecipe);
  if (options.part.check && !recipe.fragments.empty())
    throw Failure(ExitCode::WrongUse,
      "--check measures the gap to the bone as scanned, and the recipe moves fragments of it");
  const LoadedVolume volume = ReadVolume(options.volume, session);
  SayWarnings(volume.passport, session);
  vtkNew<vtkHaspPlateFilter> filter;
  filter->SetRecipe(recipe);
  filter->SetInputData(0, volume.image);
  if (!options.labels.empty())
    filter->SetInputData(1, ReadOther(options.labels, session));
  const vtkSmartPointer<vtkPolyData> plate = RunPartFilter(filter, "plate", session);
  const std::vector<ScrewAxis> screws = ScrewsOf(plate);
  session.progress.Wipe();
  SayScrews(screws, session);
  WritePart(
    plate, options.part, volume.image,
    [&] { return ClaimsOf(recipe, screws, options.part.leastShare); }, session);
}

} // namespace

void AddPlateVerb(CLI::App& app, Session& session)
{
  auto options = std::make_shared<PlateOptions>();
  CLI::App* verb = app.add_subcommand("plate", "Make a bone plate from a CT and a recipe");
  AddVolumeOptions(*verb, options->volume);
  AddPartOptions(*verb, options->part);
  AddLeastShare(*verb, options->part.leastShare)->needs("--check");
  verb->add_option(
    "--labels", options->labels, "Labels of the same grid, for recipes that move fragments");
  AddCommonOptions(*verb, session);
  verb->footer("Example: hasp plate head.mha --recipe plate.json --output plate.stl --check\n"
               "Exit codes: 0 done, 1 wrong use, 2 bad input, 3 the plate does not hold.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
