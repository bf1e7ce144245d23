#include "SurfaceFragment.h"

#include "Evaluation/MeshCheck.h"
#include "Haptics/DistanceMap.h"
#include "Haptics/PointShell.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>

namespace
{

using glm::dvec3;
using hasp::SurfaceFragment;
using hasp::SurfaceFragmentSettings;
using hasp::TriangleMesh;

/// A sphere about `middle`, wound outward; both poles are many points that are equal but for
/// rounding.
TriangleMesh Sphere(double radius, const dvec3& middle, unsigned round = 128, unsigned up = 64)
{
  TriangleMesh mesh;
  for (unsigned u = 0; u <= up; ++u)
    for (unsigned r = 0; r < round; ++r)
    {
      const double a = 2.0 * glm::pi<double>() * r / round;
      const double b = glm::pi<double>() * (double(u) / up - 0.5);
      mesh.points.push_back(
        middle + radius * dvec3(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)));
    }
  for (unsigned u = 0; u < up; ++u)
    for (unsigned r = 0; r < round; ++r)
    {
      const unsigned a = u * round + r, b = u * round + (r + 1) % round;
      if (u > 0)
        mesh.triangles.push_back({ a, b, b + round });
      if (u + 1 < up)
        mesh.triangles.push_back({ a, b + round, a + round });
      if (u == 0)
        mesh.triangles.back() = { a, b + round, a + round };
      else if (u + 1 == up)
        mesh.triangles.back() = { a, b, b + round };
    }
  return mesh;
}

/// A box with corners low and high.
TriangleMesh Box(const dvec3& low, const dvec3& high)
{
  TriangleMesh mesh;
  for (int c = 0; c < 8; ++c)
    mesh.points.push_back(
      { c & 1 ? high.x : low.x, c & 2 ? high.y : low.y, c & 4 ? high.z : low.z });
  mesh.triangles = { { 0, 2, 1 }, { 1, 2, 3 }, { 4, 5, 6 }, { 5, 7, 6 }, { 0, 1, 4 }, { 1, 5, 4 },
    { 2, 6, 3 }, { 3, 6, 7 }, { 0, 4, 2 }, { 2, 4, 6 }, { 1, 3, 5 }, { 3, 7, 5 } };
  return mesh;
}

