#include "Window/PlannerMenus.h"

#include "Model/RecentPlans.h"
#include "Output/CaseReport.h"
#include "Tools/MeasureTool.h"
#include "View/SliceView.h"
#include "Window/DevicePage.h"
#include "Window/KeysPage.h"
#include "Window/PlannerWindow.h"
#include "Window/SceneLooks.h"
#include "Window/StereoPage.h"
#include "Window/ViewPresets.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>

namespace hasp
{

QAction* PlannerMenus::AddAction(QMenu* menu, const QString& text, const char* name,
  const QKeySequence& key, std::function<void()> act)
{
  QAction* action = menu->addAction(text);
  action->setObjectName(name);
  action->setShortcut(key);
  QObject::connect(action, &QAction::triggered, &this->Window, std::move(act));
  return action;
}

void PlannerMenus::AddChoice(QMenu* menu, const QString& text, const char* name,
  const QKeySequence& key, bool checked, std::function<void(bool)> act)
{
  QAction* action = menu->addAction(text);
  action->setObjectName(name);
  action->setShortcut(key);
  action->setCheckable(true);
  action->setChecked(checked);
  QObject::connect(action, &QAction::toggled, &this->Window, std::move(act));
}

void PlannerMenus::Add()
{
  this->AddFile();
  this->AddEdit();
  this->AddView();
  this->AddMeasure();
  this->AddHelp();
}

void PlannerMenus::AddFile()
{
  PlannerWindow* window = &this->Window;
  QMenu* menu = window->menuBar()->addMenu(PlannerWindow::tr("&File"));
  menu->setObjectName("menu.file");
  this->AddAction(menu, PlannerWindow::tr("&New plan"), "file.new", QKeySequence::New,
    [window] { window->NewPlan(); });
  this->AddAction(menu, PlannerWindow::tr("&Open a plan …"), "file.open", QKeySequence::Open,
    [window] { window->OpenPlan(); });
  QMenu* recent = menu->addMenu(PlannerWindow::tr("Open &recent"));
  recent->setObjectName("menu.recent");
  QObject::connect(recent, &QMenu::aboutToShow, window,
    [window, recent] { PlannerMenus(*window).FillRecent(recent); });
  this->AddAction(menu, PlannerWindow::tr("&Save"), "file.save", QKeySequence::Save,
    [window] { window->SavePlanHere(); });
  this->AddAction(menu, PlannerWindow::tr("Save &as …"), "file.saveas",
    QKeySequence("Ctrl+Shift+S"), [window] { window->SavePlanAs(); });
  menu->addSeparator();
  QMenu* samples = menu->addMenu(PlannerWindow::tr("&Try it on a sample"));
  samples->setObjectName("menu.samples");
  this->AddAction(samples, PlannerWindow::tr("A &skull with a defect: a guide"),
    "file.sample.skull", {}, [window] { window->TrySample(Sample::Skull); });
  this->AddAction(samples, PlannerWindow::tr("A broken &mandible: fragments, reduction, plate"),
    "file.sample.mandible", {}, [window] { window->TrySample(Sample::Mandible); });
  this->AddAction(samples, PlannerWindow::tr("A jaw and a &fibula: cuts and a transplant"),
    "file.sample.fibula", {}, [window] { window->TrySample(Sample::Fibula); });
  menu->addSeparator();
  this->AddAction(menu, PlannerWindow::tr("&Quit"), "file.quit", QKeySequence("Ctrl+Q"),
    [window] { window->close(); });
}

void PlannerMenus::FillRecent(QMenu* menu)
{
  menu->clear();
  PlannerWindow* window = &this->Window;
  const PlannerFolders& folders = window->Parts().folders;
  int number = 0;
  for (const RecentPlans::Entry& entry : RecentPlans(folders.state, folders.plans).Entries())
  {
    QString label = entry.caseLabel.empty() ? PlannerWindow::tr("(no case label)")
                                            : QString::fromStdString(entry.caseLabel);
    label.replace('&', "&&"); // it is no key
    const QString name = QString("file.recent.%1").arg(++number);
    this->AddAction(menu, QString("&%1 %2").arg(number).arg(label), name.toUtf8(), {},
      [window, place = QString::fromStdString(entry.place.string())] { window->OpenPlan(place); });
  }
  if (number == 0)
    menu->addAction(PlannerWindow::tr("None yet"))->setEnabled(false);
}

void PlannerMenus::AddEdit()
{
  PlannerWindow* window = &this->Window;
  PlanSession* plan = &window->Parts().plan;
  QMenu* menu = window->menuBar()->addMenu(PlannerWindow::tr("&Edit"));
  menu->setObjectName("menu.edit");
  QAction* undo = this->AddAction(
    menu, PlannerWindow::tr("&Undo"), "edit.undo", QKeySequence::Undo, [plan] { plan->Undo(); });
  QAction* redo = this->AddAction(menu, PlannerWindow::tr("&Redo"), "edit.redo",
    QKeySequence("Ctrl+Y"), [plan] { plan->Redo(); });
  redo->setShortcuts({ QKeySequence("Ctrl+Y"), QKeySequence("Ctrl+Shift+Z") });
  this->AddPutAway(menu);
  const auto follow = [window, plan, undo, redo]
  {
    const PlanHistory& history = plan->Document().history;
    const auto show = [](QAction* action, const QString& verb, const PlanStep* step)
    {
      action->setEnabled(step != nullptr);
      action->setText(
        step ? QString("%1: %2").arg(verb, QString::fromStdString(step->label)) : verb);
    };
    show(undo, PlannerWindow::tr("&Undo"), history.ToUndo());
    show(redo, PlannerWindow::tr("&Redo"), history.ToRedo());
  };
  QObject::connect(plan, &PlanSession::Changed, window, follow);
  follow();
}

void PlannerMenus::AddPutAway(QMenu* menu)
{
  ToolBox* tools = &this->Window.Parts().tools;
  QAction* away = this->AddAction(menu, PlannerWindow::tr("Put the &tool away"), "edit.away",
    QKeySequence("Esc"), [tools] { tools->Take(nullptr); });
  away->setEnabled(false);
  QObject::connect(tools, &ToolBox::Changed, away,
    [away, tools] { away->setEnabled(tools->InHand() != nullptr); });
}

void PlannerMenus::AddView()
{
  PlannerWindow* window = &this->Window;
  Planner* parts = &window->Parts();
  QMenu* menu = window->menuBar()->addMenu(PlannerWindow::tr("&View"));
  menu->setObjectName("menu.view");
  AddViewPresets(*menu, *parts);
  menu->addSeparator();
  this->AddAction(menu, PlannerWindow::tr("One view or &four"), "view.maximise",
    QKeySequence("Ctrl+M"),
    [parts]
    {
      ViewGrid& views = parts->views;
      views.Maximise(views.Maximised() ? nullptr : &views.Scene());
    });
  this->AddChoice(menu, PlannerWindow::tr("&Crosshair"), "view.crosshair", QKeySequence("Ctrl+H"),
    true, [parts](bool on) { parts->views.SetCrosshairVisible(on); });
  AddSceneLooks(*menu, *parts);
  AddStereoActions(*menu, *window);
  AddDeviceAction(*menu, *window);
  for (const char* dock : { "dock.objects", "dock.use" })
  {
    QAction* action = window->findChild<QDockWidget*>(dock)->toggleViewAction();
    action->setObjectName(QString("view.%1").arg(dock));
    menu->addAction(action);
  }
  this->AddChoice(menu, PlannerWindow::tr("F&ull screen"), "view.full", QKeySequence("F11"), false,
    [window](bool on) { on ? window->showFullScreen() : window->showNormal(); });
}

void PlannerMenus::AddMeasure()
{
  PlannerWindow* window = &this->Window;
  Planner* parts = &window->Parts();
  QMenu* menu = window->menuBar()->addMenu(PlannerWindow::tr("&Measure"));
  menu->setObjectName("menu.measure");
  auto* tool = new MeasureTool(*parts, window);
  this->AddAction(menu, PlannerWindow::tr("&Distance: touch two places"), "measure.distance",
    QKeySequence("Ctrl+D"), [tool] { tool->Start(MeasureKind::Distance); });
  this->AddAction(menu, PlannerWindow::tr("&Angle: touch three places"), "measure.angle",
    QKeySequence("Ctrl+Shift+D"), [tool] { tool->Start(MeasureKind::Angle); });
}

void PlannerMenus::AddHelp()
{
  PlannerWindow* window = &this->Window;
  QMenu* menu = window->menuBar()->addMenu(PlannerWindow::tr("&Help"));
  menu->setObjectName("menu.help");
  QAction* keys = this->AddAction(menu, PlannerWindow::tr("&Keys and mouse"), "help.keys", {},
    [window] { ShowKeysPage(*window); });
  keys->setShortcuts({ QKeySequence("?"), QKeySequence("F1") });
  this->AddAction(
    menu, PlannerWindow::tr("&About"), "help.about", {}, [window] { ShowAboutPage(*window); });
}

/// A number or a name that is being typed is done, and it is typed on.
void PlannerWindow::TakeTyped()
{
  const QPointer<QWidget> typing = this->focusWidget();
  if (typing)
    typing->clearFocus();
  if (typing && typing->isVisible())
    typing->setFocus();
}

} // namespace hasp
