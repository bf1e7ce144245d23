#pragma once
#include "Planning/PlanJournal.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What the bytes of a journal say (Utilities/Docs/Formats.md#journals); PlanJournal is the way in
/// and out. Internal. Any thread.
namespace hasp
{

/// More than that is not read, and so not written.
constexpr std::size_t MostJournal = 256U << 20U, MostRecord = 4U << 20U;

/// A document as a journal follows it: without the plans that PlanHistory keeps.
struct JournalState
{
  explicit JournalState(const PlanDocument& document);
  PlanDocument Document() const; ///< throws what PlanHistory throws

  Plan start;
  std::vector<PlanStep> steps;
  std::size_t done;
  PlanId nextId;
  std::vector<DerivedPart> parts;
};

/// What a record says: how a document is to be, as far as it is not what it was. No differences,
/// as in edits: a record that is taken twice changes nothing.
struct JournalChange
{
  std::size_t kept = 0;        ///< so many of the steps of before stay, those behind are forgotten
  std::vector<PlanStep> steps; ///< behind those
  std::size_t done = 0;
  PlanId nextId = 1;
  std::optional<std::vector<DerivedPart>> parts; ///< all of them; none: as before
};

/// Whether a change leads there: not to another start, or where ids are given again.
bool CanLeadTo(const JournalState& before, const PlanDocument& now);
/// That change; none if nothing differs. Of documents where CanLeadTo is true.
std::optional<JournalChange> ChangeTo(const JournalState& before, const PlanDocument& now);
/// Takes it; does not throw after MakeRoom.
void Take(JournalState& state, JournalChange change);
void MakeRoom(JournalState& state, const JournalChange& change);

/// A line of JSON, without the line feed.
std::string FormatChange(const JournalChange& change);

/// Puts payloads into records, or takes them out, in their order. A record is NUMBER, from 0, SIZE
/// of the payload, HASH, the payload and a line feed, with a space between. HASH is the first 16
/// digits of the SHA-256 of the seed, NUMBER and the payload: of other bytes by chance once in 2^64
/// times. The seed is the hash of the last of the first two records, so that no record of another
/// journal is taken.
class JournalSeal
{
public:
  std::string Record(std::string_view payload);
  /// The next payload and `rest` behind its record; none, and nothing moves, if it is not whole or
  /// larger than `most`.
  std::optional<std::string_view> Payload(std::string_view& rest, std::size_t most);
  /// Whether a whole record follows `rest`, which begins with one that is not.
  bool AnyBehind(std::string_view rest) const;

private:
  std::string Head(std::size_t number, std::string_view payload) const;
  std::optional<std::string_view> Whole(
    std::string_view text, std::size_t number, std::size_t most) const;
  void MoveOn(std::string_view head);

  std::string Seed;
  std::size_t Number = 0;
};

/// The records that a journal begins with.
std::string StartRecords(JournalSeal& seal, const PlanDocument& start, std::size_t actions);
/// All of a journal. Throws std::runtime_error.
RecoveredPlan ReadRecords(std::string_view bytes);

} // namespace hasp
