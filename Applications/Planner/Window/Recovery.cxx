#include "Window/Recovery.h"

#include "Model/WorkFolder.h"
#include "Planning/PlanJournal.h"
#include "Window/PlannerWindow.h"

#include <QDateTime>
#include <QMessageBox>
#include <QPushButton>

namespace hasp
{
namespace
{
namespace fs = std::filesystem;

/// Actions that were not saved; 0: none, or nothing that can be read.
std::size_t UnsavedActions(const fs::path& work, QString& label)
{
  try
  {
    const RecoveredPlan found = ReadJournal(JournalIn(work));
    label = QString::fromStdString(found.document.history.Current().caseLabel);
    return found.actions;
  }
  catch (const std::exception&) // not ours, or damaged in its start
  {
    return 0;
  }
}

enum class Answer
{
  BringBack,
  Later,
  Discard
};

Answer Ask(PlannerWindow& window, const QString& label, std::size_t actions)
{
  QMessageBox question(QMessageBox::Question, window.tr("Bring back what was not saved?"),
    window
      .tr("The planner ended without saving. Case: %1. Not saved: %n action(s).", nullptr,
        int(actions))
      .arg(label.isEmpty() ? window.tr("(no case label)") : label),
    QMessageBox::NoButton, &window);
  question.setObjectName("question.recover");
  question.setTextFormat(Qt::PlainText);
  QPushButton* bring = question.addButton(window.tr("&Bring back"), QMessageBox::AcceptRole);
  bring->setObjectName("recover.bring");
  QPushButton* later = question.addButton(window.tr("Ask &later"), QMessageBox::RejectRole);
  later->setObjectName("recover.later");
  QPushButton* discard = question.addButton(window.tr("&Discard"), QMessageBox::DestructiveRole);
  discard->setObjectName("recover.discard");
  question.setDefaultButton(bring);
  question.setEscapeButton(later);
  question.exec();
  return question.clickedButton() == bring     ? Answer::BringBack
         : question.clickedButton() == discard ? Answer::Discard
                                               : Answer::Later;
}
} // namespace

void OfferRecovery(PlannerWindow& window)
{
  Planner& planner = window.Parts();
  for (const fs::path& work : WorkFolder::Crashed(planner.folders.state))
  {
    QString label;
    const std::size_t actions = UnsavedActions(work, label);
    const Answer answer = actions == 0 ? Answer::Discard : Ask(window, label, actions);
    if (answer == Answer::Later)
      continue;
    if (answer == Answer::Discard)
    {
      WorkFolder::Remove(work);
      continue;
    }
    if (planner.plan.Recover(work, WorkFolder::PlaceOf(work, planner.folders.plans)))
    {
      WorkFolder::Remove(work);
      planner.Say(window.tr("Brought back. Save the plan to keep it."));
    }
    return; // one plan at a time: others are offered at the next start
  }
}

} // namespace hasp
