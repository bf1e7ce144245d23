#pragma once
#include "Steps/StepPanel.h"

#include <memory>

class QLabel;
class QPushButton;

namespace hasp
{

class CertificateBox;
class FitBox;
class PartTable;
class ToolMarks;

/// Is what was planned fit to be made? Every part with its state and verdict, what was measured on
/// it, and a test fit before it leaves the planner. Faults are marked in the views, by their
/// numbers.
///
/// Widgets: check.table, check.make, check.makeall, check.why; CertificateBox's, FitBox's,
/// PlanFigures'.
class CheckPanel : public StepPanel
{
  Q_OBJECT
public:
  explicit CheckPanel(Planner& planner, QWidget* parent = nullptr);
  ~CheckPanel() override;

  QString Title() const override { return tr("Check"); }
  QString StillNeeds() const override;
  void Enter() override;
  void Leave() override; ///< the part that is tried goes back

  PartTable& Parts() { return *this->Table; }
  FitBox& Fit() { return *this->Trying; }

private:
  void Refresh();
  void Mark(int fault);

  PartTable* Table;
  CertificateBox* Certificate;
  FitBox* Trying;
  QPushButton *Make, *All;
  QLabel* Why;
  std::unique_ptr<ToolMarks> Marks; ///< while it is shown
  int Fault = -1;
};

} // namespace hasp
