#include "Window/ObjectList.h"

#include "Planning/DerivedPart.h"
#include "Planning/PlanEdits.h"
#include "Planning/PlanLists.h"
#include "Tools/Planner.h"

#include <QHeaderView>
#include <QPainter>
#include <QPixmap>

#include <algorithm>
#include <map>
#include <set>

namespace hasp
{
namespace
{
constexpr int IdRole = Qt::UserRole;
constexpr int IndentPixels = 10, LockPixels = 26; // names need the room

PlanId IdOf(const QTreeWidgetItem* item)
{
  return item->data(0, IdRole).toUInt();
}

QString KindTitle(const char* noun)
{
  static const std::map<std::string, const char*> titles{
    { "volume", QT_TRANSLATE_NOOP("hasp::ObjectList", "Scans") },
    { "segmentation", QT_TRANSLATE_NOOP("hasp::ObjectList", "Segmentations") },
    { "surface", QT_TRANSLATE_NOOP("hasp::ObjectList", "Surfaces") },
    { "fragment", QT_TRANSLATE_NOOP("hasp::ObjectList", "Fragments") },
    { "group", QT_TRANSLATE_NOOP("hasp::ObjectList", "Groups") },
    { "cut", QT_TRANSLATE_NOOP("hasp::ObjectList", "Cuts") },
    { "guide", QT_TRANSLATE_NOOP("hasp::ObjectList", "Guides") },
    { "plate", QT_TRANSLATE_NOOP("hasp::ObjectList", "Plates") },
    { "implant", QT_TRANSLATE_NOOP("hasp::ObjectList", "Implants") },
    { "transplant", QT_TRANSLATE_NOOP("hasp::ObjectList", "Transplants") },
    { "mitre-guide", QT_TRANSLATE_NOOP("hasp::ObjectList", "Mitre guides") },
    { "measure", QT_TRANSLATE_NOOP("hasp::ObjectList", "Measures") },
    { "mirror", QT_TRANSLATE_NOOP("hasp::ObjectList", "Ghosts") },
  };
  return ObjectList::tr(titles.at(noun));
}

QPixmap Swatch(const std::array<std::uint8_t, 3>& colour)
{
  QPixmap swatch(14, 14);
  swatch.fill(QColor(colour[0], colour[1], colour[2]));
  return swatch;
}

/// In place of a word that would take the room from names.
QPixmap Padlock(const QColor& colour)
{
  QPixmap lock(14, 14);
  lock.fill(Qt::transparent);
  QPainter painter(&lock);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colour, 1.6));
  painter.drawArc(QRectF(4, 1.5, 6, 9), 0, 180 * 16);
  painter.fillRect(2, 6, 10, 7, colour);
  return lock;
}

QString StateOf(const PlanSession& plan, const PlanFragment& fragment)
{
  if (fragment.state == FragmentState::Resected)
    return ObjectList::tr("resected");
  return IsDivided(plan.Now(), fragment.id) ? ObjectList::tr("in pieces") : QString();
}

/// Of what is made: guides, plates and so on.
template <typename T>
QString StateOf(const PlanSession& plan, const T& object)
{
  if constexpr (std::is_same_v<T, PlanMeasure>)
    return object.kind == MeasureKind::Distance
             ? ObjectList::tr("%1 mm").arg(MeasureValue(plan.Now(), object), 0, 'f', 2)
             : ObjectList::tr("%1°").arg(MeasureValue(plan.Now(), object), 0, 'f', 1);
  else if (std::is_same_v<T, PlanGroup> || !IsPartObject(plan.Now(), object.id))
    return {};
  else if (PartInDate(plan.Now(), plan.Document().parts, object.id))
    return ObjectList::tr("in date");
  const bool made = std::any_of(plan.Document().parts.begin(), plan.Document().parts.end(),
    [&](const DerivedPart& part) { return part.object == object.id; });
  return made ? ObjectList::tr("out of date") : ObjectList::tr("not made");
}
} // namespace

