// Light at the edges of what there is: sizes, spacings, one bright pixel, black, a camera inside.
#include "Isosurface/Hemisphere.h"
#include "Light/Testing/LitPictures.h"

namespace
{

using namespace hasp::testing;
using hasp::LitPicture;
using hasp::LitScene;
using hasp::PathTracer;
using hasp::SceneLightCache;
using hasp::SobolSequence;

/// The two balls, all lengths times a scale, somewhere.
struct Scaled
{
  std::vector<hasp::LitBody> bodies;
  hasp::PictureView view;

  Scaled(double scale, const glm::dvec3& place, const glm::ivec2& size)
  {
    TwoBalls of;
    const glm::dmat4 pose = glm::scale(glm::translate(glm::dmat4(1.0), place), glm::dvec3(scale));
    bodies = of.Bodies();
    for (hasp::LitBody& body : bodies)
      body.bodyToWorld = pose * body.bodyToWorld;
    view = BallsView(size);
    view.indexToClip = view.indexToClip * glm::inverse(pose);
  }
};

TEST(LightExtreme, SizeAndPlaceChangeNothing)
{
  const auto far = SoftSky();
  const glm::ivec2 size(28, 24);
  const auto lightOf = [&](const Scaled& of, LitPicture& kept)
  {
    const LitScene scene(of.bodies, { hasp::LitLamp() }, far);
    SceneLightCache cache;
    kept = LightOf(cache, scene, of.view, Traced(2), 32);
    return PathsOf(scene, of.view, 2, 64);
  };
  LitPicture one;
  const LitPicture truth = lightOf({ 1.0, {}, size }, one);
  double mean = 0.0;
  for (const glm::vec4& pixel : truth)
    mean += pixel.r / double(truth.size());
  for (const auto& [scale, place] : { std::pair(1e-3, glm::dvec3(0.0)),
         std::pair(1e4, glm::dvec3(0.0)), std::pair(1.0, glm::dvec3(1e4, -1e4, 1e4)) })
  {
    LitPicture kept;
    const LitPicture paths = lightOf({ scale, place, size }, kept);
    double sum = 0.0, other = 0.0, seen = 0.0, all = 0.0;
    for (std::size_t n = 0; n < truth.size(); ++n) // pixels along edges may be another body's
    {
      sum += paths[n].r / double(truth.size());
      other += kept[n].r / double(truth.size());
      seen += paths[n].a;
      all += truth[n].a;
    }
    EXPECT_NEAR(seen, all, 4) << scale;
    EXPECT_NEAR(sum, mean, 0.01 * mean) << scale;
    EXPECT_NEAR(other, mean, 0.02 * mean) << scale;
  }
}

TEST(LightExtreme, WhatIsMetWhereTheRayBeganIsLitAllTheSame)
{
  // Whole numbers and rays along the grid: hits lie on faces and edges of cells, whose neighbours
  // a ray that leaves meets at once, after no way at all.
  std::mt19937 random(3);
  std::uniform_int_distribution<int> rough(-2, 2);
  const hasp::GridGeometry grid{ glm::ivec3(24), glm::dvec3(0.0), glm::dvec3(1.0),
    glm::dmat3(1.0) };
  const auto cells =
    TracedCells(grid, [&](const glm::dvec3& p) { return 12.0 - p.z + rough(random); });
  const auto coat = Scattering({ glm::vec3(0.8F), 0.04F, 0.4F });
  const LitScene scene({ Body(cells, coat) }, { hasp::LitLamp() }, SoftSky());
  const PathTracer<SobolSequence> tracer(scene, { 4 });
  int met = 0, atOnce = 0;
  for (int y = 1; y < 23; ++y)
    for (int x = 1; x < 23; ++x)
      if (const auto hit = scene.Trace({ x, y, 30.0 }, { 0, 0, -1 }))
        for (std::uint32_t k = 0; k < 64; ++k)
        {
          SobolSequence points(static_cast<std::uint32_t>(24 * y + x), k), same = points;
          const auto next = scene.TraceFrom(*hit, hasp::CosineAround(hit->normal, points.Next()));
          atOnce += next && next->position == hit->position;
          const glm::vec3 light = tracer.Radiance(*hit, { 0, 0, 1 }, points).radiance;
          const glm::vec3 white = tracer.WhiteRadiance(*hit, same).radiance;
          ASSERT_TRUE(glm::dot(light, light) < 1e12F) << x << " " << y << " " << k;
          ASSERT_TRUE(glm::dot(white, white) < 1e12F) << x << " " << y << " " << k;
          ++met;
        }
  EXPECT_GT(met, 20'000);
  EXPECT_GT(atOnce, 10) << "else this tests nothing";
}

TEST(LightExtreme, MeshesAndCellsOfAnySizeNeitherLeakNorShadeThemselves)
{
  std::mt19937 random(1);
  for (const double radius : { 1e-3, 1.0, 1e4 })
    for (const glm::dvec3& middle : { glm::dvec3(0.0), glm::dvec3(1e6, -1e6, 1e6) })
      for (const bool cells : { false, true })
      {
        if (radius < 1.0 && middle != glm::dvec3(0.0))
          continue; // doubles of 1e6 mm know 1e-10: a size of 1e-3 has 7 digits there
        SCOPED_TRACE(std::to_string(radius) + (cells ? " cells" : " mesh"));
        const LitScene scene({ cells ? Body(SphereCells(middle, radius, 21), Matt(0.5))
                                     : Body(SphereMesh(middle, radius), Matt(0.5)) },
          {}, Uniform(1.0));
        for (int n = 0; n < 1500; ++n)
        {
          const glm::dvec3 out = RandomDirection(random);
          const auto inner = scene.Trace(middle, out);
          ASSERT_TRUE(inner);
          const auto outer = scene.Trace(middle + 5.0 * radius * out, -out);
          ASSERT_TRUE(outer);
          for (int k = 0; k < 8; ++k)
          {
            ASSERT_TRUE(scene.OccludedFrom(*inner, RandomDirection(random, inner->normal)));
            if (!cells) // a ball of trilinear patches is convex but for a hundredth of a voxel
            {
              ASSERT_FALSE(scene.OccludedFrom(*outer, RandomDirection(random, outer->normal)));
            }
          }
        }
      }
}

TEST(LightExtreme, VoxelsOf100To1AreLitWell)
{
  for (const glm::dvec3& spacing : { glm::dvec3(1, 1, 0.01), glm::dvec3(0.01, 1, 1) })
  {
    // A floor and a wall in steps of the grid.
    const hasp::GridGeometry g{ glm::ivec3(40), {}, spacing, glm::dmat3(1.0) };
    const LitScene scene(
      { Body(TracedCells(g, [&](const glm::dvec3& p)
               { return std::max(10.3 - p.z / spacing.z, 12.0 - p.x / spacing.x); }),
        Matt(0.8)) },
      {}, Uniform(1.0));
    const glm::dvec3 middle = g.IndexToWorld({ 20, 20, 10 }),
                     way = glm::normalize(glm::dvec3(1, 0.1, 1) / spacing);
    const auto view = Camera(middle + 50.0 * way, middle, { 40, 40 });
    const LitPicture truth = PathsOf(scene, view, 2, 128);
    SceneLightCache cache;
    EXPECT_LT(ErrorOf(LightOf(cache, scene, view, Traced(2), 32), truth), 0.04);
  }
}

TEST(LightExtreme, InsideBoneAllIsDarkOrLitByLampsWithin)
{
  hasp::LitLamp outside, inside;
  inside.place = { 1, 1, 1, 1 };
  const auto body = Body(SphereCells({}, 8.0, 25), Matt(0.5));
  const auto view = Camera({ 2, 0, 0 }, { 8, 3, 1 }, { 20, 20 }, 90.0);
  for (const auto& far : { Uniform(1.0), SunnySky() })
  {
    const LitScene dark({ body }, { outside }, far), lit({ body }, { inside }, far);
    for (const auto& request : { Traced(3), Open(1e9) })
    {
      SceneLightCache cache;
      for (const glm::vec4& pixel : LightOf(cache, dark, view, request, 3))
        ASSERT_EQ(pixel, glm::vec4(0, 0, 0, 1)) << "light leaks in";
    }
    for (const glm::vec4& pixel : PathsOf(dark, view, 3, 4))
      ASSERT_EQ(pixel, glm::vec4(0, 0, 0, 1));
    SceneLightCache cache;
    const LitPicture kept = LightOf(cache, lit, view, Traced(3), 32);
    EXPECT_GT(kept[200].r, 0.5F);
    EXPECT_LT(ErrorOf(kept, PathsOf(lit, view, 3, 96)), 0.04);
  }
}

TEST(LightExtreme, OnePixelOfAMillionLightsNoFirefly)
{
  const auto far = Surroundings({ 64, 32 }, [](const glm::dvec3& d)
    { return glm::distance(d, glm::normalize(glm::dvec3(0.3, 0.5, 0.8))) < 0.06 ? 1e6 : 1.0; });
  TwoBalls of;
  of.far = far;
  const LitScene scene = of.Scene();
  const auto view = BallsView({ 40, 34 });
  const PathTracer<SobolSequence> tracer(scene, { 3 });
  const double most = tracer.BrightestSample();
  for (int n = 0; n < 100; ++n)
  {
    const LitPicture one = PathsOf(scene, view, 3, 1, n);
    for (const glm::vec4& pixel : one)
      for (int c = 0; c < 3; ++c)
        ASSERT_TRUE(pixel[c] >= 0.0F && pixel[c] <= most) << pixel[c];
  }
  SceneLightCache cache;
  for (int frame = 0; frame < 16; ++frame)
    for (const glm::vec4& pixel : LightOf(cache, scene, view, Traced(3)))
      for (int c = 0; c < 3; ++c)
        ASSERT_TRUE(pixel[c] >= 0.0F && pixel[c] <= most) << pixel[c];
}

TEST(LightExtreme, BlackIsBlackWithEveryMaterial)
{
  const auto black = Surroundings({ 16, 8 }, [](const glm::dvec3&) { return 0.0; });
  for (const hasp::SurfaceMaterial& material :
    { hasp::SurfaceMaterial{ glm::vec3(1.0F), 0.04F, 0.03F }, { glm::vec3(1.0F), 0.0F, 1.0F, 1.0F },
      { glm::vec3(0.0F), 1.0F, 0.03F }, { glm::vec3(0.0F) } })
  {
    TwoBalls of;
    of.material = material;
    for (const auto& far : { black, Uniform(0.0) })
    {
      of.far = far;
      SceneLightCache cache;
      for (const auto& request : { Traced(4), Open(20.0) })
        for (const glm::vec4& pixel : LightOf(cache, of.Scene(), BallsView({ 24, 20 }), request, 2))
          ASSERT_EQ(glm::vec3(pixel), glm::vec3(0.0F));
    }
  }
}

TEST(LightExtreme, ManyBouncesAndSharpMetalsStayFinite)
{
  TwoBalls of;
  of.far = SunnySky();
  of.lamps.emplace_back();
  for (const float metallic : { 0.0F, 0.5F, 1.0F })
  {
    of.material = { glm::vec3(1.0F), 0.5F, 0.03F, metallic };
    const LitScene scene = of.Scene();
    for (const glm::vec4& pixel : PathsOf(scene, BallsView({ 32, 28 }), 64, 16))
      ASSERT_TRUE(std::isfinite(pixel.r + pixel.g + pixel.b) && pixel.r >= 0.0F);
    SceneLightCache cache;
    for (int frame = 0; frame < 4; ++frame)
      for (const glm::vec4& pixel : LightOf(cache, scene, BallsView({ 32, 28 }), Traced(64)))
        ASSERT_TRUE(std::isfinite(pixel.r + pixel.g + pixel.b) && pixel.r >= 0.0F);
  }
}

TEST(LightExtreme, SliversAndHolesAreLit)
{
  // Triangles as thin as doubles tell, among good ones, seen from close and far.
  hasp::LitMesh mesh = SphereMesh({}, 8.0, 12);
  std::mt19937 random(3);
  for (int n = 0; n < 200; ++n)
  {
    const auto first = static_cast<std::uint32_t>(mesh.mesh.points.size());
    const glm::dvec3 a = 9.0 * RandomDirection(random), b = a + RandomDirection(random);
    mesh.mesh.points.insert(mesh.mesh.points.end(),
      { a, b, 0.5 * (a + b) + std::pow(10.0, -double(n % 17)) * RandomDirection(random) });
    mesh.mesh.triangles.push_back({ first, first + 1, first + 2 });
  }
  const LitScene scene({ Body(mesh, Scattering({ glm::vec3(0.8F), 0.04F, 0.3F })) }, {}, SoftSky());
  for (const double distance : { 12.0, 1e4 })
  {
    const auto view = Camera({ distance, 0.1, 0 }, {}, { 64, 64 }, distance < 100 ? 80.0 : 0.1);
    for (const glm::vec4& pixel : PathsOf(scene, view, 3, 8))
      ASSERT_TRUE(std::isfinite(pixel.r) && pixel.r >= 0.0F);
  }
}

} // namespace
