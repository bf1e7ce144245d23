#pragma once
#include "Tools/PickTool.h"

#include <QGroupBox>

class QDoubleSpinBox;
class QPushButton;

namespace hasp
{

/// Fragments without painting: all bone that is connected with a place, or all pieces of bone.
///
/// Widgets: split.bone.pick, split.bone.crosshair, split.pieces, split.pieces.least.
class BonesBox : public QGroupBox
{
  Q_OBJECT
public:
  explicit BonesBox(Planner& planner, QWidget* parent = nullptr);

  void PutAway(); ///< the tool, if it is in hand

private:
  void Refresh();
  void ShowToPick();

  Planner& Of;
  PickTool Pick;
  QPushButton *Picking, *AtCrosshair, *Pieces;
  QDoubleSpinBox* Least;
  PlanId ShownToPick = 0, HiddenAfterPick = 0; ///< volumes; 0: none
};

} // namespace hasp
