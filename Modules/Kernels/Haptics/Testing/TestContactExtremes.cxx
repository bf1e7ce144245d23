// Where the contact kernels must feel nothing, or no more than they should.
#include "Testing/ContactReaders.h"

#include <limits>
#include <span>

namespace
{

using namespace hasp;

const ContactSettings Pulling{ .attraction = 0.1F, .captureMm = 3.0F };

double FloorMm(const glm::dvec3& p)
{
  return p.z;
}

using hasp::testing::CubeGrid;

TEST(ContactExtremes, NoPoints)
{
  Scene scene(CubeGrid(20), 6.0, FloorMm);
  for (const Reader& reader : scene.Readers)
    for (const ContactTerms terms : AllTerms)
      ExpectNothing(reader.feel(terms, {}, {}, Pulling), reader.name);
}

TEST(ContactExtremes, PaddingFeelsNothingInsideOfABody)
{
  Scene scene(CubeGrid(20), 6.0, [](const glm::dvec3&) { return -1.0; }); // solid everywhere
  ShellOfPoints far;
  far.Add(glm::dvec3(ContactPoints::FarAway), { 0, 0, 1 });
  const ContactPoints points = far.Get(1.0F); // 16 of them
  for (const Reader& reader : scene.Readers)
    for (const ContactTerms terms : AllTerms)
      for (const double spin : { 0.0, 1.0, 3.0 })
        ExpectNothing(
          reader.feel(terms, points, { {}, TurnBy(glm::dvec3(spin)) }, Pulling), reader.name);
}

/// One real point in front of the floor, and each side of the grid.
TEST(ContactExtremes, NothingOutsideOfTheGrid)
{
  const auto solid = [](const glm::dvec3&) { return -1.0; };
  Scene scene(CubeGrid(18), 6.0, solid); // not a multiple of 8 cells: 17
  ShellOfPoints one;
  one.Add(glm::dvec3(0.0), { 0, 0, 1 });
  const ContactPoints points = one.Get(1.0F);
  for (const Reader& reader : scene.Readers)
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : { -1.0, 1.0 })
      {
        glm::dvec3 at(0.3);
        at[axis] = sign * 8.49;
        EXPECT_EQ(reader.feel(ContactTerms::Snap, points, { at, {} }, Pulling).contacts, 1U)
          << reader.name;
        for (const double beyond : { 8.51, 9.0, 12.0, 1e4, 1e12, 1e37 })
        {
          at[axis] = sign * beyond;
          ExpectNothing(reader.feel(ContactTerms::Snap, points, { at, {} }, Pulling), reader.name);
        }
      }
}

TEST(ContactExtremes, APoseThatIsNoNumberFeelsNothing)
{
  Scene scene(CubeGrid(20), 6.0, [](const glm::dvec3&) { return -1.0; });
  ShellOfPoints one;
  one.Add(glm::dvec3(0.0), { 0, 0, 1 });
  const ContactPoints points = one.Get(1.0F);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Reader& reader : scene.Readers)
    for (const ContactTerms terms : AllTerms)
      for (const double bad : { nan, infinity, -infinity, 1e300 })
        for (int part = 0; part < 7; ++part)
        {
          RigidPose pose{ {}, TurnBy({ 0.1, 0.2, 0.3 }) };
          if (part < 3)
            pose.position[part] = bad;
          else
            pose.orientation[part - 3] = bad;
          ExpectNothing(reader.feel(terms, points, pose, Pulling), reader.name);
        }
}

