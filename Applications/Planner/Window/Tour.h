#pragma once
#include "Planning/Plan.h"
#include "Window/Samples.h"

#include <QFrame>

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
  QString widget; ///< object name of what is marked; empty: nothing is
  QString text;
  std::function<bool(const Plan&)> isDone; ///< none: goes on by Next alone
};

/// The guided first run: a line below the message bar says what to do next, and the widget for it
/// is marked; it goes on by itself when the plan shows that it was done, or by Next. It can be left
/// at any time, and does nothing by itself. Threads: RENDER.
class Tour : public QFrame
{
  Q_OBJECT
public:
  Tour(PlannerWindow& window, Sample sample);

private:
  void Go(int stop);
  void Follow();
  void Mark(const QString& widget);

  PlannerWindow& Window;
  std::vector<TourStop> Stops;
  int Now = -1;
  QLabel* Words;
  QPushButton* NextButton;
  QFrame* Marker; ///< around the marked widget
};

/// What the tour of a sample asks for, in order.
std::vector<TourStop> TourOf(Sample sample);

} // namespace hasp
