#include "Steps/PanelWidgets.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>

namespace hasp
{

QBoxLayout* AddRow(QBoxLayout* layout)
{
  auto* row = new QHBoxLayout;
  layout->addLayout(row);
  return row;
}

QPushButton* AddButton(QBoxLayout* layout, const char* name, const QString& text)
{
  auto* button = new QPushButton(text);
  button->setObjectName(QLatin1String(name));
  layout->addWidget(button);
  return button;
}

QCheckBox* AddCheckBox(QBoxLayout* layout, const char* name, const QString& text)
{
  auto* box = new QCheckBox(text);
  box->setObjectName(QLatin1String(name));
  layout->addWidget(box);
  return box;
}

void PutInTabOrder(QWidget* place, QWidget* made)
{
  QWidget* row = made; // what it came with is as new
  while (row->parentWidget() != place)
    row = row->parentWidget();
  QWidget* last = place; // of those in it, which may be none that Tab comes to
  for (QWidget* next = place->nextInFocusChain(); next != place; next = next->nextInFocusChain())
    if (place->isAncestorOf(next) && next != row && !row->isAncestorOf(next))
      last = next;
  while (last->focusPolicy() == Qt::NoFocus)
    last = last->previousInFocusChain();
  if (last != made) // else nothing that is focused is before it
    QWidget::setTabOrder(last, made);
}

QDoubleSpinBox* AddSpinBox(
  QBoxLayout* layout, const char* name, const QString& label, const NumberRange& range)
{
  auto* box = new QDoubleSpinBox;
  box->setObjectName(QLatin1String(name));
  box->setDecimals(range.decimals);
  box->setRange(range.least, range.most);
  box->setValue(range.value);
  box->setSuffix(range.unit);
  box->setKeyboardTracking(false);
  if (!label.isEmpty())
  {
    auto* text = new QLabel(label);
    text->setBuddy(box);
    layout->addWidget(text);
  }
  layout->addWidget(box);
  return box;
}

} // namespace hasp
