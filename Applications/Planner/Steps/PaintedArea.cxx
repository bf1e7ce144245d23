#include "Steps/PaintedArea.h"

#include "Steps/PanelWidgets.h"
#include "Tools/Planner.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QHideEvent>
#include <QLabel>
#include <QPushButton>

namespace hasp
{

PaintedArea::PaintedArea(Planner& planner, QWidget* parent)
  : QWidget(parent),
    Of(planner),
    Brush(planner),
    Count(new QLabel)
{
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto *row = new QHBoxLayout, *below = new QHBoxLayout;
  this->Paint = AddButton(row, "guide.paint", tr("&Paint"));
  this->Wipe = AddButton(row, "guide.wipe", tr("&Wipe off"));
  QPushButton* crosshair = AddButton(row, "guide.paint.crosshair", tr("At the +"));
  crosshair->setToolTip(tr("A dab at the crosshair"));
  this->Radius =
    AddSpinBox(below, "guide.brush", tr("Radius"), { 0.5, 100.0, this->Brush.radiusMm, tr(" mm") });
  QPushButton* clear = AddButton(below, "guide.paint.clear", tr("Clear"));
  this->Count->setObjectName("guide.paint.count");
  column->addLayout(row);
  column->addLayout(below);
  column->addWidget(this->Count);
  for (QPushButton* button : { this->Paint, this->Wipe })
  {
    button->setCheckable(true);
    connect(button, &QPushButton::clicked, this,
      [this, wipe = button == this->Wipe](bool on) { this->Take(wipe, on); });
  }
  connect(crosshair, &QPushButton::clicked, this, [this] { this->Brush.DabCrosshair(); });
  connect(this->Radius, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
    [this](double mm) { this->Brush.radiusMm = mm; });
  connect(clear, &QPushButton::clicked, this,
    [this]
    {
      this->All.clear();
      Q_EMIT this->Cleared();
    });
  connect(&planner.tools, &ToolBox::Changed, this,
    [this]
    {
      const bool held = this->Of.tools.InHand() == &this->Brush;
      this->Paint->setChecked(held && !this->Brush.Erases());
      this->Wipe->setChecked(held && this->Brush.Erases());
    });
  connect(&this->Brush, &AreaTool::Painted, this,
    [this](const GuideStroke& stroke, const TouchedPlace& first)
    {
      this->All.push_back(stroke);
      Q_EMIT this->Painted(first);
    });
  this->SetStrokes({}, 0);
}

void PaintedArea::Take(bool wipe, bool on)
{
  this->Brush.SetErases(wipe);
  this->Of.tools.Take(on ? &this->Brush : nullptr);
}

void PaintedArea::hideEvent(QHideEvent* event)
{
  if (!event->spontaneous() && this->Of.tools.InHand() == &this->Brush)
    this->Of.tools.Take(nullptr);
  QWidget::hideEvent(event);
}

void PaintedArea::SetStrokes(const std::vector<GuideStroke>& strokes, PlanId bone)
{
  this->All = strokes;
  this->Brush.SetStrokes(strokes, bone);
  this->Count->setText(
    strokes.empty() ? tr("Nothing is painted.") : tr("Strokes: %1").arg(strokes.size()));
}

} // namespace hasp
