#include "Window/WindowState.h"

#include "Model/ObjectNames.h"
#include "Planning/PlanLists.h"
#include "Window/PlannerWindow.h"

namespace hasp
{

nlohmann::ordered_json StateOf(const PlannerWindow& window)
{
  Planner& parts = window.Parts();
  return { { "busy", !parts.jobs.IsIdle() }, { "pending", !window.IsSettled() },
    { "step", window.ChosenStep().toStdString() }, { "frames", parts.views.Scene().Frames() },
    { "plan", PlanHash(parts.plan.Now()) }, { "modified", parts.plan.IsModified() },
    { "message", window.LastMessage().toStdString() } };
}

QStringList WordsOf(const PlannerWindow& window)
{
  const Plan& plan = window.Parts().plan.Now();
  QStringList words{ QString::fromStdString(plan.caseLabel) };
  ForEachPlanObject(plan,
    [&](const auto& object)
    {
      if (ObjectNames::IsGiven(object))
        words += QString::fromStdString(object.name);
    });
  for (const PlanSegmentation& segmentation : plan.segmentations)
    for (const LabelName& label : segmentation.recipe.names)
      if (ObjectNames::IsGiven(label))
        words += QString::fromStdString(label.name);
  words.removeAll(QString());
  return words;
}

} // namespace hasp
