#include "GuideClaims.h"
#include "RecipePart.h"
#include "Verbs.h"
#include "VolumeInput.h"
#include "VtkMessages.h"
#include "vtkHaspGuideFilter.h"
#include "vtkHaspOutputFile.h"

#include "Planning/GuideRecipeFile.h"

#include "vtkImageData.h"
#include "vtkNew.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>

namespace hasp
{
namespace
{

struct GuideOptions
{
  VolumeChoices volume;
  PartOptions part{ .part = "guide" };
  std::string preview, caseLabel;
  BodySide side = BodySide::None;
};

/// The field alone, 0.8 mm apart or as the recipe's grid: what `hasp render` draws as clustered
/// cells.
void WritePreview(vtkHaspGuideFilter* filter, const std::string& path, Session& session)
{
  session.progress.Step("sampling the guide");
  const auto start = std::chrono::steady_clock::now();
  const vtkSmartPointer<vtkImageData> preview =
    filter->MakePreview(std::max(0.8, filter->GetRecipe().spacingMm));
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  ThrowVtkError(ExitCode::BadInput, "no guide can be made of this recipe and volume");
  session.resources.push_back(
    { "preview", 1024 * preview->GetActualMemorySize(), spent.count(), "sampled from the recipe" });
  WriteVolume(preview, path);
  session.result["preview"] = FileLabel(path);
}

void Run(const GuideOptions& options, Session& session)
{
  if (options.part.output.empty() && options.preview.empty())
    throw Failure(ExitCode::WrongUse, "--output or --preview is required");
  if (options.preview.empty())
    RequirePartOptions(options.part);
  else
    RequireWritable(options.preview, { ".mha" });
  GuideRecipe recipe = ReadRecipeFile(options.part.recipe, ReadGuideRecipe);
  const bool labelled = !options.caseLabel.empty() || options.side != BodySide::None;
  if (labelled && std::none_of(recipe.labels.begin(), recipe.labels.end(),
                    [](const GuideLabel& label) { return label.kind == GuideLabelKind::Case; }))
    throw Failure(ExitCode::WrongUse,
      "--case-label and --side are for labels of the kind case, and the recipe has none");
  if (labelled)
    recipe = WithCaseLabels(std::move(recipe), options.caseLabel, options.side, "");
  const LoadedVolume volume = ReadVolume(options.volume, session);
  SayWarnings(volume.passport, session);
  vtkNew<vtkHaspGuideFilter> filter;
  filter->SetInputData(volume.image);
  filter->SetRecipe(recipe);
  if (!options.preview.empty())
    return WritePreview(filter, options.preview, session);
  const vtkSmartPointer<vtkPolyData> guide = RunPartFilter(filter, "guide", session);
  glm::dvec3 axis;
  filter->GetInsertionAxis(&axis.x);
  session.result["insertion_axis"] = { axis.x, axis.y, axis.z };
  WritePart(
    guide, options.part, volume.image,
    [&] { return ClaimsOf(filter->GetMadeRecipe(), options.part.leastShare); }, session);
}

} // namespace

void AddGuideVerb(CLI::App& app, Session& session)
{
  auto options = std::make_shared<GuideOptions>();
  CLI::App* verb = app.add_subcommand("guide", "Make a surgical guide from a CT and a recipe");
  AddVolumeOptions(*verb, options->volume);
  CLI::Option* output = AddPartOptions(*verb, options->part)->required(false);
  CLI::Option* preview = verb->add_option("--preview", options->preview,
    "An .mha file of the guide's field instead of --output: hasp render draws it, --isovalue 0");
  AddLeastShare(*verb, options->part.leastShare)->needs("--check");
  preview->excludes(output);
  for (const char* ofMeshes : { "--check", "--force", "--html" })
    preview->excludes(ofMeshes);
  verb->add_option("--case-label", options->caseLabel, "What labels of the kind case say");
  verb->add_option("--side", options->side, "Of the body, on the same labels")
    ->transform(CLI::CheckedTransformer(
      std::map<std::string, BodySide>{ { "left", BodySide::Left }, { "right", BodySide::Right } }));
  AddCommonOptions(*verb, session);
  verb->footer("Example: hasp guide head.mha --recipe guide.json --output guide.stl --check\n"
               "Exit codes: 0 done, 1 wrong use, 2 bad input, 3 the guide does not hold.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
