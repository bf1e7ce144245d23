#pragma once
#include "Steps/StepPanel.h"
#include "Tools/DistanceColours.h"
#include "Tools/GrabTool.h"

class QCheckBox;
class QDoubleSpinBox;
class QGroupBox;
class QLabel;
class QPushButton;

namespace hasp
{

class FragmentTable;
class ReductionProposals;

/// Puts fragments together: by hand, by small steps, or by themselves.
///
/// Widgets: reduce.grab, reduce.snap, reduce.forces, reduce.distances, reduce.contact;
/// FragmentTable (reduce.fragments), reduce.group, reduce.ungroup, reduce.lock; NudgePad's;
/// reduce.auto, reduce.startmm, reduce.startdegrees, ReductionProposals'; reduce.mirror.
class ReducePanel : public StepPanel
{
  Q_OBJECT
public:
  explicit ReducePanel(Planner& planner, QWidget* parent = nullptr);
  ~ReducePanel() override;

  QString Title() const override { return tr("Reduce"); }
  QString StillNeeds() const override;
  void Leave() override;

  GrabTool& Grab() { return this->Hand; }

private:
  QGroupBox* MakeByHand();
  QGroupBox* MakeFragments();
  QGroupBox* MakeAutomatic();
  void Refresh();
  void ShowState();
  void FollowColours();
  void Group();
  void Reduce();
  void AddMirror();

  GrabTool Hand;
  DistanceColours Colours;
  FragmentTable* Table = nullptr;
  ReductionProposals* Proposals = nullptr;
  QPushButton *Grabbing = nullptr, *Grouping = nullptr, *Ungrouping = nullptr, *Locking = nullptr,
              *Automatic = nullptr, *Mirror = nullptr;
  QCheckBox* Distances = nullptr;
  QDoubleSpinBox *StartMm = nullptr, *StartDegrees = nullptr;
  QLabel* Contact = nullptr;
};

} // namespace hasp
