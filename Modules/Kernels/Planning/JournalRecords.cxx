#include "Planning/JournalRecords.h"

#include "Planning/PlanJson.h"
#include "Planning/PlanMigration.h"
#include "Planning/Sha256.h"
#include "Planning/ValueChecks.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr const char* Format = "hasp-journal-1";
constexpr std::size_t MostHeader = 200, MostPlan = 64U << 20U; // as FormatPlan's
constexpr std::size_t MostEntries = 100'000'000;               // a record's own limit comes first
constexpr std::size_t Starts = 2;                              // the header and the plan
constexpr std::size_t HashDigits = 16;
constexpr std::size_t MostCounted = std::size_t(1) << 53U; // a JSON number is whole up to there

std::size_t PlanVersion()
{
  return PlanMigrations().size() + 1;
}

/// A number and the space behind it, off the front of a text.
std::optional<std::size_t> CutNumber(std::string_view& text)
{
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const auto digits = std::size_t(end - text.data());
  if (error != std::errc() || digits == text.size() || text[digits] != ' ')
    return {};
  text.remove_prefix(digits + 1);
  return number;
}

/// The first line off a text; what is left begins behind its line feed, or is empty.
void CutLine(std::string_view& text)
{
  text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
}

Json PartsToJson(const std::vector<DerivedPart>& parts)
{
  Json list = Json::array();
  for (const DerivedPart& part : parts)
    list.push_back(PartToJson(part));
  return list;
}

Json StepsToJson(const std::vector<PlanStep>& steps)
{
  Json list = Json::array();
  for (const PlanStep& step : steps)
  {
    Json edits = Json::array();
    for (const PlanEdit& edit : step.edits)
      edits.push_back(EditToJson(edit));
    list.push_back({ { "label", step.label }, { "edits", std::move(edits) } });
  }
  return list;
}

PlanStep ReadStep(const Json& json, const std::string& name)
{
  const StrictJson read(json, "plan", name, { "label", "edits" });
  PlanStep step{ read.Text("label"), {} };
  for (const Json& edit : read.List("edits", MostEntries))
    step.edits.push_back(EditFromJson(edit, Below(name, ListKey("edits", step.edits.size()))));
  return step;
}

/// Of a record behind `before`, of the version that the journal was begun with.
JournalChange ReadChange(
  std::string_view payload, const JournalState& before, std::size_t version, std::size_t action)
{
  const std::string subject = "action " + std::to_string(action);
  Json json = ParseJson(std::string(payload), subject);
  MigratePlanFile(json, version, PlanMigrations());
  const StrictJson record(json, subject, "", { "history", "parts" });
  const StrictJson read(
    record.Get("history"), subject, "history", { "kept", "steps", "done", "nextId" });
  JournalChange change;
  change.kept = read.Count("kept", 0, before.steps.size());
  for (const Json& step : read.List("steps", MostEntries))
    change.steps.push_back(ReadStep(step, ListKey("history.steps", change.steps.size())));
  change.done = read.Count("done", 0, change.kept + change.steps.size());
  change.nextId =
    static_cast<PlanId>(read.Count("nextId", before.nextId, std::uint64_t(MaxPlanId) + 1));
  if (record.Has("parts"))
  {
    change.parts.emplace();
    for (const Json& part : record.List("parts", MostEntries))
      change.parts->push_back(PartFromJson(part, ListKey("parts", change.parts->size())));
  }
  return change;
}

struct Header
{
  std::size_t version, actions;
};

Header ReadHeader(std::string_view payload)
{
  const Json json = ParseJson(std::string(payload), "header");
  const StrictJson read(json, "header", "", { "format", "version", "actions" });
  if (read.Text("format") != Format)
    read.Fail("format", std::string("is none that this version of Hasp reads: ") + Format);
  return { read.Count("version", 1, PlanVersion()), read.Count("actions", 0, MostCounted) };
}
} // namespace

JournalState::JournalState(const PlanDocument& document)
  : start(document.history.Start()),
    steps(document.history.Steps()),
    done(document.history.Done()),
    nextId(document.history.NewId()),
    parts(document.parts)
{
}

PlanDocument JournalState::Document() const
{
  return { PlanHistory(this->start, this->steps, this->done, this->nextId), this->parts };
}

bool CanLeadTo(const JournalState& before, const PlanDocument& now)
{
  return now.history.NewId() >= before.nextId && now.history.Start() == before.start;
}

std::optional<JournalChange> ChangeTo(const JournalState& before, const PlanDocument& now)
{
  // All steps are compared, and not only those behind the last call's Done(): what was undone and
  // done otherwise between two calls may have come back to the same counts.
  const std::vector<PlanStep>& steps = now.history.Steps();
  const auto differ =
    std::mismatch(before.steps.begin(), before.steps.end(), steps.begin(), steps.end()).second;
  JournalChange change{ std::size_t(differ - steps.begin()), { differ, steps.end() },
    now.history.Done(), now.history.NewId(), {} };
  if (now.parts != before.parts)
    change.parts = now.parts;
  if (change.kept == before.steps.size() && change.steps.empty() && change.done == before.done &&
      change.nextId == before.nextId && !change.parts)
    return {};
  return change;
}

