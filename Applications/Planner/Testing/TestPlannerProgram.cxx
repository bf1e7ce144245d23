// bin/hasp-planner as a program: how it starts, rests and ends, and what it leaves alone.
#include "PlannerDesk.h"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace
{
namespace fs = std::filesystem;

/// Numbers of the sockets of the Internet's kind that the process has open.
std::set<std::string> InternetSockets(pid_t process)
{
  std::set<std::string> open, found;
  const fs::path own = "/proc/" + std::to_string(process);
  for (const fs::directory_entry& entry : fs::directory_iterator(own / "fd"))
  {
    std::error_code gone;
    const std::string what = fs::read_symlink(entry.path(), gone).string();
    if (what.starts_with("socket:["))
      open.insert(what.substr(8, what.size() - 9));
  }
  for (const char* kind : { "tcp", "tcp6", "udp", "udp6", "raw", "raw6" })
  {
    std::ifstream table(own / "net" / kind);
    std::string line;
    while (std::getline(table, line))
    {
      std::istringstream words(line);
      for (std::string word; words >> word;)
        if (open.contains(word))
          found.insert(word);
    }
  }
  return found;
}

using PlannerProgram = PlannerDesk;

TEST_F(PlannerProgram, RestsWithoutAFrameAndWithoutASocket)
{
  const auto planner = this->Open();
  planner->WaitSettled();
  const long long before = planner->State("frames");
  EXPECT_TRUE(InternetSockets(planner->Process()).empty());
  const timespec span{ 2, 0 }; // nothing happens: that is what is tried
  nanosleep(&span, nullptr);
  EXPECT_EQ(planner->State("frames"), before);
}

/// What judges sessions (OfflinePlanner.cxx) judges: a socket that the user asks for would end one.
TEST_F(PlannerProgram, EndsWhereASocketIsOpenedThatNoSessionMayHave)
{
  if (!HASP_OFFLINE)
    GTEST_SKIP() << "sockets cannot be forbidden on this system";
  const auto planner = this->Open();
  planner->Menu({ "menu.view", "view.stereo.settings" });
  planner->Choose("stereo.head", 2); // opentrack, on a port
  EXPECT_EQ(planner->ClickToEnd("stereo.ok"), 128 + SIGSYS);
}

TEST_F(PlannerProgram, EachStepSaysWhatItStillNeedsAndNoneIsShut)
{
  const auto planner = this->Open();
  for (const char* step :
    { "split", "reduce", "cut", "guide", "plate", "check", "export", "import" })
  {
    planner->Click(std::string("step.") + step);
    EXPECT_EQ(planner->State("step"), step);
  }
}

TEST_F(PlannerProgram, QuestionMarkListsTheKeys)
{
  const auto planner = this->Open();
  planner->Key("question");
  EXPECT_TRUE(planner->Has("page.keys"));
}

TEST_F(PlannerProgram, KeysOfVTKThatQuitDoNot)
{
  const auto planner = this->Open();
  planner->ClickAt("view.scene", 0.5, 0.5);
  planner->Key("e");
  planner->Key("q");
  EXPECT_TRUE(planner->IsRunning());
  EXPECT_TRUE(planner->Has("view.scene"));
}

TEST_F(PlannerProgram, AsksBeforeWhatIsNotSavedGoes)
{
  const auto planner = this->Open();
  planner->SetText("import.case", "K-17");
  planner->CloseWindow();
  planner->Click("question.save.cancel"); // when it is asked
  EXPECT_TRUE(planner->IsRunning());
  planner->CloseWindow();
  EXPECT_EQ(planner->ClickToEnd("question.save.discard"), 0);
}

} // namespace
