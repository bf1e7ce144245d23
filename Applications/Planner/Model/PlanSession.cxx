#include "Model/PlanSession.h"

#include "Model/ErrorText.h"
#include "Model/WorkFolder.h"
#include "Planning/PlanJournal.h"

#include <exception>

namespace hasp
{
namespace
{
namespace fs = std::filesystem;
} // namespace

PlanSession::PlanSession(const fs::path& work, QObject* parent)
  : QObject(parent),
    Work(work),
    Kept(std::make_shared<PlanDocument>())
{
  this->Write();
  this->JournalFails = false; // nobody listens yet: the next action says it
}

PlanSession::~PlanSession() = default;

std::shared_ptr<PlanHistory> PlanSession::History() const
{
  return { this->Kept, &this->Kept->history };
}

void PlanSession::Write(bool isSaved)
{
  try
  {
    if (!this->Journal)
      this->Journal = std::make_unique<PlanJournal>(JournalIn(this->Work), this->Saved);
    if (isSaved)
      this->Journal->Begin(this->Saved);
    this->Journal->Append(*this->Kept);
    this->JournalFails = false;
  }
  catch (const std::exception& error)
  {
    if (!std::exchange(this->JournalFails, true))
      Q_EMIT this->Warned(tr("What you do is not kept against a crash: %1. Save the plan, and make "
                             "room on the disk.")
                            .arg(ErrorText(error)));
  }
}

bool PlanSession::Do(std::vector<PlanEdit> edits, const QString& label)
{
  try
  {
    this->Kept->history.Do(std::move(edits), label.toStdString());
  }
  catch (const std::exception& error)
  {
    Q_EMIT this->Refused(ErrorText(error));
    return false;
  }
  this->Took();
  return true;
}

bool PlanSession::Do(PlanEdit edit, const QString& label)
{
  return this->Do(std::vector<PlanEdit>{ std::move(edit) }, label);
}

void PlanSession::Undo()
{
  if (!this->Kept->history.ToUndo())
    return;
  this->Kept->history.Undo();
  this->Took();
}

void PlanSession::Redo()
{
  if (!this->Kept->history.ToRedo())
    return;
  this->Kept->history.Redo();
  this->Took();
}

void PlanSession::Took()
{
  this->Write();
  Q_EMIT this->Changed();
  Q_EMIT this->SavedChanged();
}

void PlanSession::KeepMade(DerivedPart part)
{
  KeepPart(this->Kept->parts, std::move(part));
  this->Write();
  Q_EMIT this->PartsChanged();
  Q_EMIT this->SavedChanged();
}

std::string PlanSession::StoreBlob(std::string_view bytes)
{
  try
  {
    return WriteBlob(this->Work, bytes);
  }
  catch (const std::exception& error)
  {
    Q_EMIT this->Refused(ErrorText(error));
    return {};
  }
}

void PlanSession::Put(PlanDocument document, fs::path place, PlanDocument saved)
{
  *this->Kept = std::move(document); // in place: History() is held by others
  this->Saved = std::move(saved);
  this->Place = std::move(place);
  this->JournalFails = false; // of this plan it has not been said
  Q_EMIT this->Replaced();
  this->Write(true); // what it warns of is this plan's
  Q_EMIT this->Changed();
  Q_EMIT this->PartsChanged();
  Q_EMIT this->SavedChanged();
}

void PlanSession::BeginNew()
{
  this->Put({}, {}, {});
}

bool PlanSession::Open(const fs::path& folder)
{
  try
  {
    PlanDocument document;
    {
      const PlanLock lock(folder); // no longer: what follows a new plan may take seconds
      document = LoadPlan(folder);
      this->CopyBlobs(folder, this->Work, document);
    }
    PlanDocument saved = document;
    this->Put(std::move(document), folder, std::move(saved));
    return true;
  }
  catch (const std::exception& error)
  {
    Q_EMIT this->Refused(tr("The plan cannot be opened: %1").arg(ErrorText(error)));
    return false;
  }
}

bool PlanSession::Recover(const fs::path& crashedWork, const fs::path& place)
{
  try
  {
    RecoveredPlan found = ReadJournal(JournalIn(crashedWork));
    this->CopyBlobs(crashedWork, this->Work, found.document);
    this->Put(std::move(found.document), place, place.empty() ? PlanDocument{} : LoadPlan(place));
    if (found.damaged)
      Q_EMIT this->Warned(tr("A part of the journal is damaged: what was done after it is lost."));
    return true;
  }
  catch (const std::exception& error)
  {
    Q_EMIT this->Refused(tr("The work cannot be brought back: %1").arg(ErrorText(error)));
    return false;
  }
}

bool PlanSession::IsModified() const
{
  return !(this->Saved == *this->Kept);
}

QString PlanSession::WhyNot(PlanId object) const
{
  return QString::fromStdString(WhyNoPart(this->Now(), this->Kept->parts, object));
}

} // namespace hasp
