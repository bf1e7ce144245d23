#include "PlanFragments.h"

#include "Failure.h"
#include "LabelInput.h"
#include "PlanFragmentLabels.h"
#include "PlanText.h"
#include "Planning/PlanLists.h"
#include "Report/ScratchFolder.h"
#include "RunSegments.h"
#include "Session.h"
#include "VerbWork.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspLabelFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>

namespace hasp
{
namespace
{

/// Throws Failure: BadInput unless each of them is one of the table's.
void RequireLabels(
  const LabelTable& table, const std::vector<std::uint16_t>& labels, const char* option)
{
  for (const std::uint16_t label : labels)
    if (std::none_of(
          table.begin(), table.end(), [&](const LabelEntry& e) { return e.value == label; }))
      throw Failure(ExitCode::BadInput, option + (" " + std::to_string(label)) +
                                          ": no fragment has this label; hasp info lists those "
                                          "of the label map");
}

/// Of the file's labels those that were asked for, with their names.
LabelTable Chosen(const LoadedLabels& labels, const std::vector<std::uint16_t>& only)
{
  const std::vector<std::uint16_t> present =
    LabelsOf(std::get<GridView<const std::uint16_t>>(ViewImage(labels.image)));
  LabelTable table = WithUnnamedLabels(labels.table, present);
  std::erase_if(table, [&](const LabelEntry& e)
    { return !std::binary_search(present.begin(), present.end(), e.value); });
  if (table.empty())
    throw Failure(ExitCode::BadInput, "the label map is empty: no voxel has a label");
  RequireLabels(table, only, "--label");
  std::erase_if(table, [&](const LabelEntry& e)
    { return !only.empty() && std::find(only.begin(), only.end(), e.value) == only.end(); });
  return table;
}

/// Each piece twice in one place could not be put together.
void RequireNew(const Plan& plan, const FragmentLabels& labels)
{
  for (const PlanFragment& fragment : plan.fragments)
    if (const auto* source = std::get_if<LabelSource>(&fragment.source))
      if (const auto* map = FindPlanObject<PlanSegmentation>(plan, source->segmentation);
          map && map->labels == labels.blob && map->recipe == SegmentationRecipe{} &&
          std::any_of(labels.fragments.begin(), labels.fragments.end(),
            [&](const LabelEntry& entry) { return entry.value == source->label; }))
        throw Failure(ExitCode::BadInput,
          "label " + std::to_string(source->label) + " of this label map is fragment " +
            std::to_string(fragment.id) + " of the plan already; --label names others");
}

} // namespace

std::vector<PlanEdit> FragmentEdits(const Plan& plan, PlanId firstId, const FragmentLabels& labels)
{
  std::vector<PlanEdit> edits;
  const auto known = std::find_if(plan.volumes.begin(), plan.volumes.end(),
    [&](const PlanVolume& volume) { return volume.hash == labels.scanHash; });
  PlanId id = firstId;
  const PlanId volume = known == plan.volumes.end() ? id++ : known->id, segmentation = id++;
  if (known == plan.volumes.end())
    edits.push_back(AddObject<PlanVolume>{ { volume, "scan", labels.scanHash } });
  edits.push_back(
    AddObject<PlanSegmentation>{ { segmentation, "fragments", volume, labels.blob } });
  for (const LabelEntry& entry : labels.fragments)
  {
    PlanFragment fragment;
    fragment.id = id++;
    fragment.name = entry.name;
    fragment.source = LabelSource{ segmentation, entry.value, labels.isovalue, labels.spacingMm };
    fragment.locked =
      std::find(labels.locked.begin(), labels.locked.end(), entry.value) != labels.locked.end();
    edits.push_back(AddObject<PlanFragment>{ std::move(fragment) });
  }
  return edits;
}

std::string StoreLabels(const std::string& planFolder, vtkImageData* labels)
{
  const ScratchFolder scratch;
  const std::string file = (std::filesystem::path(scratch.Path()) / "labels.nrrd").string();
  WriteLabels(labels, {}, file);
  return WriteBlob(planFolder, ReadWholeFile(file));
}

void AddFragmentOptions(CLI::App& verb, PlanFragmentsChoice& choice)
{
  CLI::Option* labels = verb.add_option(
    "--fragments", choice.labels, "A label map, whose labels become fragments of the plan");
  CLI::Option* scan =
    verb.add_option("--volume", choice.scan.input, "With --fragments: its scan")->needs(labels);
  labels->needs(scan);
  AddSeriesOptions(verb, choice.scan);
  verb.add_option("--isovalue", choice.isovalue, "With --fragments: bone is this and more")
    ->needs(labels)
    ->check(Within(-1e6, 1e6))
    ->capture_default_str();
  verb.add_option("--label", choice.only, "With --fragments: of these labels alone")
    ->needs(labels)
    ->check(CLI::Range(1, 65535));
  verb
    .add_option("--lock", choice.locked,
      "With --fragments: this label's stays where it is, as the cranium: the reference")
    ->needs(labels)
    ->check(CLI::Range(1, 65535));
}

std::string MakeFragments(PlanDocument& document, const std::string& planFolder,
  const PlanFragmentsChoice& choice, Session& session)
{
  VolumeChoices scan = choice.scan;
  scan.hash = true;
  const LoadedVolume volume = ReadVolume(scan, session);
  if (!volume.segments.empty())
    throw Failure(ExitCode::BadInput,
      FileLabel(scan.input) + ": is a segmentation; --volume is the scan that it is of");
  if (choice.isovalue > volume.passport.maximum)
    throw Failure(ExitCode::WrongUse,
      Line("--isovalue %.6g: no value of the scan is so large; they run from %.6g to %.6g",
        choice.isovalue, volume.passport.minimum, volume.passport.maximum));
  const LoadedLabels labels = ReadLabels(choice.labels, volume.passport.geometry, session);
  FragmentLabels made{ volume.passport.hash, {}, Chosen(labels, choice.only), choice.isovalue,
    FragmentSpacing(volume.passport.geometry.spacing), choice.locked };
  RequireLabels(made.fragments, made.locked, "--lock");
  made.blob = Try(ExitCode::WrongUse, "", [&] { return StoreLabels(planFolder, labels.image); });
  RequireNew(document.history.Current(), made);
  return Try(ExitCode::BadInput, "",
    [&]
    {
      const std::vector<PlanEdit> edits =
        FragmentEdits(document.history.Current(), document.history.NewId(), made);
      std::string label = TextOf(document.history.Current(), edits);
      document.history.Do(edits, label);
      return label;
    });
}

} // namespace hasp
