// Closed forms, held by the reference and by every kernel that this processor runs.
#include "Testing/ContactReaders.h"
#include "Testing/WallAndPatch.h"

#include <gtest/gtest.h>

namespace
{

using namespace hasp;

const GridGeometry Grid = hasp::testing::SkewGrid({ 50, 32, 22 });
const hasp::testing::DistanceFunction Bumpy = hasp::testing::BumpyBall(9.0, 0.8);

using Matrix6 = std::array<std::array<double, 6>, 6>;

Matrix6 Full(const std::array<double, 21>& triangle)
{
  Matrix6 m{};
  for (int r = 0, n = 0; r < 6; ++r)
    for (int c = r; c < 6; ++c, ++n)
      m[r][c] = m[c][r] = triangle[n];
  return m;
}

TEST(ContactForce, HalfSpaceIsPressureTimesArea)
{
  Scene scene(Grid, 8.0, WallMm);
  ShellOfPoints patch = Patch();
  const double area = 0.225, k = 0.2, depth = 0.5;
  const ContactPoints points = patch.Get(area);
  const RigidPose pose = PatchAt(-depth);
  const double total = area * static_cast<double>(patch.Count());
  const glm::dvec3 force = k * total * depth * WallNormal;
  const glm::dvec3 torque = glm::cross(pose.Turn({ 1.0, 0.0, 2.0 }), force); // the patch's middle
  for (const Reader& reader : scene.Readers)
    for (const ContactTerms terms : AllTerms)
    {
      const ContactSums sums =
        reader.feel(terms, points, pose, { .stiffness = static_cast<float>(k) });
      ExpectNear(sums.contact.force, force, reader.tolerance * glm::length(force), reader.name);
      ExpectNear(sums.contact.torque, torque, reader.tolerance * glm::length(torque), reader.name);
      EXPECT_EQ(sums.contacts, patch.Count()) << reader.name;
      EXPECT_NEAR(sums.contactArea, total, 1e-6 * total) << reader.name;
      EXPECT_NEAR(sums.deepestMm, -depth, reader.tolerance * depth) << reader.name;
      EXPECT_NEAR(
        sums.energy, 0.5 * k * total * depth * depth, 2.0 * reader.tolerance * sums.energy)
        << reader.name;
      EXPECT_EQ(sums.attractedArea, 0.0) << reader.name;
    }
}

/// Hertz without elasticity: over the cap of height h the depth is even in z, so the force is
/// k pi R h^2, the energy k pi R h^3 / 3, and neither depends on how many points there are.
TEST(ContactForce, BallOnPlaneWhateverTheNumberOfPoints)
{
  Scene scene(Grid, 8.0, WallMm);
  const double radius = 6.0, k = 0.3, h = 1.5;
  const glm::dvec3 center(0.7, -0.4, 0.9); // in the body's axes
  RigidPose pose{ {}, TurnBy({ 0.2, 0.1, -0.3 }) };
  pose.position = WallNormal * (radius - h) - pose.Turn(center);
  const double force = k * glm::pi<double>() * radius * h * h;
  const glm::dvec3 torque = glm::cross(pose.Turn(center), force * WallNormal);
  for (const int n : { 2000, 8000, 32000 })
  {
    ShellOfPoints ball;
    AddBall(ball, n, radius, center);
    const double area = 4.0 * glm::pi<double>() * radius * radius / n;
    const ContactPoints points = ball.Get(static_cast<float>(area));
    // The cap's rim is cut by whole points: about a row of them, each at the least depth.
    const double within = 0.02 * std::sqrt(2000.0 / n);
    for (const Reader& reader : scene.Readers)
    {
      const ContactSums sums =
        reader.feel(ContactTerms::Matrix, points, pose, { .stiffness = static_cast<float>(k) });
      ExpectNear(sums.contact.force, force * WallNormal, within * force, reader.name);
      ExpectNear(sums.contact.torque, torque, 2.0 * within * force * radius, reader.name);
      EXPECT_NEAR(sums.energy, force * h / 3.0, within * force * h) << reader.name;
    }
  }
}

TEST(ContactForce, IsTheSlopeOfTheEnergy)
{
  const ContactMap map(Grid, 6.0, Bumpy);
  ShellOfPoints ball;
  AddBall(ball, 6000, 5.0);
  const ContactPoints points = ball.Get(0.05F);
  const RigidPose pose{ { 8.0, 5.0, 6.0 }, TurnBy({ 0.4, -0.2, 0.1 }) };
  const auto feel = [&](const RigidPose& at)
  {
    ContactSums sums;
    ContactForceReference(ContactTerms::Matrix, points, { at }, map.Floats(), {}, sums);
    return sums;
  };
  const ContactSums here = feel(pose);
  ASSERT_GT(here.contacts, 200U);
  // Central differences; the slope has steps at the cells' faces, which single points cross.
  const double step = 1e-3, within = 2e-3 * glm::length(here.contact.force);
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec3 d(0.0);
    d[axis] = step;
    const auto energy = [&](const glm::dvec3& move, const glm::dvec3& turn) {
      return feel({ pose.position + move, TurnBy(turn) * pose.orientation }).energy;
    };
    const double push = -(energy(d, {}) - energy(-d, {})) / (2.0 * step);
    EXPECT_NEAR(here.contact.force[axis], push, within);
    const double twist = -(energy({}, d) - energy({}, -d)) / (2.0 * step);
    EXPECT_NEAR(here.contact.torque[axis], twist, 5.0 * within); // 5 mm of lever
  }
}