std::string Refusal(const TriangleMesh& mesh, const SurfaceFragmentSettings& settings = {})
{
  try
  {
    hasp::BakeSurface(mesh, settings);
    return {};
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
}

void ExpectSays(const std::string& text, const std::string& part)
{
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(SurfaceFragment, NonsenseIsRefusedWithWhatToDo)
{
  const TriangleMesh ball = Sphere(10.0, dvec3(0.0));
  ExpectSays(Refusal({}), "has no triangles");
  ExpectSays(Refusal(Sphere(0.01, dvec3(0.0))), "metres"); // of 10 mm in metres
  ExpectSays(Refusal(Sphere(10000.0, dvec3(0.0))), "micrometres");
  TriangleMesh bad = ball;
  bad.points[200].x = std::nan("");
  ExpectSays(Refusal(bad), "not finite");
  bad = ball;
  bad.triangles[100].x = 1'000'000;
  ExpectSays(Refusal(bad), "names point");
  bad = ball;
  std::swap(bad.triangles[5000].x, bad.triangles[5000].y);
  ExpectSays(Refusal(bad), "wound against each other");
  SurfaceFragmentSettings settings;
  settings.thicknessMm = 0.7; // under two spacings
  ExpectSays(Refusal(ball, settings), "thicknessMm is 0.7");
  settings = {};
  settings.spacingMm = 0.01;
  ExpectSays(Refusal(ball, settings), "spacingMm is 0.01");
  settings = {};
  settings.mostSamples = 1000;
  ExpectSays(Refusal(ball, settings), "at most 1000 are allowed");
  EXPECT_THROW(hasp::BakeSurface(ball, {}, hasp::AllOfFragment, [](double) { return false; }),
    hasp::Cancelled);
}

TEST(SurfaceFragment, ASphereWithAHoleIsSaidToBeOpenAndHowFar)
{
  TriangleMesh ball = Sphere(10.0, { 5, 6, 7 });
  ball.triangles.erase(ball.triangles.begin() + 7000);
  const std::string why = Refusal(ball);
  ExpectSays(why, "it is open: 3 border edges in 1 holes");
  ExpectSays(why, "thicknessMm");
  SurfaceFragmentSettings sheet; // as a sheet it is a body
  sheet.thicknessMm = 2.0;
  const SurfaceFragment made = hasp::BakeSurface(ball, sheet);
  const double shell = 4.0 / 3.0 * glm::pi<double>() * (1000.0 - 512.0);
  EXPECT_NEAR(made.volumeMm3, shell, 0.01 * shell);
}

TEST(SurfaceFragment, ABallIsItsClosedForm)
{
  const dvec3 middle(120.3, -45.1, 61.7); // far from 0, and on no sample
  const SurfaceFragment made = hasp::BakeSurface(Sphere(10.0, middle), {});
  EXPECT_TRUE(made.warnings.empty());
  EXPECT_LT(glm::distance(made.model.origin, middle), 1e-6);
  ASSERT_TRUE(made.model.map && made.model.shell && made.model.surface);
  EXPECT_TRUE(hasp::CheckMesh(*made.model.surface).Sound());
  EXPECT_EQ(made.model.map->RangeMm(), 8.0);
  const auto& grid = made.model.map->Geometry();
  double worst = 0.0, far = 0.0;
  for (int k = 0; k < grid.dims.z; k += 2)
    for (int j = 0; j < grid.dims.y; j += 2)
      for (int i = 0; i < grid.dims.x; i += 2)
      {
        const dvec3 p = grid.IndexToWorld({ i, j, k });
        const double truth = glm::distance(p, middle) - 10.0;
        const double error = std::abs(made.model.map->At(p).mm - std::clamp(truth, -8.0, 8.0));
        (std::abs(truth) < 1.0 ? worst : far) =
          std::max(std::abs(truth) < 1.0 ? worst : far, error);
      }
  EXPECT_LT(worst, 0.02); // chords of 128 parts are 0.003 mm; OpenVDB's nearest triangles
  EXPECT_LT(far, 0.25);   // half a spacing: it hands on a neighbour's triangle
  const double area = 4.0 * glm::pi<double>() * 100.0;
  EXPECT_NEAR(made.model.shell->SurfaceArea(), area, 0.02 * area);
  EXPECT_NEAR(made.model.shell->Radius(), 10.0, 0.05);
}

TEST(SurfaceFragment, ABoxKeepsItsFacesAndWhatIsInsideOutIsTurned)
{
  TriangleMesh box = Box({ -8.0, -5.0, -3.0 }, { 8.0, 5.0, 3.0 });
  for (glm::uvec3& t : box.triangles)
    std::swap(t.y, t.z);
  const SurfaceFragment made = hasp::BakeSurface(box, {});
  ASSERT_EQ(made.warnings.size(), 1U);
  ExpectSays(made.warnings[0], "inside out");
  EXPECT_NEAR(made.volumeMm3, 16.0 * 10.0 * 6.0, 1e-9);
  for (const double z : { -5.0, -3.5, -2.0, 0.0, 2.5, 6.0 }) // above and below the largest face
    EXPECT_NEAR(made.model.map->At({ 0.3, -0.4, z }).mm, std::abs(z) - 3.0, 0.02) << z;
  EXPECT_NEAR(made.model.map->At({ 10.0, 7.0, 0.0 }).mm, std::hypot(2.0, 2.0), 0.05); // an edge
}

TEST(SurfaceFragment, AnOpenSquareIsASheetBehindItOrAboutIt)
{
  TriangleMesh square;
  square.points = { { -10, -10, 0 }, { 10, -10, 0 }, { 10, 10, 0 }, { -10, 10, 0 } };
  square.triangles = { { 0, 1, 2 }, { 0, 2, 3 } }; // +z is outside
  SurfaceFragmentSettings settings;
  settings.thicknessMm = 2.0;
  for (const bool behind : { true, false })
  {
    settings.behind = behind;
    const SurfaceFragment made = hasp::BakeSurface(square, settings);
    const double middle = behind ? -1.0 : 0.0;
    EXPECT_NEAR(made.volumeMm3, 800.0, 1e-9);
    for (double z = -6.0; z <= 6.0; z += 0.5)
      EXPECT_NEAR(made.model.map->At({ 0.3, -0.4, z }).mm, std::abs(z - middle) - 1.0, 0.02) << z;
    EXPECT_NEAR(made.model.map->At({ 14.0, 0.0, middle }).mm, 4.0, 0.05); // beside its rim
  }
}

TEST(SurfaceFragment, ABodyWithinABodyAndTwoApartAreSaid)
{
  TriangleMesh two = Sphere(10.0, dvec3(0.0));
  const TriangleMesh inner = Sphere(4.0, dvec3(0.0));
  const auto offset = unsigned(two.points.size());
  for (const dvec3& p : inner.points)
    two.points.push_back(p);
  for (const glm::uvec3& t : inner.triangles)
    two.triangles.push_back(t + offset);
  const SurfaceFragment made = hasp::BakeSurface(two, {}, { .map = true });
  ASSERT_EQ(made.warnings.size(), 1U);
  ExpectSays(made.warnings[0], "2 pieces");
  EXPECT_LT(made.model.map->At({ 0.0, 0.0, 5.0 }).mm, 0.0); // solid between both
  EXPECT_LT(made.model.map->At({ 0.0, 0.0, 0.0 }).mm, 0.0);
  EXPECT_FALSE(made.model.shell || made.model.surface); // not asked for
}

} // namespace
