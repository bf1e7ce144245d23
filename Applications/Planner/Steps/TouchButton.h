#pragma once
#include "Tools/LandmarkTool.h"

#include <QWidget>

class QPushButton;

namespace hasp
{

struct Planner;

/// Asks for one place: the next touch says it, and the tool is put away.
/// Widgets: NAME, NAME.crosshair. Threads: RENDER.
class TouchButton : public QWidget
{
  Q_OBJECT
public:
  TouchButton(Planner& planner, const QString& name, const QString& text, const QString& hint,
    QWidget* parent = nullptr);

Q_SIGNALS:
  void Touched(const hasp::TouchedPlace& place);

protected:
  void hideEvent(QHideEvent* event) override; ///< puts it away: another page is turned to

private:
  Planner& Of;
  LandmarkTool Hand;
  QPushButton* Button;
};

} // namespace hasp
