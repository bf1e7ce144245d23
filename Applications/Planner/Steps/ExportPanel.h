#pragma once
#include "Steps/StepPanel.h"

#include <map>

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace hasp
{

/// Parts, recipes and the case's report as files. Only what is in date and holds leaves the
/// planner; of the rest it says why not.
///
/// Widgets: export.folder, export.browse, export.format, export.all, export.all.why, export.report,
/// export.report.names; of each part export.part.ID, export.why.ID.
class ExportPanel : public StepPanel
{
  Q_OBJECT
public:
  explicit ExportPanel(Planner& planner, QWidget* parent = nullptr);

  QString Title() const override { return tr("Export"); }
  QString StillNeeds() const override;

protected:
  void showEvent(QShowEvent* event) override;

private:
  struct Row
  {
    QWidget* all;
    QPushButton* button;
    QLabel* why;
  };
  Row MakeRow(PlanId object);
  void Refresh();
  void ExportOne(PlanId object);
  void Report();
  QString Format() const;

  QLineEdit* Folder;
  QComboBox* Formats;
  QPushButton *All, *Reporting;
  QCheckBox* Names;
  QLabel* AllWhy;
  QVBoxLayout* Parts;
  std::map<PlanId, Row> Rows;
  bool Stale = true;
};

} // namespace hasp
