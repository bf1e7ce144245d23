#include "Steps/BladeNudge.h"

#include "Planning/BladePlacing.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QSignalBlocker>

#include <glm/trigonometric.hpp>

namespace hasp
{

BladeNudge::BladeNudge(QWidget* parent) : QWidget(parent)
{
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  this->Add(form, "cut.shift.normal", tr("Shift along its normal"), Way::Shift, 2);
  this->Add(form, "cut.shift.along", tr("Shift along its width"), Way::Shift, 0);
  this->Add(form, "cut.shift.across", tr("Shift along its depth"), Way::Shift, 1);
  this->Add(form, "cut.turn.along", tr("Turn about its width"), Way::Turn, 0);
  this->Add(form, "cut.turn.across", tr("Turn about its depth"), Way::Turn, 1);
  this->Add(form, "cut.turn.normal", tr("Turn in its plane"), Way::Turn, 2);
}

void BladeNudge::Add(
  QFormLayout* form, const QString& name, const QString& label, Way way, int axis)
{
  const bool shifts = way == Way::Shift;
  auto* box = new QDoubleSpinBox;
  box->setObjectName(name);
  box->setRange(shifts ? -200.0 : -180.0, shifts ? 200.0 : 180.0);
  box->setDecimals(shifts ? 2 : 1);
  box->setSingleStep(shifts ? 0.5 : 1.0);
  box->setSuffix(shifts ? QStringLiteral(" mm") : QStringLiteral("°"));
  box->setKeyboardTracking(false);
  connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
    [this, box, way, axis] { this->Nudge(box, way, axis); });
  form->addRow(label, box);
}

void BladeNudge::Nudge(QDoubleSpinBox* box, Way way, int axis)
{
  const double by = box->value();
  {
    const QSignalBlocker quiet(box);
    box->setValue(0.0);
  }
  if (by == 0.0 || !this->blade)
    return;
  const Osteotomy before = this->blade();
  glm::dvec3 shift(0.0);
  if (way == Way::Shift)
    shift[axis] = by;
  Q_EMIT this->Nudged(way == Way::Shift ? ShiftedBlade(before, shift)
                                        : TurnedBlade(before, glm::angleAxis(glm::radians(by),
                                                                BladeAxes(before)[axis])));
}

} // namespace hasp
