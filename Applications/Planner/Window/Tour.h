#pragma once
#include "Planning/Plan.h"
#include "Window/Samples.h"

#include <QFrame>
#include <QPointer>

#include <functional>
#include <vector>

class QLabel;
class QPushButton;

namespace hasp
{

class PlannerWindow;

/// One thing that the tour asks for.
struct TourStop
{
  QString step;   ///< of the workflow
  QString widget; ///< object name of what is marked: its page of tabs is turned to, and it is
                  ///< scrolled to; where it cannot be seen, what stands behind a space
  QString text;
  std::function<bool(const Plan&)> isDone; ///< none: goes on by Next alone
};

/// The guided first run: a line below the message bar says what to do next, and the widget for it
/// is marked, wherever it moves; it goes on by itself when the plan shows that it was done, or by
/// Next. Back says again what was said before, and undoes nothing. It can be left at any time, and
/// does nothing to the plan. Threads: RENDER.
class Tour : public QFrame
{
  Q_OBJECT
public:
  Tour(PlannerWindow& window, Sample sample);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void Go(int stop);
  void Follow();
  void Choose(); ///< what is marked
  void Mark();

  PlannerWindow& Window;
  std::vector<TourStop> Stops;
  int Now = -1;
  QLabel* Words;
  QPushButton *BackButton, *NextButton;
  QPointer<QWidget> Marked;
  std::vector<QPointer<QWidget>> Watched; ///< it, and all that it is in
  QFrame* Marker;                         ///< around what is seen of it
};

/// What the tour of a sample asks for, in order.
std::vector<TourStop> TourOf(Sample sample);

} // namespace hasp
