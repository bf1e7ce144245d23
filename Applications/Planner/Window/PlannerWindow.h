#pragma once
#include "Tools/Planner.h"
#include "Window/Samples.h"

#include <QMainWindow>
#include <QPointer>

#include <functional>
#include <memory>
#include <vector>

class QLabel;
class QProgressBar;
class QStackedWidget;
class QToolButton;

namespace hasp
{

class DevicePointer;
class MessageBar;
class ObjectList;
class StepPanel;
class UsePanel;
class WorkFolder;
class WorkflowBar;

/// The planner's window: workflow above, objects at the left, views in the middle, the chosen step
/// at the right, long work below. It only puts together what its parts do.
///
/// Threads: RENDER.
class PlannerWindow : public QMainWindow
{
  Q_OBJECT
public:
  PlannerWindow(const PlannerFolders& folders, WorkFolder& work);
  ~PlannerWindow() override;

  Planner& Parts() const { return *this->Of; }
  /// Chooses a step by its object name ("guide"). False: there is none.
  bool ChooseStep(const QString& name);
  QString ChosenStep() const;
  StepPanel* Step(const QString& name) const;
  /// A scan, a surface, a label map or a plan.
  void OpenPath(const QString& path);
  /// Begins anew with a sample, and the tour of it.
  void TrySample(Sample sample);
  /// No job, and no frame to come.
  bool IsSettled() const;
  const QString& LastMessage() const;

  /// Asked when it is to be closed and the plan may go: false keeps it open. None: it closes.
  std::function<bool()> mayClose;

Q_SIGNALS:
  void StepChosen(const QString& name);

protected:
  void closeEvent(QCloseEvent* event) override; ///< asks for what is not saved
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

private:
  friend class PlannerMenus;
  void AddSteps();
  void AddDocks();
  void AddStatus();
  void EnterStep(int step);
  void FollowPlan();
  void FollowScan(); ///< into the slices
  void LoadMissing();
  void BeginSample(Sample sample, const std::vector<ShelfScan>& scans);

  ///@{
  /// What the menus do.
  void TakeTyped();
  bool MayLeavePlan(); ///< saved, or the user says that it may go
  void LeavePlan();    ///< before another one: what is under way for it ends
  void NewPlan();
  void OpenPlan(const QString& folder = {});
  bool SavePlanHere();
  bool SavePlanAs();
  ///@}
  void Remember(); ///< where it was saved

  WorkFolder& Work;
  ViewGrid* Views;
  std::unique_ptr<Planner> Of;
  std::unique_ptr<DevicePointer> Pointer;
  MessageBar* Messages;
  WorkflowBar* Steps = nullptr;
  QStackedWidget* Stack = nullptr;
  std::vector<StepPanel*> Panels;
  int Chosen = -1;
  ObjectList* Objects = nullptr;
  UsePanel* Use = nullptr;
  QLabel* Hint = nullptr;
  QLabel* Working = nullptr;
  QProgressBar* Bar = nullptr;
  QToolButton* Cancel = nullptr;
  QPointer<QWidget> Guided; ///< the tour
  std::string ShownScan;    ///< hash of what the slices show
};

} // namespace hasp
