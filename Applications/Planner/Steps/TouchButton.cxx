#include "Steps/TouchButton.h"

#include "Tools/Planner.h"

#include <QHBoxLayout>
#include <QHideEvent>
#include <QPushButton>

namespace hasp
{

TouchButton::TouchButton(
  Planner& planner, const QString& name, const QString& text, const QString& hint, QWidget* parent)
  : QWidget(parent),
    Of(planner),
    Hand(planner, { hint, 1 }),
    Button(new QPushButton(text))
{
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  this->Button->setObjectName(name);
  this->Button->setToolTip(hint);
  this->Button->setCheckable(true);
  row->addWidget(this->Button, 1);
  auto* crosshair = new QPushButton(tr("At the +"));
  crosshair->setObjectName(name + ".crosshair");
  crosshair->setToolTip(tr("The place at the crosshair"));
  crosshair->setAccessibleName(tr("The place at the crosshair"));
  row->addWidget(crosshair);
  connect(this->Button, &QPushButton::clicked, this,
    [this](bool on) { this->Of.tools.Take(on ? &this->Hand : nullptr); });
  connect(crosshair, &QPushButton::clicked, this, [this] { this->Hand.TouchCrosshair(); });
  connect(&planner.tools, &ToolBox::Changed, this,
    [this] { this->Button->setChecked(this->Of.tools.InHand() == &this->Hand); });
  connect(&this->Hand, &LandmarkTool::Edited, this,
    [this]
    {
      if (this->Hand.Places().empty())
        return;
      const TouchedPlace place = this->Hand.Places().back();
      this->Hand.SetPlaces({});
      if (this->Of.tools.InHand() == &this->Hand)
        this->Of.tools.Take(nullptr);
      Q_EMIT this->Touched(place);
    });
}

void TouchButton::hideEvent(QHideEvent* event)
{
  if (!event->spontaneous() && this->Of.tools.InHand() == &this->Hand)
    this->Of.tools.Take(nullptr);
  QWidget::hideEvent(event);
}

} // namespace hasp
