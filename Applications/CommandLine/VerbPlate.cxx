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

namespace hasp
{
namespace
{

struct PlateOptions
{
  VolumeChoices volume;
  std::string recipe, labels, output;
};

/// Where each screw goes in, and along what.
void SayScrews(vtkPolyData* plate, Session& session)
{
  vtkDataArray* axes = plate->GetFieldData()->GetArray("ScrewAxes");
  nlohmann::ordered_json& list = session.result["screws"] = nlohmann::ordered_json::array();
  for (vtkIdType n = 0; n < axes->GetNumberOfTuples(); ++n)
  {
    const double* s = axes->GetTuple(n);
    list.push_back({ { "outer_mm", { s[0], s[1], s[2] } }, { "axis", { s[3], s[4], s[5] } } });
    char text[200];
    std::snprintf(text, sizeof text,
      "screws[%d]  through (%.2f, %.2f, %.2f) mm, out of the bone along (%.4f, %.4f, %.4f)\n",
      int(n), s[0], s[1], s[2], s[3], s[4], s[5]);
    if (!session.json)
      std::cout << text;
  }
}

void Run(const PlateOptions& options, Session& session)
{
  RequireWritable(options.output, PartEndings);
  const PlateRecipe recipe = ReadRecipeFile(options.recipe, ReadPlateRecipe);
  const LoadedVolume volume = ReadVolume(options.volume, session);
  SayWarnings(volume.passport, session);
  vtkNew<vtkHaspPlateFilter> filter;
  filter->SetRecipe(recipe);
  filter->SetInputData(0, volume.image);
  if (!options.labels.empty())
  {
    VolumeChoices choices;
    choices.input = options.labels;
    filter->SetInputData(1, ReadVolume(choices, session).image);
  }
  const vtkSmartPointer<vtkPolyData> plate = RunPartFilter(filter, "plate", session);
  WritePart(plate, options.output, session, LabelOfRecipe("plate", options.recipe));
  session.progress.Wipe();
  SayScrews(plate, session);
}

} // namespace

void AddPlateVerb(CLI::App& app, Session& session)
{
  auto options = std::make_shared<PlateOptions>();
  CLI::App* verb = app.add_subcommand("plate", "Make a bone plate from a CT and a recipe");
  AddVolumeOptions(*verb, options->volume);
  verb->add_option("--recipe", options->recipe, "The .json file that says what to make")
    ->required();
  verb->add_option(
    "--labels", options->labels, "Labels of the same grid, for recipes that move fragments");
  verb
    ->add_option(
      "--output", options->output, "The .stl, .3mf, .ply or .obj file; its folder must exist")
    ->required();
  AddCommonOptions(*verb, session);
  verb->footer("Example: hasp plate head.mha --recipe plate.json --output plate.stl\n"
               "Exit codes: 0 done, 1 wrong use, 2 bad input.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
