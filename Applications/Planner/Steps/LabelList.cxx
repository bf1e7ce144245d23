#include "Steps/LabelList.h"

#include "Grid/LabelTable.h"
#include "Model/ObjectNames.h"
#include "Tools/StrokeEdits.h"

#include <QColorDialog>
#include <QHBoxLayout>
#include <QListWidget>
#include <QPixmap>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace hasp
{
namespace
{

constexpr int LabelRole = Qt::UserRole;
constexpr int FirstLabel = 2; ///< 1 is bone that nobody has named yet
constexpr int Offered = 2;    ///< before anybody asks for more

QColor ColourOf(const LabelName& name)
{
  return { name.colour[0], name.colour[1], name.colour[2] };
}

bool IsOf(const std::vector<LabelName>& names, std::uint16_t label)
{
  return std::any_of(
    names.begin(), names.end(), [&](const LabelName& name) { return name.label == label; });
}

LabelName NewName(int label)
{
  const auto number = std::uint16_t(label);
  return { number, ObjectNames::OfLabel(number), UnnamedLabel(number).colour };
}

std::vector<LabelName> NewNames()
{
  std::vector<LabelName> names;
  for (int label = FirstLabel; label < FirstLabel + Offered; ++label)
    names.push_back(NewName(label));
  return names;
}

/// With those that strokes have and nobody has named.
std::vector<LabelName> NamesOf(const PlanSegmentation& painted)
{
  std::vector<LabelName> names = painted.recipe.names;
  if (const SplitStep* split = SplitOf(painted))
    for (const BrushStroke& stroke : split->strokes)
      if (!IsOf(names, stroke.label))
        names.push_back(NewName(stroke.label));
  std::sort(names.begin(), names.end(),
    [](const LabelName& a, const LabelName& b) { return a.label < b.label; });
  return names;
}

} // namespace

LabelList::LabelList(Planner& planner, QWidget* parent)
  : QWidget(parent),
    Of(planner),
    List(new QListWidget),
    Colour(new QPushButton(tr("Colo&ur…"))),
    Coming(NewNames())
{
  this->List->setObjectName("split.label");
  this->List->setAccessibleName(tr("Labels that are painted"));
  this->List->setMaximumHeight(120);
  this->List->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
  this->Colour->setObjectName("split.label.colour");
  auto* add = new QPushButton(tr("&Add label"));
  add->setObjectName("split.label.add");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->List);
  auto* row = new QHBoxLayout;
  row->addWidget(add);
  row->addWidget(this->Colour);
  layout->addLayout(row);

  connect(add, &QPushButton::clicked, this, &LabelList::Add);
  connect(this->Colour, &QPushButton::clicked, this, &LabelList::Recolour);
  connect(this->List, &QListWidget::itemChanged, this, &LabelList::Rename);
  connect(this->List, &QListWidget::currentRowChanged, this,
    [this] { Q_EMIT this->LabelChosen(this->Label()); });
  connect(&planner.plan, &PlanSession::Replaced, this, [this] { this->Coming = NewNames(); });
  connect(&planner.plan, &PlanSession::Changed, this, &LabelList::Refresh);
  connect(&planner.scene, &PlanScene::PropsChanged, this, &LabelList::Refresh);
  this->Refresh();
}

int LabelList::Label() const
{
  const QListWidgetItem* item = this->List->currentItem();
  return item ? item->data(LabelRole).toInt() : FirstLabel;
}

void LabelList::Refresh()
{
  const PlanSegmentation* painted = PaintedIn(this->Of.plan.Now(), this->Of.scene.ShownVolume());
  std::vector<LabelName> names = painted ? NamesOf(*painted) : this->Coming;
  if (names == this->Shown)
    return;
  const int chosen = this->Label();
  this->Shown = std::move(names);
  {
    const QSignalBlocker quiet(this->List);
    this->List->clear();
    for (const LabelName& name : this->Shown)
    {
      QPixmap swatch(16, 16);
      swatch.fill(ColourOf(name));
      auto* item = new QListWidgetItem(swatch, QString::fromStdString(name.name), this->List);
      item->setData(LabelRole, int(name.label));
      item->setFlags(item->flags() | Qt::ItemIsEditable);
      item->setToolTip(tr("Label %1").arg(name.label));
      if (name.label == chosen)
        this->List->setCurrentItem(item);
    }
    if (!this->List->currentItem())
      this->List->setCurrentRow(0);
  }
  Q_EMIT this->NamesChanged();
  if (this->Label() != chosen)
    Q_EMIT this->LabelChosen(this->Label());
}

void LabelList::Keep(std::vector<LabelName> names, const QString& step)
{
  const PlanSegmentation* painted = PaintedIn(this->Of.plan.Now(), this->Of.scene.ShownVolume());
  if (painted)
  {
    PlanSegmentation changed = *painted;
    changed.recipe.names = std::move(names);
    this->Of.plan.Do(ChangeObject<PlanSegmentation>{ std::move(changed) }, step);
  }
  else
    this->Coming = std::move(names);
  this->Shown.clear(); // as the plan has them, also where it has refused what was typed
  this->Refresh();
}

void LabelList::Add()
{
  std::vector<LabelName> names = this->Shown;
  const int label = names.empty() ? FirstLabel : names.back().label + 1;
  if (label > 65535)
    return;
  names.push_back(NewName(label));
  this->Keep(std::move(names), tr("Add label %1").arg(label));
  this->List->setCurrentRow(this->List->count() - 1);
}

void LabelList::Recolour()
{
  const int row = this->List->currentRow();
  if (row < 0)
    return;
  const QColor chosen = QColorDialog::getColor(
    ColourOf(this->Shown[std::size_t(row)]), this, tr("Colour of the label"));
  if (!chosen.isValid() || row >= int(this->Shown.size())) // another scan is shown by now
    return;
  std::vector<LabelName> names = this->Shown;
  names[std::size_t(row)].colour = { std::uint8_t(chosen.red()), std::uint8_t(chosen.green()),
    std::uint8_t(chosen.blue()) };
  this->Keep(std::move(names), tr("Colour label %1").arg(this->Label()));
}

void LabelList::Rename(QListWidgetItem* item)
{
  const int row = this->List->row(item);
  std::vector<LabelName> names = this->Shown;
  names[std::size_t(row)].name = item->text().trimmed().toStdString();
  if (names == this->Shown)
    return;
  const int label = item->data(LabelRole).toInt();
  // The list is built anew by what follows, and this is called by an item of it.
  QMetaObject::invokeMethod(
    this,
    [this, names = std::move(names), label]
    { this->Keep(names, tr("Rename label %1").arg(label)); },
    Qt::QueuedConnection);
}

} // namespace hasp
