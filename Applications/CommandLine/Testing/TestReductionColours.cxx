// What `hasp report reduction` says of colours that follow a fragment.
#include "ReductionColours.h"
#include "Testing/FilledReport.h"

#include <gtest/gtest.h>

TEST(ReductionColours, RowsTellTimeErrorAndARival)
{
  const hasp::Report report = hasp::testing::Filled("reduction", hasp::TryColours);
  const hasp::ReportRow& ms = hasp::testing::Row(report, "reduction.colours.ms");
  EXPECT_EQ(ms.n, 20);
  ASSERT_EQ(ms.bars.size(), 1U);
  EXPECT_EQ(*ms.bars[0].most, 50.0);
  EXPECT_NE(ms.data.find("200702 places"), std::string::npos) << ms.data;
  EXPECT_NE(ms.data.find("1 time sampled"), std::string::npos) << ms.data; // poses alone changed
  // A spacing is 60 mm / 160: a twentieth of it rms (vtkHaspSurfaceDistance.h), a quarter at most.
  const double rms = *hasp::testing::Row(report, "reduction.colours.rms").value;
  EXPECT_LT(rms, 0.02);
  EXPECT_GT(rms, 1e-6);
  EXPECT_LT(*hasp::testing::Row(report, "reduction.colours.max").value, 0.25 * 60.0 / 160.0);
  EXPECT_EQ(*ms.error, rms);
  const hasp::ReportRow& speed = hasp::testing::Row(report, "reduction.colours.speed");
  EXPECT_GT(*speed.value, 2.0); // 100 or so
  EXPECT_NE(speed.rival.find("vtkImplicitPolyDataDistance"), std::string::npos);
}