ObjectList::ObjectList(Planner& planner, QWidget* parent) : QTreeWidget(parent), Of(planner)
{
  this->setObjectName("objects");
  this->setColumnCount(Columns);
  this->setHeaderLabels({ tr("Object"), {}, tr("State") });
  this->headerItem()->setIcon(Lock, Padlock(this->palette().text().color()));
  this->headerItem()->setToolTip(Lock, tr("Lock"));
  this->setIndentation(IndentPixels);
  this->header()->setSectionResizeMode(Name, QHeaderView::Stretch);
  this->header()->setMinimumSectionSize(LockPixels);
  this->header()->setSectionResizeMode(Lock, QHeaderView::Fixed);
  this->header()->resizeSection(Lock, LockPixels);
  this->header()->setSectionResizeMode(State, QHeaderView::ResizeToContents);
  this->header()->setStretchLastSection(false);
  this->setSelectionMode(QAbstractItemView::ExtendedSelection);
  this->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
  this->setContextMenuPolicy(Qt::ActionsContextMenu);
  this->setAccessibleName(tr("Objects of the plan"));
  this->AddActions();
  connect(this, &QTreeWidget::itemChanged, this, &ObjectList::TakeChange);
  connect(this, &QTreeWidget::itemSelectionChanged, this, &ObjectList::FollowSelection);
  connect(&planner.plan, &PlanSession::Changed, this, &ObjectList::Refresh);
  connect(&planner.plan, &PlanSession::PartsChanged, this, &ObjectList::Refresh);
  connect(&planner.scene, &PlanScene::PropsChanged, this, &ObjectList::Refresh);
  this->Refresh();
}

void ObjectList::Refresh()
{
  if (this->state() == EditingState) // a name that is being typed is not to be lost
  {
    this->Stale = true;
    return;
  }
  this->Stale = false;
  const std::vector<PlanId> chosen = this->Chosen();
  const std::set<PlanId> again(chosen.begin(), chosen.end());
  const PlanId current = this->currentItem() ? IdOf(this->currentItem()) : 0;
  this->Filling = true;
  this->clear();
  this->Fill();
  for (QTreeWidgetItemIterator at(this); *at; ++at)
  {
    if (current != 0 && IdOf(*at) == current) // where the keyboard is
      this->setCurrentItem(*at, Name, QItemSelectionModel::NoUpdate);
    (*at)->setSelected(again.contains(IdOf(*at)));
  }
  this->Filling = false;
}

void ObjectList::closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint)
{
  QTreeWidget::closeEditor(editor, hint);
  if (this->Stale) // once Qt is done with the item
    QMetaObject::invokeMethod(this, &ObjectList::Refresh, Qt::QueuedConnection);
}

void ObjectList::Fill()
{
  const Plan& plan = this->Of.plan.Now();
  ForEachPlanList(
    [&](const auto& list)
    {
      const auto& objects = plan.*list.objects;
      if (objects.empty())
        return;
      auto* kind = new QTreeWidgetItem(this, { KindTitle(list.noun) });
      kind->setFlags(Qt::ItemIsEnabled);
      kind->setExpanded(true);
      for (const auto& object : objects)
      {
        auto* item = new QTreeWidgetItem(
          kind, { object.name.empty() ? QString::fromStdString(CalledObject(plan, object.id))
                                      : QString::fromStdString(object.name) });
        item->setData(0, IdRole, object.id);
        item->setFlags(
          Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable | Qt::ItemIsUserCheckable);
        item->setCheckState(
          Name, this->Of.scene.IsVisible(object.id) ? Qt::Checked : Qt::Unchecked);
        item->setText(State, StateOf(this->Of.plan, object));
        item->setToolTip(Name, QString::fromStdString(CalledObject(plan, object.id)));
        if constexpr (requires { object.colour; })
        {
          item->setIcon(Name, Swatch(object.colour));
          item->setCheckState(Lock, object.locked ? Qt::Checked : Qt::Unchecked);
        }
      }
    });
}

std::vector<PlanId> ObjectList::Chosen() const
{
  std::vector<PlanId> chosen;
  for (const QTreeWidgetItem* item : this->selectedItems())
    if (IdOf(item) != 0)
      chosen.push_back(IdOf(item));
  return chosen;
}

void ObjectList::TakeChange(QTreeWidgetItem* item, int column)
{
  const PlanId id = IdOf(item);
  if (this->Filling || id == 0)
    return;
  const Plan& plan = this->Of.plan.Now();
  const auto* fragment = FindPlanObject<PlanFragment>(plan, id);
  if (column == Lock && fragment)
  {
    PlanFragment changed = *fragment;
    changed.locked = item->checkState(Lock) == Qt::Checked;
    if (changed.locked != fragment->locked &&
        !this->Of.plan.Do(ChangeObject<PlanFragment>{ changed }))
      this->Refresh();
  }
  if (column != Name)
    return;
  const bool shown = item->checkState(Name) == Qt::Checked;
  if (shown != this->Of.scene.IsVisible(id))
    this->Of.scene.SetVisible(id, shown);
  else if (!this->Of.plan.Do(RenameObject{ id, item->text(Name).toStdString() }))
    this->Refresh(); // it is called as before
}

void ObjectList::FollowSelection()
{
  if (this->Filling)
    return;
  const std::vector<PlanId> chosen = this->Chosen();
  this->Of.scene.Select(chosen.size() == 1 ? chosen.front() : 0);
}

} // namespace hasp
