#include "PartsDesk.h"

#include "Planning/PlanEditsFile.h"
#include "Planning/PlanLists.h"

#include <QtTest>

using namespace hasp;

namespace
{
constexpr int MostWaitMs = 300'000; // of parts that are made while others build
}

PlannerParts::PlannerParts()
{
  const HaspRun phantom = RunHasp({ "phantom", "--spacing", "1,1,1", "--output", this->Scan() });
  EXPECT_EQ(phantom.exitCode, 0) << phantom.err;
  std::filesystem::create_directories(this->PathOf("work"));
  this->views = std::make_unique<ViewGrid>();
  this->planner =
    std::make_unique<Planner>(PlannerFolders{ this->PathOf("state"), this->PathOf("plans") },
      this->PathOf("work"), *this->views);
  QObject::connect(this->planner.get(), &Planner::Said,
    [this](const QString& text, bool fault) { (fault ? this->faults : this->said) << text; });
  this->planner->scans.Put(ScanShelf::Read(this->Scan(), {}, {}));
  EXPECT_TRUE(this->planner->plan.Do(ParseEdits(ReadBytes(HASP_PLAN_EDITS))));
  this->Finish(); // what the scene makes of it
}

PlannerParts::~PlannerParts()
{
  this->planner.reset();
  this->views.reset();
}

void PlannerParts::Finish()
{
  EXPECT_TRUE(QTest::qWaitFor([this] { return this->planner->jobs.IsIdle(); }, MostWaitMs));
  QCoreApplication::processEvents();
}

void PlannerParts::MoveCut(double mm)
{
  PlanCut cut = *FindPlanObject<PlanCut>(this->planner->plan.Now(), 3);
  cut.blade.point += mm * cut.blade.normal;
  this->Do(ChangeObject<PlanCut>{ cut });
}

void PlannerParts::SpoilGuide()
{
  PlanGuide guide = *FindPlanObject<PlanGuide>(this->planner->plan.Now(), 8);
  GuideHole wide;
  wide.point = guide.recipe.landmarks.at(3); // between the cuts
  wide.axis = guide.recipe.withdrawal;
  wide.diameterMm = guide.recipe.widthMm - 1.0; // walls of 0.5 mm beside it: 0.6 is the least
  wide.depthMm = 20.0;
  wide.sleeveHeightMm = 0.0;
  guide.recipe.holes.push_back(wide);
  this->Do(ChangeObject<PlanGuide>{ guide });
}

std::map<std::string, std::string> PlannerParts::Files(const std::string& folder) const
{
  std::map<std::string, std::string> files;
  for (const auto& file : std::filesystem::directory_iterator(this->PathOf(folder)))
    files[file.path().filename().string()] = ReadBytes(file.path().string());
  return files;
}