void MakeRoom(JournalState& state, const JournalChange& change)
{
  if (const std::size_t size = change.kept + change.steps.size(); size > state.steps.capacity())
    state.steps.reserve(2 * size);
}

void Take(JournalState& state, JournalChange change)
{
  const auto kept = state.steps.begin() + std::ptrdiff_t(change.kept);
  state.steps.erase(kept, state.steps.end());
  std::move(change.steps.begin(), change.steps.end(), std::back_inserter(state.steps));
  state.done = change.done;
  state.nextId = change.nextId;
  if (change.parts)
    state.parts = std::move(*change.parts);
}

std::string FormatChange(const JournalChange& change)
{
  Json json = { { "history", { { "kept", change.kept }, { "steps", StepsToJson(change.steps) },
                               { "done", change.done }, { "nextId", change.nextId } } } };
  if (change.parts)
    json["parts"] = PartsToJson(*change.parts);
  try
  {
    return json.dump();
  }
  catch (const Json::exception&) // its text quotes the value
  {
    throw std::runtime_error("the journal cannot be written: a text is not UTF-8");
  }
}

std::string JournalSeal::Head(std::size_t number, std::string_view payload) const
{
  const std::string count = std::to_string(number) + " ";
  const std::string hash = Sha256((this->Seed + " " + count).append(payload));
  return count + std::to_string(payload.size()) + " " + hash.substr(0, HashDigits) + " ";
}

void JournalSeal::MoveOn(std::string_view head)
{
  if (this->Number++ < Starts)
    this->Seed = head.substr(head.size() - HashDigits - 1, HashDigits);
}

std::string JournalSeal::Record(std::string_view payload)
{
  std::string record = this->Head(this->Number, payload);
  this->MoveOn(record);
  return record.append(payload).append(1, '\n');
}

std::optional<std::string_view> JournalSeal::Whole(
  std::string_view text, std::size_t number, std::size_t most) const
{
  std::string_view rest = text;
  const auto counted = CutNumber(rest), size = CutNumber(rest);
  if (counted != number || !size || *size > most || rest.size() < HashDigits + 1 + *size + 1)
    return {};
  const std::string_view payload = rest.substr(HashDigits + 1, *size);
  const bool oneLine = number + 1 == Starts || payload.find('\n') == std::string_view::npos;
  // The hash last, and of one line: so much is hashed as the file is long, whatever is in it.
  if (rest[HashDigits + 1 + *size] != '\n' || !oneLine ||
      !text.starts_with(this->Head(number, payload)))
    return {};
  return payload;
}

std::optional<std::string_view> JournalSeal::Payload(std::string_view& rest, std::size_t most)
{
  const auto payload = this->Whole(rest, this->Number, most);
  if (payload)
  {
    this->MoveOn(rest.substr(0, std::size_t(payload->data() - rest.data())));
    rest = rest.substr(std::size_t(payload->data() - rest.data()) + payload->size() + 1);
  }
  return payload;
}

bool JournalSeal::AnyBehind(std::string_view rest) const
{
  const auto isRecord = [&](std::string_view text)
  {
    std::string_view line = text;
    const auto number = CutNumber(line);
    return number && *number >= this->Number && this->Whole(text, *number, MostRecord);
  };
  // Where the record says that it ends, in case that it is its line feed that is wrong.
  std::string_view own = rest;
  if (CutNumber(own))
    if (const auto size = CutNumber(own); size && *size < own.size())
      if (isRecord(own.substr(std::min(HashDigits + 1 + *size + 1, own.size()))))
        return true;
  while (!rest.empty())
  {
    CutLine(rest);
    if (isRecord(rest))
      return true;
  }
  return false;
}

std::string StartRecords(JournalSeal& seal, const PlanDocument& start, std::size_t actions)
{
  const Json header = { { "format", Format }, { "version", PlanVersion() },
    { "actions", actions } };
  std::string records = seal.Record(header.dump());
  return records += seal.Record(FormatPlan(start));
}

RecoveredPlan ReadRecords(std::string_view bytes)
{
  JournalSeal seal;
  const auto header = seal.Payload(bytes, MostHeader), plan = seal.Payload(bytes, MostPlan);
  if (!header || !plan)
    throw std::runtime_error("the journal is none, or is damaged in its start: nothing in it can "
                             "be offered back. Open the plan as it was saved last");
  try
  {
    const Header begun = ReadHeader(*header);
    JournalState state(ParsePlan(std::string(*plan)));
    RecoveredPlan found{ {}, begun.actions, false, false };
    while (const auto payload = seal.Payload(bytes, MostRecord))
      Take(state, ReadChange(*payload, state, begun.version, ++found.actions));
    found.damaged = seal.AnyBehind(bytes);
    found.truncated = !bytes.empty() && !found.damaged;
    found.document = state.Document();
    return found;
  }
  catch (const std::exception& error)
  {
    throw std::runtime_error(std::string("the journal: ") + error.what());
  }
}

} // namespace hasp
