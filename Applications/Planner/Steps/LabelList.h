#pragma once
#include "Planning/SegmentationRecipe.h"
#include "Tools/Planner.h"

#include <QWidget>

#include <vector>

class QListWidget;
class QListWidgetItem;
class QPushButton;

namespace hasp
{

/// The labels that are painted, with their names and colours: those of the plan's painted
/// segmentation, or, until something is painted, those that it will have. The one that is chosen is
/// painted. A name is changed where it stands (F2).
///
/// Widgets: split.label (the list), split.label.add, split.label.colour.
class LabelList : public QWidget
{
  Q_OBJECT
public:
  explicit LabelList(Planner& planner, QWidget* parent = nullptr);

  int Label() const; ///< that is chosen, [2, 65535]
  const std::vector<LabelName>& Names() const { return this->Shown; }

Q_SIGNALS:
  void LabelChosen(int label);
  void NamesChanged();

private:
  void Refresh();
  void Add();
  void Recolour();
  void Rename(QListWidgetItem* item);
  /// Into the plan where there is a segmentation, else among those that it will have.
  void Keep(std::vector<LabelName> names, const QString& step);

  Planner& Of;
  QListWidget* List;
  QPushButton* Colour;
  std::vector<LabelName> Shown, Coming; ///< Coming: until there is a segmentation
};

} // namespace hasp
