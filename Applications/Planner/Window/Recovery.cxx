#include "Window/Recovery.h"

#include "Model/WorkFolder.h"
#include "Planning/PlanJournal.h"
#include "Window/PlannerWindow.h"

#include <QMessageBox>
#include <QPushButton>

#include <optional>

namespace hasp
{
namespace
{
namespace fs = std::filesystem;

/// None: it cannot be read. A newer version may have written it, and the disk may give it later.
std::optional<RecoveredPlan> Unsaved(const fs::path& work)
{
  try
  {
    return ReadJournal(JournalIn(work));
  }
  catch (const std::exception&)
  {
    return std::nullopt;
  }
}

QString WordsOf(const std::optional<RecoveredPlan>& found)
{
  if (!found)
    return PlannerWindow::tr("The planner ended without saving, and what it kept cannot be read: "
                             "it is damaged, or of a newer version.");
  const QString label = QString::fromStdString(found->document.history.Current().caseLabel);
  return PlannerWindow::tr("The planner ended without saving. Case: %1. Actions not saved: %2.")
    .arg(label.isEmpty() ? PlannerWindow::tr("(no case label)") : label)
    .arg(found->actions);
}

enum class Answer
{
  BringBack,
  Later,
  Discard
};

Answer Ask(PlannerWindow& window, const std::optional<RecoveredPlan>& found)
{
  QMessageBox question(QMessageBox::Question, PlannerWindow::tr("Bring back what was not saved?"),
    WordsOf(found), QMessageBox::NoButton, &window);
  question.setObjectName("question.recover");
  question.setTextFormat(Qt::PlainText);
  QPushButton* bring =
    question.addButton(PlannerWindow::tr("&Bring back"), QMessageBox::AcceptRole);
  bring->setObjectName("recover.bring");
  QPushButton* later = question.addButton(PlannerWindow::tr("Ask &later"), QMessageBox::RejectRole);
  later->setObjectName("recover.later");
  QPushButton* discard =
    question.addButton(PlannerWindow::tr("&Discard"), QMessageBox::DestructiveRole);
  discard->setObjectName("recover.discard");
  bring->setEnabled(found.has_value());
  question.setDefaultButton(found ? bring : later);
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
    const std::optional<RecoveredPlan> found = Unsaved(work);
    const bool nothing = found && found->actions == 0;
    const Answer answer = nothing ? Answer::Discard : Ask(window, found);
    if (answer == Answer::Later)
      continue;
    if (answer == Answer::Discard)
    {
      WorkFolder::Remove(work);
      continue;
    }
    // As soon as it is there: faults follow.
    const auto saying = QObject::connect(&planner.plan, &PlanSession::Replaced, &planner,
      [&planner] { planner.Say(PlannerWindow::tr("Brought back. Save the plan to keep it.")); });
    if (planner.plan.Recover(work, WorkFolder::PlaceOf(work, planner.folders.plans)) &&
        planner.plan.IsJournalled()) // else it is all that there is against another crash
      WorkFolder::Remove(work);
    QObject::disconnect(saying);
    return; // one plan at a time: others are offered at the next start
  }
}

} // namespace hasp
