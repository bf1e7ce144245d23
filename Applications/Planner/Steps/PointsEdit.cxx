#include "Steps/PointsEdit.h"

#include "Steps/NumberText.h"
#include "Tools/Planner.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QHideEvent>
#include <QLocale>
#include <QPushButton>
#include <QShortcut>
#include <QTableWidget>
#include <QVBoxLayout>

#include <glm/geometric.hpp>

#include <utility>

namespace hasp
{

namespace
{
constexpr int ShownRows = 4, RowPixels = 24;
constexpr double SameMm = 1e-9;
} // namespace

PointsEdit::PointsEdit(Planner& planner, const QString& name, const QString& text,
  LandmarkPurpose purpose, Space space, QWidget* parent)
  : QWidget(parent),
    Of(planner),
    In(space),
    Hand(planner, std::move(purpose)),
    List(new QTableWidget(0, 3))
{
  this->Build(name, text);
  auto* remove =
    new QShortcut(QKeySequence::Delete, this->List, nullptr, nullptr, Qt::WidgetShortcut);
  connect(remove, &QShortcut::activated, this, [this] { this->Hand.RemoveSelected(); });
  connect(this->Touch, &QPushButton::clicked, this,
    [this](bool on) { on ? this->Take() : this->PutAway(); });
  connect(this->Crosshair, &QPushButton::clicked, this, [this] { this->Hand.TouchCrosshair(); });
  connect(this->Remove, &QPushButton::clicked, this, [this] { this->Hand.RemoveSelected(); });
  connect(this->Up, &QPushButton::clicked, this, [this] { this->Swap(-1); });
  connect(this->Down, &QPushButton::clicked, this, [this] { this->Swap(1); });
  connect(&planner.tools, &ToolBox::Changed, this,
    [this] { this->Touch->setChecked(this->Of.tools.InHand() == &this->Hand); });
  connect(&this->Hand, &LandmarkTool::Edited, this,
    [this]
    {
      this->Fill();
      Q_EMIT this->Edited();
    });
  connect(&this->Hand, &LandmarkTool::SelectedChanged, this, &PointsEdit::ShowSelected);
  connect(this->List, &QTableWidget::currentCellChanged, this,
    [this](int place)
    {
      if (!this->Filling)
        this->Hand.Select(place);
    });
  connect(this->List, &QTableWidget::itemChanged, this, &PointsEdit::Type);
}

void PointsEdit::Build(const QString& name, const QString& text)
{
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  auto* below = new QHBoxLayout;
  auto* side = new QVBoxLayout;
  const auto add =
    [&](QBoxLayout* into, const QString& called, const QString& shown, const QString& tip)
  {
    auto* button = new QPushButton(shown);
    button->setObjectName(called);
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    into->addWidget(button);
    return button;
  };
  this->Touch = add(row, name, text, tr("Touch places in the views"));
  this->Touch->setCheckable(true);
  const QString plain = QString(text).remove('&');
  this->Touch->setAccessibleName(plain);
  row->setStretch(0, 1);
  this->Crosshair = add(row, name + ".crosshair", tr("At the +"), tr("A place at the crosshair"));
  this->Remove = add(side, name + ".remove", QStringLiteral("−"), tr("Remove the chosen place"));
  this->Up = add(side, name + ".up", QStringLiteral("↑"), tr("The chosen place sooner"));
  this->Down = add(side, name + ".down", QStringLiteral("↓"), tr("The chosen place later"));
  for (QPushButton* button : { this->Remove, this->Up, this->Down })
    button->setMaximumWidth(28);
  side->addStretch(1);
  const bool single = this->Hand.Purpose().most == 1;
  this->Up->setHidden(single);
  this->Down->setHidden(single);
  this->List->setObjectName(name + ".list");
  this->List->setAccessibleName(plain);
  this->List->setHorizontalHeaderLabels({ tr("x"), tr("y"), tr("z, mm") });
  this->List->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  this->List->horizontalHeader()->setMinimumSectionSize(30);
  this->List->verticalHeader()->setDefaultSectionSize(RowPixels);
  this->List->setSelectionMode(QAbstractItemView::SingleSelection);
  this->List->setTabKeyNavigation(false); // Tab goes on
  this->List->setFixedHeight((single ? 2 : ShownRows + 1) * RowPixels + 8);
  below->addWidget(this->List, 1);
  below->addLayout(side);
  column->addLayout(row);
  column->addLayout(below);
}

glm::dvec3 PointsEdit::PointOf(const TouchedPlace& place) const
{
  return this->In == Space::Scan ? place.inScan : place.world;
}

std::vector<glm::dvec3> PointsEdit::Points() const
{
  std::vector<glm::dvec3> points;
  for (const TouchedPlace& place : this->Places())
    points.push_back(this->PointOf(place));
  return points;
}

void PointsEdit::SetPoints(const std::vector<glm::dvec3>& points, PlanId object)
{
  const Plan& plan = this->Of.plan.Now();
  std::vector<TouchedPlace> places;
  for (const glm::dvec3& point : points)
  {
    TouchedPlace place =
      this->In == Space::Scan ? PlaceOfScan(plan, object, point) : PlaceOfPlan(plan, object, point);
    for (const TouchedPlace& known : this->Places())
      if (glm::distance(this->PointOf(known), point) < SameMm)
        place = this->In == Space::Scan ? PlaceOfScan(plan, known.object, point)
                                        : PlaceOfPlan(plan, known.object, point),
        place.normal = known.normal;
    places.push_back(place);
  }
  this->SetPlaces(std::move(places));
}

void PointsEdit::SetPlaces(std::vector<TouchedPlace> places)
{
  this->Hand.SetPlaces(std::move(places));
  this->Fill();
}

void PointsEdit::Take()
{
  this->Of.tools.Take(&this->Hand);
}

void PointsEdit::PutAway()
{
  if (this->Of.tools.InHand() == &this->Hand)
    this->Of.tools.Take(nullptr);
}

void PointsEdit::showEvent(QShowEvent* event)
{
  this->Hand.Show(true);
  QWidget::showEvent(event);
}

void PointsEdit::hideEvent(QHideEvent* event)
{
  if (!event->spontaneous()) // else it is the window that goes out of sight
  {
    this->PutAway();
    this->Hand.Show(false);
  }
  QWidget::hideEvent(event);
}

void PointsEdit::Fill()
{
  this->Filling = true;
  this->List->setRowCount(int(this->Places().size()));
  for (int row = 0; row < this->List->rowCount(); ++row)
    for (int axis = 0; axis < 3; ++axis)
    {
      QTableWidgetItem* item = this->List->item(row, axis);
      if (!item)
        this->List->setItem(row, axis, item = new QTableWidgetItem);
      const double value = this->PointOf(this->Places()[std::size_t(row)])[axis];
      item->setText(QString::number(value, 'f', 2));
    }
  this->Filling = false;
  this->ShowSelected(this->Hand.Selected());
}

void PointsEdit::ShowSelected(int place)
{
  const bool filling = std::exchange(this->Filling, true); // its row may not be there yet
  this->List->setCurrentCell(place, place < 0 ? -1 : 0);
  this->Filling = filling;
}

void PointsEdit::Type(QTableWidgetItem* item)
{
  if (this->Filling)
    return;
  std::vector<TouchedPlace> places = this->Places();
  bool good = false;
  const double value = QLocale::c().toDouble(item->text().replace(QChar(0x2212), '-'), &good);
  if (!good || std::abs(value) > 4000.0)
  {
    this->Of.SayFault(tr("A place is a number of millimetres, from -4000 to 4000."));
    this->Fill();
    return;
  }
  TouchedPlace& place = places.at(std::size_t(item->row()));
  glm::dvec3 point = this->PointOf(place);
  point[item->column()] = value;
  const Plan& plan = this->Of.plan.Now();
  place = this->In == Space::Scan ? PlaceOfScan(plan, place.object, point)
                                  : PlaceOfPlan(plan, place.object, point);
  this->SetPlaces(std::move(places));
  Q_EMIT this->Edited();
}

void PointsEdit::Swap(int by)
{
  std::vector<TouchedPlace> places = this->Places();
  const int from = this->Hand.Selected(), to = from + by;
  if (from < 0 || to < 0 || to >= int(places.size()))
    return;
  std::swap(places[std::size_t(from)], places[std::size_t(to)]);
  this->SetPlaces(std::move(places));
  this->Hand.Select(to);
  Q_EMIT this->Edited();
}

} // namespace hasp
