#pragma once
#include "PlanProposals.h"
#include "Steps/PointsEdit.h"
#include "Tools/Planner.h"

#include <QWidget>

class QListWidget;
class QPushButton;

namespace hasp
{

/// The pieces that cuts leave. Found in the scan (PlanProposals.h, on the WORKER), or each touched;
/// either way they become fragments of the plan, one step. The chosen ones are resected, or kept
/// again.
///
/// Widgets: cut.pieces, cut.seeds (PointsEdit's), cut.keep, cut.piece.list, cut.resect.
/// Threads: RENDER.
class PiecesBox : public QWidget
{
  Q_OBJECT
public:
  explicit PiecesBox(Planner& planner, QWidget* parent = nullptr);

  /// The cut whose fragments are divided; 0: all fragments that a cut goes through.
  void Show(PlanId cut);

private:
  std::vector<PlanId> Divided() const;
  void Find();
  void Take(PlanId divided, const Plan& before, const ProposedPieces& found);
  void KeepTouched();
  void Keep(PlanId divided, const std::vector<glm::dvec3>& seeds);
  void Resect();
  void Fill();
  void ShowChosen();
  std::vector<PlanId> Chosen() const;

  Planner& Of;
  PlanId Cut = 0;
  PointsEdit* Seeds;
  QListWidget* List;
  QPushButton *FindThem, *KeepThem, *ResectThem;
};

} // namespace hasp
