#pragma once
#include <QFrame>

class QLabel;

namespace hasp
{

/// The line above the views that says what happened: the last message, until it is closed,
/// another comes, or it is withdrawn. Faults are red and say so in words, too. Not there while
/// there is nothing to say. Threads: RENDER.
class MessageBar : public QFrame
{
  Q_OBJECT
public:
  explicit MessageBar(QWidget* parent = nullptr);

  void Say(const QString& text, bool fault);
  void Withdraw() { this->Say({}, false); }          ///< the last message is out of date
  const QString& Text() const { return this->Last; } ///< also after it was closed

private:
  QLabel* Words;
  QString Last;
};

} // namespace hasp
