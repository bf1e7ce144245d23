#pragma once
#include "Steps/ReductionWork.h"
#include "Tools/Planner.h"

#include <QWidget>

#include <memory>
#include <optional>

class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace hasp
{

/// What automatic reduction proposes: of each unit that was placed its proposals, with how likely
/// each is and how far the truth may be off (at 95 %). One of each unit is chosen; they are shown
/// in the view before they are taken, as one step of the plan. Proposals that the plan has left
/// behind go by themselves.
///
/// Widgets: reduce.proposals, reduce.preview, reduce.take.
class ReductionProposals : public QWidget
{
  Q_OBJECT
public:
  explicit ReductionProposals(Planner& planner, QWidget* parent = nullptr);

  void Show(std::shared_ptr<const ReductionResult> result);
  void SetPreview(bool on);

Q_SIGNALS:
  void PreviewBegins(); ///< hands must not move what is shown elsewhere

private:
  void Follow();
  void Clear();
  void Fill();
  void Chosen(QTreeWidgetItem* item);
  void Place();
  void PlaceBack();
  void Take();
  /// Of all units that are checked, as they are chosen; no poses: none is.
  PoseFragments Edit() const;

  Planner& Of;
  QTreeWidget* Tree;
  QPushButton *Preview, *TakeIt;
  bool Shows = false;
  std::shared_ptr<const ReductionResult> Result; ///< null: there are none
};

/// A unit, and one of its proposals, as lines for the user.
QString UnitText(const ReducedUnit& unit);
QString ProposalText(const ReducedUnit& unit, std::size_t number);

} // namespace hasp
