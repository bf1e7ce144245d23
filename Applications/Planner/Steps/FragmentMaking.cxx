#include "Steps/FragmentMaking.h"

#include "Model/ObjectNames.h"
#include "PlanFragmentLabels.h"
#include "Planning/PlanLists.h"
#include "Steps/LabelFindings.h"
#include "Steps/LabelMaps.h"
#include "Tools/StrokeEdits.h"
#include "vtkHaspVolumeView.h"

#include <QCoreApplication>
#include <QPointer>

#include <algorithm>
#include <memory>

namespace hasp
{
namespace
{

struct FragmentMaking
{
  Q_DECLARE_TR_FUNCTIONS(hasp::FragmentMaking)
};

/// What a WORKER hands back.
struct MadeLabels
{
  PlanId segmentation = 0;
  DerivedPart part;
  LabelTable present;
  double spacingMm = 0.5;
  std::vector<SegmentationFinding> findings;
  double voxelMm3 = 0.0;
};

/// `label`: 0: any.
bool IsFragment(const Plan& plan, PlanId segmentation, std::uint32_t label = 0)
{
  return std::any_of(plan.fragments.begin(), plan.fragments.end(),
    [&](const PlanFragment& fragment)
    {
      const auto* source = std::get_if<LabelSource>(&fragment.source);
      return source && source->segmentation == segmentation &&
             (label == 0 || source->label == label);
    });
}

/// Names and colours of labels as the recipe has them.
LabelTable TableOf(const PlanSegmentation& segmentation, const std::vector<std::uint16_t>& labels)
{
  LabelTable names;
  for (const LabelName& name : segmentation.recipe.names)
    names.push_back({ name.label, name.name, name.colour });
  LabelTable table = WithUnnamedLabels(std::move(names), labels);
  std::erase_if(table, [&](const LabelEntry& entry)
    { return !std::binary_search(labels.begin(), labels.end(), entry.value); });
  return table;
}

MadeLabels MakeLabels(const PlanSnapshot& snapshot, PlanId id, const ProgressFunction& progress)
{
  const auto* segmentation = FindPlanObject<PlanSegmentation>(snapshot.plan, id);
  const vtkSmartPointer<vtkImageData>& scan = snapshot.scans.at(segmentation->volume);
  MadeLabelMap map = MakeLabelMap(snapshot.plan, id, scan, snapshot.folder, progress);
  const std::vector<std::uint16_t> labels =
    LabelsOf(std::get<GridView<const std::uint16_t>>(ViewImage(map.labels)));
  return { id, std::move(map.part), TableOf(*segmentation, labels),
    FragmentSpacing(ImageGeometry(scan).spacing), std::move(map.findings), map.voxelMm3 };
}

/// What has become of it, and what a planner would look for in vain. A fault where a label that was
/// painted has become nothing.
void Tell(Planner& planner, const QString& made, const LabelNotes& notes)
{
  const QStringList sentences = QStringList{ made } + notes.faults + notes.others;
  const QString text = sentences.join(' ');
  if (notes.faults.isEmpty())
    planner.Say(text);
  else
    planner.SayFault(text);
}

void Take(Planner& planner, const MadeLabels& made)
{
  const Plan& plan = planner.plan.Now();
  const auto* segmentation = FindPlanObject<PlanSegmentation>(plan, made.segmentation);
  if (!segmentation)
  {
    planner.SayFault(FragmentMaking::tr("What was painted is no longer in the plan: no fragments "
                                        "were made of it."));
    return;
  }
  const LabelNotes notes = NotesOf(segmentation->recipe, made.findings, made.voxelMm3);
  planner.plan.KeepMade(made.part);
  const std::vector<PlanEdit> edits =
    FragmentsOfLabels(plan, planner.plan.NewId(), made.segmentation, made.present, made.spacingMm);
  if (!edits.empty() && !planner.plan.Do(edits, FragmentMaking::tr("Make fragments")))
    return;
  if (!WhyOutOfDate(planner.plan.Now(), made.part).empty())
    planner.SayFault(
      FragmentMaking::tr("It was painted on meanwhile: make the fragments once more."));
  else if (made.present.empty())
    planner.SayFault(FragmentMaking::tr("There is no bone in it: choose a lower isovalue."));
  else if (!edits.empty())
    Tell(planner, FragmentMaking::tr("Fragments made: %1.").arg(edits.size()), notes);
  else if (IsFragment(plan, made.segmentation))
    Tell(planner, FragmentMaking::tr("The fragments are as they are painted now."), notes);
  else
    Tell(planner, FragmentMaking::tr("No fragment was made."), notes);
}

} // namespace

void MakeFragmentsOf(Planner& planner, PlanId segmentation)
{
  PlanSnapshot snapshot(planner.plan.Document(), planner.scans, planner.plan.Folder());
  const auto* wanted = FindPlanObject<PlanSegmentation>(snapshot.plan, segmentation);
  if (!wanted || !snapshot.scans.contains(wanted->volume))
  {
    planner.SayFault(
      FragmentMaking::tr("The scan that was painted on is not here: locate it in the "
                         "step Import."));
    return;
  }
  planner.jobs.Add(FragmentMaking::tr("Making fragments"),
    [me = QPointer<Planner>(&planner), snapshot = std::move(snapshot), segmentation](
      const ProgressFunction& progress) -> JobQueue::Finish
    {
      auto made = std::make_shared<const MadeLabels>(MakeLabels(snapshot, segmentation, progress));
      return [me, made]
      {
        if (me)
          Take(*me, *made);
      };
    });
}

std::vector<PlanEdit> FragmentsOfLabels(const Plan& plan, PlanId firstId, PlanId segmentation,
  const LabelTable& present, double spacingMm)
{
  const auto* painted = FindPlanObject<PlanSegmentation>(plan, segmentation);
  const ThresholdStep* bone = painted ? ThresholdOf(*painted) : nullptr;
  const bool isSplit = painted && SplitOf(*painted);
  std::vector<PlanEdit> edits;
  for (const LabelEntry& entry : present)
  {
    if ((isSplit && entry.value == 1) || IsFragment(plan, segmentation, entry.value))
      continue;
    PlanFragment fragment;
    fragment.id = firstId++;
    fragment.name = ObjectNames::OfFragment(fragment.id, entry.value, entry.name);
    fragment.colour = entry.colour;
    LabelSource source{ segmentation, entry.value };
    source.isovalue = bone ? bone->lowest : source.isovalue;
    source.spacingMm = spacingMm;
    fragment.source = source;
    edits.push_back(AddObject<PlanFragment>{ std::move(fragment) });
  }
  return edits;
}

void MakePieces(Planner& planner, double leastMm3)
{
  if (!planner.scene.ShownImage())
  {
    planner.SayFault(FragmentMaking::tr("No scan is shown: import one, or show it."));
    return;
  }
  PlanSegmentation pieces;
  pieces.id = planner.plan.NewId();
  pieces.name = FragmentMaking::tr("pieces of bone").toStdString();
  pieces.volume = planner.scene.ShownVolume();
  pieces.recipe.steps = { ThresholdStep{ planner.scene.Isovalue() },
    ComponentsStep{ 1, leastMm3 } };
  const PlanId id = pieces.id;
  if (planner.plan.Do(
        AddObject<PlanSegmentation>{ std::move(pieces) }, FragmentMaking::tr("Take bone apart")))
    MakeFragmentsOf(planner, id);
}

bool AddBoneAt(Planner& planner, const glm::dvec3& place)
{
  const ShelfScan* scan = planner.scans.OfVolume(planner.plan.Now(), planner.scene.ShownVolume());
  if (!scan)
  {
    planner.SayFault(FragmentMaking::tr("No scan is shown: import one, or show it."));
    return false;
  }
  PlanFragment bone;
  bone.id = planner.plan.NewId();
  bone.name = ObjectNames::Of<PlanFragment>(bone.id);
  bone.colour = UnnamedLabel(std::uint16_t(2 + planner.plan.Now().fragments.size())).colour;
  bone.source = ComponentSource{ planner.scene.ShownVolume(), planner.scene.Isovalue(), place,
    FragmentSpacing(scan->passport.geometry.spacing) };
  return planner.plan.Do(
    AddObject<PlanFragment>{ std::move(bone) }, FragmentMaking::tr("Bone from here"));
}

} // namespace hasp