TEST(ContactForce, PotentialReturnsAroundAClosedPath)
{
  const ContactMap map(Grid, 6.0, Bumpy);
  ShellOfPoints ball;
  AddBall(ball, 3000, 5.0);
  const ContactPoints points = ball.Get(0.1F);
  const ContactKernels kernels = FastestContactKernels();
  double work = 0.0, moved = 0.0;
  glm::dvec3 lastForce(0.0), lastAt(0.0);
  constexpr int Steps = 2000;
  for (int n = 0; n <= Steps; ++n)
  {
    const double a = 2.0 * glm::pi<double>() * n / Steps;
    const glm::dvec3 at =
      glm::dvec3(8.0, 5.0, 6.0) +
      glm::dvec3(1.2 * std::sin(a), 1.5 * (std::cos(a) - 1.0), 0.6 * std::sin(2.0 * a));
    ContactSums sums;
    kernels[ContactTerms::Matrix](points, { { at, {} } }, map.Shorts(), {}, sums);
    if (n > 0)
    {
      const double share = glm::dot(0.5 * (sums.contact.force + lastForce), at - lastAt);
      work += share;
      moved += std::abs(share);
    }
    lastForce = sums.contact.force;
    lastAt = at;
  }
  EXPECT_LT(std::abs(work), 1e-4 * moved); // trapezes of 5 um
}

/// On a flat wall the depth is linear in a small motion, and the direction constant: the forces'
/// rows are the whole derivative. (A torque changes also as its lever turns: left out on purpose.)
TEST(ContactForce, MatrixIsTheForcesSlopeOnAWall)
{
  Scene scene(Grid, 8.0, WallMm);
  ShellOfPoints patch = Patch();
  const ContactPoints points = patch.Get(0.3F);
  const RigidPose pose = PatchAt(-0.5);
  for (const Reader& reader : scene.Readers)
  {
    const auto feel = [&](const RigidPose& at)
    { return reader.feel(ContactTerms::Matrix, points, at, { .stiffness = 1.0F }); };
    const Matrix6 k = Full(feel(pose).matrix);
    const double step = 0.05; // large against int16's step; the wall is flat
    for (int c = 0; c < 6; ++c)
    {
      glm::dvec3 d(0.0);
      d[c % 3] = step;
      const auto moved = [&](double sign) -> RigidPose
      {
        if (c < 3)
          return { pose.position + sign * d, pose.orientation };
        return { pose.position, TurnBy(0.1 * sign * d) * pose.orientation };
      };
      const glm::dvec3 slope = (feel(moved(1)).contact.force - feel(moved(-1)).contact.force) /
                               (2.0 * step * (c < 3 ? 1.0 : 0.1));
      for (int r = 0; r < 3; ++r) // 43 mm^2 of patch, levers of 2 mm
        EXPECT_NEAR(-k[r][c], slope[r], 2.0 * reader.tolerance * 43.0 * (c < 3 ? 1.0 : 4.0))
          << reader.name << " " << r << c;
    }
  }
}

