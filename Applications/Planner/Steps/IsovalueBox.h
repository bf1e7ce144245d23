#pragma once
#include "Tools/Planner.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QPushButton;
class QSlider;

namespace hasp
{

/// Where bone begins: a slider, a number, ranges of HU by their names, and, for values that are no
/// HU, a proposal from the histogram. Says it to the scene (PlanScene::SetIsovalue) and follows it.
///
/// Widgets: split.isovalue (the number), split.isovalue.slider, split.preset, split.propose.
class IsovalueBox : public QWidget
{
  Q_OBJECT
public:
  explicit IsovalueBox(Planner& planner, QWidget* parent = nullptr);

private:
  void Refresh();
  void TakePreset(int row);
  void Propose();
  const ShelfScan* Scan() const; ///< that is shown; nullptr: none is in memory

  Planner& Of;
  QDoubleSpinBox* Value;
  QSlider* Slider;
  QComboBox* Preset;
  QPushButton* Proposal;
};

} // namespace hasp
