#pragma once
#include <QRegularExpression>
#include <QString>
#include <QStringList>

class QAction;
class QWidget;

/// What is called how, and what is kept private, in a layout file (LayoutWidgets.h). Internal.
/// Threads: RENDER.
namespace hasp
{

/// objectName, or what LayoutWidgets.h says of those that have none; empty: no name.
QString LayoutName(const QWidget& widget);
QString ActionName(const QAction& action);

class LayoutTexts
{
public:
  explicit LayoutTexts(const QStringList& words);
  /// Whether a text of that widget may be the user's.
  bool Hide(const QString& text, const QWidget& of) const;

private:
  QRegularExpression Private;
};

} // namespace hasp
