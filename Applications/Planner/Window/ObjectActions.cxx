// What ObjectList does with what is chosen.
#include "Model/ObjectNames.h"
#include "Planning/PlanEdits.h"
#include "Planning/PlanLists.h"
#include "Steps/MoveEdits.h"
#include "Tools/Planner.h"
#include "Window/ObjectList.h"

#include <QAction>
#include <QColorDialog>

#include <algorithm>

namespace hasp
{
namespace
{
std::vector<PlanId> FragmentsAmong(const Plan& plan, const std::vector<PlanId>& chosen)
{
  std::vector<PlanId> fragments;
  std::copy_if(chosen.begin(), chosen.end(), std::back_inserter(fragments),
    [&](PlanId id) { return FindPlanObject<PlanFragment>(plan, id) != nullptr; });
  return fragments;
}
} // namespace

void ObjectList::AddActions()
{
  const auto add = [this](const QString& text, const char* name, const QKeySequence& key, auto act)
  {
    auto* action = new QAction(text, this);
    action->setObjectName(name);
    action->setShortcut(key);
    action->setShortcutContext(Qt::WidgetShortcut);
    connect(action, &QAction::triggered, this, act);
    this->addAction(action);
  };
  add(tr("Re&name"), "objects.rename", QKeySequence("F2"), &ObjectList::RenameCurrent);
  add(tr("S&how, or hide"), "objects.show", {}, &ObjectList::ShowChosen);
  add(tr("&Lock, or take that back"), "objects.lock", {}, &ObjectList::LockChosen);
  add(tr("&Remove"), "objects.remove", QKeySequence::Delete, &ObjectList::RemoveChosen);
  add(tr("&Group"), "objects.group", QKeySequence("Ctrl+G"), &ObjectList::GroupChosen);
  add(tr("Re&sect, or take that back"), "objects.resect", {}, &ObjectList::ResectChosen);
  add(tr("&Colour …"), "objects.colour", {}, &ObjectList::ColourChosen);
}

void ObjectList::RenameCurrent()
{
  QTreeWidgetItem* item = this->currentItem();
  if (item && item->flags().testFlag(Qt::ItemIsEditable))
    this->editItem(item, Name);
}

/// All that are hidden are shown; where none is, all are hidden.
void ObjectList::ShowChosen()
{
  const std::vector<PlanId> chosen = this->Chosen();
  PlanScene& scene = this->Of.scene;
  const bool all =
    std::all_of(chosen.begin(), chosen.end(), [&](PlanId id) { return scene.IsVisible(id); });
  for (const PlanId id : chosen)
    scene.SetVisible(id, !all);
}

void ObjectList::LockChosen()
{
  const Plan& plan = this->Of.plan.Now();
  const std::vector<PlanId> fragments = FragmentsAmong(plan, this->Chosen());
  if (fragments.empty())
    return this->Of.SayFault(tr("Choose the fragments that shall stay where they are."));
  this->Of.plan.Do(LockEdits(plan, fragments));
}

void ObjectList::RemoveChosen()
{
  std::vector<PlanId> chosen = this->Chosen();
  if (chosen.empty())
    return;
  std::sort(chosen.rbegin(), chosen.rend()); // what names others is younger
  std::vector<PlanEdit> edits;
  for (const PlanId id : chosen)
    edits.push_back(RemoveObject{ id });
  this->Of.plan.Do(std::move(edits));
}

void ObjectList::GroupChosen()
{
  std::vector<PlanId> fragments = FragmentsAmong(this->Of.plan.Now(), this->Chosen());
  if (fragments.size() < 2)
    return this->Of.SayFault(tr("Choose the two or more fragments that shall move as one."));
  PlanGroup group;
  group.id = this->Of.plan.NewId();
  group.name = ObjectNames::Of<PlanGroup>(group.id);
  std::sort(fragments.begin(), fragments.end());
  group.fragments = std::move(fragments);
  this->Of.plan.Do(AddObject<PlanGroup>{ std::move(group) });
}

void ObjectList::ResectChosen()
{
  const Plan& plan = this->Of.plan.Now();
  SetFragmentState edit;
  edit.fragments = FragmentsAmong(plan, this->Chosen());
  if (edit.fragments.empty())
    return this->Of.SayFault(tr("Choose the fragments that shall be resected."));
  const bool all = std::all_of(edit.fragments.begin(), edit.fragments.end(),
    [&](PlanId id)
    { return FindPlanObject<PlanFragment>(plan, id)->state == FragmentState::Resected; });
  edit.state = all ? FragmentState::Kept : FragmentState::Resected;
  this->Of.plan.Do(edit);
}

void ObjectList::ColourChosen()
{
  const Plan& plan = this->Of.plan.Now();
  const std::vector<PlanId> fragments = FragmentsAmong(plan, this->Chosen());
  if (fragments.empty())
    return this->Of.SayFault(tr("Choose the fragments that shall have another colour."));
  const auto& before = FindPlanObject<PlanFragment>(plan, fragments.front())->colour;
  const QColor colour =
    QColorDialog::getColor(QColor(before[0], before[1], before[2]), this, tr("Colour"));
  if (!colour.isValid())
    return;
  std::vector<PlanEdit> edits;
  for (const PlanId id : fragments)
  {
    const auto* fragment = FindPlanObject<PlanFragment>(plan, id);
    if (!fragment)
      continue; // a job has ended while the colour was chosen
    PlanFragment changed = *fragment;
    changed.colour = { std::uint8_t(colour.red()), std::uint8_t(colour.green()),
      std::uint8_t(colour.blue()) };
    edits.push_back(ChangeObject<PlanFragment>{ changed });
  }
  if (!edits.empty())
    this->Of.plan.Do(std::move(edits), tr("Change colour"));
}

} // namespace hasp
