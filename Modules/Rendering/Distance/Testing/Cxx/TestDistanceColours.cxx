#include "vtkHaspDistanceColours.h"

#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkMath.h"
#include "vtkScalarBarActor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

/// CIELAB's L*, a*, b* of what a distance is drawn in.
struct Lab
{
  double l, a, b;
};
Lab LabOf(vtkDiscretizableColorTransferFunction* colours, double mm)
{
  double rgb[3];
  colours->GetColor(mm, rgb);
  Lab lab;
  vtkMath::RGBToLab(rgb[0], rgb[1], rgb[2], &lab.l, &lab.a, &lab.b);
  return lab;
}

/// What who lacks the red-sensitive cones (protan) or the green ones (deutan) sees, in linear RGB
/// (Vienot, Brettel and Mollon 1999), as L* and the blue-yellow b* that is left to him.
double Seen(vtkDiscretizableColorTransferFunction* colours, double mm, bool protan)
{
  double rgb[3];
  colours->GetColor(mm, rgb);
  for (double& c : rgb)
    c = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  const double yellow =
    protan ? 0.1121 * rgb[0] + 0.8853 * rgb[1] : 0.2927 * rgb[0] + 0.7073 * rgb[1];
  return rgb[2] - yellow;
}

TEST(DistanceColours, SettingsOutOfRangeAreRefused)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const hasp::DistanceColourSettings& s :
    { hasp::DistanceColourSettings{ 0.0 }, hasp::DistanceColourSettings{ none },
      hasp::DistanceColourSettings{ 1001 }, hasp::DistanceColourSettings{ 1, 1 },
      hasp::DistanceColourSettings{ 1, 4 }, hasp::DistanceColourSettings{ 1, 257 } })
    EXPECT_THROW(hasp::MakeDistanceColours(s), std::invalid_argument);
}

TEST(DistanceColours, ZeroIsNeutralAndTheEndsAreMorelands)
{
  const auto colours = hasp::MakeDistanceColours({ 2.0 });
  const Lab middle = LabOf(colours, 0.0);
  EXPECT_LT(std::hypot(middle.a, middle.b), 1.5);
  EXPECT_GT(middle.l, 85.0);
  double rgb[3];
  for (const double mm : { -2.0, -7.0 }) // beyond the range nothing changes any more
  {
    colours->GetColor(mm, rgb);
    EXPECT_NEAR(rgb[0] * 255, 59, 1.0);
    EXPECT_NEAR(rgb[2] * 255, 192, 1.0);
  }
  colours->GetColor(9.0, rgb);
  EXPECT_NEAR(rgb[0] * 255, 180, 1.0);
  EXPECT_NEAR(rgb[2] * 255, 38, 1.0);
}

TEST(DistanceColours, LightnessFallsToEitherSide)
{
  const auto colours = hasp::MakeDistanceColours({ 3.0 });
  for (const double side : { -1.0, 1.0 })
    for (int n = 0; n < 60; ++n)
      EXPECT_GT(LabOf(colours, side * 0.05 * n).l, LabOf(colours, side * 0.05 * (n + 1)).l)
        << side << " " << n;
}

TEST(DistanceColours, SidesDifferForWhoDoesNotTellRedFromGreen)
{
  const auto colours = hasp::MakeDistanceColours({ 3.0 });
  for (const bool protan : { false, true })
    for (int n = 3; n <= 60; ++n) // from a twentieth of the range on
    {
      EXPECT_GT(Seen(colours, -0.05 * n, protan), 0.0);
      EXPECT_LT(Seen(colours, 0.05 * n, protan), Seen(colours, -0.05 * n, protan) - 0.03);
    }
}

TEST(DistanceColours, StepsHaveOneAroundZero)
{
  const auto colours = hasp::MakeDistanceColours({ 2.5, 5 });
  double one[3], other[3];
  for (const double mm : { -2.0, -1.0, 0.0, 1.0, 2.0 })
  {
    colours->GetColor(mm - 0.4, one);
    colours->GetColor(mm + 0.4, other);
    for (int c = 0; c < 3; ++c)
      EXPECT_EQ(one[c], other[c]) << mm;
  }
}

TEST(DistanceColours, TheScaleIsInMillimetres)
{
  const auto colours = hasp::MakeDistanceColours();
  const auto scale = hasp::MakeDistanceScale(colours);
  EXPECT_STREQ(scale->GetTitle(), "mm");
  EXPECT_EQ(scale->GetLookupTable(), colours);
  EXPECT_EQ(scale->GetNumberOfLabels() % 2, 1); // one is 0
}

} // namespace
