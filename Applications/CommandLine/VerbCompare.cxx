#include "Evaluation/Dice.h"
#include "Failure.h"
#include "Files.h"
#include "LabelInput.h"
#include "Session.h"
#include "VerbWork.h"
#include "Verbs.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <CLI/CLI.hpp>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>

namespace hasp
{
namespace
{

struct CompareOptions
{
  std::string labels, truth;
  std::optional<double> toleranceMm;
  bool match = false;
  double leastDice = 0.0, leastSurfaceDice = 0.0;
};

/// The truth's lattice as far as both reach: 3D Slicer crops what it saves. Throws Failure:
/// BadInput if they do not overlap.
GridGeometry AroundBoth(const GridGeometry& truth, const GridGeometry& labels)
{
  glm::dvec3 low(1e300), high(-1e300);
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 at(corner & 1, corner >> 1 & 1, corner >> 2);
    const glm::dvec3 index =
      truth.WorldToIndex(labels.IndexToWorld(at * glm::dvec3(labels.dims - 1)));
    low = glm::min(low, index);
    high = glm::max(high, index);
  }
  const glm::dvec3 end(truth.dims - 1);
  if (glm::any(glm::greaterThan(low, end)) || glm::any(glm::lessThan(high, glm::dvec3(0.0))))
    throw Failure(ExitCode::BadInput,
      "the two label maps lie apart from each other: are they of one scan, and both in LPS?");
  GridGeometry grid = truth;
  const glm::ivec3 first(glm::round(glm::min(low, glm::dvec3(0.0)))),
    last(glm::round(glm::max(high, end)));
  grid.dims = last - first + 1;
  grid.origin = truth.IndexToWorld(glm::dvec3(first));
  return grid;
}

nlohmann::ordered_json Describe(const SegmentationDice& dice, double toleranceMm)
{
  nlohmann::ordered_json json{ { "tolerance_mm", toleranceMm },
    { "labels", nlohmann::ordered_json::array() } };
  for (const LabelDice& label : dice.labels)
    json["labels"].push_back(
      { { "truth", label.truth }, { "label", label.result }, { "dice", label.Dice() },
        { "surface_dice", label.SurfaceDice() }, { "truth_voxels", label.truthVoxels },
        { "voxels", label.resultVoxels }, { "shared_voxels", label.sharedVoxels } });
  json["worst_dice"] = dice.Worst().Dice();
  json["worst_surface_dice"] = dice.WorstSurface().SurfaceDice();
  json["stray_voxels"] = dice.strayVoxels;
  return json;
}

void Print(const SegmentationDice& dice, double toleranceMm)
{
  for (const LabelDice& label : dice.labels)
  {
    std::cout << Line("label %5d  Dice %.4f  surface Dice %.4f  %zu voxels, ", int(label.truth),
      label.Dice(), label.SurfaceDice(), label.truthVoxels);
    if (label.result == label.truth)
      std::cout << label.resultVoxels << " found\n";
    else if (label.result != 0)
      std::cout << label.resultVoxels << " found, as label " << label.result << "\n";
    else
      std::cout << "not found\n";
  }
  std::cout << Line(
    "worst        Dice %.4f (label %d), surface Dice within %.3g mm %.4f (label %d)\n",
    dice.Worst().Dice(), int(dice.Worst().truth), toleranceMm, dice.WorstSurface().SurfaceDice(),
    int(dice.WorstSurface().truth));
  std::cout << "stray        " << dice.strayVoxels << (dice.strayVoxels == 1 ? " voxel" : " voxels")
            << " of labels that stand for none of the truth's\n";
}

/// Throws Failure: FailedCheck.
void RequireAgreement(const SegmentationDice& dice, const CompareOptions& options)
{
  std::vector<std::string> faults;
  for (const LabelDice& label : dice.labels)
  {
    const std::string called = "label " + std::to_string(label.truth);
    if (label.Dice() < options.leastDice)
      faults.push_back(
        called + Line(": Dice %.4f, at least %g is asked for", label.Dice(), options.leastDice));
    if (label.SurfaceDice() < options.leastSurfaceDice)
      faults.push_back(called + Line(": surface Dice %.4f, at least %g is asked for",
                                  label.SurfaceDice(), options.leastSurfaceDice));
  }
  if (!faults.empty())
    throw FailedCheck("the label maps do not agree", faults);
}

void Run(const CompareOptions& options, Session& session)
{
  for (const std::string& path : { options.labels, options.truth })
    RequireInput(path);
  const auto geometry = [](const std::string& path)
  { return Try(ExitCode::BadInput, "", [&] { return OpenVolume(path).passport.geometry; }); };
  const GridGeometry own = geometry(options.truth);
  const GridGeometry grid = AroundBoth(own, geometry(options.labels));
  const LoadedLabels truth = ReadLabels(options.truth, grid, session);
  const LoadedLabels labels = ReadLabels(options.labels, grid, session);
  const double toleranceMm =
    options.toleranceMm.value_or(std::max({ own.spacing.x, own.spacing.y, own.spacing.z }));
  session.progress.Step("comparing");
  const auto view = [](const LoadedLabels& of)
  { return std::get<GridView<const std::uint16_t>>(ViewImage(of.image)); };
  const SegmentationDice dice = Try(ExitCode::BadInput, "",
    [&]
    {
      return CompareLabels(view(truth), view(labels),
        { toleranceMm, options.match ? LabelPairing::BestMatch : LabelPairing::SameNumber });
    });
  session.progress.Wipe();
  session.result.update(Describe(dice, toleranceMm));
  if (!session.json)
    Print(dice, toleranceMm);
  RequireAgreement(dice, options);
}

} // namespace

void AddCompareVerb(CLI::App& app, Session& session)
{
  auto options = std::make_shared<CompareOptions>();
  CLI::App* verb =
    app.add_subcommand("compare", "Say how far a label map agrees with another, label by label");
  verb->add_option("LABELS", options->labels, "The label map to be judged")->required();
  verb->add_option("TRUTH", options->truth, "What it is held to, of the same scan")->required();
  verb
    ->add_option("--tolerance", options->toleranceMm,
      "Surfaces that are so near agree, mm; default: the truth's largest spacing")
    ->check(Within(0.0, 1000.0));
  verb->add_flag("--match", options->match,
    "Pair labels by what they share; without it a label stands for the one of its number");
  verb->add_option("--least-dice", options->leastDice, "Exit code 3 if a label's is less")
    ->check(Within(0.0, 1.0))
    ->capture_default_str();
  verb
    ->add_option(
      "--least-surface-dice", options->leastSurfaceDice, "Likewise, of the surfaces' agreement")
    ->check(Within(0.0, 1.0))
    ->capture_default_str();
  AddCommonOptions(*verb, session);
  verb->footer(
    "Dice is twice the voxels that both have over the voxels of both, 1 where they are the same;\n"
    "surface Dice the share of both surfaces that lies within the tolerance of the other. One\n"
    "of the two may be cropped, as 3D Slicer saves it; nothing is resampled.\n"
    "Example: hasp compare case.seg.nrrd truth.seg.nrrd --least-dice 0.95\n"
    "Exit codes: 0 done, 1 wrong use, 2 bad input, 3 a label agrees less than is asked for.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
