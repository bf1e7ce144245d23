#pragma once
#include "Steps/ImportReading.h"
#include "Steps/StepPanel.h"

#include <functional>

class QDoubleSpinBox;
class QLineEdit;

namespace hasp
{

class ImportRemedies;
class PassportBrowser;

/// Brings in what a plan is made of: scans (a second one for a donor's bone), label maps of the
/// scan that is shown, surfaces, and plans. Reads on the WORKER; what is refused changes nothing,
/// and says why and what to do: another series, or resampling where that mends it.
///
/// Widgets: import.open, import.folder, import.case, import.thickness; ImportRemedies',
/// MissingInputs' and PassportBrowser's.
class ImportPanel : public StepPanel
{
  Q_OBJECT
public:
  explicit ImportPanel(Planner& planner, QWidget* parent = nullptr);

  QString Title() const override { return tr("Import"); }
  QString StillNeeds() const override { return {}; }

  /// A file or a folder, whatever it is: chosen here, dropped on the window or named on the command
  /// line.
  void ImportPath(const QString& path);

  /// The window's way to another plan, which asks about what was not saved. None: it is opened
  /// where all is saved, else refused.
  std::function<void(const QString& folder)> openPlan;

private:
  void Build();
  void Refresh();
  void SetCase();
  void OpenPlan(const QString& folder);
  void Read(const QString& path);
  void Take(Imported& imported);
  void TakeScan(ImportedScan& scan);
  void TakeLabels(const ImportedLabels& labels);
  void TakeSurface(const ImportedSurface& surface);

  QLineEdit* Case = nullptr;
  PassportBrowser* Page = nullptr;
  ImportRemedies* Remedies = nullptr;
  QDoubleSpinBox* Thickness = nullptr;
  QString Path; ///< of what was asked for last: to try again; never shown
};

} // namespace hasp
