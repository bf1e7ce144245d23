#pragma once
#include <QFrame>

class QLabel;

namespace hasp
{

/// The line above the views that says what happened: the last message, until it is closed or
/// another comes. Faults are red and say so in words, too. Not there while there is nothing to say.
/// Threads: RENDER.
class MessageBar : public QFrame
{
  Q_OBJECT
public:
  explicit MessageBar(QWidget* parent = nullptr);

  void Say(const QString& text, bool fault);
  const QString& Text() const { return this->Last; } ///< also after it was closed

private:
  QLabel* Words;
  QString Last;
};

} // namespace hasp
