#include "Window/LayoutNames.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QMenu>
#include <QMetaEnum>
#include <QToolButton>

namespace hasp
{
namespace
{

/// Any of the words; nothing: no word.
QRegularExpression PatternOf(const QStringList& words)
{
  QStringList escaped;
  for (const QString& word : words)
    if (!word.trimmed().isEmpty())
      escaped.append(QRegularExpression::escape(word.trimmed()));
  if (escaped.isEmpty())
    return {};
  return QRegularExpression("(?<!\\w)(" + escaped.join('|') + ")(?!\\w)",
    QRegularExpression::CaseInsensitiveOption | QRegularExpression::UseUnicodePropertiesOption);
}

bool IsQtsOwn(const QString& name)
{
  return name.startsWith("qt_") || name.startsWith("ScrollLeftButton") ||
         name.startsWith("ScrollRightButton");
}

QString DialogName(const QWidget& inside)
{
  const QString name = inside.window()->objectName();
  return name.isEmpty() ? QString("dialog") : name;
}

/// "ask.save.discard": by the standard button that it is.
QString StandardButtonName(const QAbstractButton& button)
{
  auto* box = qobject_cast<QDialogButtonBox*>(button.parentWidget());
  if (!box)
    return {};
  const auto standard = box->standardButton(const_cast<QAbstractButton*>(&button));
  const char* key =
    QMetaEnum::fromType<QDialogButtonBox::StandardButtons>().valueToKey(int(standard));
  if (standard == QDialogButtonBox::NoButton || !key)
    return {};
  return DialogName(button) + "." + QString(key).toLower();
}

} // namespace

LayoutTexts::LayoutTexts(const QStringList& words) : Private(PatternOf(words)) {}

bool LayoutTexts::Hide(const QString& text, const QWidget& of) const
{
  return of.property("userText").toBool() || qobject_cast<const QFileDialog*>(of.window()) ||
         (!this->Private.pattern().isEmpty() && text.contains(this->Private));
}

QString ActionName(const QAction& action)
{
  if (action.objectName().isEmpty() && action.menu())
    return action.menu()->objectName();
  return action.objectName();
}

QString LayoutName(const QWidget& widget)
{
  if (widget.objectName() == "qt_msgbox_label")
    return DialogName(widget) + ".text";
  if (!widget.objectName().isEmpty())
    return IsQtsOwn(widget.objectName()) ? QString() : widget.objectName();
  if (const auto* tool = qobject_cast<const QToolButton*>(&widget); tool && tool->defaultAction())
    return ActionName(*tool->defaultAction());
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
    return StandardButtonName(*button);
  if (qobject_cast<const QAbstractItemView*>(&widget))
    for (const QWidget* at = widget.parentWidget(); at; at = at->parentWidget())
      if (const auto* combo = qobject_cast<const QComboBox*>(at))
        return combo->objectName().isEmpty() ? QString() : combo->objectName() + ".list";
  return {};
}

} // namespace hasp
