#pragma once
#include "Planning/Plan.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace hasp
{

struct Planner;

/// Whether the part of an object is in date, and if not why; and the button that makes it.
/// Widgets: PREFIX.status, PREFIX.make. Threads: RENDER; parts are made on the WORKER.
class PartStatus : public QWidget
{
  Q_OBJECT
public:
  PartStatus(Planner& planner, const QString& prefix, QWidget* parent = nullptr);

  void Show(PlanId object); ///< 0: none, or not in the plan

private:
  void Refresh();

  Planner& Of;
  PlanId Now = 0;
  QLabel* Line;
  QPushButton* Make;
};

} // namespace hasp
