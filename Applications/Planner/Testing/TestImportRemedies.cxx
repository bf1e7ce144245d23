// What can be done about a scan that was refused.
#include "ImportDesk.h"

#include "Steps/ImportRemedies.h"

#include <QComboBox>

#include <gtest/gtest.h>

using namespace hasp;
using namespace hasp::testing;

namespace
{

/// What was refused is of the case before.
TEST(ImportRemedies, ANewPlanHasNoneOfTheOldOne)
{
  const CanaryFolder folder;
  ImportDesk desk(folder);
  auto& remedies = *desk.panel.findChild<ImportRemedies*>();
  Passport several;
  several.seriesFound = 3;
  several.faults = { { FaultKind::MixedSeries, "the folder holds 3 series" } };
  remedies.Offer(several);
  desk.planner.plan.BeginNew();
  EXPECT_TRUE(remedies.isHidden());
}

TEST(ImportRemedies, AreWhatFaultsAskFor)
{
  ImportRemedies remedies;
  Passport several;
  several.seriesFound = 3;
  several.faults = { { FaultKind::MixedSeries, "the folder holds 3 series" } };
  remedies.Offer(several);
  EXPECT_FALSE(remedies.isHidden());
  StepsOneDesk::Find<QComboBox>(remedies, "import.series").setCurrentIndex(1);
  EXPECT_EQ(remedies.Settings().series, 2);
  EXPECT_FALSE(remedies.Settings().resample);
  Passport tilted;
  tilted.seriesFound = 3;
  tilted.faults = { { FaultKind::GantryTilt, "is tilted" } };
  tilted.faults[0].resamplable = true;
  remedies.Offer(tilted);
  EXPECT_EQ(remedies.Settings().series, 2); // the same series, mended
  EXPECT_TRUE(remedies.Settings().resample);
  remedies.Withdraw();
  EXPECT_TRUE(remedies.isHidden());
  EXPECT_EQ(remedies.Settings().series, 0);
  EXPECT_FALSE(remedies.Settings().resample);
}

} // namespace
