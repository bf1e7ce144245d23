#pragma once
#include <QGroupBox>

class QPushButton;
class QTableWidget;

namespace hasp
{

struct Planner;

/// Figures of the plan as it is: its measures, and step-off and gap along its fractures, as `hasp
/// evaluate` has them.
///
/// Widgets: check.planmeasures, check.evaluate, check.fractures. Threads: RENDER; fractures are
/// measured by a job, of fragments whose parts are in date.
class PlanFigures : public QGroupBox
{
  Q_OBJECT
public:
  explicit PlanFigures(Planner& planner, QWidget* parent = nullptr);

private:
  void Refresh();
  void Evaluate();

  Planner& Of;
  QTableWidget *Measures, *Fractures;
  QPushButton* Evaluating;
};

} // namespace hasp
