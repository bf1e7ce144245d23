// Parts that the planner makes, keeps and writes: those of `hasp run`, and nothing that is out of
// date.
#include "PartsDesk.h"

#include "Output/PartExport.h"
#include "Output/PartFacts.h"
#include "Output/PartMaking.h"
#include "Output/RedParts.h"

#include "Planning/PlanLists.h"
#include "vtkHaspPrintableText.h"

#include <QSignalSpy>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <utility>

using namespace hasp;
namespace fs = std::filesystem;

namespace
{

TEST_F(PlannerParts, WhatCannotBeMadeIsSaidAndChangesNothing)
{
  MakePart(*this->planner, 3); // a cut
  ASSERT_EQ(this->faults.size(), 1);
  EXPECT_TRUE(this->faults.back().contains("cut 3"));
  this->planner->scans.KeepOnly({}); // its scan is not in memory
  MakePart(*this->planner, 8);
  ASSERT_EQ(this->faults.size(), 2);
  EXPECT_TRUE(this->faults.back().contains("guide 8 cannot be made: its scan, volume 1"));
  MakeAll(*this->planner);
  EXPECT_EQ(this->faults.size(), 3);
  this->Finish();
  EXPECT_TRUE(this->planner->plan.Document().parts.empty());
  EXPECT_FALSE(ExportPart(*this->planner, 8, this->PathOf("guide.stl")));
  EXPECT_FALSE(ExportAll(*this->planner, this->PathOf("all"), "stl"));
  this->Finish();
  EXPECT_FALSE(fs::exists(this->PathOf("guide.stl")));
  EXPECT_FALSE(fs::exists(this->PathOf("all")));
  for (const QString& text : this->faults) // the folder's name is a canary
    EXPECT_FALSE(text.contains(QString::fromStdString(this->folder.filename().string())));
}

TEST_F(PlannerParts, AWorkThatIsGivenUpLeavesThePlanAsItWas)
{
  const PlanDocument before = this->planner->plan.Document();
  const QSignalSpy gaveUp(&this->planner->jobs, &JobQueue::GaveUp);
  QObject::connect(&this->planner->jobs, &JobQueue::Progressed, this->planner.get(),
    [this] { this->planner->jobs.CancelAll(); });
  MakeAll(*this->planner);
  this->Finish();
  EXPECT_EQ(gaveUp.size(), 1); // the others had not begun
  EXPECT_EQ(this->planner->plan.Document(), before);
  EXPECT_TRUE(this->faults.isEmpty()) << this->faults.join('\n').toStdString();
}

TEST_F(PlannerParts, HaveTheBytesThatHaspRunWrites)
{
  MakeAll(*this->planner);
  this->Finish();
  EXPECT_TRUE(this->faults.isEmpty()) << this->faults.join('\n').toStdString();
  for (const PlanId object : PartObjects(this->Now()))
  {
    const PartFacts facts = FactsOf(*this->planner, object);
    EXPECT_EQ(facts.state, PartState::InDate) << facts.called.toStdString();
    EXPECT_EQ(facts.verdict, object < 8 ? FitVerdict::NotCertified : FitVerdict::Green)
      << facts.called.toStdString() << ": " << facts.faults.join("; ").toStdString();
    EXPECT_EQ(facts.certificate.has_value(), object >= 8);
  }
  ASSERT_TRUE(ExportAll(*this->planner, this->PathOf("planner"), "stl"));
  this->Finish();
  ASSERT_TRUE(this->planner->plan.SaveAs(this->PathOf("case.hasp")));
  const HaspRun run = RunHasp({ "run", this->Path("case.hasp"), "--volume", this->Scan(),
    "--rebuild", "--output", this->Path("hasp") });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const auto ours = this->Files("planner"), theirs = this->Files("hasp");
  ASSERT_EQ(ours.size(), theirs.size());
  for (const auto& [name, bytes] : theirs)
  {
    ASSERT_TRUE(ours.contains(name)) << name;
    const auto at =
      std::mismatch(bytes.begin(), bytes.end(), ours.at(name).begin(), ours.at(name).end()).first -
      bytes.begin();
    EXPECT_TRUE(ours.at(name) == bytes)
      << name << " from byte " << at << " on: " << PrintableText(bytes.substr(std::size_t(at), 60));
  }
  EXPECT_TRUE(ours.contains("guide-8.json"));
  EXPECT_TRUE(ours.contains("run.json"));
}

TEST_F(PlannerParts, LeaveThePlannerInDateAlone)
{
  const auto file = [this](const char* name) { return this->PathOf(name); };
  MakePart(*this->planner, 8);
  this->Finish();
  ASSERT_TRUE(ExportPart(*this->planner, 8, file("first.stl")));
  this->Finish();
  const std::string first = ReadBytes(this->Path("first.stl"));
  EXPECT_EQ(first.size() % 50, 84U % 50); // a whole .stl
  EXPECT_FALSE(ExportPart(*this->planner, 8, file("none/first.stl")));
  EXPECT_EQ(this->faults.back(), "Nothing is written: its folder does not exist; make it first");
  this->MoveCut(1.0);
  EXPECT_EQ(FactsOf(*this->planner, 8).state, PartState::OutOfDate);
  EXPECT_EQ(
    WhyNotExported(FactsOf(*this->planner, 8)), "guide 8 is out of date: cut 3 has changed");
  EXPECT_FALSE(ExportPart(*this->planner, 8, file("moved.stl")));
  EXPECT_TRUE(this->faults.back().contains("guide 8 is out of date: cut 3 has changed"));
  EXPECT_TRUE(WhyNotAll(*this->planner).contains("guide 8 is out of date"));
  this->Finish();
  EXPECT_FALSE(fs::exists(file("moved.stl")));
  MakePart(*this->planner, 8);
  this->Finish();
  ASSERT_TRUE(ExportPart(*this->planner, 8, file("moved.stl")));
  this->Finish();
  EXPECT_TRUE(ReadBytes(this->Path("moved.stl")) != first);
  this->planner->plan.Undo(); // what was made before is in date again
  ASSERT_TRUE(ExportPart(*this->planner, 8, file("undone.stl")));
  this->Finish();
  EXPECT_TRUE(ReadBytes(this->Path("undone.stl")) == first);
  for (const char* ending : { "ply", "obj" }) // read back and compared by the job itself
  {
    ASSERT_TRUE(ExportPart(*this->planner, 8, this->PathOf(std::string("part.") + ending)));
    this->Finish();
    EXPECT_GT(fs::file_size(this->PathOf(std::string("part.") + ending)), 10'000U);
  }
}

TEST_F(PlannerParts, MadeOfAPlanThatHasChangedMeanwhileAreKeptOutOfDate)
{
  bool moved = false;
  QObject::connect(&this->planner->jobs, &JobQueue::Progressed, this->planner.get(),
    [&]
    {
      if (!std::exchange(moved, true))
        this->MoveCut(1.0);
    });
  MakePart(*this->planner, 8);
  this->Finish();
  ASSERT_TRUE(moved);
  EXPECT_EQ(FactsOf(*this->planner, 8).state, PartState::OutOfDate);
  this->planner->plan.Undo();
  EXPECT_EQ(FactsOf(*this->planner, 8).state, PartState::InDate);
}

TEST_F(PlannerParts, ThatDoNotHoldAreNotKeptAndSayWhereAndWhy)
{
  this->SpoilGuide();
  MakePart(*this->planner, 8);
  this->Finish();
  ASSERT_FALSE(this->faults.isEmpty());
  EXPECT_TRUE(this->faults.back().contains("guide 8 does not hold and is not kept"));
  EXPECT_TRUE(this->planner->plan.Document().parts.empty());
  const PartFacts facts = FactsOf(*this->planner, 8);
  EXPECT_EQ(facts.state, PartState::DoesNotHold);
  EXPECT_EQ(facts.verdict, FitVerdict::Red);
  ASSERT_TRUE(facts.certificate);
  ASSERT_FALSE(facts.certificate->faults.empty());
  const FitFault& fault = facts.certificate->faults.front();
  ASSERT_TRUE(fault.at);
  const glm::dvec3 hole =
    FindPlanObject<PlanGuide>(this->planner->plan.Now(), 8)->recipe.holes.back().point;
  EXPECT_LT(glm::distance(*fault.at, hole), 15.0); // the hole is 13 mm wide in a wall of 3 mm
  EXPECT_FALSE(ExportPart(*this->planner, 8, this->PathOf("red.stl")));
  this->planner->plan.Undo();
  EXPECT_EQ(FactsOf(*this->planner, 8).state, PartState::NotMade);
  this->planner->plan.Redo(); // and it is known again
  EXPECT_EQ(FactsOf(*this->planner, 8).state, PartState::DoesNotHold);
}

} // namespace
