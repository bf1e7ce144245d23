#include "JournalFixture.h"

#include <gtest/gtest.h>

#include <csignal>

namespace
{
using namespace hasp;
namespace fs = std::filesystem;

/// A sound journal: of this document, after so many actions.
RecoveredPlan Sound(const PlanDocument& document, std::size_t actions)
{
  return { document, actions, false, false };
}

TEST(PlanJournal, ReadsBackExactlyAfterEachAction)
{
  for (unsigned seed = 0; seed < 8; ++seed)
  {
    const JournalFolder folder;
    RandomActions planner(seed);
    PlanJournal journal(folder.Journal(), planner.Now());
    ASSERT_EQ(ReadJournal(folder.Journal()), Sound(planner.Now(), 0));
    for (std::size_t n = 1; n <= 40; ++n)
    {
      journal.Append(planner.Next());
      ASSERT_EQ(ReadJournal(folder.Journal()), Sound(planner.Now(), n)) << seed;
    }
  }
}

TEST(PlanJournal, TakesManyActionsInOneCall)
{
  for (unsigned seed = 0; seed < 12; ++seed)
  {
    const JournalFolder folder;
    RandomActions planner(seed);
    RandomEdits random(seed);
    PlanJournal journal(folder.Journal(), planner.Now());
    for (std::size_t n = 1; n <= 15; ++n)
    {
      for (int more = random.Below(12); more >= 0; --more)
        planner.Next();
      journal.Append(planner.Now());
      ASSERT_EQ(ReadJournal(folder.Journal()).document, planner.Now()) << seed;
    }
  }
}

TEST(PlanJournal, SeesWhatWasUndoneAndDoneOtherwise)
{
  const JournalFolder folder;
  PlanDocument document = ToPaint();
  document.history.Do(RenameObject{ 1, "a" });
  document.history.Do(RenameObject{ 1, "b" });
  PlanJournal journal(folder.Journal(), document);
  document.history.Undo();
  document.history.Undo();
  document.history.Do(RenameObject{ 1, "c" });
  document.history.Do(RenameObject{ 1, "b" }); // as many steps, and the last one is the same
  journal.Append(document);
  EXPECT_EQ(ReadJournal(folder.Journal()), Sound(document, 1));
  document.history.Undo();
  document.history.Undo();
  document.history.Do(RenameObject{ 1, "c" }); // forgets a step, and adds none
  journal.Append(document);
  EXPECT_EQ(ReadJournal(folder.Journal()), Sound(document, 2));
}

TEST(PlanJournal, KeepsIdsThatOnlyForgottenStepsHad)
{
  const JournalFolder folder;
  PlanDocument document = ToPaint();
  PlanJournal journal(folder.Journal(), document);
  document.history.Do(AddObject<PlanVolume>{ { 3, "", std::string(64, 'b') } });
  document.history.Undo();
  document.history.Do(RenameObject{ 1, "a" });
  journal.Append(document);
  const PlanHistory found = ReadJournal(folder.Journal()).document.history;
  EXPECT_EQ(found.NewId(), 4U);
  EXPECT_EQ(found, document.history);
}

TEST(PlanJournal, WritesNothingIfNothingWasDone)
{
  const JournalFolder folder;
  RandomActions planner(3);
  PlanJournal journal(folder.Journal(), planner.Now());
  journal.Append(planner.Next());
  const std::string bytes = ReadBytes(folder.Journal());
  journal.Append(planner.Now());
  EXPECT_EQ(ReadBytes(folder.Journal()), bytes);
}

TEST(PlanJournal, AppendsNoMoreThanWhatIsNew)
{
  const JournalFolder folder;
  RandomEdits random(5);
  PlanDocument document{ PlanHistory(random.MakePlan(400)), {} };
  PlanJournal journal(folder.Journal(), document);
  const auto cost = [&](std::size_t actions)
  {
    const auto before = fs::file_size(folder.Journal());
    for (std::size_t n = 0; n < actions; ++n)
    {
      if (n % 4 == 2)
        document.history.Undo();
      else if (n % 4 == 3)
        document.history.Redo();
      else
        document.history.Do(RenameObject{ 1, n % 4 == 0 ? "Le Fort I" : "BSSO" });
      journal.Append(document);
    }
    return fs::file_size(folder.Journal()) - before;
  };
  const std::size_t first = cost(80);
  while (document.history.Steps().size() < 2000)
    document.history.Do(RenameObject{ 1, "genioplasty" });
  journal.Append(document);
  const std::size_t last = cost(80);
  EXPECT_LT(first, 80U * 150U);       // number, size, hash, four counts, a label and an edit
  EXPECT_LT(last, first + 80U * 10U); // numbers have more digits
  EXPECT_EQ(ReadJournal(folder.Journal()), Sound(document, 161));
}

TEST(PlanJournal, BeginsAnewBeforeItGrowsOutOfProportion)
{
  const JournalFolder folder;
  RandomEdits random(6);
  PlanDocument document = ToPaint();
  PlanJournal journal(folder.Journal(), document);
  std::size_t before = fs::file_size(folder.Journal()), begun = before, times = 0;
  for (std::size_t n = 1; n <= 60; ++n)
  {
    if (n % 2 == 0)
      document.history.Undo(); // so that what is kept does not grow
    else
      document.history.Do(Stroke(random, 1000));
    journal.Append(document);
    const std::size_t size = fs::file_size(folder.Journal());
    ASSERT_LE(size, 4 * begun + (1U << 20U));
    if (size < before)
    {
      begun = size;
      ++times;
      ASSERT_EQ(ReadJournal(folder.Journal()), Sound(document, n));
    }
    before = size;
  }
  EXPECT_GE(times, 1U);
  EXPECT_EQ(ReadJournal(folder.Journal()), Sound(document, 60));
}

TEST(PlanJournal, BeginsAnewForAnActionTooLargeForARecord)
{
  const JournalFolder folder;
  PlanDocument document{ {}, { { 1, PartFormat::Stl, {}, std::string(64, 'a'), "" } } };
  document.parts[0].inputs.resize(45'000, { 1, PartFacet::Shape, std::string(64, 'b') });
  PlanJournal journal(folder.Journal(), document);
  const auto before = fs::file_size(folder.Journal()); // it may grow to 4 times that
  document.parts[0].bytes[0] = 'c';                    // a record of all parts: above 4 MiB
  journal.Append(document);
  EXPECT_LT(fs::file_size(folder.Journal()), before + 1000);
  EXPECT_EQ(ReadJournal(folder.Journal()), Sound(document, 1));
}

TEST(PlanJournal, BeginsAnewWithAnotherPlan)
{
  const JournalFolder folder;
  PlanJournal journal(folder.Journal(), RandomDocument(1, 20));
  journal.Append(RandomDocument(2, 20));
  EXPECT_EQ(ReadJournal(folder.Journal()), Sound(RandomDocument(2, 20), 1));
  PlanDocument other{ PlanHistory(RandomDocument(2, 20).history.Start()), {} };
  journal.Append(other); // the same start, but ids of before would be given again
  EXPECT_EQ(ReadJournal(folder.Journal()), Sound(other, 2));
  journal.Begin(RandomDocument(3, 5));
  EXPECT_EQ(ReadJournal(folder.Journal()), Sound(RandomDocument(3, 5), 0));
}

TEST(PlanJournal, BeginsAnewWhenSomeoneTouchedTheFile)
{
  const JournalFolder folder;
  const fs::path aside = folder.Path() / "aside";
  RandomActions planner(4);
  PlanJournal journal(folder.Journal(), planner.Now());
  const std::function<void()> touches[] = { [&] { fs::remove(folder.Journal()); },
    [&] { fs::resize_file(folder.Journal(), fs::file_size(folder.Journal()) - 3); },
    [&] { std::ofstream(folder.Journal(), std::ios::app) << "Erika"; },
    [&] { fs::rename(folder.Journal(), aside); },
    [&]
    {
      fs::copy_file(folder.Journal(), aside, fs::copy_options::overwrite_existing);
      fs::rename(aside, folder.Journal());
    } };
  for (std::size_t n = 0; n < std::size(touches); ++n)
  {
    touches[n]();
    journal.Append(planner.Next());
    EXPECT_EQ(ReadJournal(folder.Journal()), Sound(planner.Now(), 2 * n + 1)) << n;
    journal.Append(planner.Next());
    EXPECT_EQ(ReadJournal(folder.Journal()), Sound(planner.Now(), 2 * n + 2)) << n;
  }
}

TEST(PlanJournal, TellsWhoIsInUseFromWhoCrashed)
{
  const JournalFolder folder;
  const PlanDocument document = RandomDocument(1, 5);
  EXPECT_FALSE(JournalInUse(folder.Journal()));
  {
    const PlanJournal journal(folder.Journal(), document);
    EXPECT_TRUE(JournalInUse(folder.Journal()));
    EXPECT_FALSE(JournalInUse(folder.Path() / "8.journal"));
    const std::string inUse = "it is in use by a planner that runs";
    EXPECT_EQ(Thrown([&] { PlanJournal(folder.Journal(), {}); }),
      "the journal cannot be written: " + inUse);
    EXPECT_EQ(
      Thrown([&] { RemoveJournal(folder.Journal()); }), "the journal cannot be removed: " + inUse);
    EXPECT_EQ(ReadJournal(folder.Journal()), Sound(document, 0));
    EXPECT_EQ(InChild(
                [&]
                {
                  if (!JournalInUse(folder.Journal()))
                    throw std::exception();
                  PlanJournal(folder.Journal(), {});
                }),
      1);
    EXPECT_TRUE(JournalInUse(folder.Journal())); // to ask took nothing from it
    const PlanLock lock(folder.Path());          // nor is it in the way of a plan's
  }
  EXPECT_FALSE(JournalInUse(folder.Journal()));
  EXPECT_EQ(InChild(
              [&]
              {
                const PlanJournal journal(folder.Journal(), document);
                raise(SIGKILL);
              }),
    -1);
  EXPECT_FALSE(JournalInUse(folder.Journal()));
  EXPECT_EQ(ReadJournal(folder.Journal()), Sound(document, 0));
  const PlanJournal journal(folder.Journal(), document); // goes on where that one was
}

TEST(PlanJournal, IsRemovedWithItsLock)
{
  const JournalFolder folder;
  {
    const PlanJournal journal(folder.Journal(), {});
  }
  RemoveJournal(folder.Journal());
  EXPECT_TRUE(fs::is_empty(folder.Path()));
  RemoveJournal(folder.Journal()); // nothing
  EXPECT_TRUE(fs::is_empty(folder.Path()));
  EXPECT_EQ(Thrown([&] { ReadJournal(folder.Journal()); }), "the journal is not there");
}

TEST(PlanJournal, IsReadInAFolderThatCannotBeWritten)
{
  const JournalFolder folder;
  const PlanDocument document = RandomDocument(1, 5);
  {
    const PlanJournal journal(folder.Journal(), document);
  }
  const std::string bytes = ReadBytes(folder.Journal());
  fs::permissions(folder.Path(), fs::perms(0555));
  EXPECT_EQ(InChild(
              [&]
              {
                if (geteuid() == 0 && seteuid(65534) != 0) // root may write anywhere
                  _exit(3);
                if (!(ReadJournal(folder.Journal()) == Sound(document, 0)) ||
                    JournalInUse(folder.Journal()))
                  _exit(4);
                for (const char* name : { "7.journal", "8.journal" })
                  if (Thrown([&] { PlanJournal(folder.Path() / name, {}); }) !=
                      "the journal cannot be written: Permission denied")
                    _exit(5);
              }),
    0);
  fs::permissions(folder.Path(), fs::perms(0755));
  EXPECT_EQ(ReadBytes(folder.Journal()), bytes);
}

TEST(PlanJournal, WhatCannotBeWrittenIsToldWithoutThePath)
{
  const JournalFolder folder;
  EXPECT_EQ(Thrown([&] { PlanJournal(folder.Path() / "no" / "folder", {}); }),
    "the journal cannot be written: No such file or directory");
  fs::create_directory(folder.Journal());
  EXPECT_EQ(Thrown([&] { PlanJournal(folder.Journal(), {}); }),
    "the journal cannot be written: Is a directory");
  EXPECT_EQ(Thrown([&] { ReadJournal(folder.Journal()); }), "the journal is not a file");
  EXPECT_FALSE(JournalInUse(folder.Journal()));
}

} // namespace
