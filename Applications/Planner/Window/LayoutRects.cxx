#include "Window/LayoutRects.h"

#include <QAbstractScrollArea>
#include <QCheckBox>
#include <QGroupBox>
#include <QRadioButton>
#include <QStyle>
#include <QStyleOptionGroupBox>
#include <QWidget>

namespace hasp
{

QRect OnScreen(const QWidget& widget, const QRect& rect)
{
  return { widget.mapToGlobal(rect.topLeft()), rect.size() };
}

QRect Shown(const QWidget& widget, const QRect& rect)
{
  QRect rest = OnScreen(widget, rect & widget.rect());
  const QWidget* inner = &widget;
  while (!inner->isWindow() && inner->parentWidget())
  {
    inner = inner->parentWidget();
    rest &= OnScreen(*inner, inner->rect());
  }
  return rest.isEmpty() ? QRect(OnScreen(widget, rect).topLeft(), QSize(0, 0)) : rest;
}

QRect ShownOfArea(const QWidget& widget)
{
  for (const QWidget* inner = widget.parentWidget(); inner; inner = inner->parentWidget())
    if (const auto* area = qobject_cast<const QAbstractScrollArea*>(inner))
      return Shown(*area->viewport(), area->viewport()->rect());
  return {};
}

QRect HitOf(const QWidget& widget)
{
  if (qobject_cast<const QCheckBox*>(&widget) || qobject_cast<const QRadioButton*>(&widget))
  {
    const QSize size = widget.sizeHint().boundedTo(widget.size());
    return QStyle::alignedRect(
      widget.layoutDirection(), Qt::AlignLeft | Qt::AlignVCenter, size, widget.rect());
  }
  const auto* group = qobject_cast<const QGroupBox*>(&widget);
  if (!group || !group->isCheckable())
    return {};
  QStyleOptionGroupBox option;
  option.initFrom(group);
  option.text = group->title();
  option.subControls =
    QStyle::SC_GroupBoxFrame | QStyle::SC_GroupBoxCheckBox | QStyle::SC_GroupBoxLabel;
  return group->style()->subControlRect(
    QStyle::CC_GroupBox, &option, QStyle::SC_GroupBoxCheckBox, group);
}

} // namespace hasp
