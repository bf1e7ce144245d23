// Bodies of cells and of triangles in one scene, against what is known of each.
#include "Light/Testing/LightScenes.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_inverse.hpp>

#include <cstring>

namespace
{

using namespace hasp::testing;
using hasp::LitBody;
using hasp::LitHit;
using hasp::LitScene;

constexpr double Infinity = std::numeric_limits<double>::infinity();

LitScene Scene(std::vector<LitBody> bodies)
{
  return { std::move(bodies), {}, Uniform(1.0) };
}

struct Pose
{
  const char* name;
  glm::dmat4 matrix;
};

std::vector<Pose> Poses()
{
  const glm::dmat4 one(1.0);
  const glm::dmat4 turned =
    glm::rotate(glm::translate(one, { 100, -50, 30 }), 1.1, glm::normalize(glm::dvec3(1, 2, 3)));
  return { { "none", one }, { "rigid", turned },
    { "mirrored", glm::scale(turned, glm::dvec3(-1, 1, 1)) },
    { "small", glm::scale(turned, glm::dvec3(1e-3)) },
    { "large and flat", glm::scale(turned, glm::dvec3(100, 30, 0.5)) },
    { "very flat", glm::scale(turned, glm::dvec3(1e4, 1e4, 1)) } };
}

/// Rays at a sphere of radius 8 about the origin of a body in a pose, and what they ought to meet.
void ExpectSphere(const LitBody& body, const Pose& pose, double error, double normalError)
{
  SCOPED_TRACE(pose.name);
  const LitScene scene = Scene({ body });
  const glm::dmat4 toBody = glm::inverse(pose.matrix);
  std::mt19937 random(5);
  int hits = 0;
  for (int n = 0; n < 500; ++n)
  {
    // A ray of the body at some part of the sphere, seen in the world.
    const glm::dvec3 from = 30.0 * RandomDirection(random),
                     to = 8.4 * std::cbrt(n / 500.0) * RandomDirection(random);
    const glm::dvec3 origin(pose.matrix * glm::dvec4(from, 1));
    const glm::dvec3 direction =
      (n % 2 ? 1.0 : 3.0) * glm::normalize(glm::dmat3(pose.matrix) * (to - from));
    const glm::dvec3 along = glm::dmat3(toBody) * direction;
    const double a = glm::dot(along, along), b = glm::dot(along, from),
                 rest = b * b - a * (glm::dot(from, from) - 64.0);
    if (std::abs(rest) / a < 4.0) // grazing: 0.1 off the surface is much along the ray
      continue;
    const auto hit = scene.Trace(origin, direction);
    ASSERT_EQ(hit.has_value(), rest > 0.0) << n;
    if (!hit)
      continue;
    ++hits;
    ASSERT_EQ(hit->body, 0);
    const double t = (-b - std::sqrt(rest)) / a;
    ASSERT_NEAR(hit->t * std::sqrt(a), t * std::sqrt(a), 4.0 * error) << n; // of the body's mm
    const glm::dvec3 place(toBody * glm::dvec4(hit->position, 1.0));
    ASSERT_NEAR(glm::length(place), 8.0, error) << n;
    ASSERT_LT(glm::distance(hit->position, origin + hit->t * direction),
      1e-6 * glm::length(glm::dmat3(pose.matrix) * glm::dvec3(8.0)));
    ASSERT_NEAR(glm::length(hit->normal), 1.0, 1e-12);
    ASSERT_NEAR(glm::length(hit->shading), 1.0, 1e-12);
    ASSERT_LT(glm::dot(hit->normal, direction), 0.0) << "the side that the ray came from";
    const glm::dvec3 normal =
      glm::normalize(glm::inverseTranspose(glm::dmat3(pose.matrix)) * glm::normalize(place));
    ASSERT_LT(glm::distance(hit->shading, normal), normalError) << n;
    ASSERT_EQ(hit->albedo, glm::vec3(0.25F));
    // Cut off before it, nothing is there; cut off within, its inside is.
    ASSERT_FALSE(scene.Trace(origin, direction, 0.0, hit->t * 0.999));
    const auto back = scene.Trace(origin, direction, hit->t * 1.001 + 1e-9);
    ASSERT_TRUE(back) << n;
    ASSERT_NEAR(back->t * std::sqrt(a), (-b + std::sqrt(rest)) / a * std::sqrt(a), 4.0 * error);
    ASSERT_LT(glm::dot(back->normal, direction), 0.0);
  }
  EXPECT_GT(hits, 200);
}

TEST(LitScene, CellsAreMetWhereTheirPosePutsThem)
{
  // Samples 0.6 apart: trilinear cells are off a sphere of 8 by 0.6^2 / 8 / 8 and some.
  const auto ball = SphereCells({}, 8.0, 33);
  for (const Pose& pose : Poses())
  {
    const double flat = std::strcmp(pose.name, "large and flat") == 0 ? 60.0 : 1.0; // tilts normals
    ExpectSphere(Body(ball, Matt(0.25), pose.matrix), pose, 0.02, 0.07 * flat);
  }
}

TEST(LitScene, MeshesAreMetWhereTheirPosePutsThem)
{
  // 32 rows: the middle of a side of 0.8 lies 0.02 within the sphere.
  hasp::LitMesh ball = SphereMesh({}, 8.0, 32);
  for (const auto& point : ball.mesh.points)
    ball.normals.emplace_back(glm::normalize(point));
  for (const Pose& pose : Poses())
  {
    const double flat = std::strcmp(pose.name, "large and flat") == 0 ? 60.0 : 1.0;
    ExpectSphere(Body(ball, Matt(0.25), pose.matrix), pose, 0.05, 0.02 * flat);
  }
}

/// Secondary rays from within a closed body: none escapes.
void ExpectClosed(const LitScene& scene, const glm::dvec3& middle, int rays)
{
  std::mt19937 random(6);
  for (int n = 0; n < rays / 8; ++n)
  {
    const auto hit = scene.Trace(middle, RandomDirection(random));
    ASSERT_TRUE(hit) << n;
    for (int k = 0; k < 8; ++k)
    {
      const glm::dvec3 direction = RandomDirection(random, hit->normal);
      ASSERT_TRUE(scene.OccludedFrom(*hit, direction)) << n << ": leaks";
      const auto next = scene.TraceFrom(*hit, direction);
      ASSERT_TRUE(next) << n << ": leaks";
      ASSERT_LT(glm::dot(next->normal, direction), 0.0);
    }
  }
}

/// And from outside a convex one: none is blocked. Returns how many hits there were.
int ExpectConvex(const LitScene& scene, const glm::dvec3& middle, double radius, int rays)
{
  std::mt19937 random(7);
  int hits = 0;
  for (int n = 0; n < rays / 8; ++n)
  {
    const glm::dvec3 from = middle + 3.0 * radius * RandomDirection(random);
    const auto hit = scene.Trace(from, middle + radius * RandomDirection(random) - from);
    if (!hit)
      continue;
    ++hits;
    for (int k = 0; k < 8; ++k)
    {
      const glm::dvec3 direction = RandomDirection(random, hit->normal);
      EXPECT_FALSE(scene.OccludedFrom(*hit, direction)) << n << ": shades itself";
      EXPECT_FALSE(scene.TraceFrom(*hit, direction)) << n << ": shades itself";
      if (testing::Test::HasFailure())
        return hits;
    }
  }
  return hits;
}

TEST(LitScene, NothingLeaksThroughAClosedMesh)
{
  for (const Pose& pose : Poses())
  {
    SCOPED_TRACE(pose.name);
    const LitScene scene = Scene({ Body(SphereMesh({}, 8.0), Matt(0.5), pose.matrix) });
    ExpectClosed(scene, glm::dvec3(pose.matrix[3]), 20'000);
  }
}

TEST(LitScene, NothingShadesItselfOnAConvexMesh)
{
  for (const Pose& pose : Poses())
  {
    SCOPED_TRACE(pose.name);
    const LitScene scene = Scene({ Body(SphereMesh({}, 8.0), Matt(0.5), pose.matrix) });
    const double radius = 0.5 * scene.Bounds().Size() / std::sqrt(3.0);
    EXPECT_GT(ExpectConvex(scene, glm::dvec3(pose.matrix[3]), radius, 20'000), 400);
  }
}

TEST(LitScene, NothingLeaksThroughClosedCells)
{
  const auto ball = SphereCells({}, 8.0, 25);
  for (const Pose& pose : Poses())
  {
    SCOPED_TRACE(pose.name);
    ExpectClosed(Scene({ Body(ball, Matt(0.5), pose.matrix) }), glm::dvec3(pose.matrix[3]), 10'000);
  }
}

TEST(LitScene, NothingShadesItselfOnConvexCells)
{
  const auto convex = ConvexCells();
  for (const Pose& pose : Poses())
  {
    SCOPED_TRACE(pose.name);
    const LitScene scene = Scene({ Body(convex, Matt(0.5), pose.matrix) });
    std::mt19937 random(8);
    std::uniform_real_distribution<double> at(2.0, 32.0);
    int hits = 0;
    for (int n = 0; n < 1500; ++n)
    {
      // From the hollow side, so that it is the outside that is met.
      const double x = at(random), y = at(random), z = at(random);
      const glm::dvec3 from(pose.matrix * glm::dvec4(1.2, 1.2, 1.2, 1.0)),
        to(pose.matrix * glm::dvec4(x, y, z, 1.0));
      const auto hit = scene.Trace(from, glm::normalize(to - from));
      if (!hit)
        continue;
      ++hits;
      for (int k = 0; k < 8; ++k)
      {
        const glm::dvec3 direction = RandomDirection(random, hit->normal);
        ASSERT_FALSE(scene.OccludedFrom(*hit, direction)) << n;
        ASSERT_FALSE(scene.TraceFrom(*hit, direction)) << n;
      }
    }
    EXPECT_GT(hits, 1000);
  }
}

TEST(LitScene, TheNearestOfSeveralIsMet)
{
  // Eight along a line, cells and meshes in turn, in an order that is not theirs.
  const auto ball = SphereCells({}, 2.0, 17);
  std::vector<LitBody> bodies;
  for (const int place : { 3, 7, 0, 5, 1, 6, 2, 4 })
  {
    const glm::dmat4 pose = glm::translate(glm::dmat4(1.0), glm::dvec3(10 * place, 0, 0));
    bodies.push_back(place % 2 ? Body(ball, Matt(0.1 * place), pose)
                               : Body(SphereMesh({}, 2.0, 24), Matt(0.1 * place), pose));
  }
  const LitScene scene = Scene(bodies);
  for (int n = 0; n < 8; ++n)
  {
    const glm::dvec3 from(10 * n - 5, 0.3, 0.2);
    const auto right = scene.Trace(from, { 1, 0, 0 });
    ASSERT_TRUE(right);
    EXPECT_NEAR(right->t, 3.033, 0.02) << n;
    EXPECT_EQ(scene.Bodies()[right->body].bodyToWorld[3].x, 10 * n);
    EXPECT_FLOAT_EQ(right->albedo.r, 0.1F * n);
    const auto left = scene.Trace(from, { -1, 0, 0 });
    ASSERT_EQ(left.has_value(), n > 0);
    // And on from there: the one before it.
    const auto next = scene.TraceFrom(*right, { -1, 0, 0 });
    ASSERT_EQ(next.has_value(), n > 0);
    ASSERT_EQ(scene.OccludedFrom(*right, { -1, 0, 0 }), n > 0);
    if (!next)
      continue;
    EXPECT_EQ(next->body, left->body);
    EXPECT_NEAR(next->t, 2.0 * 3.033, 0.03);
    EXPECT_TRUE(scene.OccludedFrom(*right, { -1, 0, 0 }, 6.1));
    EXPECT_FALSE(scene.OccludedFrom(*right, { -1, 0, 0 }, 6.0)) << "it is farther away";
  }
}

TEST(LitScene, GuideCloseAboveBoneIsMet)
{
  // Bone ends at z = 10, exactly; a plate lies 0.3 mm above it, and one 1e-4 mm.
  const hasp::GridGeometry g{ { 21, 21, 21 }, { -10, -10, 0 }, glm::dvec3(1), glm::dmat3(1) };
  const auto bone = TracedCells(g, [](const glm::dvec3& p) { return 10.0 - p.z; });
  std::mt19937 random(9);
  for (const double gap : { 0.3, 1e-4 })
  {
    const LitScene scene =
      Scene({ Body(bone, Matt(0.5)), Body(PlaneMesh(50.0, 10.0 + gap), Matt(0.2)) });
    for (int n = 0; n < 2000; ++n)
    {
      std::uniform_real_distribution<double> at(-8.0, 8.0);
      const double x = at(random), y = at(random);
      const auto plate = scene.Trace({ x, y, 20 }, { 0, 0, -1 });
      ASSERT_TRUE(plate);
      ASSERT_EQ(plate->body, 1);
      const auto hit = scene.Trace({ x, y, 10.0 + 0.5 * gap }, { 0, 0, -1 });
      ASSERT_TRUE(hit);
      ASSERT_EQ(hit->body, 0);
      const glm::dvec3 up =
        glm::normalize(RandomDirection(random, { 0, 0, 1 }) + glm::dvec3(0, 0, 0.02));
      const auto above = scene.TraceFrom(*hit, up);
      ASSERT_TRUE(above && above->body == 1) << n;
      ASSERT_NEAR(above->t, gap / up.z, 1e-5 * gap / up.z + 1e-9); // cells keep floats
      ASSERT_TRUE(scene.OccludedFrom(*hit, up));
      // From the plate's lower side the bone is near, from its upper side nothing is.
      if (std::max(std::abs(above->position.x), std::abs(above->position.y)) < 9.0)
      {
        const auto below = scene.TraceFrom(*above, { 0, 0, -1 });
        ASSERT_TRUE(below && below->body == 0);
        ASSERT_NEAR(below->t, gap, 1e-5 * gap + 1e-9);
      }
      ASSERT_FALSE(scene.OccludedFrom(*plate, up));
    }
  }
}

TEST(LitScene, FacesThatTouchKeepTheirOrder)
{
  // Two plates in the same plane: the one that a ray leaves never hides behind the other.
  const LitScene scene =
    Scene({ Body(PlaneMesh(5.0, 0.0), Matt(0.5)), Body(PlaneMesh(9.0, 0.0), Matt(0.2)) });
  for (int n = 0; n < 100; ++n)
  {
    const auto hit = scene.Trace({ 0.04 * n, 0.01 * n, 3 }, { 0, 0, -1 });
    ASSERT_TRUE(hit);
    ASSERT_NEAR(hit->t, 3.0, 1e-12);
    ASSERT_FALSE(scene.OccludedFrom(*hit, { 0.6, 0, 0.8 })) << "it is on the side it came from";
  }
}

TEST(LitScene, CameraInsideBoneSeesItsInside)
{
  const LitScene scene = Scene({ Body(SphereCells({}, 8.0), Matt(0.5)) });
  std::mt19937 random(10);
  for (int n = 0; n < 200; ++n)
  {
    const glm::dvec3 from = 6.0 * RandomDirection(random), direction = RandomDirection(random);
    const auto hit = scene.Trace(from, direction);
    ASSERT_TRUE(hit);
    ASSERT_TRUE(hit->cell.fromInside);
    ASSERT_LT(glm::dot(hit->normal, direction), 0.0);
    ASSERT_NEAR(glm::length(hit->position), 8.0, 0.02);
  }
}

TEST(LitScene, RaysWithinAFaceOfABoxAreMet)
{
  // A wall whose edges are the box of all: rays along each of them meet it as others do.
  hasp::LitMesh wall;
  wall.mesh.points = { { -1, 0, -1 }, { 1, 0, -1 }, { 1, 0, 1 }, { -1, 0, 1 }, { -1, 1, -1 },
    { 1, 1, -1 }, { 1, 1, 1 }, { -1, 1, 1 } };
  wall.mesh.triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 4, 5, 6 }, { 4, 6, 7 } };
  const hasp::TriangleTracer tracer(wall);
  const LitScene scene = Scene({ Body(wall, Matt(0.5)) });
  for (const double x : { -1.0, 0.5, 1.0 })
    for (const double z : { -1.0, 0.5, 1.0 })
      EXPECT_EQ(scene.Trace({ x, -5, z }, { 0, 1, 0 }).has_value(),
        tracer.Trace({ x, -5, z }, { 0, 1, 0 }, 0.0).has_value())
        << x << " " << z;
}

TEST(LitScene, EmptyBodiesAndScenesMeetNothing)
{
  const auto none = TracedCells(CubeAround({}, 5.0, 9), [](const glm::dvec3&) { return -1.0; });
  const LitScene empty = Scene({}),
                 scene = Scene({ Body(none, Matt(0.5)), Body(hasp::LitMesh(), Matt(0.5)),
                   Body(SphereMesh({ 20, 0, 0 }, 1.0), Matt(0.5)) });
  EXPECT_FALSE(empty.Trace({ 0, 0, 0 }, { 1, 0, 0 }));
  EXPECT_EQ(empty.Bounds().Size(), 0.0);
  EXPECT_GT(empty.Bounds().low.x, empty.Bounds().high.x);
  EXPECT_EQ(scene.BoxOf(0).Size(), 0.0);
  EXPECT_EQ(scene.BoxOf(1).Size(), 0.0);
  EXPECT_FALSE(scene.Trace({ 0, 0, -9 }, { 0, 0, 1 }));
  const auto hit = scene.Trace({ 0, 0, 0 }, { 1, 0, 0 });
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->body, 2);
  EXPECT_NEAR(scene.Bounds().low.x, 19.0, 1e-12) << "the empty ones take no room";
  EXPECT_FALSE(scene.Trace({ 0, 0, std::nan("") }, { 1, 0, 0 }));
  EXPECT_FALSE(scene.Trace({ 0, 0, 0 }, { Infinity, 0, 0 }));
}

TEST(LitScene, WhatItCannotLightIsRefused)
{
  const auto cells = SphereCells({}, 2.0, 9);
  const auto mesh = std::make_shared<const hasp::TriangleTracer>(SphereMesh({}, 1.0, 6));
  const auto expect = [&](std::vector<LitBody> bodies, std::vector<hasp::LitLamp> lamps,
                        std::shared_ptr<const hasp::Environment> far, const char* says)
  {
    try
    {
      const LitScene scene(std::move(bodies), std::move(lamps), std::move(far));
      ADD_FAILURE() << says;
    }
    catch (const std::invalid_argument& e)
    {
      EXPECT_NE(std::strstr(e.what(), says), nullptr) << e.what();
    }
  };
  const auto matt = Matt(0.5);
  const LitBody good = Body(cells, matt);
  expect({ good, { nullptr, nullptr, glm::dmat4(1), matt } }, {}, Uniform(1), "body 1 must have");
  expect({ { cells, mesh, glm::dmat4(1), matt } }, {}, Uniform(1), "body 0 must have either");
  expect({ { cells, nullptr, glm::dmat4(1), nullptr } }, {}, Uniform(1), "no material");
  expect({ { cells, nullptr, glm::dmat4(0), matt } }, {}, Uniform(1), "body 0 has a matrix");
  expect({ { cells, nullptr, glm::scale(glm::dmat4(1), { 1, 0, 1 }), matt } }, {}, Uniform(1),
    "cannot be inverted");
  glm::dmat4 moved(1.0);
  moved[3].x = std::nan("");
  expect({ { cells, nullptr, moved, matt } }, {}, Uniform(1), "body 0 has a matrix");
  expect({ good }, {}, nullptr, "environment");

  const auto lamp = [&](const std::function<void(hasp::LitLamp&)>& change)
  {
    hasp::LitLamp bad;
    change(bad);
    expect({ good }, { hasp::LitLamp(), bad }, Uniform(1), "lamp 1");
  };
  lamp([](hasp::LitLamp& l) { l.place = glm::dvec4(0.0); });
  lamp([](hasp::LitLamp& l) { l.place.x = std::nan(""); });
  lamp([](hasp::LitLamp& l) { l.place.w = 2.0; });
  lamp([](hasp::LitLamp& l) { l.color.g = -0.5F; });
  lamp([](hasp::LitLamp& l) { l.color.b = std::nanf(""); });
  lamp([](hasp::LitLamp& l) { l.attenuation = glm::vec3(0.0F); });
  lamp([](hasp::LitLamp& l) { l.attenuation = { 2.0F, -1.0F, 0.0F }; });
}

} // namespace
