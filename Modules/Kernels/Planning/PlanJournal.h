#pragma once
#include "Planning/PlanFile.h"

#include <cstddef>
#include <filesystem>
#include <memory>

/// What has been done to a plan since it was saved, on disk as soon as it is done: after a crash,
/// a kill or a power cut, all but the action that was under way is there to be offered back.
///
/// A journal is a file of any name: a whole document to start with, and a record behind it for each
/// action (Utilities/Docs/Formats.md#journals). Records are whole or not taken: each has a hash of
/// what it says, of its number and of the start. Nothing of a patient is in it that is not in the
/// plan.
///
/// Two programs do not write one journal: as long as a PlanJournal lives, it holds a lock on the
/// file's name with ".lock" behind it, an empty file of its own, since the journal itself is
/// replaced at times and the folder is what PlanLock holds. The lock goes with its program, however
/// that ends, so that it tells a crashed program from one that runs. To ask for it disturbs nobody.
/// Limit: where the file system knows no locks, as on some network drives, no journal is in use.
///
/// Needs HASP_ENABLE_JSON and HASP_ENABLE_OPENSSL. Errors: std::runtime_error, which says "the
/// journal" and neither a path nor a text of the plan; of a document that cannot be saved either,
/// what FormatPlan throws. Any thread; a PlanJournal one at a time.
namespace hasp
{

/// What was found in a journal.
struct RecoveredPlan
{
  PlanDocument document;   ///< as after the last whole record before the first that is not
  std::size_t actions = 0; ///< since the constructor, or Begin: calls of Append that wrote
  bool truncated = false; ///< the last record is not whole, as a crash leaves it; it is not counted
  bool damaged = false;   ///< whole records follow one that is not: what they say is lost

  bool operator==(const RecoveredPlan&) const noexcept = default;
};

class PlanJournal
{
public:
  /// Locks the journal and begins it with this document: what was there is replaced, whole or not
  /// at all. Its folder must be there. Throws if the journal is in use, too.
  PlanJournal(const std::filesystem::path& file, const PlanDocument& start);
  ~PlanJournal(); ///< the lock goes, the file stays
  PlanJournal(const PlanJournal&) = delete;
  PlanJournal& operator=(const PlanJournal&) = delete;

  /// Appends what `now` differs in from the last call, in one record: for each action (Do, Undo,
  /// Redo, a made part), as soon as it is done; nothing if nothing differs. After the return
  /// ReadJournal gives `now`, also after a power cut.
  ///
  /// What throws, such as a full disk, leaves the journal as it was, or with this action, but not
  /// safe from a power cut: the caller goes on, and the next call writes what is missing. Where
  /// `now` is not of the same start, where someone else has touched the file, or where that would
  /// grow above 4 times its start and 1 MiB, it begins anew with `now`, as in the constructor, and
  /// goes on counting actions.
  ///
  /// Cost: the new steps as JSON, a write and an fdatasync, some ms on a hard disk. Before, the
  /// steps are compared in memory: 2,000 names in 0.04 ms, 2,000 strokes of 60 points in 0.4 ms.
  /// Memory: a copy of the steps.
  void Append(const PlanDocument& now);

  /// Begins anew with this document, after it was saved: no actions. What throws leaves the journal
  /// as it was, or begun anew and not yet safe from a power cut.
  void Begin(const PlanDocument& start);

private:
  class Writer;
  std::unique_ptr<Writer> Own;
};

/// Reads a journal, also in a folder that cannot be written, and one in use: as of now, and if it
/// is begun anew just then this may throw. Throws if it is not there, is none, is larger than 256
/// MiB or was damaged in its start, which a crash does not do.
RecoveredPlan ReadJournal(const std::filesystem::path& file);

/// Whether a PlanJournal of this file lives, here or in another program. False if it is not there.
bool JournalInUse(const std::filesystem::path& file);

/// Deletes a journal, when there is nothing more to offer back, and its lock. Throws if it is in
/// use. Nothing if there is none. Temporaries (.hasp-…) beside it, which a crash may leave when a
/// journal begins anew, are the caller's to delete.
void RemoveJournal(const std::filesystem::path& file);

} // namespace hasp
