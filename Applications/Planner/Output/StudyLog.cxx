#include "Output/StudyLog.h"

#include "Model/PlanSession.h"
#include "Output/StudyFiles.h"
#include "Planning/PlanLists.h"

#include <nlohmann/json.hpp>

#include <QCoreApplication>
#include <QEvent>

#include <cmath>
#include <exception>
#include <utility>

namespace hasp
{
namespace
{

using Json = nlohmann::ordered_json;

/// To the millisecond: what a clock of a desktop is good for.
double Rounded(double seconds)
{
  return std::round(seconds * 1000.0) / 1000.0;
}

/// What a step does, in our words: its own label may be anybody's.
std::string TextOf(const Plan& before, const PlanStep& step)
{
  if (step.edits.empty())
    return {};
  const std::size_t more = step.edits.size() - 1;
  return EditLabel(before, step.edits.front()) +
         (more > 0 ? " and " + std::to_string(more) + " more" : "");
}

bool IsSignOfLife(QObject* watched, QEvent* event)
{
  if (!watched->isWindowType() || !event->spontaneous())
    return false;
  switch (event->type())
  {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseMove:
    case QEvent::Wheel:
    case QEvent::KeyPress:
    case QEvent::ShortcutOverride:
      return true;
    default:
      return false;
  }
}

} // namespace

StudyLog::StudyLog(StudySettings settings, PlanSession& plan, QObject* parent)
  : QObject(parent),
    Of(std::move(settings)),
    Session(plan),
    Times(Of.pauseS),
    Files(std::make_unique<StudyFiles>(Of))
{
  this->Clock.start();
  const std::vector<StepTime> earlier = this->Files->TimesInLog();
  for (const StepTime& time : earlier)
    this->Times.Add(time);
  this->Files->Append({ { "t", 0.0 }, { "what", "begin" }, { "format", "hasp-study-log-1" },
    { "operator", this->Of.operatorName }, { "trial", this->Of.trial },
    { "pause_s", this->Of.pauseS }, { "again", this->Files->IsAgain() } });
  this->Remember();
  connect(&plan, &PlanSession::Replaced, this,
    [this]
    {
      this->Append({ { "what", "plan" } });
      this->Remember();
    });
  connect(&plan, &PlanSession::Changed, this, &StudyLog::PlanChanged);
  connect(&plan, &PlanSession::PartsChanged, this, &StudyLog::PartsChanged);
  qApp->installEventFilter(this);
}

StudyLog::~StudyLog()
{
  if (!this->Finished)
    this->LeaveStep();
}

double StudyLog::NowS() const
{
  return static_cast<double>(this->Clock.nsecsElapsed()) * 1e-9;
}

bool StudyLog::eventFilter(QObject* watched, QEvent* event)
{
  if (IsSignOfLife(watched, event))
    this->Times.Alive(this->NowS());
  return false;
}

bool StudyLog::Append(Json line)
{
  if (this->Finished)
    return false;
  Json timed{ { "t", Rounded(this->NowS()) } };
  timed.update(line);
  try
  {
    this->Files->Append(timed);
    this->Told = false;
    return true;
  }
  catch (const std::exception& error)
  {
    if (!std::exchange(this->Told, true))
      Q_EMIT this->Failed(
        tr("What is done is missing in the trial's log: %1. Make room on the disk "
           "of the study's folder, and do the trial again.")
          .arg(QString::fromUtf8(error.what())));
    return false;
  }
}

void StudyLog::LeaveStep()
{
  const StepTime visit = this->Times.Visit(this->NowS());
  if (!visit.step.empty())
    this->Append({ { "what", "left" }, { "step", visit.step },
      { "active_s", Rounded(visit.activeS) }, { "wall_s", Rounded(visit.wallS) } });
}

void StudyLog::StepChanged(const QString& step)
{
  if (this->Finished || step.toStdString() == this->Times.Step())
    return;
  this->LeaveStep();
  this->Times.Enter(step.toStdString(), this->NowS());
  if (!step.isEmpty())
    this->Append({ { "what", "step" }, { "step", step.toStdString() } });
}

void StudyLog::ToolTaken(const QString& tool)
{
  this->Append({ { "what", "tool" }, { "tool", tool.toStdString() } });
}

void StudyLog::Remember()
{
  const PlanDocument& document = this->Session.Document();
  const PlanStep* next = document.history.ToRedo();
  this->Before = document.history.Current();
  this->Done = document.history.Done();
  this->Next = next ? *next : PlanStep{};
  this->Parts = document.parts;
}

/// Steps that were made elsewhere come in ones, too: a session of a reduction makes one at a time.
void StudyLog::PlanChanged()
{
  const PlanHistory& history = this->Session.Document().history;
  const auto say = [&](const char* what, const Plan& before, const PlanStep& step) {
    this->Append({ { "what", what }, { "label", TextOf(before, step) } });
  };
  if (history.Done() < this->Done)
    say("undo", history.Current(), history.Steps()[history.Done()]);
  else if (history.Done() > this->Done)
  {
    const PlanStep& step = history.Steps()[this->Done];
    say(step == this->Next ? "redo" : "action", this->Before, step);
  }
  else if (this->Done > 0 && !(history.Current() == this->Before)) // the last step is another
    say("action", this->Before, history.Steps()[this->Done - 1]);
  this->Remember();
}

/// The newest of an object stands behind its older ones, and comes again when it is made anew.
void StudyLog::PartsChanged()
{
  const std::vector<DerivedPart>& parts = this->Session.Document().parts;
  const Plan& plan = this->Session.Now();
  if (!parts.empty() && parts != this->Parts)
    this->Append({ { "what", "part" },
      { "kind", PlanNoun(plan, parts.back().object) ? PlanNoun(plan, parts.back().object) : "" },
      { "id", parts.back().object } });
  this->Parts = parts;
}

bool StudyLog::KeepSus(const SusAnswers& answers)
{
  return this->Append(
    { { "what", "sus" }, { "answers", answers }, { "score", SusScore(answers) } });
}

bool StudyLog::Finish()
{
  if (this->Finished)
    return true;
  this->StepChanged({});
  const PlanDocument& document = this->Session.Document();
  try
  {
    this->Files->WriteTimes(this->Times.Left());
    this->Files->SavePlanOf(document, this->Session.Folder());
  }
  catch (const std::exception& error)
  {
    Q_EMIT this->Failed(
      tr("The trial's plan is not saved: %1. Make room on the disk of the study's "
         "folder, and finish again.")
        .arg(QString::fromUtf8(error.what())));
    return false;
  }
  this->Append({ { "what", "finish" }, { "plan", PlanHash(document.history.Current()) } });
  this->Finished = true;
  return true;
}

} // namespace hasp
