// The program is killed at any moment: at most the action that was under way is lost.
#include "CrashDesk.h"

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <set>
#include <vector>

namespace
{
namespace fs = std::filesystem;

/// One action of the user's: another case label, or one taken back.
void Act(PlannerProcess& planner, std::mt19937& dice, int number)
{
  if (number > 2 && dice() % 4 == 0)
    planner.Key(dice() % 2 == 0 ? "ctrl+z" : "ctrl+y");
  else
    planner.SetText("import.case", "K-" + std::to_string(number));
}

/// Sends another case label and does not wait for what comes of it.
void SendLabel(PlannerProcess& planner, const std::string& label)
{
  planner.Click("import.case");
  planner.Hand().Key("ctrl+a");
  planner.Hand().Type(label);
  planner.Hand().Key("Return");
}

/// Waits until something changes in a folder.
class FolderWatch
{
public:
  explicit FolderWatch(const fs::path& folder) : Events(inotify_init1(IN_CLOEXEC))
  {
    inotify_add_watch(this->Events, folder.c_str(), IN_CREATE | IN_MODIFY | IN_MOVED_TO);
  }
  ~FolderWatch() { close(this->Events); }
  FolderWatch(const FolderWatch&) = delete;
  void operator=(const FolderWatch&) = delete;

  bool Wait(double mostS) const
  {
    pollfd event{ this->Events, POLLIN, 0 };
    return poll(&event, 1, int(1000.0 * mostS)) == 1;
  }

private:
  int Events;
};

class PlannerCrash : public CrashDesk
{
protected:
  /// Starts it again; how long it took until it asked.
  std::unique_ptr<PlannerProcess> Restart()
  {
    const auto start = std::chrono::steady_clock::now();
    auto planner = this->Open();
    const bool asked = planner->Has("recover.bring");
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    if (asked)
      this->askedS.push_back(took.count());
    return planner;
  }
  void TearDown() override
  {
    if (this->askedS.empty())
      return;
    std::sort(this->askedS.begin(), this->askedS.end());
    std::printf("asked after %zu of %d kills; from its start to the question: median %.2f s, at "
                "most %.2f s\n",
      this->askedS.size(), Kills(), this->askedS[this->askedS.size() / 2], this->askedS.back());
  }
  std::mt19937 dice{ 12 };
  std::vector<double> askedS;
};

TEST_F(PlannerCrash, LosesAtMostTheActionUnderWayAndOffersTheRest)
{
  constexpr int MostMs = 60;
  std::set<std::string> allowed; // plans that may come back
  int number = 0;
  for (int kill = 0; kill < Kills(); ++kill)
  {
    const auto planner = this->Restart();
    ASSERT_EQ(BringBack(*planner), kill > 0) << "kill " << kill;
    ASSERT_TRUE(kill == 0 || allowed.contains(planner->State("plan"))) << "kill " << kill;
    const int actions = 1 + int(this->dice() % 3);
    for (int n = 0; n < actions; ++n)
      Act(*planner, this->dice, ++number);
    allowed = { planner->State("plan") };
    const std::string last = "L-" + std::to_string(++number);
    SendLabel(*planner, last);
    KillSoon(*planner, this->dice, MostMs);
    allowed.insert(PlanWith(last));
  }
  EXPECT_EQ(int(this->askedS.size()), Kills() - 1);
}

/// Each round: what came back is saved, an action is done, and the program is killed while it saves
/// that.
TEST_F(PlannerCrash, APlanThatWasBeingSavedIsTheOldOneOrTheNewOneAndWhole)
{
  constexpr int MostMs = 6;
  fs::path place;
  std::string before, after; // case labels: on disk, and of the save under way
  int old = 0;
  for (int kill = 0; kill < Kills(); ++kill)
  {
    const auto planner = this->Restart();
    const std::string found = place.empty() ? std::string() : LabelIn(place);
    if (BringBack(*planner))
      ASSERT_EQ(planner->State("plan"), PlanWith(after)) << "kill " << kill;
    else if (kill > 0) // it was saved, and nothing of it is lost
    {
      ASSERT_EQ(found, after) << "kill " << kill;
      planner->SetText("import.case", "M-" + std::to_string(kill));
    }
    old += kill > 0 && found == before;
    const fs::path another = this->Plans() / ("plan-" + std::to_string(kill) + ".hasp");
    if (Save(*planner, another))
      place = another;
    before = LabelIn(place);
    after = "K-" + std::to_string(kill);
    planner->SetText("import.case", after);
    const FolderWatch watch(place);
    planner->Hand().Key("ctrl+s");
    ASSERT_TRUE(watch.Wait(planner->patienceS)) << "kill " << kill << ": nothing is saved";
    KillSoon(*planner, this->dice, MostMs);
    ASSERT_EQ(hasp::PlanFaults(place), std::vector<std::string>()) << "kill " << kill;
    const std::string now = LabelIn(place);
    ASSERT_TRUE(now == before || now == after) << "kill " << kill << ": " << now;
  }
  std::printf("the old plan was there after %d of %d kills\n", old, Kills());
}

} // namespace
