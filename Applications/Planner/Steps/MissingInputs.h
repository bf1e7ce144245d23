#pragma once
#include "Tools/Planner.h"

#include <QWidget>

#include <set>
#include <string>

class QListWidget;
class QPushButton;

namespace hasp
{

/// The scans and surfaces that a plan names and that are not in memory. They are listed, and the
/// user says where they are: a file is taken if it holds the same. Surfaces that the planner has
/// kept are read again by themselves, as the window reads kept scans. Not seen while none is
/// missing.
///
/// Widgets: import.missing, import.locate, import.locatefolder.
class MissingInputs : public QWidget
{
  Q_OBJECT
public:
  explicit MissingInputs(Planner& planner, QWidget* parent = nullptr);

  /// Takes what lies there as the one that is chosen in the list, if it is that.
  void Locate(const QString& path);

private:
  void Refresh();
  void List(PlanId id, const QString& text);
  void ReadKeptSurface(const PlanSurface& surface);
  void LocateScan(PlanId id, const std::string& path);
  void LocateSurface(const PlanSurface& surface, const std::string& path);

  Planner& Of;
  QListWidget* Items;
  QPushButton *File, *Folder;
  std::set<std::string> Tried; ///< hashes of surfaces that were looked for among what is kept
};

} // namespace hasp
