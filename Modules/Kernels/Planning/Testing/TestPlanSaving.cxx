#include "FailingCalls.h"
#include "InChild.h"
#include "PlanFixture.h"
#include "Planning/PlanFile.h"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <algorithm>
#include <csignal>

namespace
{
using namespace hasp;
namespace fs = std::filesystem;

std::size_t FilesIn(const fs::path& folder)
{
  return std::size_t(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(PlanSaving, BytesAreOnDiskBeforeTheNameIsTheirs)
{
  const PlanFolder folder;
  SavePlan(folder.Plan(), {});
  failing::Arm(0, failing::Way::Error);
  SavePlan(folder.Plan(), {});
  EXPECT_EQ(failing::Disarm(), "mkdir open write fsync close rename open fsync close ");
}

TEST(PlanSaving, ACrashAtAnyCallLeavesTheOldPlanOrTheNewOne)
{
  const PlanDocument before = RandomDocument(1, 5), after = RandomDocument(2, 9);
  int olds = 0, news = 0, call = 1;
  for (int status = -1; status != 0; ++call)
  {
    const PlanFolder folder;
    SavePlan(folder.Plan(), before);
    status = InChild(
      [&]
      {
        failing::Arm(call, failing::Way::Crash);
        SavePlan(folder.Plan(), after);
      });
    ASSERT_TRUE(status == 0 || status == 99) << status;
    const PlanDocument found = LoadPlan(folder.Plan());
    ASSERT_TRUE(found == before || found == after) << "crash at call " << call;
    ++(found == before ? olds : news);
    SavePlan(folder.Plan(), after); // what the crash left is in no one's way
    RemoveUnusedBlobs(folder.Plan(), after);
    EXPECT_EQ(FilesIn(folder.Plan()), 1U);
  }
  EXPECT_EQ(olds, 6); // up to the renaming
  EXPECT_EQ(news, 4); // open, fsync and close of the folder; no crash
}

TEST(PlanSaving, AnErrorAtAnyCallIsToldAndLeavesNoHalfFile)
{
  const PlanDocument before = RandomDocument(1, 5), after = RandomDocument(2, 9);
  bool fails = true;
  for (int call = 1; fails; ++call)
  {
    const PlanFolder folder;
    SavePlan(folder.Plan(), before);
    failing::Arm(call, failing::Way::Error);
    const std::string error = Thrown([&] { SavePlan(folder.Plan(), after); });
    const std::string calls = failing::Disarm();
    fails = std::count(calls.begin(), calls.end(), ' ') >= call;
    const PlanDocument found = LoadPlan(folder.Plan());
    const bool told = error.find("No space left on device") != std::string::npos;
    // The folder's own close tells nothing more: it is synced by then.
    EXPECT_TRUE(told || found == after) << "call " << call << ": " << error;
    EXPECT_TRUE(found == after || error.find("cannot be") != std::string::npos) << error;
    EXPECT_EQ(FilesIn(folder.Plan()), 1U) << "call " << call;
  }
}

TEST(PlanSaving, ABlobIsWholeOrNotThere)
{
  const std::string bytes(10'000, 'x');
  bool fails = true;
  for (int call = 1; fails; ++call)
  {
    const PlanFolder folder;
    SavePlan(folder.Plan(), {});
    const int status = InChild(
      [&]
      {
        failing::Arm(call, failing::Way::Crash);
        WriteBlob(folder.Plan(), bytes);
      });
    fails = status != 0;
    if (fs::is_directory(folder.Plan() / "blobs"))
      for (const auto& entry : fs::directory_iterator(folder.Plan() / "blobs"))
        if (const std::string name = entry.path().filename().string(); name.size() == 64)
        {
          EXPECT_EQ(ReadBlob(folder.Plan(), name), bytes) << "crash at call " << call;
        }
    EXPECT_EQ(LoadPlan(folder.Plan()), PlanDocument{});
    EXPECT_EQ(ReadBlob(folder.Plan(), WriteBlob(folder.Plan(), bytes)), bytes);
  }
}

TEST(PlanSaving, AFileThatTheSystemDoesNotTakeLeavesTheOldPlan)
{
  const PlanFolder folder;
  const PlanDocument before = RandomDocument(1, 5);
  SavePlan(folder.Plan(), before);
  const int status = InChild(
    [&]
    {
      std::signal(SIGXFSZ, SIG_IGN);
      const rlimit limit{ 1000, 1000 }; // the system's own refusal, in the middle of the file
      setrlimit(RLIMIT_FSIZE, &limit);
      SavePlan(folder.Plan(), RandomDocument(2, 9));
    });
  EXPECT_EQ(status, 1);
  EXPECT_EQ(LoadPlan(folder.Plan()), before);
  EXPECT_EQ(FilesIn(folder.Plan()), 1U);
}

} // namespace
