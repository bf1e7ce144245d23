#include "Steps/ReductionProposals.h"

#include "Planning/PlanLists.h"
#include "PropPose.h"
#include "Steps/PanelWidgets.h"
#include "Steps/WrappedRows.h"

#include "vtkProp3D.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace hasp
{
namespace
{

constexpr int LeastLines = 18;

/// Little holds it: faces are planned to 2 mm.
bool IsWide(const ReducedUnit& unit)
{
  return !(unit.assembled.within95Mm <= 2.0);
}

/// What is to be thought of it.
QString VerdictOf(const ReducedUnit& unit)
{
  const bool undecided = unit.assembled.proposals.undecided;
  if (IsWide(unit))
    return undecided ? ReductionProposals::tr("wide and undecided: little holds it, look before "
                                              "you use it, and at the next one, too")
                     : ReductionProposals::tr("wide: little holds it, look before you use it");
  return undecided ? ReductionProposals::tr("undecided: look at the next one, too")
                   : ReductionProposals::tr("placed");
}

}

QString UnitText(const ReducedUnit& unit)
{
  const AssembledUnit& made = unit.assembled;
  const QString called = unit.group != 0
                           ? ReductionProposals::tr("group %1").arg(unit.group)
                           : ReductionProposals::tr("fragment %1").arg(unit.fragments.front());
  if (made.turn == 0)
    return made.placed
             ? ReductionProposals::tr("%1 stays where it is").arg(called)
             : ReductionProposals::tr("%1 is not placed: no face is in its reach").arg(called);
  return ReductionProposals::tr(
    "%1, %2.\nAt 95 % within %3 mm and %4°; turned %5°, faces %6 mm² at %7 mm")
    .arg(called, VerdictOf(unit))
    .arg(made.within95Mm, 0, 'f', 2)
    .arg(made.fit.spread.within95Degrees, 0, 'f', 1)
    .arg(glm::degrees(glm::length(RotationVector(made.groupInWorld.orientation))), 0, 'f', 1)
    .arg(made.fit.sums.facesMm2, 0, 'f', 0)
    .arg(made.fit.FaceRmsMm(), 0, 'f', 2);
}

QString ProposalText(const ReducedUnit& unit, std::size_t number)
{
  const FitProposal& proposal = unit.assembled.proposals.proposals.at(number);
  return ReductionProposals::tr(
    "%1: %2 % likely, within %3 mm; %4 mm from where it was, faces %5 mm² at %6 mm")
    .arg(number + 1)
    .arg(100.0 * proposal.share, 0, 'f', 0)
    .arg(proposal.fit.spread.within95Mm, 0, 'f', 2)
    .arg(proposal.startMm, 0, 'f', 2)
    .arg(proposal.fit.sums.facesMm2, 0, 'f', 0)
    .arg(proposal.fit.FaceRmsMm(), 0, 'f', 2);
}

ReductionProposals::ReductionProposals(Planner& planner, QWidget* parent)
  : QWidget(parent),
    Of(planner),
    Tree(new QTreeWidget)
{
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  this->Tree->setObjectName("reduce.proposals");
  this->Tree->setAccessibleName(tr("Proposals"));
  this->Tree->setHeaderHidden(true);
  new WrappedRows(*this->Tree);
  this->Tree->setMinimumHeight(LeastLines * this->fontMetrics().lineSpacing());
  layout->addWidget(this->Tree);
  auto* row = new QHBoxLayout;
  this->Preview = AddButton(row, "reduce.preview", tr("Show in &the view"));
  this->Preview->setCheckable(true);
  this->TakeIt = AddButton(row, "reduce.take", tr("Ta&ke"));
  layout->addLayout(row);
  connect(this->Tree, &QTreeWidget::itemChanged, this, &ReductionProposals::Chosen);
  connect(this->Preview, &QPushButton::clicked, this, &ReductionProposals::SetPreview);
  connect(this->TakeIt, &QPushButton::clicked, this, &ReductionProposals::Take);
  connect(&planner.plan, &PlanSession::Changed, this, &ReductionProposals::Follow);
  connect(&planner.scene, &PlanScene::PropsChanged, this,
    [this]
    {
      if (this->Shows)
        this->Place(); // props that are new
    });
  this->Clear();
}

void ReductionProposals::Show(std::shared_ptr<const ReductionResult> result)
{
  this->Clear();
  if (!IsOf(this->Of.plan.Now(), *result))
  {
    this->Of.SayFault(tr("Fragments have changed while they were put together: do it again."));
    return;
  }
  this->Result = std::move(result);
  this->Fill();
  const std::vector<ReducedUnit>& units = this->Result->reduction.units;
  if (std::none_of(units.begin(), units.end(),
        [](const ReducedUnit& unit) { return unit.assembled.turn > 0; }))
    this->Of.SayFault(tr("No fragment has a face within reach of another's: move them nearer by "
                         "hand first, or say how far they may be off."));
  this->show();
}

void ReductionProposals::Fill()
{
  const QSignalBlocker quiet(this->Tree);
  for (const ReducedUnit& unit : this->Result->reduction.units)
  {
    auto* item = new QTreeWidgetItem(this->Tree, { UnitText(unit) });
    if (unit.assembled.turn == 0)
      continue;
    item->setCheckState(0, IsWide(unit) ? Qt::Unchecked : Qt::Checked); // then it is looked at
    for (std::size_t n = 0; n < unit.assembled.proposals.proposals.size(); ++n)
    {
      auto* proposal = new QTreeWidgetItem(item, { ProposalText(unit, n) });
      proposal->setCheckState(0, n == 0 ? Qt::Checked : Qt::Unchecked);
    }
    item->setExpanded(true);
  }
  this->TakeIt->setEnabled(true);
  this->Preview->setEnabled(true);
}

void ReductionProposals::Clear()
{
  this->SetPreview(false);
  this->Result = nullptr;
  this->Tree->clear();
  this->TakeIt->setEnabled(false);
  this->Preview->setEnabled(false);
  this->hide();
}

void ReductionProposals::Follow()
{
  if (this->Result && !IsOf(this->Of.plan.Now(), *this->Result))
    this->Clear();
}

/// One proposal of a unit is checked, not more and not less.
void ReductionProposals::Chosen(QTreeWidgetItem* item)
{
  if (QTreeWidgetItem* unit = item->parent())
  {
    const QSignalBlocker quiet(this->Tree);
    for (int n = 0; n < unit->childCount(); ++n)
      unit->child(n)->setCheckState(0, unit->child(n) == item ? Qt::Checked : Qt::Unchecked);
  }
  if (this->Shows)
    this->Place();
}

PoseFragments ReductionProposals::Edit() const
{
  const PlanReduction& reduction = this->Result->reduction;
  std::vector<std::size_t> chosen(reduction.units.size(), 0);
  std::vector<PlanId> leftOut;
  for (std::size_t unit = 0; unit < chosen.size(); ++unit)
  {
    const QTreeWidgetItem* item = this->Tree->topLevelItem(int(unit));
    for (int n = 0; n < item->childCount(); ++n)
      if (item->child(n)->checkState(0) == Qt::Checked)
        chosen[unit] = std::size_t(n);
    const std::vector<PlanId>& ids = reduction.units[unit].fragments;
    if (item->checkState(0) != Qt::Checked)
      leftOut.insert(leftOut.end(), ids.begin(), ids.end());
  }
  PoseFragments edit = ReductionEdit(this->Of.plan.Now(), reduction, chosen);
  std::erase_if(edit.poses, [&](const FragmentPose& pose)
    { return std::find(leftOut.begin(), leftOut.end(), pose.fragment) != leftOut.end(); });
  return edit;
}

void ReductionProposals::SetPreview(bool on)
{
  const bool was = std::exchange(this->Shows, on && this->Result);
  this->Preview->setChecked(this->Shows);
  if (this->Shows)
  {
    Q_EMIT this->PreviewBegins();
    this->Place();
  }
  else if (was)
    this->PlaceBack();
}

void ReductionProposals::Place()
{
  this->PlaceBack(); // those that are not checked any more
  for (const FragmentPose& pose : this->Edit().poses)
    if (vtkProp3D* prop = this->Of.scene.PropOf(pose.fragment))
      SetUserPose(prop, { pose.scanToPlanned.position, pose.scanToPlanned.orientation });
}

void ReductionProposals::PlaceBack()
{
  for (const PlanFragment& fragment : this->Of.plan.Now().fragments)
    if (vtkProp3D* prop = this->Of.scene.PropOf(fragment.id))
      SetUserPose(prop, { fragment.scanToPlanned.position, fragment.scanToPlanned.orientation });
  this->Of.views.DrawAll();
}

void ReductionProposals::Take()
{
  const PoseFragments edit = this->Result ? this->Edit() : PoseFragments{};
  if (edit.poses.empty())
    this->Of.SayFault(tr("No unit that was placed is checked: there is nothing to take."));
  else
    this->Of.plan.Do(edit, tr("Put fragments together"));
}

} // namespace hasp
