#include "Failure.h"
#include "Files.h"
#include "LabelInput.h"
#include "RecipePart.h"
#include "SegmentText.h"
#include "SegmentationChoices.h"
#include "SegmentationWarnings.h"
#include "Segmenter.h"
#include "Session.h"
#include "VerbWork.h"
#include "Verbs.h"
#include "VolumeInput.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspLabelFile.h"
#include "vtkHaspLabelTable.h"
#include "vtkHaspVolumeView.h"

#include "Grid/ThreadLimit.h"
#include "Planning/SeedsFile.h"
#include "Planning/SegmentationRecipeFile.h"
#include "vtkImageData.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <utility>
#include <vector>

namespace hasp
{
namespace
{

struct SegmentOptions
{
  VolumeChoices volume;
  SegmentationChoices segmentation;
  std::string labels, output, writeRecipe, writeSeeds;
  double tolerance = RandomWalkerSettings{}.tolerance;
  int threads = 0;
};

/// Throws Failure: BadInput if a split has strokes and none of them is on bone: no user means that.
void RequireSeeds(const SegmentationStep& step, const SegmentationFinding& found, std::size_t n)
{
  const auto* split = std::get_if<SplitStep>(&step);
  if (split && !split->strokes.empty() && found.besideBone.size() == split->strokes.size())
    throw Failure(ExitCode::BadInput,
      "steps[" + std::to_string(n) + "]: no stroke touches a voxel of label " +
        std::to_string(split->label) + ": points are LPS in mm, and of this scan");
}

/// Says which labels have a name and no voxel. A recipe's names stay: who wrote them asked for the
/// same segments whatever the scan. Those of seeds go, so that no segment is empty for no reason
/// that its user knows.
void SayEmptyNames(ChosenSegmentation& chosen, vtkImageData* labels, Session& session)
{
  const std::vector<std::size_t> voxels =
    CountLabels(std::get<GridView<const Label>>(ViewImage(labels)));
  const auto isEmpty = [&](const LabelName& name)
  { return name.label >= voxels.size() || voxels[name.label] == 0; };
  std::vector<LabelName>& names = chosen.recipe.names;
  for (std::size_t n = 0; n < names.size(); ++n)
    if (isEmpty(names[n]))
      SayWarning(session, (chosen.seeds ? "" : "names[" + std::to_string(n) + "]: ") + "label " +
                            std::to_string(names[n].label) + " has no voxel in the end; " +
                            (chosen.seeds ? "it becomes no segment" : "its segment is empty"));
  if (chosen.seeds)
    std::erase_if(names, isEmpty);
}

/// Does all steps, and fills in a threshold that is open.
SegmentedScan Segment(const SegmentOptions& options, ChosenSegmentation& chosen,
  const LoadedVolume& volume, Session& session)
{
  vtkSmartPointer<vtkImageData> given;
  if (!options.labels.empty())
    given = ReadLabels(options.labels, ImageGeometry(volume.image), session).image;
  Segmenter segmenter(volume.image, given);
  segmenter.SetWalkerSettings({ .tolerance = options.tolerance });
  SegmentedScan made;
  for (std::size_t n = 0; n < chosen.recipe.steps.size(); ++n)
  {
    SegmentationStep& step = chosen.recipe.steps[n];
    if (chosen.openThreshold == n)
      step =
        ProposeThresholdStep(segmenter.Image(), std::get<ThresholdStep>(step).smoothMm, session);
    session.progress.Step(StepLabel(step));
    const auto start = std::chrono::steady_clock::now();
    const std::size_t before = segmenter.UndoBytes();
    segmenter.Apply(step,
      [&session](double share)
      {
        session.progress.Share(share);
        return true;
      });
    session.resources.push_back({ StepLabel(step), segmenter.UndoBytes() - before,
      MillisecondsSince(start), "a step; the bytes are those that would take it back" });
    segmenter.ForgetUndo(); // nobody will
    made.findings.push_back(segmenter.Finding());
    RequireSeeds(step, segmenter.Finding(), n);
    const StepPlace place{ "steps[" + std::to_string(n) + "]",
      chosen.seeds ? chosen.seeds->places : std::vector<std::string>() };
    for (const std::string& warning :
      WarningsOf(step, segmenter.Finding(), place, VoxelMm3(volume.image)))
      SayWarning(session, warning);
  }
  made.labels = segmenter.Labels();
  SayEmptyNames(chosen, made.labels, session);
  NameLabels(made.labels, chosen.recipe.names, given ? GetLabelTable(given) : LabelTable());
  return made;
}

using NamedFiles = std::vector<std::pair<std::string, std::string>>; ///< path, option

/// Throws Failure: WrongUse if a file that is written is one that is read, or written, too.
void RequireFreshFiles(const SegmentOptions& options)
{
  RequireWritable(options.output, { ".seg.nrrd", ".nrrd", ".mha", ".nii", ".nii.gz", ".vti" });
  NamedFiles outputs{ { options.output, "--output" } }, inputs{ { options.volume.input, "IN" },
    { options.labels, "--labels" }, { options.segmentation.recipe, "--recipe" } };
  if (!options.labels.empty())
    RequireDifferent(options.labels, options.volume.input, "--labels and IN");
  for (const std::string& seeds : options.segmentation.seeds)
    inputs.emplace_back(seeds, "--seeds");
  for (const auto& [path, name] : NamedFiles{
         { options.writeRecipe, "--write-recipe" }, { options.writeSeeds, "--write-seeds" } })
    if (!path.empty())
    {
      RequireWritable(path, { ".json" });
      outputs.emplace_back(path, name);
    }
  for (std::size_t n = 0; n < outputs.size(); ++n)
  {
    for (std::size_t before = 0; before < n; ++before)
      RequireDifferent(outputs[n].first, outputs[before].first,
        outputs[n].second + " and " + outputs[before].second);
    for (const auto& [path, name] : inputs)
      if (!path.empty())
        RequireDifferent(outputs[n].first, path, outputs[n].second + " and " + name);
  }
}

void WriteFiles(
  const SegmentOptions& options, const ChosenSegmentation& chosen, const SegmentedScan& made)
{
  WriteLabels(made.labels, GetLabelTable(made.labels), options.output);
  if (!options.writeRecipe.empty())
    WriteSegmentationRecipe(options.writeRecipe, chosen.recipe);
  if (options.writeSeeds.ends_with(".mrk.json"))
    WriteMarkups(options.writeSeeds, *chosen.seeds);
  else if (!options.writeSeeds.empty())
    WriteSeeds(options.writeSeeds, *chosen.seeds);
}

void Run(const SegmentOptions& options, Session& session)
{
  RequireFreshFiles(options);
  const LoadedVolume volume = ReadVolume(options.volume, session);
  SayWarnings(volume.passport, session);
  RequireScan(volume, options.volume.input, session);
  ChosenSegmentation chosen = ChooseSegmentation(options.segmentation, volume.passport, session);
  const SegmentedScan made =
    Try(ExitCode::BadInput, "", [&] { return Segment(options, chosen, volume, session); });
  const nlohmann::ordered_json described = DescribeSegmentation(chosen.recipe, made);
  if (described["labels"].empty())
    throw Failure(ExitCode::BadInput, "no voxel has a label: the threshold finds no bone, or a "
                                      "step leaves none; hasp info shows the "
                                      "range of values");
  session.progress.Step("writing the labels");
  Try(ExitCode::WrongUse, "", [&] { WriteFiles(options, chosen, made); });
  session.progress.Wipe();
  if (!session.json)
    PrintSegmentation(described);
  session.result["output"] = FileLabel(options.output);
  session.result.update(described);
}

} // namespace

void AddSegmentVerb(CLI::App& app, Session& session)
{
  auto options = std::make_shared<SegmentOptions>();
  CLI::App* verb = app.add_subcommand("segment", "Make labels of a CT: bone, and its fragments");
  AddVolumeOptions(*verb, options->volume);
  AddSegmentationOptions(*verb, options->segmentation);
  verb
    ->add_option("--labels", options->labels,
      "Labels of the same grid that the recipe's steps begin with; a threshold forgets them")
    ->needs(verb->get_option("--recipe"));
  verb
    ->add_option("--output", options->output,
      "The .seg.nrrd file for 3D Slicer, or .nrrd, .mha, .nii, .vti without names")
    ->required();
  verb->add_option("--write-recipe", options->writeRecipe,
    "Write what was done to this .json file: --recipe makes the same labels, with the same "
    "--labels\n"
    "and --tolerance");
  verb
    ->add_option("--write-seeds", options->writeSeeds,
      "Write the seeds to this file: .mrk.json for 3D Slicer, .json as Hasp has them")
    ->needs(verb->get_option("--seeds"));
  verb->add_option("--tolerance", options->tolerance, "Of the probabilities that are solved for")
    ->check(Within(1e-6, 0.1))
    ->capture_default_str();
  verb
    ->add_option(
      "--threads", options->threads, "At most so many; the bytes are the same; 0: one a core")
    ->check(CLI::Range(0, 1024));
  AddCommonOptions(*verb, session);
  verb->footer(
    "Example: hasp segment head.mha --threshold 226 --seeds seeds.json --output case.seg.nrrd\n"
    "Bone is what the threshold takes; where none is given, 226 HU, or what the histogram\n"
    "proposes where values are not HU. It is cut between strokes where that costs least, along\n"
    "cracks and edges (--norm 1), or each voxel goes to the stroke that a random walk meets\n"
    "first (--norm 2), or between the two. Without seeds bone is label 1. A --recipe does more:\n"
    "it paints, erases, merges and splits any label, in any order (Utilities/Docs/Formats.md).\n"
    "Exit codes: 0 done, 1 wrong use, 2 bad input.");
  verb->callback(
    [&session, options]
    {
      session.run = [&session, options]
      { WithThreadLimit(options->threads, [&] { Run(*options, session); }); };
    });
}

} // namespace hasp
