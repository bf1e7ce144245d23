#pragma once
#include <QString>

class QBoxLayout;
class QCheckBox;
class QDoubleSpinBox;
class QPushButton;
class QWidget;

namespace hasp
{

/// What panels are made of, each behind what their layout has already. RENDER.

/// For widgets side by side.
QBoxLayout* AddRow(QBoxLayout* layout);
QPushButton* AddButton(QBoxLayout* layout, const char* name, const QString& text);
QCheckBox* AddCheckBox(QBoxLayout* layout, const char* name, const QString& text);

/// Tab comes to it right before what comes after `place`: of a widget that is made when the window
/// is there already, and which would be the last.
void PutInTabOrder(QWidget* place, QWidget* made);

struct NumberRange
{
  double least = 0.0, most = 1.0, value = 0.0;
  QString unit;
  int decimals = 1;
};
/// With its label, unless that is empty. Typed numbers count when they are complete.
QDoubleSpinBox* AddSpinBox(
  QBoxLayout* layout, const char* name, const QString& label, const NumberRange& range);

} // namespace hasp