TEST(ContactForce, MatrixIsTheSumOfLeversSquared)
{
  const auto ball = [](const glm::dvec3& p) { return glm::length(p) - 9.0; };
  GridGeometry fine = hasp::testing::SkewGrid({ 110, 70, 48 });
  fine.spacing *= 0.35;
  fine.origin *= 0.35;
  Scene scene(fine, 8.0, ball);
  ShellOfPoints shell;
  AddBall(shell, 4000, 5.0, { 0.5, 0.0, -1.0 });
  const ContactPoints points = shell.Get(0.08F);
  const RigidPose pose{ { 9.0, 6.0, 7.0 }, TurnBy({ -0.3, 0.6, 0.2 }) };
  // By brute force, with the ball's own gradient; the map's is off by the curvature in a cell of
  // 0.56 mm, at most 0.56^2 / (8 * 9), 0.4% of it and twice that in a square; its surface lies as
  // much deeper, which leaves out the rim of a contact 1 mm deep: 0.7% of the area.
  Matrix6 truth{};
  int touching = 0;
  for (std::size_t n = 0; n < shell.Count(); ++n)
  {
    const glm::dvec3 r = pose.Turn({ points.x[n], points.y[n], points.z[n] });
    if (ball(pose.position + r) >= 0.0)
      continue;
    const glm::dvec3 g = glm::normalize(pose.position + r), t = glm::cross(r, g);
    const double j[6] = { g.x, g.y, g.z, t.x, t.y, t.z };
    ++touching;
    for (int a = 0; a < 6; ++a)
      for (int b = 0; b < 6; ++b)
        truth[a][b] += 0.08 * 0.05 * j[a] * j[b];
  }
  ASSERT_GT(touching, 100);
  for (const Reader& reader : scene.Readers)
  {
    const Matrix6 k = Full(reader.feel(ContactTerms::Matrix, points, pose, {}).matrix);
    for (int a = 0; a < 6; ++a)
      for (int b = 0; b < 6; ++b)
        EXPECT_NEAR(k[a][b], truth[a][b], 0.02 * std::sqrt(truth[a][a] * truth[b][b]))
          << reader.name << " " << a << b;
    Dice dice(7);
    for (int n = 0; n < 200; ++n) // positive semidefinite
    {
      double form = 0.0, size = 0.0;
      const glm::dvec3 u = dice.InBox(1.0), v = dice.InBox(1.0);
      const double x[6] = { u.x, u.y, u.z, v.x, v.y, v.z };
      for (int a = 0; a < 6; ++a)
        for (int b = 0; b < 6; ++b)
        {
          form += x[a] * k[a][b] * x[b];
          size += std::abs(x[a] * k[a][b] * x[b]);
        }
      EXPECT_GE(form, -1e-6 * size) << reader.name; // summed in float
    }
  }
}

TEST(ContactForce, TermsAgreeOnWhatTheyShare)
{
  Scene scene(Grid, 6.0, Bumpy);
  ShellOfPoints ball;
  AddBall(ball, 3000, 5.0);
  const ContactPoints points = ball.Get(0.1F);
  const RigidPose pose{ { 8.0, 5.0, 6.0 }, {} };
  for (const Reader& reader : scene.Readers)
  {
    const ContactSettings settings{ .attraction = 0.1F };
    const ContactSums force = reader.feel(ContactTerms::Force, points, pose, settings);
    const ContactSums matrix = reader.feel(ContactTerms::Matrix, points, pose, settings);
    const ContactSums snap = reader.feel(ContactTerms::Snap, points, pose, settings);
    EXPECT_GT(snap.attractedArea, 0.0);
    EXPECT_EQ(force.contacts, matrix.contacts) << reader.name;
    EXPECT_EQ(snap.contacts, matrix.contacts) << reader.name;
    EXPECT_NEAR(force.energy, matrix.energy, 1e-6 * matrix.energy) << reader.name;
    EXPECT_EQ(force.matrix[0], 0.0) << reader.name;
    const double size = glm::length(matrix.contact.force);
    ExpectNear(snap.contact.force, matrix.contact.force, 1e-6 * size, reader.name);
    EXPECT_NEAR(snap.matrix[7], matrix.matrix[7], 1e-6 * matrix.matrix[7]) << reader.name;
  }
}

} // namespace
