#include "Model/PlanSession.h"

#include "Model/WorkFolder.h"
#include "Planning/DurableFile.h"
#include "Planning/PlanJournal.h"

#include <exception>
#include <stdexcept>

namespace hasp
{
namespace
{
namespace fs = std::filesystem;

QString Text(const std::exception& error)
{
  return QString::fromUtf8(error.what());
}

/// Bytes that the document names; those that are there already stay as they are.
void CopyBlobs(const fs::path& from, const fs::path& to, const PlanDocument& document)
{
  for (const std::string& hash : BlobsOf(document))
    if (!fs::exists(to / "blobs" / hash))
      WriteBlob(to, ReadBlob(from, hash));
}
} // namespace

PlanSession::PlanSession(const fs::path& work, QObject* parent)
  : QObject(parent),
    Work(work),
    Kept(std::make_shared<PlanDocument>())
{
  this->Write();
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
                            .arg(Text(error)));
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
    Q_EMIT this->Refused(Text(error));
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
    Q_EMIT this->Refused(Text(error));
    return {};
  }
}

void PlanSession::Put(PlanDocument document, fs::path place, PlanDocument saved)
{
  *this->Kept = std::move(document); // in place: History() is held by others
  this->Saved = std::move(saved);
  this->Place = std::move(place);
  this->Write(true);
  Q_EMIT this->Replaced();
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
    const PlanLock lock(folder);
    PlanDocument document = LoadPlan(folder);
    CopyBlobs(folder, this->Work, document);
    PlanDocument saved = document;
    this->Put(std::move(document), folder, std::move(saved));
    return true;
  }
  catch (const std::exception& error)
  {
    Q_EMIT this->Refused(tr("The plan cannot be opened: %1").arg(Text(error)));
    return false;
  }
}

bool PlanSession::Recover(const fs::path& crashedWork, const fs::path& place)
{
  try
  {
    RecoveredPlan found = ReadJournal(JournalIn(crashedWork));
    CopyBlobs(crashedWork, this->Work, found.document);
    if (found.damaged)
      Q_EMIT this->Warned(tr("A part of the journal is damaged: what was done after it is lost."));
    this->Put(std::move(found.document), place, place.empty() ? PlanDocument{} : LoadPlan(place));
    return true;
  }
  catch (const std::exception& error)
  {
    Q_EMIT this->Refused(tr("The work cannot be brought back: %1").arg(Text(error)));
    return false;
  }
}

void PlanSession::SaveIn(const fs::path& folder)
{
  MakeFolderDurably(folder, "the plan's folder");
  const PlanLock lock(folder);
  const bool isThere = fs::exists(folder / "plan.json");
  if (isThere && folder != this->Place)
    throw std::runtime_error("there is a plan already in that folder; choose another name");
  if (isThere && !(LoadPlan(folder) == this->Saved))
    throw std::runtime_error("somebody else has changed this plan since it was opened; save it "
                             "under another name, and compare them");
  CopyBlobs(this->Work, folder, *this->Kept);
  SavePlan(folder, *this->Kept);
  this->Saved = *this->Kept;
  this->Place = folder;
  RemoveUnusedBlobs(folder, this->Saved); // and what an interrupted save left
}

bool PlanSession::SaveAs(const fs::path& folder)
{
  std::error_code ignored;
  const bool isNew = !fs::exists(folder, ignored);
  try
  {
    this->SaveIn(folder);
    this->Write(true);
  }
  catch (const std::exception& error)
  {
    if (isNew && !fs::exists(folder / "plan.json", ignored))
      fs::remove_all(folder, ignored); // nothing half-written stays
    Q_EMIT this->Refused(tr("The plan is not saved: %1").arg(Text(error)));
    return false;
  }
  Q_EMIT this->SavedChanged();
  return true;
}

bool PlanSession::Save()
{
  const std::filesystem::path place = this->Place; // SaveAs sets it
  return this->HasPlace() && this->SaveAs(place);
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
