#include "FailingCalls.h"
#include "JournalFixture.h"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

namespace
{
using namespace hasp;
namespace fs = std::filesystem;

RecoveredPlan Sound(const PlanDocument& document, std::size_t actions)
{
  return { document, actions, false, false };
}

int CallsOf(const std::string& names)
{
  return int(std::count(names.begin(), names.end(), ' '));
}

std::ptrdiff_t FilesIn(const fs::path& folder)
{
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

/// A journal that a crashed planner left.
void Leave(const fs::path& file, const PlanDocument& document)
{
  const PlanJournal journal(file, document);
}

TEST(PlanJournalCrashes, AnActionIsOnDiskWhenAppendReturns)
{
  const JournalFolder folder;
  RandomActions planner(1);
  failing::Arm(0, failing::Way::Error);
  PlanJournal journal(folder.Journal(), planner.Now());
  EXPECT_EQ(failing::Disarm(), "open fcntl open write fsync close rename open fsync close open ");
  failing::Arm(0, failing::Way::Error);
  journal.Append(planner.Next());
  EXPECT_EQ(failing::Disarm(), "write fdatasync ");
}

TEST(PlanJournalCrashes, ACrashAtAnyCallOfAppendLosesAtMostThatAction)
{
  int olds = 0, news = 0;
  for (int call = 1, status = -1; status != 0; ++call)
  {
    const JournalFolder folder;
    RandomActions planner(unsigned(call), RandomDocument(1, 5)), again = planner;
    status = InChild(
      [&]
      {
        PlanJournal journal(folder.Journal(), planner.Now());
        journal.Append(planner.Next());
        failing::Arm(call, failing::Way::Crash);
        journal.Append(planner.Next());
        failing::Disarm();
      });
    ASSERT_TRUE(status == 0 || status == 99) << status;
    const PlanDocument before = again.Next(), after = again.Next();
    const RecoveredPlan found = ReadJournal(folder.Journal());
    ASSERT_TRUE(found.document == (found.actions == 1 ? before : after)) << "call " << call;
    EXPECT_EQ(found.truncated, call == 1); // half of the write
    ++(found.actions == 1 ? olds : news);
    EXPECT_FALSE(JournalInUse(folder.Journal()));
    PlanJournal journal(folder.Journal(), found.document); // what the crash left is in no one's way
    journal.Append(after);
    EXPECT_EQ(ReadJournal(folder.Journal()).document, after);
  }
  EXPECT_EQ(olds, 1); // in the write
  EXPECT_EQ(news, 2); // before it is synced, no crash
}

TEST(PlanJournalCrashes, ACrashAtAnyCallOfABeginningLeavesTheOldJournalOrTheNewOne)
{
  const PlanDocument before = RandomDocument(1, 5), after = RandomDocument(2, 9);
  int olds = 0, news = 0;
  for (int call = 1, status = -1; status != 0; ++call)
  {
    const JournalFolder folder;
    Leave(folder.Journal(), before);
    status = InChild(
      [&]
      {
        failing::Arm(call, failing::Way::Crash);
        const PlanJournal journal(folder.Journal(), after);
        failing::Disarm();
      });
    ASSERT_TRUE(status == 0 || status == 99) << status;
    const RecoveredPlan found = ReadJournal(folder.Journal());
    ASSERT_TRUE(found == Sound(before, 0) || found == Sound(after, 0)) << "call " << call;
    ++(found.document == before ? olds : news);
    EXPECT_FALSE(JournalInUse(folder.Journal()));
    Leave(folder.Journal(), after);
    EXPECT_EQ(ReadJournal(folder.Journal()), Sound(after, 0));
  }
  EXPECT_EQ(olds, 7); // up to the renaming
  EXPECT_EQ(news, 5);
}

TEST(PlanJournalCrashes, ACrashAtAnyCallOfBeginningAnewLosesAtMostThatAction)
{
  const PlanDocument start = RandomDocument(1, 5), other = RandomDocument(2, 9);
  for (int call = 1, status = -1; status != 0; ++call)
  {
    const JournalFolder folder;
    RandomActions planner(unsigned(call), start), again = planner;
    status = InChild(
      [&]
      {
        PlanJournal journal(folder.Journal(), planner.Now());
        journal.Append(planner.Next());
        failing::Arm(call, failing::Way::Crash);
        journal.Append(other); // of another start
        failing::Disarm();
      });
    ASSERT_TRUE(status == 0 || status == 99) << status;
    const RecoveredPlan found = ReadJournal(folder.Journal());
    ASSERT_TRUE(found == Sound(again.Next(), 1) || found == Sound(other, 2)) << "call " << call;
    ASSERT_EQ(status != 0 || found.actions == 2, true);
  }
}

/// After the error: what is in the journal is old or new, and the next call brings all.
void ExpectNothingLost(const JournalFolder& folder, PlanJournal& journal, RandomActions& planner,
  const PlanDocument& before, const std::string& error)
{
  const PlanDocument after = planner.Now();
  const RecoveredPlan found = ReadJournal(folder.Journal());
  EXPECT_TRUE(found.document == before || found.document == after);
  EXPECT_EQ(error.find("the journal "), error.empty() ? std::string::npos : 0U) << error;
  EXPECT_TRUE(!error.empty() || found.document == after);
  journal.Append(planner.Next());
  const RecoveredPlan next = ReadJournal(folder.Journal());
  EXPECT_EQ(next, Sound(planner.Now(), next.actions));
  journal.Append(planner.Next());
  EXPECT_EQ(ReadJournal(folder.Journal()), Sound(planner.Now(), next.actions + 1));
}

TEST(PlanJournalCrashes, AnErrorAtAnyCallOfAppendIsToldAndTheNextCallBringsAll)
{
  for (const failing::Way way : { failing::Way::Error, failing::Way::Gone })
    for (int call = 1, calls = call; calls >= call; ++call)
    {
      const JournalFolder folder;
      RandomActions planner(unsigned(call), RandomDocument(1, 5));
      PlanJournal journal(folder.Journal(), planner.Now());
      journal.Append(planner.Next());
      const PlanDocument before = planner.Now();
      failing::Arm(call, way);
      const std::string error = Thrown([&] { journal.Append(planner.Next()); });
      calls = CallsOf(failing::Disarm());
      EXPECT_EQ(
        error, calls < call ? "" : "the journal cannot be written: No space left on device");
      if (way == failing::Way::Error)
      {
        EXPECT_EQ(
          ReadJournal(folder.Journal()), calls < call ? Sound(planner.Now(), 2) : Sound(before, 1));
      }
      ExpectNothingLost(folder, journal, planner, before, error);
    }
}

TEST(PlanJournalCrashes, WhatTheDiskDidNotTakeOnceIsWrittenWholeTheNextTime)
{
  const std::string anew = "open write fsync close rename open fsync close open close ";
  for (int call : { 1, 2 })
  {
    const JournalFolder folder;
    RandomActions planner(7);
    PlanJournal journal(folder.Journal(), planner.Now());
    failing::Arm(call, failing::Way::Error);
    EXPECT_NE(Thrown([&] { journal.Append(planner.Next()); }), "");
    failing::Arm(0, failing::Way::Error);
    journal.Append(planner.Now());
    // After a failed sync no later one tells what became of those bytes; a failed write is told.
    EXPECT_EQ(failing::Disarm(), call == 1 ? "write fdatasync " : anew);
  }
}

TEST(PlanJournalCrashes, AnErrorAtAnyCallOfBeginningAnewLosesNothing)
{
  for (const failing::Way way : { failing::Way::Error, failing::Way::Gone })
    for (int call = 1, calls = call; calls >= call; ++call)
    {
      const JournalFolder folder;
      RandomActions planner(unsigned(call), RandomDocument(1, 5));
      PlanJournal journal(folder.Journal(), RandomDocument(3, 2));
      const PlanDocument before = RandomDocument(3, 2);
      failing::Arm(call, way);
      const std::string error = Thrown([&] { journal.Append(planner.Now()); });
      calls = CallsOf(failing::Disarm());
      ExpectNothingLost(folder, journal, planner, before, error);
      if (way == failing::Way::Error) // the journal and its lock, no half file
      {
        EXPECT_EQ(FilesIn(folder.Path()), 2) << call;
      }
    }
}

TEST(PlanJournalCrashes, AnErrorAtAnyCallOfTheConstructorLeavesTheOldJournalOrTheNewOne)
{
  const PlanDocument before = RandomDocument(1, 5), after = RandomDocument(2, 9);
  for (int call = 1, calls = call; calls >= call; ++call)
  {
    const JournalFolder folder;
    Leave(folder.Journal(), before);
    failing::Arm(call, failing::Way::Error);
    const std::string error = Thrown([&] { PlanJournal(folder.Journal(), after); });
    calls = CallsOf(failing::Disarm());
    const RecoveredPlan found = ReadJournal(folder.Journal());
    EXPECT_TRUE(found == Sound(before, 0) || found == Sound(after, 0)) << call;
    EXPECT_TRUE(!error.empty() || found.document == after) << call;
    EXPECT_FALSE(JournalInUse(folder.Journal())) << call;
    Leave(folder.Journal(), after);
  }
}

TEST(PlanJournalCrashes, AWriteThatTheSystemTakesHalfOfIsTakenBack)
{
  const JournalFolder folder;
  EXPECT_EQ(InChild(
              [&]
              {
                std::signal(SIGXFSZ, SIG_IGN);
                RandomEdits random(1);
                PlanDocument document = ToPaint();
                PlanJournal journal(folder.Journal(), document);
                const std::string sound = ReadBytes(folder.Journal());
                rlimit limit{};
                getrlimit(RLIMIT_FSIZE, &limit);
                limit.rlim_cur = sound.size() + 1000;
                setrlimit(RLIMIT_FSIZE, &limit); // the system's own refusal
                document.history.Do(Stroke(random, 100));
                if (Thrown([&] { journal.Append(document); }) !=
                    "the journal cannot be written: File too large")
                  _exit(3);
                if (ReadBytes(folder.Journal()) != sound)
                  _exit(4);
                document.history.Undo();
                document.history.Do(RenameObject{ 1, "small" });
                journal.Append(document); // there is room for that
                if (!(ReadJournal(folder.Journal()) == Sound(document, 1)))
                  _exit(5);
              }),
    0);
}

/// A journal that begins anew with the next stroke.
struct GrownJournal
{
  GrownJournal()
  {
    const auto size = [this] { return std::size_t(fs::file_size(this->folder.Journal())); };
    const std::size_t most = 4 * size() + (std::size_t(1) << 20U);
    for (std::size_t record = 0; size() + record < most;)
    {
      const std::size_t before = size();
      this->journal.Append(this->Paint());
      record = size() - before;
    }
  }
  const PlanDocument& Paint() // always the same stroke, so that records are of one size
  {
    ++this->actions;
    this->document.history.Do(this->stroke);
    return this->document;
  }
  RecoveredPlan Expected() const { return Sound(this->document, this->actions); }

  const JournalFolder folder;
  RandomEdits random{ 2 };
  const AddSegmentationStroke stroke = Stroke(random, 5000);
  PlanDocument document = ToPaint();
  std::size_t actions = 0;
  PlanJournal journal{ folder.Journal(), document };
};

TEST(PlanJournalCrashes, WithoutRoomForAnotherWholePlanRecordsAreStillAppended)
{
  GrownJournal grown;
  for (int n = 0; n < 3; ++n)
  {
    failing::Arm(n == 0 ? 1 : 0, failing::Way::Error); // of beginning anew: it opens a file
    grown.journal.Append(grown.Paint());
    EXPECT_EQ(failing::Disarm(), n == 0 ? "open write fdatasync " : "write fdatasync ");
    EXPECT_EQ(ReadJournal(grown.folder.Journal()), grown.Expected());
  }
}

TEST(PlanJournalCrashes, AJournalThatWasReplacedButNotSyncedIsTold)
{
  for (int call = 5; call <= 10; ++call) // rename, open fsync close, open close
  {
    GrownJournal grown;
    failing::Arm(call, failing::Way::Error);
    const std::string error = Thrown([&] { grown.journal.Append(grown.Paint()); });
    failing::Disarm();
    EXPECT_EQ(error.empty(), call == 5 || call == 8 || call == 10) << call << ": " << error;
    EXPECT_EQ(ReadJournal(grown.folder.Journal()), grown.Expected()) << call;
    grown.journal.Append(grown.document);
    EXPECT_EQ(ReadJournal(grown.folder.Journal()).document, grown.document) << call;
  }
}

/// Acts as a planner until it is killed, and says so at each action that is safe.
[[noreturn]] void ActAndTell(const fs::path& file, RandomActions planner, int pipe) noexcept
{
  PlanJournal journal(file, planner.Now());
  for (int n = 0; n < 100'000; ++n)
  {
    if (write(pipe, "", 1) != 1)
      _exit(3);
    if (n % 4 == 3)
      journal.Begin(planner.Now()); // as after a save
    journal.Append(planner.Next());
  }
  _exit(4);
}

TEST(PlanJournalCrashes, WhateverTheMomentOfAKillNoActionThatWasSafeIsLost)
{
  std::mt19937 random(1);
  int unsafe = 0;
  for (unsigned seed = 0; seed < 50; ++seed)
  {
    const JournalFolder folder;
    RandomActions planner(seed);
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    if (child == 0)
      ActAndTell(folder.Journal(), planner, ends[1]);
    close(ends[1]);
    char told = 0;
    ASSERT_EQ(read(ends[0], &told, 1), 1); // the journal is there
    const std::size_t least = random() % 8;
    std::size_t safe = 0;
    while (safe < least && read(ends[0], &told, 1) == 1)
      ++safe;
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 5000)); // an action or so
    kill(child, SIGKILL);
    while (read(ends[0], &told, 1) == 1)
      ++safe;
    close(ends[0]);
    waitpid(child, nullptr, 0);
    const RecoveredPlan found = ReadJournal(folder.Journal());
    EXPECT_FALSE(JournalInUse(folder.Journal()));
    EXPECT_FALSE(found.damaged);
    RandomActions again = planner;
    for (std::size_t n = 0; n < safe; ++n)
      again.Next();
    const PlanDocument atLeast = again.Now();
    ASSERT_TRUE(found.document == atLeast || found.document == again.Next()) << seed;
    unsafe += found.document != atLeast;
  }
  RecordProperty("kills between the write and the word of it", unsafe);
}

} // namespace