/// Deeper than the range the distance is clamped and has no gradient: along the points' normals the
/// force stays, along the gradient there is none.
TEST(ContactExtremes, DeeperThanTheRange)
{
  Scene scene(CubeGrid(40), 4.0, FloorMm);
  ShellOfPoints one;
  one.Add(glm::dvec3(0.0), { 0, 0, -1 });
  const ContactPoints points = one.Get(2.0F);
  for (const Reader& reader : scene.Readers)
  {
    const RigidPose pose{ { 0, 0, -15.0 }, {} };
    const ContactSums force = reader.feel(ContactTerms::Force, points, pose, { .stiffness = 1.0F });
    ExpectNear(force.contact.force, { 0.0, 0.0, 8.0 }, 1e-5, reader.name);
    const ContactSums matrix =
      reader.feel(ContactTerms::Matrix, points, pose, { .stiffness = 1.0F });
    ExpectNear(matrix.contact.force, glm::dvec3(0.0), 0.0, reader.name);
    EXPECT_NEAR(matrix.deepestMm, -4.0, 1e-6) << reader.name;
    EXPECT_EQ(matrix.contacts, 1U) << reader.name;
  }
}

/// A capture of more than the range ends at the range, where the map does: nothing pulls there.
TEST(ContactExtremes, NothingPullsBeyondTheRange)
{
  Scene scene(CubeGrid(40), 2.0, FloorMm);
  ShellOfPoints one;
  one.Add(glm::dvec3(0.0), { 0, 0, -1 });
  const ContactPoints points = one.Get(1.0F);
  for (const Reader& reader : scene.Readers)
  {
    const auto pull = [&](double mm) {
      return reader.feel(ContactTerms::Snap, points, { { 0, 0, mm }, {} }, Pulling).attraction;
    };
    EXPECT_LT(pull(1.0).force.z, 0.0) << reader.name;
    EXPECT_EQ(pull(5.0).force.z, 0.0) << reader.name;
  }
}

