// Closed forms of the attraction, held by the reference and by every kernel that this processor
// runs.
#include "Testing/ContactReaders.h"
#include "Testing/WallAndPatch.h"

#include <gtest/gtest.h>

namespace
{

using namespace hasp;

const GridGeometry Grid = hasp::testing::SkewGrid({ 50, 32, 22 });

double AttractionOf(double mm, double capture)
{
  const double s = mm / capture;
  return mm <= 0.0 || s >= 1.0 ? 0.0 : s * (1.0 - s * s) * (1.0 - s * s);
}

TEST(SnapToFit, IsSmoothBoundedAndZeroAtBothEnds)
{
  Scene scene(Grid, 8.0, WallMm);
  ShellOfPoints patch = Patch();
  const double area = 0.225, total = area * static_cast<double>(patch.Count());
  const ContactPoints points = patch.Get(area);
  const ContactSettings settings{ .attraction = 0.02F, .captureMm = 3.0F, .fade = 0.5F };
  const double most = 0.5 * 0.02 * total, peak = 3.0 / std::sqrt(5.0);
  EXPECT_NEAR(AttractionOf(peak, 3.0), 0.286, 5e-4); // what the header says
  for (const Reader& reader : scene.Readers)
    for (const double mm : { 0.01, 0.2, 1.0, peak, 2.0, 2.9, 2.999, 3.001, 4.0 })
    {
      const RigidPose pose = PatchAt(mm);
      const ContactSums sums = reader.feel(ContactTerms::Snap, points, pose, settings);
      const glm::dvec3 pull = -most * AttractionOf(mm, 3.0) * WallNormal;
      // The slope is at most 1 / R.
      ExpectNear(sums.attraction.force, pull, most * reader.tolerance, reader.name);
      const glm::dvec3 lever = pose.Turn({ 1.0, 0.0, 2.0 });
      ExpectNear(sums.attraction.torque, glm::cross(lever, pull), 2.0 * most * reader.tolerance,
        reader.name);
      EXPECT_NEAR(sums.attractedArea, mm < 3.0 ? total : 0.0, 1e-5 * total) << reader.name << mm;
      EXPECT_EQ(sums.contacts, 0U) << reader.name;
    }
}

TEST(SnapToFit, AttractsOnlyFacesThatLookAtEachOther)
{
  Scene scene(Grid, 8.0, WallMm);
  const ContactSettings settings{ .attraction = 1.0F, .captureMm = 3.0F };
  for (const double degrees : { 0.0, 30.0, 60.0, 89.0, 91.0, 180.0 })
  {
    const double angle = glm::radians(degrees);
    ShellOfPoints point; // in the map's axes
    const glm::dvec3 across = glm::normalize(glm::cross(WallNormal, glm::dvec3(1, 0, 0)));
    point.Add(1.0 * WallNormal, -std::cos(angle) * WallNormal + std::sin(angle) * across);
    const ContactPoints points = point.Get(1.0F);
    const double facing = std::max(0.0, std::cos(angle));
    for (const Reader& reader : scene.Readers)
    {
      const ContactSums sums = reader.feel(ContactTerms::Snap, points, {}, settings);
      ExpectNear(sums.attraction.force, -AttractionOf(1.0, 3.0) * facing * facing * WallNormal,
        reader.tolerance, reader.name);
      EXPECT_NEAR(sums.attractedArea, facing > 0.0 ? 1.0 : 0.0, 1e-6) << reader.name << degrees;
    }
  }
}

} // namespace
