#include "Window/StudyMode.h"

#include "Output/StudyLog.h"
#include "Output/SusForm.h"
#include "Window/PlannerOptions.h"
#include "Window/PlannerWindow.h"

namespace hasp
{

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
    [&parts, study = log.get()]
    {
      const Tool* tool = parts.tools.InHand();
      study->ToolTaken(tool ? QString(tool->metaObject()->className()).remove("hasp::") : "");
    });
  QObject::connect(&window, &PlannerWindow::Closing, log.get(),
    [&window, study = log.get()]
    {
      SusForm form(&window);
      if (form.exec() == QDialog::Accepted)
        study->KeepSus(*form.Answers());
      study->Finish();
    });
  log->StepChanged(window.ChosenStep());
  return log;
}

} // namespace hasp