TEST(ContactExtremes, ScenesOfAMillimetreAndOfTenMetres)
{
  for (const double size : { 1.0, 100.0, 10'000.0 })
  {
    Scene scene(CubeGrid(40, size / 40.0), size / 5.0, FloorMm);
    ShellOfPoints ball;
    AddBall(ball, 8000, size / 4.0);
    const double area = 4.0 * glm::pi<double>() * size * size / 16.0 / 8000.0;
    const ContactPoints points = ball.Get(static_cast<float>(area));
    const double h = size / 16.0;
    const RigidPose pose{ { 0, 0, size / 4.0 - h }, {} };
    const double force = 0.05 * glm::pi<double>() * size / 4.0 * h * h;
    for (const Reader& reader : scene.Readers)
      EXPECT_NEAR(
        reader.feel(ContactTerms::Matrix, points, pose, {}).contact.force.z, force, 5e-3 * force)
        << reader.name << size;
  }
}

TEST(ContactExtremes, PointsWithAreasOfTheirOwn)
{
  Scene scene(CubeGrid(40), 4.0, FloorMm);
  ShellOfPoints two;
  two.Add({ 1, 0, 0 }, { 0, 0, -1 });
  two.Add({ -1, 0, 1.0 }, { 0, 0, -1 });
  const std::vector<float> areas = { 2.0F, 5.0F };
  const ContactPoints points = two.Get(0.0F, areas);
  const ContactSettings settings{ .stiffness = 0.5F, .attraction = 0.1F, .captureMm = 3.0F };
  for (const Reader& reader : scene.Readers)
  {
    const RigidPose pose{ { 0.1, 0.2, -0.5 }, {} };
    const ContactSums sums = reader.feel(ContactTerms::Snap, points, pose, settings);
    EXPECT_NEAR(sums.contactArea, 2.0, 1e-6) << reader.name;
    EXPECT_NEAR(sums.attractedArea, 5.0, 1e-6) << reader.name;
    const double within = reader.tolerance;
    ExpectNear(sums.contact.force, { 0, 0, 0.5 * 2.0 * 0.5 }, within, reader.name);
    ExpectNear(sums.contact.torque, { 0, -0.5, 0 }, within, reader.name);
    EXPECT_NEAR(sums.matrix[11], 0.5 * 2.0, within) << reader.name;  // z, z
    EXPECT_NEAR(sums.matrix[13], -0.5 * 2.0, within) << reader.name; // z, about y
    EXPECT_NEAR(sums.energy, 0.5 * 0.5 * 2.0 * 0.25, within) << reader.name;
    const double share = 0.5 / 3.0, rim = 1.0 - share * share;
    const double pull = -0.1 * 5.0 * share * rim * rim;
    ExpectNear(sums.attraction.force, { 0, 0, pull }, within, reader.name);
    ExpectNear(sums.attraction.torque, { 0, pull, 0 }, within, reader.name);
  }
}

TEST(ContactExtremes, SumsAreAddedTo)
{
  Scene scene(CubeGrid(40), 4.0, FloorMm);
  ShellOfPoints ball;
  AddBall(ball, 640, 5.0);
  const ContactPoints all = ball.Get(0.5F);
  const RigidPose pose{ { 0.3, 0, 4.0 }, {} };
  for (const ContactKernels& kernels : AllContactKernels())
  {
    ContactSums whole, parts, apart, atOnce;
    std::vector<ContactPoints> runs(1); // the first one empty
    kernels[ContactTerms::Snap](all, { pose }, scene.Map.Shorts(), Pulling, whole);
    for (std::uint32_t first = 0; first < all.count; first += 64)
    {
      const ContactPoints part{ all.x + first, all.y + first, all.z + first, all.nx + first,
        all.ny + first, all.nz + first, nullptr, all.area, 64 };
      kernels[ContactTerms::Snap](part, { pose }, scene.Map.Shorts(), Pulling, parts);
      ContactSums one;
      kernels[ContactTerms::Snap](part, { pose }, scene.Map.Shorts(), Pulling, one);
      apart += one;
      runs.push_back(part);
    }
    kernels[ContactTerms::Snap](
      std::span<const ContactPoints>(runs), { pose }, scene.Map.Shorts(), Pulling, atOnce);
    for (const ContactSums& other : { parts, apart, atOnce })
    {
      EXPECT_EQ(other.contacts, whole.contacts) << kernels.name;
      EXPECT_EQ(other.deepestMm, whole.deepestMm) << kernels.name;
      EXPECT_NEAR(other.contact.force.z, whole.contact.force.z, 1e-6 * whole.contact.force.z);
      EXPECT_NEAR(other.attraction.force.z, whole.attraction.force.z, 1e-6);
      EXPECT_NEAR(other.energy, whole.energy, 1e-6 * whole.energy) << kernels.name;
      EXPECT_NEAR(other.matrix[0] + other.matrix[11], whole.matrix[0] + whole.matrix[11],
        1e-6 * whole.matrix[11]);
      EXPECT_NEAR(other.contactArea, whole.contactArea, 1e-6 * whole.contactArea);
      EXPECT_NEAR(other.attractedArea, whole.attractedArea, 1e-6 * whole.attractedArea);
    }
  }
}

/// Runs of points for areas that differ, with areas of their own and without, in one call.
TEST(ContactExtremes, RunsOfDifferentAreas)
{
  Scene scene(CubeGrid(40), 4.0, FloorMm);
  ShellOfPoints one, other;
  one.Add(glm::dvec3(0.0), { 0, 0, -1 });
  other.Add(glm::dvec3(0.0), { 0, 0, -1 });
  ContactPoints a = one.Get(2.0F);
  const std::vector<float> areas = { 5.0F };
  const ContactPoints b = other.Get(0.0F, areas);
  ContactPoints c = a;
  c.area = 7.0F;
  const std::vector<ContactPoints> runs = { a, a, c, b, b, a };
  for (const ContactKernels& kernels : AllContactKernels())
  {
    ContactSums sums;
    kernels[ContactTerms::Matrix](std::span<const ContactPoints>(runs), { { { 0, 0, -0.5 }, {} } },
      scene.Map.Shorts(), { .stiffness = 1.0F }, sums);
    EXPECT_NEAR(sums.contactArea, 3 * 2.0 + 7.0 + 2 * 5.0, 1e-5) << kernels.name;
    EXPECT_NEAR(sums.contact.force.z, 23.0 * 0.5, 23.0 * 1e-4) << kernels.name;
    EXPECT_NEAR(sums.matrix[11], 23.0, 23.0 * 1e-4) << kernels.name;
    EXPECT_EQ(sums.contacts, 6U) << kernels.name;
  }
}

} // namespace
