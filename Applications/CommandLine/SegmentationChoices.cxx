#include "SegmentationChoices.h"

#include "ImageSteps.h"
#include "RecipePart.h"
#include "Session.h"
#include "VerbWork.h"
#include "vtkHaspVolumeFile.h"
#include "vtkHaspVolumeView.h"

#include "Planning/SegmentationRecipeFile.h"
#include "Segmentation/ThresholdPresets.h"
#include "Segmentation/ThresholdProposal.h"
#include "vtkImageData.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace hasp
{
namespace
{

const ThresholdPreset& PresetOf(const std::string& name)
{
  for (const ThresholdPreset& preset : ThresholdPresets())
    if (name == preset.name)
      return preset;
  throw Failure(ExitCode::WrongUse, "--preset: there is none of that name");
}

Seeds ReadSeedFiles(const SegmentationChoices& choices)
{
  for (const std::string& path : choices.seeds)
    RequireInput(path);
  const std::string label =
    choices.seeds.size() == 1 ? FileLabel(choices.seeds[0]) + ": " : "--seeds: ";
  return Try(ExitCode::BadInput, label,
    [&] { return ReadSeeds(choices.seeds, { .radiusMm = choices.seedRadiusMm }); });
}

/// Strokes of label 1 say what shall stay bone without a name. Few users mean that.
void SayUnnamedBone(const Seeds& seeds, Session& session)
{
  const auto isBone = [](const BrushStroke& stroke) { return stroke.label == 1; };
  if (std::any_of(seeds.strokes.begin(), seeds.strokes.end(), isBone) &&
      !std::all_of(seeds.strokes.begin(), seeds.strokes.end(), isBone))
    SayWarning(session,
      "strokes of label 1 keep bone that nobody has named: what goes to them cannot be told from "
      "bone that no stroke is connected to; number fragments from 2 on");
}

std::vector<SegmentationStep> FiltersOf(const SegmentationChoices& choices)
{
  std::vector<SegmentationStep> steps;
  if (choices.coneBeam)
    steps.push_back(ConeBeamStep{ choices.fieldMm, 0.0, choices.insideAbove });
  if (choices.medianMm > 0.0)
    steps.push_back(MedianStep{ choices.medianMm });
  if (choices.gaussianMm > 0.0)
    steps.push_back(GaussianStep{ choices.gaussianMm });
  return steps;
}

/// What is done to bone before it is shared out.
void AddBoneSteps(const SegmentationChoices& choices, std::vector<SegmentationStep>& steps)
{
  if (choices.openMm > 0.0)
    steps.push_back(MorphologyStep{ 1, Morphology::Open, choices.openMm });
  if (choices.closeMm > 0.0)
    steps.push_back(MorphologyStep{ 1, Morphology::Close, choices.closeMm });
  if (choices.fill)
    steps.push_back(FillStep{ 1 });
  if (choices.keepLargest)
    steps.push_back(ComponentsStep{ 1, 0.0, true });
}

/// None: it is left open.
std::optional<ThresholdStep> Threshold(
  const SegmentationChoices& choices, const Passport& passport, Session& session)
{
  if (choices.threshold)
    return ThresholdStep{ *choices.threshold };
  if (!choices.preset.empty())
  {
    const ThresholdPreset& preset = PresetOf(choices.preset);
    if (!passport.hounsfield || choices.coneBeam)
      SayWarning(session, std::string("--preset is a range of HU, and ") +
                            (choices.coneBeam ? "--cone-beam changes values"
                                              : "the file does not say that its values are") +
                            ": leave it out, and a threshold is proposed");
    return ThresholdStep{ preset.lowest, preset.highest };
  }
  if (passport.hounsfield && !choices.coneBeam)
    return ThresholdStep{};
  return std::nullopt;
}

/// Steps between the threshold and the seeds, in their order. Other orders and labels are for
/// recipes.
std::vector<CLI::Option*> AddBoneOptions(CLI::App& verb, SegmentationChoices& choices)
{
  return { verb
             .add_option("--open", choices.openMm,
               "After the threshold: take off what is thinner than a ball of this radius, mm")
             ->check(Within(0.01, 50.0)),
    verb
      .add_option("--close", choices.closeMm, "Then bridge gaps that such a ball does not fit in")
      ->check(Within(0.01, 50.0)),
    verb.add_flag("--fill", choices.fill, "Then fill cavities of bone"),
    verb.add_flag("--keep-largest", choices.keepLargest,
      "Then keep its largest piece alone: no head-rest, and no jaw that does not touch the "
      "skull") };
}

} // namespace

ThresholdStep ProposeThresholdStep(vtkImageData* image, double smoothMm, Session& session)
{
  session.progress.Step("proposing a threshold");
  const ThresholdProposal proposal = Try(ExitCode::BadInput, "",
    [&]
    {
      vtkSmartPointer<vtkImageData> values = image;
      if (smoothMm > 0.0)
        values = ApplyStep(image, GaussianStep{ smoothMm }, {});
      return ProposeThreshold(ViewImage(values));
    });
  SayWarning(session,
    Line("the threshold is proposed from the histogram, since nothing says that the values are HU: "
         "%.6g; bone and soft tissue are %.1f deviations apart%s",
      proposal.threshold, proposal.separation,
      proposal.separation < 2.0 ? ", which no threshold parts well" : "") +
      "; thin bone may be lost: look at it, and give --threshold (226 where the values are HU)");
  return { proposal.threshold, ThresholdStep{}.highest, smoothMm };
}

void AddSegmentationOptions(CLI::App& verb, SegmentationChoices& choices)
{
  CLI::Option* recipe = verb.add_option("--recipe", choices.recipe, "The .json file of all steps");
  CLI::Option* threshold =
    verb.add_option("--threshold", choices.threshold, "Bone is value >= this")
      ->check(Within(-1e6, 1e6));
  std::vector<std::string> presets;
  for (const ThresholdPreset& preset : ThresholdPresets())
    presets.emplace_back(preset.name);
  CLI::Option* preset = verb.add_option("--preset", choices.preset, "Or a range of HU by its name")
                          ->check(CLI::IsMember(presets))
                          ->excludes(threshold);
  CLI::Option* seeds = verb.add_option("--seeds", choices.seeds,
    "Strokes of each fragment: a .json file, or a .mrk.json file of 3D Slicer; more: --seeds "
    "again");
  seeds->allow_extra_args(false); // what stands behind it is IN
  CLI::Option* radius =
    verb.add_option("--seed-radius", choices.seedRadiusMm, "Of strokes whose file says none, mm")
      ->check(Within(0.01, 50.0))
      ->capture_default_str()
      ->needs(seeds);
  CLI::Option* beta =
    verb.add_option("--beta", choices.beta, "How much an edge in the image parts fragments")
      ->check(Within(0.0, 1e12))
      ->capture_default_str()
      ->needs(seeds);
  CLI::Option* crack = verb
                         .add_option("--crack", choices.crack,
                           "How deep a dark line parts them, of bone's grey; 0: none does")
                         ->check(Within(0.0, 1.0))
                         ->capture_default_str()
                         ->needs(seeds);
  CLI::Option* norm =
    verb
      .add_option("--norm", choices.norm,
        "1: borders keep to edges and cracks (least cut); 2: to the middle, too (random walk)")
      ->check(Within(1.0, 2.0))
      ->capture_default_str()
      ->needs(seeds);
  CLI::Option* components = verb
                              .add_option("--components", choices.leastMm3,
                                "Make fragments of bone's pieces of at least so many mm3")
                              ->check(Within(0.0, 1e9))
                              ->excludes(seeds);
  CLI::Option* gaussian =
    verb.add_option("--gaussian", choices.gaussianMm, "Blur before, mm")->check(Within(1e-3, 10.0));
  CLI::Option* median =
    verb.add_option("--median", choices.medianMm, "Median before, mm")->check(Within(1e-3, 10.0));
  CLI::Option* smooth = verb
                          .add_option("--smooth", choices.smoothMm,
                            "Blur for the threshold alone, mm: splits still see cracks")
                          ->check(Within(1e-3, 10.0));
  CLI::Option* coneBeam =
    verb.add_flag("--cone-beam", choices.coneBeam, "Take cupping out of a cone-beam scan before");
  CLI::Option* field =
    verb.add_option("--field", choices.fieldMm, "Cupping is smooth over this length, mm")
      ->check(Within(10.0, 500.0))
      ->capture_default_str()
      ->needs(coneBeam);
  CLI::Option* inside =
    verb.add_option("--inside-above", choices.insideAbove, "The patient is value > this")
      ->check(Within(-1e6, 1e6))
      ->capture_default_str()
      ->needs(coneBeam);
  for (CLI::Option* option : { threshold, preset, seeds, radius, beta, crack, norm, components,
         gaussian, median, smooth, coneBeam, field, inside })
    recipe->excludes(option);
  for (CLI::Option* option : AddBoneOptions(verb, choices))
    recipe->excludes(option);
}

ChosenSegmentation ChooseSegmentation(
  const SegmentationChoices& choices, const Passport& passport, Session& session)
{
  ChosenSegmentation chosen;
  if (!choices.recipe.empty())
  {
    chosen.recipe = ReadRecipeFile(choices.recipe, ReadSegmentationRecipe);
    return chosen;
  }
  SplitStep split;
  if (!choices.seeds.empty())
  {
    chosen.seeds = ReadSeedFiles(choices);
    const Seeds& seeds = *chosen.seeds;
    if (seeds.notPlaced > 0)
      SayWarning(session, seeds.notPlaced == 1
                            ? "1 control point has no place yet; it is left out"
                            : std::to_string(seeds.notPlaced) +
                                " control points have no place yet; they are left out");
    SayUnnamedBone(seeds, session);
    split = { 1, seeds.strokes, choices.beta, choices.crack, choices.norm };
    chosen.recipe.names = seeds.names;
  }
  chosen.recipe.steps = FiltersOf(choices);
  const std::optional<ThresholdStep> threshold = Threshold(choices, passport, session);
  if (!threshold)
    chosen.openThreshold = chosen.recipe.steps.size();
  ThresholdStep bone = threshold.value_or(ThresholdStep{});
  bone.smoothMm = choices.smoothMm;
  chosen.recipe.steps.push_back(bone);
  AddBoneSteps(choices, chosen.recipe.steps);
  if (!choices.seeds.empty())
    chosen.recipe.steps.push_back(std::move(split));
  else if (choices.leastMm3)
    chosen.recipe.steps.push_back(ComponentsStep{ 1, *choices.leastMm3 });
  return chosen;
}

} // namespace hasp
