// Rays against triangles, held against all triangles one by one.
#include "Light/Testing/LightScenes.h"

#include <gtest/gtest.h>

#include <cstring>

namespace
{

using namespace hasp::testing;
using hasp::LitMesh;
using hasp::TriangleTracer;

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// What a ray meets first, and by how much of a triangle that is undecided: the least distance of a
/// barycentric weight from 0, of all triangles up to the hit.
struct Truth
{
  double t = Infinity, margin = Infinity;
  std::uint32_t triangle = 0;
};

/// In long double, after Moeller and Trumbore.
Truth BruteForce(const LitMesh& mesh, const glm::dvec3& origin, const glm::dvec3& direction,
  double tMin, double tMax)
{
  using Vec = glm::vec<3, long double>;
  Truth truth;
  for (std::uint32_t n = 0; n < mesh.mesh.triangles.size(); ++n)
  {
    const glm::uvec3& c = mesh.mesh.triangles[n];
    const Vec a(mesh.mesh.points[c.x]), ab = Vec(mesh.mesh.points[c.y]) - a,
                                        ac = Vec(mesh.mesh.points[c.z]) - a, d(direction),
                                        p = glm::cross(d, ac);
    const long double volume = glm::dot(ab, p);
    if (volume == 0.0L)
      continue;
    const Vec from = Vec(origin) - a, q = glm::cross(from, ab);
    const long double u = glm::dot(from, p) / volume, v = glm::dot(d, q) / volume,
                      t = glm::dot(ac, q) / volume;
    if (t < tMin || t >= tMax)
      continue;
    truth.margin =
      std::min<double>(truth.margin, std::abs(std::min({ u, v, 1.0L - u - v }))); // all, to be safe
    if (u >= 0 && v >= 0 && u + v <= 1 && t < truth.t)
    {
      truth.t = double(t);
      truth.triangle = n;
    }
  }
  return truth;
}

LitMesh Soup(int triangles, unsigned seed, double size, const glm::dvec3& middle)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> at(-0.5, 0.5);
  const auto point = [&](double around)
  {
    const double x = at(random), y = at(random), z = at(random);
    return around * glm::dvec3(x, y, z);
  };
  LitMesh mesh;
  for (int n = 0; n < triangles; ++n)
  {
    const glm::dvec3 place = middle + point(size);
    for (int c = 0; c < 3; ++c)
      mesh.mesh.points.push_back(place + point(0.4 * size));
    mesh.mesh.triangles.push_back(glm::uvec3(3 * n, 3 * n + 1, 3 * n + 2));
  }
  return mesh;
}

/// Rays through and past a mesh of that size.
void ExpectTruth(const LitMesh& mesh, double size, const glm::dvec3& middle, int rays)
{
  const TriangleTracer tracer(mesh);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> at(-0.6, 0.6), stretch(0.1, 10.0);
  int hits = 0, undecided = 0;
  for (int n = 0; n < rays; ++n)
  {
    const auto point = [&]
    {
      const double x = at(random), y = at(random), z = at(random);
      return middle + size * glm::dvec3(x, y, z);
    };
    const glm::dvec3 from = middle + (n % 2 ? 1.5 : 40.0) * size * RandomDirection(random);
    const glm::dvec3 direction = stretch(random) * glm::normalize(point() - from);
    const double tMin = n % 3 ? 0.0 : 1.6 * size / glm::length(direction);
    const double tMax = n % 5 ? Infinity : 2.1 * size / glm::length(direction);
    const Truth truth = BruteForce(mesh, from, direction, tMin, tMax);
    const auto hit = tracer.Trace(from, direction, tMin, tMax);
    ASSERT_EQ(tracer.Occluded(from, direction, tMin, tMax), hit.has_value()) << n;
    if (truth.margin < 1e-5) // Embree's points are floats
    {
      ++undecided;
      continue;
    }
    // A hit at the very end of the range may lie on either side of it.
    const Truth wider = BruteForce(mesh, from, direction, tMin * (1 - 1e-6), tMax * (1 + 1e-6));
    const Truth narrower = BruteForce(mesh, from, direction, tMin * (1 + 1e-6), tMax * (1 - 1e-6));
    if (wider.t != narrower.t)
      continue;
    ASSERT_EQ(hit.has_value(), truth.t < Infinity) << n;
    if (!hit)
      continue;
    ++hits;
    // The plane gives t; two triangles that cross nearer than a float's digits may change places.
    ASSERT_NEAR(hit->t * glm::length(direction), truth.t * glm::length(direction), 2e-6 * size)
      << n;
    if (hit->triangle != truth.triangle)
      continue;
    const glm::uvec3& c = mesh.mesh.triangles[hit->triangle];
    const auto& p = mesh.mesh.points;
    const glm::dvec3 place =
      p[c.x] + double(hit->at.x) * (p[c.y] - p[c.x]) + double(hit->at.y) * (p[c.z] - p[c.x]);
    ASSERT_LT(glm::distance(place, from + hit->t * direction), 1e-5 * size) << n;
  }
  EXPECT_GT(hits, rays / 4);
  EXPECT_LT(undecided, rays / 5);
}

