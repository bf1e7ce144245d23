#pragma once
#include "Planning/Plan.h"

#include <QWidget>

#include <vector>

class QCheckBox;
class QLabel;
class QVBoxLayout;

namespace hasp
{

/// Some of a plan's objects, each with a box to tick: PREFIX.ID. Threads: RENDER.
class ObjectChecks : public QWidget
{
  Q_OBJECT
public:
  /// `none`: said where there is nothing to tick.
  ObjectChecks(const QString& prefix, const QString& none, QWidget* parent = nullptr);

  /// All that can be ticked, and those that are; nobody is told.
  void Show(const Plan& plan, const std::vector<PlanId>& all, const std::vector<PlanId>& ticked);
  std::vector<PlanId> Ticked() const; ///< in the plan's order

Q_SIGNALS:
  void Edited(); ///< by hand

private:
  QString Prefix;
  QVBoxLayout* Column;
  QLabel* None;
  std::vector<std::pair<PlanId, QCheckBox*>> Boxes;
};

} // namespace hasp
