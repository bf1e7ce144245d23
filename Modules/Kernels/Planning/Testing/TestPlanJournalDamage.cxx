#include "JournalFixture.h"
#include "Planning/JournalRecords.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace
{
using namespace hasp;
namespace fs = std::filesystem;

/// A journal of some actions: its bytes, where each record ends (that of the start first), and the
/// document there.
struct SmallJournal
{
  explicit SmallJournal(unsigned seed, int actions)
  {
    const JournalFolder folder;
    RandomActions planner(seed, ToPaint());
    PlanJournal journal(folder.Journal(), planner.Now());
    for (;; --actions)
    {
      this->ends.push_back(fs::file_size(folder.Journal()));
      this->documents.push_back(planner.Now());
      if (actions == 0)
        break;
      journal.Append(planner.Next());
    }
    this->bytes = ReadBytes(folder.Journal());
  }

  std::string bytes;
  std::vector<std::size_t> ends;
  std::vector<PlanDocument> documents;
};

std::string Refusal(const std::string& bytes)
{
  return Thrown([&] { ReadRecords(bytes); });
}

TEST(PlanJournalDamage, ACutAnywhereLeavesTheDocumentOfTheLastWholeRecord)
{
  const SmallJournal sound(1, 8);
  for (std::size_t size = sound.ends[0]; size <= sound.bytes.size(); ++size)
  {
    const auto behind = std::upper_bound(sound.ends.begin(), sound.ends.end(), size);
    const auto actions = std::size_t(behind - sound.ends.begin()) - 1;
    const RecoveredPlan found = ReadRecords(std::string_view(sound.bytes).substr(0, size));
    ASSERT_EQ(found.document, sound.documents[actions]) << size;
    ASSERT_EQ(found.actions, actions) << size;
    ASSERT_EQ(found.truncated, size != sound.ends[actions]) << size;
    ASSERT_FALSE(found.damaged) << size;
  }
  for (std::size_t size = 0; size < sound.ends[0]; ++size) // which no crash does
    ASSERT_EQ(Refusal(sound.bytes.substr(0, size)).find("the journal is none, or is damaged"), 0U);
}

TEST(PlanJournalDamage, AWrongByteAnywhereIsFoundAndNothingBehindItIsRead)
{
  const SmallJournal sound(2, 6);
  const std::size_t last = sound.documents.size() - 1;
  for (std::size_t at = 0; at < sound.bytes.size(); ++at)
    for (const char wrong : { char(sound.bytes[at] ^ char(1U << at % 8)), '\n', '0' })
    {
      std::string bytes = sound.bytes;
      if (bytes[at] == wrong)
        continue;
      bytes[at] = wrong;
      const auto behind = std::upper_bound(sound.ends.begin(), sound.ends.end(), at);
      const auto record = std::size_t(behind - sound.ends.begin());
      if (record == 0)
      {
        ASSERT_NE(Refusal(bytes), "") << at;
        continue;
      }
      const RecoveredPlan found = ReadRecords(bytes);
      ASSERT_EQ(found.document, sound.documents[record - 1]) << at;
      ASSERT_EQ(found.actions, record - 1) << at;
      ASSERT_EQ(found.damaged, record != last) << at;
      ASSERT_EQ(found.truncated, record == last) << at;
    }
}

TEST(PlanJournalDamage, RecordsAreTakenOnceInTheirOrderAndOfThisJournalAlone)
{
  const SmallJournal sound(3, 12);
  const auto record = [&](std::size_t n)
  { return sound.bytes.substr(sound.ends[n - 1], sound.ends[n] - sound.ends[n - 1]); };
  const auto upTo = [&](std::size_t n) { return sound.bytes.substr(0, sound.ends[n]); };
  const RecoveredPlan twice = ReadRecords(upTo(5) + record(5));
  EXPECT_EQ(twice.actions, 5U);
  EXPECT_TRUE(twice.truncated);
  const RecoveredPlan missing = ReadRecords(upTo(5) + record(7) + record(8));
  EXPECT_EQ(missing.document, sound.documents[5]);
  EXPECT_TRUE(missing.damaged);
  std::string renumbered = record(7);
  renumbered.replace(0, renumbered.find(' '), record(6), 0, record(6).find(' '));
  EXPECT_EQ(ReadRecords(upTo(5) + renumbered).actions, 5U);
  // Of another start, as in a journal that was begun anew and has the old one's blocks behind it.
  PlanDocument renamed = sound.documents[0];
  renamed.history.Do(RenameObject{ 1, "another" });
  JournalSeal seal;
  const RecoveredPlan foreign = ReadRecords(StartRecords(seal, renamed, 0) + record(1));
  EXPECT_EQ(foreign.document, renamed);
  EXPECT_TRUE(foreign.truncated);
}

TEST(PlanJournalDamage, WhateverHappensToTheBytesNoOtherDocumentIsRead)
{
  const SmallJournal sound(5, 12);
  std::mt19937 random(1);
  const auto below = [&](std::size_t count) { return std::size_t(random() % count); };
  int read = 0;
  for (int n = 0; n < 1500; ++n)
  {
    std::string bytes = sound.bytes;
    for (std::size_t times = 1 + below(3); times > 0; --times)
    {
      const std::size_t at = sound.ends[0] + below(bytes.size() - sound.ends[0]);
      const std::size_t size = 1 + below(300);
      if (n % 3 == 0)
        bytes.replace(at, size, bytes.substr(below(bytes.size()), 1 + below(300)));
      else if (n % 3 == 1)
        bytes.insert(at, size, n % 2 == 0 ? '\0' : '\n'); // blocks that were never written
      else
        bytes.erase(at, size);
    }
    const RecoveredPlan found = ReadRecords(bytes);
    ASSERT_LT(found.actions, sound.documents.size()) << n;
    ASSERT_EQ(found.document, sound.documents[found.actions]) << n;
    ASSERT_TRUE(bytes == sound.bytes || found.truncated || found.damaged ||
                bytes.size() == sound.ends[found.actions])
      << n;
    read += found.actions > 0;
  }
  EXPECT_GT(read, 500);
}

TEST(PlanJournalDamage, SizesThatLieTakeNoMemory)
{
  const SmallJournal sound(6, 1);
  for (const char* size : { "62914560", "16777217", "18446744073709551615", "18446744073709551600",
         "99999999999999999999", "-1", "0", "" })
    for (const char* number : { "3 ", "18446744073709551615 ", "" })
    {
      const RecoveredPlan found =
        ReadRecords(sound.bytes + number + size + " 0123456789abcdef {\"history\":{}}\n");
      EXPECT_EQ(found.document, sound.documents[1]) << size;
      EXPECT_TRUE(found.truncated) << size;
    }
  JournalSeal seal; // a sound record, which nobody writes
  const std::string start = StartRecords(seal, sound.documents[0], 0);
  EXPECT_TRUE(ReadRecords(start + seal.Record(std::string(MostRecord + 1, ' '))).truncated);
  const JournalFolder folder;
  WriteBytes(folder.Journal(), sound.bytes);
  fs::resize_file(folder.Journal(), (256U << 20U) + 1); // a hole: no such file is on the disk
  EXPECT_EQ(Thrown([&] { ReadJournal(folder.Journal()); }),
    "the journal has 268435457 bytes, at most 268435456 are read");
}

/// A journal that someone who knows the format has written.
std::string Written(const PlanDocument& start, const std::string& payload)
{
  JournalSeal seal;
  const std::string records = StartRecords(seal, start, 0);
  return records + seal.Record(payload);
}

TEST(PlanJournalDamage, SoundRecordsThatSayNonsenseAreRefused)
{
  PlanDocument start = ToPaint();
  start.history.Do(RenameObject{ 1, "Erika" });
  const auto refusal = [&](const std::string& kept, const std::string& steps,
                         const std::string& done, const std::string& behind)
  {
    return Refusal(Written(start, "{\"history\":{\"kept\":" + kept + ",\"steps\":[" + steps +
                                    "],\"done\":" + done + ",\"nextId\":3}" + behind + "}"));
  };
  const std::string history = "the journal: action 1: history.";
  EXPECT_EQ(refusal("3", "", "3", ""), "");
  EXPECT_EQ(refusal("4", "", "3", ""), history + "kept must be a whole number in [0, 3]");
  EXPECT_EQ(refusal("2", "", "3", ""), history + "done must be a whole number in [0, 2]");
  EXPECT_EQ(refusal("3", "", "3,\"nextId\":2", ""),
    "the journal: action 1: no JSON: a key stands twice in one object");
  EXPECT_NE(
    refusal("3", "", "3", ",\"part\":[]").find("nearest known is 'parts'"), std::string::npos);
  EXPECT_EQ(
    refusal("3", "", "3", ",\"parts\":[{}]"), "the journal: plan: parts[0].object is missing");
  EXPECT_EQ(refusal("3", "{\"label\":\"Erika\",\"edits\":[{\"remove\":9}]}", "4", ""),
    "the journal: object 9: the plan has none");
  EXPECT_EQ(refusal("3", "{\"label\":\"Erika\",\"edits\":[{\"put\":9}]}", "4", "")
              .find("the journal: plan: a key of history.steps[0].edits[0] is unknown"),
    0U);
  EXPECT_EQ(
    Refusal(Written(start, "Erika")), "the journal: action 1: no JSON: a mistake at byte 1");
  EXPECT_EQ(Refusal(Written(start, "{}")), "the journal: action 1: history is missing");
  EXPECT_EQ(Refusal(Written(start, R"({"history":{"kept":3,"steps":[],"done":3,"nextId":2}})")),
    history + "nextId must be a whole number in [3, 1000000001]");
}

TEST(PlanJournalDamage, WhatIsNoJournalOrANewerOneIsRefused)
{
  const auto begun = [](const std::string& header, const std::string& plan)
  {
    JournalSeal seal;
    const std::string records = seal.Record(header);
    return Refusal(records + seal.Record(plan));
  };
  const std::string plan = FormatPlan({});
  EXPECT_EQ(begun(R"({"format":"hasp-journal-1","version":5,"actions":0})", plan), "");
  EXPECT_EQ(begun(R"({"format":"hasp-journal-2","version":5,"actions":0})", plan),
    "the journal: header: format is none that this version of Hasp reads: hasp-journal-1");
  EXPECT_EQ(begun(R"({"format":"hasp-journal-1","version":99,"actions":0})", plan)
              .find("the journal: header: version must be a whole number in [1, "),
    0U);
  EXPECT_EQ(begun(R"({"format":"hasp-journal-1","version":5,"actions":0})", plan + "\n")
              .find("the journal: plan.json is damaged"),
    0U);
  for (const std::string& other : { std::string(), plan, std::string(1000, '\0'),
         std::string("0 300 0123456789abcdef ") + std::string(300, 'x') + "\n" })
    EXPECT_EQ(Refusal(other).find("the journal is none, or is damaged in its start"), 0U);
}

/// What the first version wrote, as far as there were journals then: cuts did not say how far they
/// reach.
TEST(PlanJournalDamage, AnOlderJournalGoesTheWayOfAnOlderPlan)
{
  const std::string plan = ReadBytes(HASP_KEPT_PLAN_1);
  PlanDocument document = ParsePlan(plan);
  const std::string count = std::to_string(document.history.Done());
  JournalSeal seal;
  std::string bytes = seal.Record(R"({"format":"hasp-journal-1","version":1,"actions":4})");
  bytes += seal.Record(plan);
  bytes += seal.Record(
    "{\"history\":{\"kept\":" + count +
    R"(,"steps":[{"label":"Add cut 50","edits":[{"add":"cut","object":{"id":50,"name":"",)"
    R"("blade":{"point":[0,0,0],"normal":[0,0,1],"along":[1,0,0],"widthMm":40,"depthMm":50,)"
    R"("kerfMm":1},"fragments":[]}}]}],"done":)" +
    std::to_string(document.history.Done() + 1) + R"(,"nextId":51}})");
  const RecoveredPlan found = ReadRecords(bytes);
  EXPECT_EQ(found.actions, 5U);
  ASSERT_EQ(found.document.history.Current().cuts.back().id, 50U);
  EXPECT_EQ(found.document.history.Current().cuts.back().reachMm, 8.0);
}

} // namespace
