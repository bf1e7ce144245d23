#pragma once
#include "Planning/Plan.h"

#include <QTreeWidget>

namespace hasp
{

struct Planner;

/// The plan's objects, by kind: shown or hidden, in their colours, with what is in date and what is
/// not. A name is changed where it stands (F2), a fragment locked by its box; Delete removes what
/// nothing else needs. Several may be chosen: Group and Resect are for them. All of it are edits.
/// Threads: RENDER.
class ObjectList : public QTreeWidget
{
  Q_OBJECT
public:
  explicit ObjectList(Planner& planner, QWidget* parent = nullptr);

  std::vector<PlanId> Chosen() const;

  ///@{
  /// Actions on what is chosen, of its menu; each one step. What is shown is no edit.
  void RenameCurrent(); ///< begins to type its name
  void ShowChosen();
  void LockChosen();
  void RemoveChosen();
  void GroupChosen();
  void ResectChosen();
  void ColourChosen();
  ///@}

protected:
  void closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) override;

private:
  enum Column
  {
    Name,
    Lock,
    State,
    Columns
  };
  void Refresh();
  void Fill();
  void AddActions();
  void TakeChange(QTreeWidgetItem* item, int column);
  void FollowSelection();

  Planner& Of;
  bool Filling = false; ///< what changes is no user's change
  bool Stale = false;   ///< the plan has changed while a name was typed
};

} // namespace hasp
