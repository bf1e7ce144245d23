// How a plan is saved: whole, or not at all.
#include "Model/PlanSession.h"

#include "Model/ErrorText.h"
#include "Planning/DurableFile.h"

#include <exception>
#include <stdexcept>

namespace hasp
{
namespace fs = std::filesystem;

void PlanSession::CopyBlobs(const fs::path& from, const fs::path& to, const PlanDocument& document)
{
  for (const std::string& hash : BlobsOf(document))
    if (!fs::exists(to / "blobs" / hash))
      WriteBlob(to, ReadBlob(from, hash));
}

void PlanSession::SaveIn(const fs::path& folder)
{
  MakeFolderDurably(folder, "the plan's folder");
  const PlanLock lock(folder);
  this->CheckPlace(folder);
  this->CopyBlobs(this->Work, folder, *this->Kept);
  this->Tried = *this->Kept;
  this->TriedIn = folder;
  SavePlan(folder, *this->Kept);
  this->Saved = *this->Kept;
  this->Place = folder;
}

/// A save may have failed behind its last step: the plan is in place, and may not outlast a power
/// cut. Then that is this one's plan, too.
void PlanSession::CheckPlace(const fs::path& folder) const
{
  if (!fs::exists(folder / "plan.json"))
    return;
  const PlanDocument found = LoadPlan(folder);
  if (folder == this->TriedIn && found == this->Tried)
    return;
  if (folder != this->Place)
    throw std::runtime_error("there is a plan already in that folder; choose another name");
  if (!(found == this->Saved))
    throw std::runtime_error("somebody else has changed this plan since it was opened; save it "
                             "under another name, and compare them");
}

/// And what an interrupted save has left.
void PlanSession::RemoveUnused()
{
  try
  {
    const PlanLock lock(this->Place);
    RemoveUnusedBlobs(this->Place, this->Saved);
  }
  catch (const std::exception&)
  {
    // The plan is saved; the next save tries again.
  }
}

bool PlanSession::SaveAs(const fs::path& folder)
{
  std::error_code ignored;
  const bool isNew = !fs::exists(folder, ignored);
  try
  {
    this->SaveIn(folder);
    this->RemoveUnused();
    this->Write(true);
  }
  catch (const std::exception& error)
  {
    if (isNew && !fs::exists(folder / "plan.json", ignored))
      fs::remove_all(folder, ignored); // nothing half-written stays
    Q_EMIT this->Refused(tr("The plan is not saved: %1").arg(ErrorText(error)));
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

} // namespace hasp
