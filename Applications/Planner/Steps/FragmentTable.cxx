#include "Steps/FragmentTable.h"

#include "Planning/PlanLists.h"
#include "Steps/ReductionWork.h"

#include <QHeaderView>
#include <QPixmap>
#include <QSignalBlocker>

#include <algorithm>

namespace hasp
{
namespace
{

enum Column
{
  NameColumn,
  FitsColumn,
  OtherColumn
};
constexpr int IdRole = Qt::UserRole;

PlanId IdOf(const QTreeWidgetItem* item)
{
  return item->data(NameColumn, IdRole).toUInt();
}

QString NameOf(const Plan& plan, const PlanFragment& fragment)
{
  QString name = QString::fromStdString(fragment.name);
  if (name.isEmpty())
    name = FragmentTable::tr("fragment %1").arg(fragment.id);
  for (const PlanGroup& group : plan.groups)
    if (std::find(group.fragments.begin(), group.fragments.end(), fragment.id) !=
        group.fragments.end())
      name += FragmentTable::tr(", group %1").arg(group.id);
  return fragment.locked ? FragmentTable::tr("%1 (stays)").arg(name) : name;
}

} // namespace

FragmentTable::FragmentTable(Planner& planner, QWidget* parent) : QTreeWidget(parent), Of(planner)
{
  this->setObjectName("reduce.fragments");
  this->setAccessibleName(tr("Fragments"));
  this->setRootIsDecorated(false);
  this->setSelectionMode(QAbstractItemView::ExtendedSelection);
  this->setHeaderLabels({ tr("Fragment"), tr("Fits"), tr("Other bone") });
  this->headerItem()->setToolTip(FitsColumn, tr("Takes part when fragments are put together"));
  this->headerItem()->setToolTip(
    OtherColumn, tr("Is only touched, and nothing is fitted to it: as the cranium for a mandible"));
  this->header()->setSectionResizeMode(NameColumn, QHeaderView::Stretch);
  for (const Column narrow : { FitsColumn, OtherColumn })
    this->header()->setSectionResizeMode(narrow, QHeaderView::ResizeToContents);
  this->header()->setStretchLastSection(false);
  connect(this, &QTreeWidget::itemChanged, this, &FragmentTable::Note);
  connect(this, &QTreeWidget::itemSelectionChanged, this,
    [this]
    {
      if (this->currentItem() && this->currentItem()->isSelected())
        this->Of.scene.Select(IdOf(this->currentItem()));
      Q_EMIT this->SelectionChanged();
    });
  connect(&planner.scene, &PlanScene::SelectedChanged, this, &FragmentTable::FollowScene);
  connect(&planner.plan, &PlanSession::Replaced, this,
    [this]
    {
      this->LeftOut.clear(); // of fragments of the old plan
      this->OtherBone.clear();
    });
  connect(&planner.plan, &PlanSession::Changed, this, &FragmentTable::Refresh);
  this->Refresh();
}

void FragmentTable::Refresh()
{
  const std::vector<PlanId> selected = this->Selected();
  {
    const QSignalBlocker quiet(this);
    this->clear();
    const Plan& plan = this->Of.plan.Now();
    for (const PlanId id : ReducibleFragments(plan))
    {
      const PlanFragment& fragment = *FindPlanObject<PlanFragment>(plan, id);
      auto* item = new QTreeWidgetItem(this, { NameOf(plan, fragment) });
      item->setData(NameColumn, IdRole, id);
      QPixmap swatch(16, 16);
      swatch.fill(QColor(fragment.colour[0], fragment.colour[1], fragment.colour[2]));
      item->setIcon(NameColumn, swatch);
      item->setCheckState(FitsColumn, this->LeftOut.contains(id) ? Qt::Unchecked : Qt::Checked);
      item->setCheckState(OtherColumn, this->OtherBone.contains(id) ? Qt::Checked : Qt::Unchecked);
      item->setSelected(std::find(selected.begin(), selected.end(), id) != selected.end());
    }
  }
  this->FollowScene();
  Q_EMIT this->SelectionChanged();
}

/// What is selected there is current here, unless it is among several.
void FragmentTable::FollowScene()
{
  const PlanId id = this->Of.scene.Selected();
  for (int row = 0; row < this->topLevelItemCount(); ++row)
  {
    QTreeWidgetItem* item = this->topLevelItem(row);
    if (IdOf(item) != id || item->isSelected())
      continue;
    {
      const QSignalBlocker quiet(this); // the scene has it already
      this->setCurrentItem(item);
    }
    Q_EMIT this->SelectionChanged();
  }
}

void FragmentTable::Note(QTreeWidgetItem* item, int column)
{
  const bool checked = item->checkState(column) == Qt::Checked;
  std::set<PlanId>& ids = column == FitsColumn ? this->LeftOut : this->OtherBone;
  if (column == NameColumn)
    return;
  if (checked == (column == FitsColumn))
    ids.erase(IdOf(item));
  else
    ids.insert(IdOf(item));
}

std::vector<PlanId> FragmentTable::Selected() const
{
  std::vector<PlanId> ids;
  for (const QTreeWidgetItem* item : this->selectedItems())
    ids.push_back(IdOf(item));
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::vector<PlanId> FragmentTable::Fitted() const
{
  std::vector<PlanId> ids;
  const Plan& plan = this->Of.plan.Now();
  for (const PlanId id : ReducibleFragments(plan))
    if (!FindPlanObject<PlanFragment>(plan, id)->locked && !this->LeftOut.contains(id) &&
        !this->OtherBone.contains(id))
      ids.push_back(id);
  return ids;
}

std::vector<PlanId> FragmentTable::Obstacles() const
{
  std::vector<PlanId> ids;
  for (const PlanId id : ReducibleFragments(this->Of.plan.Now()))
    if (this->OtherBone.contains(id))
      ids.push_back(id);
  return ids;
}

} // namespace hasp
