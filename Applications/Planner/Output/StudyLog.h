#pragma once
#include "Output/StepTimes.h"
#include "Output/StudyFiles.h"
#include "Output/SusScore.h"
#include "Planning/PlanFile.h"

#include <nlohmann/json_fwd.hpp>

#include <QElapsedTimer>
#include <QObject>
#include <QString>

#include <memory>
#include <vector>

class QEvent;

namespace hasp
{

class PlanSession;

/// Keeps a trial of a study: what `hasp evaluate FOLDER` reads, and how the operator came there.
///
///   OPERATOR-TRIAL.hasp    the plan at the end
///   OPERATOR-TRIAL.jsonl   what was done, a line each, when it is done: a crash takes none of it
///   OPERATOR-TRIAL.csv     at the end: step, visits, active_s, wall_s
///
/// Lines are JSON: `t`, seconds since the program was started, `what`, and its own keys:
///
///   begin    format (hasp-study-log-1), operator, trial, pause_s, again (another program began)
///   step     step: the user goes there
///   left     step, active_s, wall_s: of that visit
///   action, undo, redo   label: EditLabel's words and, of more edits in a step, "and 2 more"
///   tool     tool: taken in hand
///   part     kind, id: made, or made again
///   plan     the plan is another one
///   sus      answers, score
///   finish   plan (its hash)
///
/// Steps, undo, redo and parts are told by the PlanSession that it is made with; steps of the
/// workflow and tools by whoever has them. No text of the user's is in it, and no date. Where a
/// program has ended without Finish the next one goes on in the same log.
///
/// Threads: RENDER. Cost: a line a step; Finish copies the plan's blobs.
class StudyLog : public QObject
{
  Q_OBJECT
public:
  /// Throws std::invalid_argument on settings, std::runtime_error if the trial is there already or
  /// the folder cannot be written; with what to do, and without a path.
  StudyLog(StudySettings settings, PlanSession& plan, QObject* parent = nullptr);
  ~StudyLog() override;

  /// The form that the operator has filled in. False after Failed, as below.
  bool KeepSus(const SusAnswers& answers);
  /// The trial is done: its plan is saved, all of it or nothing. Once; whatever comes then is not
  /// kept any more.
  bool Finish();
  bool IsFinished() const { return this->Finished; }

public Q_SLOTS:
  void StepChanged(const QString& step); ///< "cut": the program's word for it, not the user's
  void ToolTaken(const QString& tool);   ///< empty: put away

Q_SIGNALS:
  void Failed(const QString& text); ///< what could not be written, and what to do; told once

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  double NowS() const;
  bool Append(nlohmann::ordered_json line);
  void LeaveStep();
  void PlanChanged();
  void PartsChanged();
  void Remember();

  StudySettings Of;
  PlanSession& Session;
  QElapsedTimer Clock;
  StepTimes Times;
  std::unique_ptr<StudyFiles> Files;
  bool Finished = false;
  bool Told = false; ///< that the log cannot be written
  ///@{
  /// As they were at the last line.
  Plan Before;
  std::size_t Done = 0;
  PlanStep Next; ///< what Redo would do; no edits: nothing
  std::vector<DerivedPart> Parts;
  ///@}
};

} // namespace hasp
