#pragma once
#include "Tools/Planner.h"

#include <QTreeWidget>

#include <set>
#include <vector>

namespace hasp
{

/// The fragments that can be moved, with what automatic reduction does with each: fits it, only
/// touches it (another bone, as the cranium where a mandible is put together), or leaves it out.
/// The one that is current is the scene's selected one; several can be selected, for groups.
///
/// Its object name is reduce.fragments.
class FragmentTable : public QTreeWidget
{
  Q_OBJECT
public:
  explicit FragmentTable(Planner& planner, QWidget* parent = nullptr);

  std::vector<PlanId> Selected() const;
  std::vector<PlanId> Fitted() const;    ///< of those that are not locked
  std::vector<PlanId> Obstacles() const; ///< locked or not
  bool IsAll() const { return this->LeftOut.empty(); }

Q_SIGNALS:
  void SelectionChanged();

private:
  void Refresh();
  void FollowScene();
  void Note(QTreeWidgetItem* item, int column);

  Planner& Of;
  std::set<PlanId> LeftOut, OtherBone;
};

} // namespace hasp
