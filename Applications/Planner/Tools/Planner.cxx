#include "Tools/Planner.h"

namespace hasp
{
namespace
{

/// What a job's error says, without the object that it begins with where the job's name ends with
/// that: "Making plate 7" and "plate 7: ...".
QString Beyond(const QString& what, const QString& text)
{
  const int colon = text.indexOf(QLatin1String(": "));
  return colon > 0 && what.endsWith(' ' + text.left(colon)) ? text.mid(colon + 2) : text;
}

} // namespace

Planner::Planner(const PlannerFolders& folders, const std::filesystem::path& work, ViewGrid& views)
  : folders(folders),
    plan(work),
    scans(folders.state / "scans"),
    views(views),
    scene(plan, scans, jobs, views.Scene())
{
  connect(&this->plan, &PlanSession::Refused, this, &Planner::SayFault);
  connect(&this->plan, &PlanSession::Warned, this,
    [this](const QString& text)
    {
      this->SayFault(text);
      this->SaidBy.clear(); // it holds, whatever job is tried again
    });
  connect(&this->scene, &PlanScene::Refused, this, &Planner::SayFault);
  connect(&this->jobs, &JobQueue::Failed, this,
    [this](const QString& what, const QString& text)
    { this->SayFault(tr("%1 failed: %2").arg(what, Beyond(what, text))); });
  connect(&this->jobs, &JobQueue::Began, this,
    [this](const QString& what)
    {
      if (what != this->SaidBy)
        return;
      this->SaidBy.clear();
      Q_EMIT this->Withdrawn();
    });
  // Before whoever else follows a new plan, and says what of it.
  connect(&this->plan, &PlanSession::Replaced, this,
    [this]
    {
      this->SaidBy.clear();
      Q_EMIT this->Withdrawn();
    });
}

void Planner::Tell(const QString& text, bool fault)
{
  this->SaidBy = this->jobs.Delivering();
  Q_EMIT this->Said(text, fault);
}

} // namespace hasp
