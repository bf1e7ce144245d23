#include "Window/StudyMode.h"

#include "Output/StudyLog.h"
#include "Output/SusForm.h"
#include "Window/PlannerOptions.h"
#include "Window/PlannerWindow.h"

#include <QMessageBox>

#include <utility>

namespace hasp
{
namespace
{

/// The trial's end. False: it could not be kept, and the operator stays, to make room for it.
bool Finish(PlannerWindow& window, StudyLog& study, bool& asked)
{
  SusForm form(&window);
  if (!std::exchange(asked, true) && form.exec() == QDialog::Accepted)
    study.KeepSus(*form.Answers());
  if (study.Finish())
    return true;
  return QMessageBox::question(&window, PlannerWindow::tr("Close all the same?"),
           PlannerWindow::tr("The trial's plan is not saved."), QMessageBox::Yes | QMessageBox::No,
           QMessageBox::No) == QMessageBox::Yes;
}

} // namespace

std::unique_ptr<StudyLog> BeginStudy(PlannerWindow& window, const PlannerOptions& options)
{
  if (options.study.empty())
    return nullptr;
  Planner& parts = window.Parts();
  StudySettings settings;
  settings.folder = options.study;
  settings.operatorName = options.studyOperator;
  settings.trial = options.trial;
  auto log = std::make_unique<StudyLog>(settings, parts.plan);
  QObject::connect(log.get(), &StudyLog::Failed, &parts, &Planner::SayFault);
  QObject::connect(&window, &PlannerWindow::StepChosen, log.get(), &StudyLog::StepChanged);
  QObject::connect(&parts.tools, &ToolBox::Changed, log.get(),
    [&parts, study = log.get(), before = static_cast<const Tool*>(nullptr)]() mutable
    {
      const Tool* tool = parts.tools.InHand();
      if (std::exchange(before, tool) != tool) // else it is its hint that has changed
        study->ToolTaken(tool ? QString(tool->metaObject()->className()).remove("hasp::") : "");
    });
  window.mayClose = [&window, study = log.get(), asked = false]() mutable
  { return Finish(window, *study, asked); };
  log->StepChanged(window.ChosenStep());
  return log;
}

} // namespace hasp
