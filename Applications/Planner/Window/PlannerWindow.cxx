#include "Window/PlannerWindow.h"

#include "Model/RecentPlans.h"
#include "Model/WorkFolder.h"
#include "Steps/CheckPanel.h"
#include "Steps/CutPanel.h"
#include "Steps/ExportPanel.h"
#include "Steps/GuidePanel.h"
#include "Steps/ImportPanel.h"
#include "Steps/PlatePanel.h"
#include "Steps/ReducePanel.h"
#include "Steps/SplitPanel.h"
#include "Tools/DevicePointer.h"
#include "Window/MessageBar.h"
#include "Window/ObjectList.h"
#include "Window/PanelArea.h"
#include "Window/PlannerMenus.h"
#include "Window/StartHint.h"
#include "Window/UsePanel.h"
#include "Window/WorkflowBar.h"

#include "vtkImageData.h"

#include <QDockWidget>
#include <QLabel>
#include <QProgressBar>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolButton>
#include <QVBoxLayout>

namespace hasp
{

PlannerWindow::PlannerWindow(const PlannerFolders& folders, WorkFolder& work)
  : Work(work),
    Views(new ViewGrid),
    Of(std::make_unique<Planner>(folders, work.Path(), *this->Views)),
    Pointer(std::make_unique<DevicePointer>(*this->Of)),
    Messages(new MessageBar)
{
  this->setAcceptDrops(true);
  auto* middle = new QWidget;
  auto* column = new QVBoxLayout(middle);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(this->Messages);
  column->addWidget(this->Views, 1);
  this->setCentralWidget(middle);
  connect(this->Of.get(), &Planner::Said, this->Messages, &MessageBar::Say);
  connect(this->Of.get(), &Planner::Withdrawn, this->Messages, &MessageBar::Withdraw);
  this->AddSteps();
  this->AddDocks();
  this->AddStatus();
  PlannerMenus(*this).Add();
  new StartHint(*this->Of);
  connect(&this->Of->plan, &PlanSession::Changed, this, &PlannerWindow::FollowPlan);
  connect(&this->Of->plan, &PlanSession::PartsChanged, this, &PlannerWindow::FollowPlan);
  connect(&this->Of->plan, &PlanSession::SavedChanged, this, &PlannerWindow::FollowPlan);
  connect(&this->Of->plan, &PlanSession::Replaced, this, &PlannerWindow::LoadMissing);
  connect(&this->Of->scans, &ScanShelf::Added, this, &PlannerWindow::FollowScan);
  connect(&this->Of->scene, &PlanScene::PropsChanged, this, &PlannerWindow::FollowScan);
  this->ChooseStep("import");
  this->FollowPlan();
}

PlannerWindow::~PlannerWindow()
{
  this->Of->tools.Take(nullptr); // while what it is used on is there
  this->Of->jobs.CancelAll();
  delete this->findChild<QWidget*>("stereo.window"); // it draws the planner's scene
  for (StepPanel* panel : this->Panels)
    delete panel; // they know the planner, which goes before the widgets would
}

void PlannerWindow::AddSteps()
{
  this->Stack = new QStackedWidget;
  const auto add = [this](StepPanel* panel, const char* name)
  {
    panel->setObjectName(name);
    this->Stack->addWidget(new PanelArea(panel));
    this->Panels.push_back(panel);
  };
  auto* first = new ImportPanel(*this->Of, nullptr);
  first->openPlan = [this](const QString& folder) { this->OpenPlan(folder); };
  add(first, "import");
  add(new SplitPanel(*this->Of, nullptr), "split");
  add(new ReducePanel(*this->Of, nullptr), "reduce");
  add(new CutPanel(*this->Of, nullptr), "cut");
  add(new GuidePanel(*this->Of, nullptr), "guide");
  add(new PlatePanel(*this->Of, nullptr), "plate");
  add(new CheckPanel(*this->Of, nullptr), "check");
  add(new ExportPanel(*this->Of, nullptr), "export");
  this->Steps = new WorkflowBar(this->Panels, this);
  this->addToolBar(Qt::TopToolBarArea, this->Steps);
  connect(this->Steps, &WorkflowBar::Chosen, this, &PlannerWindow::EnterStep);
}

void PlannerWindow::AddDocks()
{
  const auto add =
    [this](QWidget* widget, const QString& title, const char* name, Qt::DockWidgetArea area)
  {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setWidget(widget);
    this->addDockWidget(area, dock);
    return dock;
  };
  add(this->Objects = new ObjectList(*this->Of), tr("Objects"), "dock.objects",
    Qt::LeftDockWidgetArea);
  add(this->Use = new UsePanel(*this->Of), tr("What this scene uses"), "dock.use",
    Qt::LeftDockWidgetArea)
    ->hide();
  add(this->Stack, tr("Step"), "dock.step", Qt::RightDockWidgetArea)
    ->setFeatures(QDockWidget::DockWidgetMovable);
  this->resizeDocks(
    { this->findChild<QDockWidget*>("dock.objects"), this->findChild<QDockWidget*>("dock.step") },
    { 290, 320 }, Qt::Horizontal);
}

void PlannerWindow::AddStatus()
{
  this->Hint = new QLabel;
  this->Hint->setObjectName("status.hint");
  this->Working = new QLabel;
  this->Working->setObjectName("status.working");
  this->Bar = new QProgressBar;
  this->Bar->setObjectName("status.progress");
  this->Bar->setRange(0, 1000);
  this->Bar->setMaximumWidth(180);
  this->Cancel = new QToolButton;
  this->Cancel->setObjectName("status.cancel");
  this->Cancel->setText(tr("Cancel"));
  this->Cancel->setShortcut(QKeySequence("Ctrl+."));
  auto* use = new QLabel(tr("Research use only, not a medical device"));
  use->setObjectName("status.use");
  this->statusBar()->addWidget(this->Hint, 1);
  const auto show = [this](bool busy)
  {
    for (QWidget* widget :
      std::initializer_list<QWidget*>{ this->Working, this->Bar, this->Cancel })
      widget->setVisible(busy);
  };
  for (QWidget* widget : std::initializer_list<QWidget*>{ this->Working, this->Bar, this->Cancel })
    this->statusBar()->addPermanentWidget(widget);
  show(false);
  this->statusBar()->addPermanentWidget(use);
  JobQueue& jobs = this->Of->jobs;
  connect(this->Cancel, &QToolButton::clicked, &jobs, &JobQueue::CancelAll);
  connect(&jobs, &JobQueue::Began, this,
    [this, show](const QString& what)
    {
      this->Working->setText(what);
      this->Bar->setValue(0);
      show(true);
    });
  connect(&jobs, &JobQueue::Progressed, this,
    [this](double share) { this->Bar->setValue(int(1000.0 * share)); });
  connect(&jobs, &JobQueue::Ended, this,
    [this, show]
    {
      show(!this->Of->jobs.IsIdle());
      this->FollowPlan();
    });
  connect(&this->Of->tools, &ToolBox::Changed, this,
    [this]
    {
      const Tool* tool = this->Of->tools.InHand();
      this->Hint->setText(tool ? tool->Hint() : QString());
    });
}

bool PlannerWindow::ChooseStep(const QString& name)
{
  for (std::size_t n = 0; n < this->Panels.size(); ++n)
    if (this->Panels[n]->objectName() == name)
    {
      this->EnterStep(int(n));
      return true;
    }
  return false;
}

void PlannerWindow::EnterStep(int step)
{
  this->Steps->Choose(step);
  if (step == this->Chosen)
    return;
  if (this->Chosen >= 0)
    this->Panels[std::size_t(this->Chosen)]->Leave();
  this->Chosen = step;
  StepPanel* panel = this->Panels[std::size_t(step)];
  this->Stack->setCurrentIndex(step);
  this->findChild<QDockWidget*>("dock.step")->setWindowTitle(panel->Title());
  panel->Enter();
  Q_EMIT this->StepChosen(panel->objectName());
}

QString PlannerWindow::ChosenStep() const
{
  return this->Panels.at(std::size_t(this->Chosen))->objectName();
}

StepPanel* PlannerWindow::Step(const QString& name) const
{
  return this->findChild<StepPanel*>(name);
}

void PlannerWindow::FollowPlan()
{
  const PlanSession& plan = this->Of->plan;
  const QString label = QString::fromStdString(plan.Now().caseLabel);
  this->setWindowTitle(tr("%1[*] - Hasp planner").arg(label.isEmpty() ? tr("New plan") : label));
  this->setWindowModified(plan.IsModified());
  this->Steps->Refresh();
  this->FollowScan();
}

void PlannerWindow::FollowScan()
{
  const Plan& plan = this->Of->plan.Now();
  const ShelfScan* scan = this->Of->scans.OfVolume(plan, this->Of->scene.ShownVolume());
  const std::string hash = scan ? scan->passport.hash : std::string();
  if (hash == this->ShownScan)
    return;
  this->ShownScan = hash;
  this->Views->SetImage(scan ? scan->image.Get() : nullptr, scan && scan->passport.hounsfield);
}

bool PlannerWindow::IsSettled() const
{
  return this->Of->jobs.IsIdle() && this->Views->IsSettled();
}

const QString& PlannerWindow::LastMessage() const
{
  return this->Messages->Text();
}

} // namespace hasp
