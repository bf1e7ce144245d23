#pragma once
#include "Tools/Planner.h"

#include <QWidget>

class QDoubleSpinBox;

namespace hasp
{

/// Moves the selected fragment, and what moves with it, by small steps along the patient's axes,
/// and turns it about its middle: what a hand does, by keys and numbers. Each press is a step of
/// the plan.
///
/// Widgets: reduce.move.step, reduce.turn.step; reduce.move.left, .right, .posterior, .anterior,
/// .superior, .inferior; reduce.turn.xplus, .xminus, .yplus, .yminus, .zplus, .zminus (about the
/// axes towards left, posterior, superior; counter-clockwise as seen from there); reduce.back.
class NudgePad : public QWidget
{
  Q_OBJECT
public:
  explicit NudgePad(Planner& planner, QWidget* parent = nullptr);

private:
  void Refresh();
  void Move(const glm::dvec3& direction);
  void Turn(const glm::dvec3& axis);
  void Back();
  std::vector<PlanId> Unit() const; ///< of the selected fragment; empty: none is

  Planner& Of;
  QDoubleSpinBox *MoveStep = nullptr, *TurnStep = nullptr;
};

} // namespace hasp
