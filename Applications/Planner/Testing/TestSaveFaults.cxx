// A plan that is saved while anything fails: on disk is the old plan or the new one, whole.
#include "Model/PlanSession.h"
#include "Model/WorkFolder.h"
#include "PlanFixture.h"
#include "SystemCallFaults.h"

#include <QStringList>

#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <memory>
#include <vector>

namespace
{
using namespace hasp;
using faults::Way;
namespace fs = std::filesystem;

/// A plan with blobs in a folder, opened and changed: a volume more, and a part with its bytes.
class Work
{
public:
  explicit Work(const PlanFolder& folder) : Root(folder.Plan().parent_path()) {}

  fs::path Own() const { return this->Root / "work"; }
  fs::path Plan() const { return this->Root / "case.hasp"; }

  /// The plan on disk, before.
  PlanDocument MakeOld() const
  {
    fs::create_directory(this->Own());
    fs::create_directory(this->Plan());
    PlanDocument document;
    PlanSegmentation labels{ 2, "", 1, "", {} };
    labels.labels = WriteBlob(this->Plan(), "old labels");
    document.history.Do({ AddObject<PlanVolume>{ { 1, "head", std::string(64, 'a') } },
      AddObject<PlanSegmentation>{ labels } });
    SavePlan(this->Plan(), document);
    return document;
  }
  void Begin(bool open)
  {
    this->Session = std::make_unique<PlanSession>(this->Own());
    QObject::connect(this->Session.get(), &PlanSession::Refused,
      [this](const QString& text) { this->Faults.append(text); });
    if (open)
      this->Session->Open(this->Plan());
    this->Session->Do(
      AddObject<PlanVolume>{ { this->Session->NewId(), "other", std::string(64, 'b') } });
    const PlanSegmentation labels{ this->Session->NewId(), "",
      this->Session->Now().volumes.back().id, this->Session->StoreBlob(std::string(5000, 'n')),
      {} };
    this->Session->Do(AddObject<PlanSegmentation>{ labels });
  }
  /// Bit 0: the save under failure told a fault; bit 1: it said that it is saved; bit 2: the second
  /// save, without one, is not saved.
  int Say(bool saved)
  {
    const int told = this->Faults.size() == 1 ? 1 : 0;
    this->Faults.clear();
    const bool again =
      this->Session->HasPlace() ? this->Session->Save() : this->Session->SaveAs(this->Plan());
    const bool whole =
      again && !this->Session->IsModified() && LoadPlan(this->Plan()) == this->Session->Document();
    return told | (saved ? 2 : 0) | (whole ? 0 : 4);
  }
  PlanSession& Of() { return *this->Session; }

private:
  fs::path Root;
  std::unique_ptr<PlanSession> Session;
  QStringList Faults;
};

struct Outcomes
{
  int calls = 0, olds = 0, news = 0, refused = 0;
};

/// What a save did, whose call failed, to a plan `old`, or to a folder that was not there.
void Judge(const Work& work, const PlanDocument& old, bool open, const faults::Run& run, int call,
  Outcomes& outcomes)
{
  SCOPED_TRACE("call " + std::to_string(call));
  if (!run.killed)
  {
    EXPECT_TRUE(run.status == 1 || run.status == 2) << run.status;
    outcomes.refused += run.status == 1;
    return; // the second save has put it right, which the child has tried
  }
  if (!open && !fs::exists(work.Plan() / "plan.json"))
  {
    ++outcomes.olds;
    return;
  }
  EXPECT_EQ(PlanFaults(work.Plan()), std::vector<std::string>{});
  const bool isOld = open && LoadPlan(work.Plan()) == old;
  ++(isOld ? outcomes.olds : outcomes.news);
  if (!isOld)
  {
    EXPECT_EQ(LoadPlan(work.Plan()).history.Current().volumes.size(), open ? 2U : 1U);
  }
}

/// The killed one's work is brought back, all of it, and can be saved.
void BringBack(const Work& work, bool open)
{
  const fs::path fresh = work.Own().parent_path() / "fresh";
  fs::create_directory(fresh);
  PlanSession session(fresh);
  ASSERT_TRUE(session.Recover(work.Own(), open ? work.Plan() : fs::path()));
  EXPECT_EQ(session.Now().segmentations.size(), open ? 2U : 1U);
  const fs::path other = work.Own().parent_path() / "other.hasp";
  ASSERT_TRUE(session.SaveAs(open ? work.Plan() : other));
  EXPECT_EQ(PlanFaults(open ? work.Plan() : other), std::vector<std::string>{});
}

Outcomes FailEachCall(bool open, Way way)
{
  Outcomes outcomes;
  for (int call = 1; !testing::Test::HasFailure(); ++call)
  {
    const PlanFolder folder;
    Work work(folder);
    PlanDocument old;
    if (open)
      old = work.MakeOld();
    else
      fs::create_directory(work.Own());
    bool saved = false;
    const faults::Run run = faults::InChild([&] { work.Begin(open); },
      [&] { saved = open ? work.Of().Save() : work.Of().SaveAs(work.Plan()); },
      [&] { return work.Say(saved); }, call, way);
    Judge(work, old, open, run, call, outcomes);
    if (run.killed)
      BringBack(work, open);
    if (run.calls < call)
      break;
    outcomes.calls = call;
  }
  return outcomes;
}

class SaveFaults : public testing::Test
{
protected:
  void SetUp() override
  {
    if (!faults::AreAllowed())
      GTEST_SKIP() << "processes may not be watched here";
  }
};

TEST_F(SaveFaults, AnErrorOfAnyCallIsToldAndTheNextSaveIsWhole)
{
  for (const bool open : { true, false })
  {
    const Outcomes outcomes = FailEachCall(open, Way::Error);
    EXPECT_GT(outcomes.calls, 40);
    EXPECT_GT(outcomes.refused, 20);
    std::cout << "save " << (open ? "again" : "anew") << ": " << outcomes.calls << " calls failed, "
              << outcomes.refused << " told\n";
  }
}

TEST_F(SaveFaults, ADiskThatIsFullFromAnyCallOnIsToldAndTheNextSaveIsWhole)
{
  for (const bool open : { true, false })
    EXPECT_GT(FailEachCall(open, Way::Full).refused, 20);
}

TEST_F(SaveFaults, AKillAtAnyCallLeavesTheOldPlanOrTheNewOneAndTheWork)
{
  for (const bool open : { true, false })
  {
    const Outcomes outcomes = FailEachCall(open, Way::Kill);
    EXPECT_GT(outcomes.olds, 20);
    EXPECT_GT(outcomes.news, 5);
  }
}

/// What a save says, tried in a child process that `spoil` has made poorer.
int SaveInChild(const PlanFolder& folder, const std::function<void()>& spoil, PlanDocument& old)
{
  Work work(folder);
  old = work.MakeOld();
  bool saved = false;
  return faults::InChild(
    [&]
    {
      work.Begin(true);
      spoil();
    },
    [&] { saved = work.Of().Save(); }, [&] { return saved ? 2 : 1; }, 0, Way::Error)
    .status;
}

TEST_F(SaveFaults, ADiskThatTakesNoMoreLeavesTheOldPlan)
{
  const PlanFolder folder;
  PlanDocument old;
  const int said = SaveInChild(
    folder,
    []
    {
      std::signal(SIGXFSZ, SIG_IGN);
      const rlimit limit{ 3000, 3000 }; // the system's own refusal, within the blob
      setrlimit(RLIMIT_FSIZE, &limit);
    },
    old);
  EXPECT_EQ(said, 1);
  EXPECT_EQ(LoadPlan(Work(folder).Plan()), old);
}

TEST_F(SaveFaults, AFolderThatMayOnlyBeReadKeepsItsPlan)
{
  const PlanFolder folder;
  PlanDocument old;
  const int said = SaveInChild(
    folder,
    [&]
    {
      chmod(Work(folder).Plan().c_str(), 0555);
      if (geteuid() == 0 && (setgid(65534) != 0 || setuid(65534) != 0)) // who may do anything
        throw std::runtime_error("nobody else can be had");
    },
    old);
  EXPECT_EQ(said, 1);
  EXPECT_EQ(LoadPlan(Work(folder).Plan()), old);
  chmod(Work(folder).Plan().c_str(), 0755);
}

} // namespace