TEST(TriangleTracer, SoupIsMetAsBruteForceSays)
{
  ExpectTruth(Soup(100, 1, 60.0, {}), 60.0, {}, 4000);
}

TEST(TriangleTracer, ClosedMeshIsMetAsBruteForceSays)
{
  ExpectTruth(SphereMesh({ 3, 4, 5 }, 20.0, 8), 40.0, { 3, 4, 5 }, 3000);
}

TEST(TriangleTracer, SizeAndPlaceChangeNothing)
{
  for (const double size : { 1e-3, 1.0, 1e4 })
    ExpectTruth(Soup(60, 3, size, {}), size, {}, 1000);
  const glm::dvec3 far(1e6, -1e6, 1e6);
  ExpectTruth(Soup(60, 4, 50.0, far), 50.0, far, 1000);
}

TEST(TriangleTracer, HitsFarAwayKeepTheirDigits)
{
  const glm::dvec3 middle(1e6, -1e6, 1e6);
  LitMesh mesh = PlaneMesh(10.0);
  for (auto& point : mesh.mesh.points)
    point += middle;
  const TriangleTracer tracer(mesh);
  const auto hit = tracer.Trace(middle + glm::dvec3(1, 2, 1e5), { 0, 0, -1 }, 0.0);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->t, 1e5, 1e-8) << "of doubles at 1e6 mm: 1e-10";
}

TEST(TriangleTracer, NormalsAndColoursLieBetweenThePoints)
{
  LitMesh mesh = PlaneMesh(1.0);
  const TriangleTracer plain(mesh);
  const auto plainHit = plain.Trace({ 0.2, -0.3, 5 }, { 0, 0, -1 }, 0.0);
  ASSERT_TRUE(plainHit);
  EXPECT_FALSE(plain.Color(*plainHit));
  EXPECT_EQ(plain.Normal(plainHit->triangle), glm::dvec3(0, 0, 1)) << "by the points' order";
  EXPECT_EQ(plain.ShadingNormal(*plainHit), glm::dvec3(0, 0, 1));

  for (const auto& point : mesh.mesh.points) // linear in x and y, so the truth is known everywhere
  {
    mesh.normals.emplace_back(0.3 * point.x, 0.2 * point.y, 1.0);
    mesh.colors.emplace_back(0.5 + 0.5 * point.x, 0.5 + 0.5 * point.y, 0.25);
  }
  const TriangleTracer tracer(mesh);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(-0.99, 0.99);
  for (int n = 0; n < 200; ++n)
  {
    const double x = at(random), y = at(random);
    const auto hit = tracer.Trace({ x, y, -7 }, { 0, 0, 2 }, 0.0);
    ASSERT_TRUE(hit);
    ASSERT_NEAR(hit->t, 3.5, 1e-12);
    const glm::dvec3 normal = glm::normalize(glm::dvec3(0.3 * x, 0.2 * y, 1.0));
    ASSERT_LT(glm::distance(tracer.ShadingNormal(*hit), normal), 1e-6); // weights are floats
    const glm::dvec3 color(0.5 + 0.5 * x, 0.5 + 0.5 * y, 0.25);
    ASSERT_LT(glm::distance(glm::dvec3(*tracer.Color(*hit)), color), 1e-6);
  }
  // Normals that cancel out, or are 0, leave the triangle's own.
  mesh.normals.assign(4, glm::vec3(0.0F));
  const TriangleTracer none(mesh);
  EXPECT_EQ(none.ShadingNormal(*plainHit), glm::dvec3(0, 0, 1));
}

