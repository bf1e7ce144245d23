#include "Steps/LabelFindings.h"

#include "Model/ObjectNames.h"
#include "SegmentationWarnings.h"

#include <QCoreApplication>

#include <algorithm>
#include <variant>

namespace hasp
{
namespace
{

struct LabelFindings
{
  Q_DECLARE_TR_FUNCTIONS(hasp::LabelFindings)
};

QString Called(std::uint16_t label)
{
  return QString::fromStdString(ObjectNames::OfLabel(label));
}

void AddSplit(LabelNotes& notes, const SegmentationFinding& found, double mm3)
{
  for (const std::uint16_t label : found.withoutSeeds)
    notes.faults << LabelFindings::tr(
      "%1 gets no bone: its strokes touch none, or later ones paint over them.")
                      .arg(Called(label));
  if (found.walk && !found.walk->converged)
    notes.faults << LabelFindings::tr(
      "Sharing out bone did not come to its end: look at where fragments meet.");
  if (!found.besideBone.empty())
    notes.others
      << LabelFindings::tr("Strokes that touch no bone: %1.").arg(found.besideBone.size());
  if (found.unreached > 0)
    notes.others << LabelFindings::tr(
      "Left out is bone that no stroke is connected to: %1 mm³ (voxels: %2).")
                      .arg(double(found.unreached) * mm3, 0, 'f', 1)
                      .arg(found.unreached);
}

/// Why a step of the planner's own buttons has changed nothing; of others in a file's words.
QString WhyNothing(const SegmentationRecipe& recipe, std::size_t number,
  const SegmentationFinding& found, double mm3)
{
  const SegmentationStep& step = recipe.steps[number];
  if (const auto* fill = std::get_if<FillStep>(&step))
    return LabelFindings::tr("%1 has no cavity to fill.").arg(Called(fill->label));
  if (const auto* close = std::get_if<MorphologyStep>(&step))
    return LabelFindings::tr("Of %1 nothing changes within %2 mm.")
      .arg(Called(close->label))
      .arg(close->radiusMm);
  if (std::holds_alternative<ComponentsStep>(step))
    return LabelFindings::tr("The bone is one piece.");
  const std::string called = LabelFindings::tr("Step %1").arg(number + 1).toStdString();
  return QString::fromStdString(WarningsOf(step, found, { called }, mm3).front()) + '.';
}

} // namespace

LabelNotes NotesOf(const SegmentationRecipe& recipe,
  const std::vector<SegmentationFinding>& findings, double voxelMm3)
{
  LabelNotes notes;
  for (std::size_t n = 0; n < std::min(findings.size(), recipe.steps.size()); ++n)
    if (std::holds_alternative<SplitStep>(recipe.steps[n]))
      AddSplit(notes, findings[n], voxelMm3);
    else if (findings[n].changedNothing)
      notes.others << WhyNothing(recipe, n, findings[n], voxelMm3);
  return notes;
}

} // namespace hasp
