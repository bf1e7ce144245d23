#include "ImplantClaims.h"
#include "RecipePart.h"
#include "Verbs.h"
#include "VolumeInput.h"
#include "vtkHaspImplantFilter.h"

#include "Planning/ImplantRecipe.h"
#include "Planning/ImplantRecipeFile.h"

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

struct ImplantOptions
{
  VolumeChoices volume;
  PartOptions part{ .part = "implant" };
};

nlohmann::ordered_json Vector(const double* v)
{
  return { v[0], v[1], v[2] };
}

/// What the recipe left to be found, and how well the mirrored side fits.
void SayFound(vtkPolyData* implant, Session& session)
{
  vtkFieldData* data = implant->GetFieldData();
  double plane[6], axis[3], rim[4];
  data->GetArray("MirrorPlane")->GetTuple(0, plane);
  data->GetArray("Axis")->GetTuple(0, axis);
  data->GetArray("Rim")->GetTuple(0, rim);
  vtkDataArray* holes = data->GetArray("Holes");
  session.result["mirror"] = { { "point_mm", Vector(plane) }, { "normal", Vector(plane + 3) } };
  session.result["axis"] = Vector(axis);
  session.result["rim"] = { { "shift_mm", rim[0] }, { "tilt_deg", rim[1] }, { "rms_mm", rim[2] },
    { "p95_mm", rim[3] } };
  nlohmann::ordered_json& list = session.result["holes_mm"] = nlohmann::ordered_json::array();
  for (vtkIdType n = 0; n < holes->GetNumberOfTuples(); ++n)
    list.push_back(Vector(holes->GetTuple(n)));
  char text[500];
  std::snprintf(text, sizeof text,
    "mirror  through (%.2f, %.2f, %.2f) mm, upright on (%.4f, %.4f, %.4f)\n"
    "rim     %.2f mm rms off the bone around the hole, 95 %% within %.2f\n"
    "laid    the mirrored side was moved %.2f mm along the axis and tilted %.2f degrees, as heads "
    "are\n        not quite symmetric (more than 6 mm or 8 degrees is refused)\n"
    "axis    (%.4f, %.4f, %.4f), out of the head\n"
    "holes   %d\n",
    plane[0], plane[1], plane[2], plane[3], plane[4], plane[5], rim[2], rim[3], rim[0], rim[1],
    axis[0], axis[1], axis[2], int(holes->GetNumberOfTuples()));
  if (!session.json)
    std::cout << text;
}

PartClaims ClaimsOfImplant(const ImplantRecipe& recipe, vtkPolyData* implant)
{
  vtkFieldData* data = implant->GetFieldData();
  glm::dvec3 axis;
  data->GetArray("Axis")->GetTuple(0, &axis.x);
  vtkDataArray* tuples = data->GetArray("Holes");
  std::vector<glm::dvec3> holes(std::size_t(tuples->GetNumberOfTuples()));
  for (std::size_t n = 0; n < holes.size(); ++n)
    tuples->GetTuple(vtkIdType(n), &holes[n].x);
  return ClaimsOf(recipe, axis, holes);
}

void Run(const ImplantOptions& options, Session& session)
{
  RequirePartOptions(options.part);
  const ImplantRecipe recipe = ReadRecipeFile(options.part.recipe, ReadImplantRecipe);
  const LoadedVolume volume = ReadVolume(options.volume, session);
  SayWarnings(volume.passport, session);
  vtkNew<vtkHaspImplantFilter> filter;
  filter->SetRecipe(recipe);
  filter->SetInputData(volume.image);
  const vtkSmartPointer<vtkPolyData> implant = RunPartFilter(filter, "implant", session);
  session.progress.Wipe();
  SayFound(implant, session);
  WritePart(
    implant, options.part, volume.image, [&] { return ClaimsOfImplant(recipe, implant); }, session);
}

} // namespace

void AddImplantVerb(CLI::App& app, Session& session)
{
  auto options = std::make_shared<ImplantOptions>();
  CLI::App* verb = app.add_subcommand("implant", "Make an implant for a hole in the skull");
  AddVolumeOptions(*verb, options->volume);
  AddPartOptions(*verb, options->part);
  AddCommonOptions(*verb, session);
  verb->footer("Example: hasp implant head.mha --recipe implant.json --output implant.stl --check\n"
               "Exit codes: 0 done, 1 wrong use, 2 bad input, 3 the implant does not hold.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