TEST(TriangleTracer, TrianglesWithoutAreaAreNotMet)
{
  LitMesh mesh = PlaneMesh(1.0);
  mesh.mesh.points.emplace_back(0.0, 0.0, 1.0);
  mesh.mesh.points.emplace_back(0.0, 0.0, 0.5);
  // A point, a line, a line back and forth: above the plane, so that they would be met first.
  mesh.mesh.triangles.insert(
    mesh.mesh.triangles.end(), { { 4, 4, 4 }, { 4, 5, 4 }, { 4, 5, 5 }, { 0, 2, 0 } });
  const TriangleTracer tracer(mesh);
  EXPECT_EQ(tracer.Normal(2), glm::dvec3(0.0));
  for (int n = 0; n < 100; ++n)
  {
    const double x = 0.013 * (n - 50);
    for (const glm::dvec3& to : { glm::dvec3(0, 0, -1), glm::dvec3(0.1, 0.0, -1) })
    {
      const auto hit =
        tracer.Trace(glm::dvec3(x, 0.3 * x, 3) - 3.0 * (to + glm::dvec3(0, 0, 1)), to, 0.0);
      ASSERT_TRUE(hit) << n;
      ASSERT_LT(hit->triangle, 2) << n;
      ASSERT_NEAR(hit->t, 3.0, 1e-12) << n;
    }
  }
  LitMesh flat;
  flat.mesh.points = { { 1, 2, 3 } };
  flat.mesh.triangles = { { 0, 0, 0 } };
  EXPECT_FALSE(TriangleTracer(flat).Trace({ 1, 2, 9 }, { 0, 0, -1 }, 0.0));
}

TEST(TriangleTracer, NothingIsMetInAnEmptyMesh)
{
  const TriangleTracer none{ LitMesh() };
  EXPECT_FALSE(none.Trace({ 0, 0, 5 }, { 0, 0, -1 }, 0.0));
  EXPECT_FALSE(none.Occluded({ 0, 0, 5 }, { 0, 0, -1 }, 0.0));
  EXPECT_GT(none.Low().x, none.High().x);
  EXPECT_EQ(none.Bytes(), 0);
}

TEST(TriangleTracer, RaysThatAreNoNumbersMeetNothing)
{
  const TriangleTracer tracer(SphereMesh({}, 1.0, 6));
  const double nan = std::nan("");
  for (const glm::dvec3& bad : { glm::dvec3(nan, 0, 0), glm::dvec3(0, Infinity, 0) })
  {
    EXPECT_FALSE(tracer.Trace(bad, { 0, 0, 1 }, 0.0));
    EXPECT_FALSE(tracer.Trace({ 0, 0, 5 }, bad, 0.0));
    EXPECT_FALSE(tracer.Occluded(bad, { 0, 0, 1 }, 0.0));
    EXPECT_FALSE(tracer.Occluded({ 0, 0, 5 }, bad, 0.0));
  }
  EXPECT_FALSE(tracer.Trace({ 0, 0, 5 }, { 0, 0, -1 }, nan));
  EXPECT_FALSE(tracer.Trace({ 0, 0, 5 }, { 0, 0, -1 }, 3.0, 2.0));
}

TEST(TriangleTracer, BytesCountWhatIsHeld)
{
  LitMesh mesh = SphereMesh({}, 1.0, 64);
  const TriangleTracer tracer(mesh);
  const double each = double(tracer.Bytes()) / double(mesh.mesh.triangles.size());
  EXPECT_GT(each, 24 + 12); // points and indices alone: half a point each
  EXPECT_LT(each, 300);
}

TEST(TriangleTracer, BadMeshesAreRefused)
{
  const auto expect = [](LitMesh mesh, std::initializer_list<const char*> words)
  {
    try
    {
      const TriangleTracer tracer(std::move(mesh));
      FAIL() << *words.begin();
    }
    catch (const std::invalid_argument& e)
    {
      for (const char* word : words)
        EXPECT_NE(std::strstr(e.what(), word), nullptr) << e.what();
    }
  };
  LitMesh nan = PlaneMesh(1.0), far = nan, corner = nan, normals = nan, colors = nan;
  nan.mesh.points[2].y = std::nan("");
  far.mesh.points[3].x = Infinity;
  corner.mesh.triangles[1].z = 4;
  normals.normals.resize(3);
  colors.colors.resize(5);
  expect(nan, { "point 2", "finite" });
  expect(far, { "point 3", "finite" });
  expect(corner, { "triangle 1", "point 4", "of 4" });
  expect(normals, { "3 normals", "4 points" });
  expect(colors, { "5 normals or colours", "4 points" });
}

} // namespace
