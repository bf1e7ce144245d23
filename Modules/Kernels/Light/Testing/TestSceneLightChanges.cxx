// What is kept while things change: nothing stale where it matters, nothing lost where it does not.
#include "Light/Testing/LitPictures.h"

namespace
{

using namespace hasp::testing;
using hasp::LitPicture;
using hasp::LitScene;
using hasp::SceneLightCache;

/// Pixels that show the plane, within or beyond so many mm of a place.
std::function<bool(std::size_t)> OnPlane(
  const hasp::PictureView& view, const glm::dvec3& place, double distance, bool within)
{
  return [=](std::size_t n)
  {
    const hasp::PictureRays rays(view);
    hasp::CellRay ray;
    rays.Of(glm::dvec2(n % view.size.x, n / view.size.x) + 0.5, ray);
    const glm::dvec3 at = ray.origin - ray.direction * (ray.origin.z / ray.direction.z);
    return (glm::distance(at, place) < distance) == within;
  };
}

double Largest(const LitPicture& picture)
{
  float most = 0.0F;
  for (const glm::vec4& pixel : picture)
    most = std::max({ most, pixel.r, pixel.g, pixel.b });
  return most;
}

TEST(SceneLightChanges, AMovedBodyLeavesNoOldLightAround)
{
  TwoBalls of;
  of.cellBall = { 6, 0, 3.0 };
  const hasp::PictureView view = BallsView({ 40, 34 });
  std::vector<hasp::LitBody> bodies = of.Bodies();
  SceneLightCache cache;
  LightOf(cache, { bodies, {}, of.far }, view, Traced(2), 64);
  const std::int64_t all = std::int64_t(view.size.x) * view.size.y;
  // The ball of cells goes from the east to the north.
  bodies[1].bodyToWorld = glm::translate(glm::dmat4(1.0), glm::dvec3(2, 8, 3));
  const LitScene moved(bodies, {}, of.far);
  const LitPicture truth = PathsOf(moved, view, 2, 200);
  LightOf(cache, moved, view, Traced(2));
  EXPECT_GT(cache.NewPixels(), 20) << "around it";
  EXPECT_LT(cache.NewPixels(), all / 2) << "far light stayed";
  const LitPicture later = LightOf(cache, moved, view, Traced(2), 31);
  const auto beside = OnPlane(view, { 6, 0, 0 }, 3.0, true);
  EXPECT_LT(ErrorOf(later, truth, beside), 0.025) << "where it stood";
  EXPECT_LT(ErrorOf(later, truth, OnPlane(view, { 2, 8, 0 }, 5.0, true)), 0.045) << "where it is";
  EXPECT_LT(ErrorOf(later, truth), 0.025);
  // Without a change nothing is new.
  LightOf(cache, { bodies, {}, of.far }, view, Traced(2));
  EXPECT_EQ(cache.NewPixels(), 0);
}

TEST(SceneLightChanges, OpennessIsForgottenWithinReachExactly)
{
  TwoBalls of;
  const hasp::PictureView view = BallsView({ 40, 34 });
  std::vector<hasp::LitBody> bodies = of.Bodies();
  const double reach = 3.0;
  SceneLightCache cache;
  LightOf(cache, { bodies, {}, of.far }, view, Open(reach), 16);
  bodies[1].bodyToWorld = glm::translate(glm::dmat4(1.0), glm::dvec3(2, 12, 3.5));
  const LitScene moved(bodies, {}, of.far);
  // A cache that never saw the other place, as long at work.
  SceneLightCache fresh;
  const LitPicture truth = LightOf(fresh, moved, view, Open(reach), 200),
                   picture = LightOf(cache, moved, view, Open(reach), 64);
  EXPECT_LT(ErrorOf(picture, truth), 0.012);
  EXPECT_LT(ErrorOf(picture, truth, OnPlane(view, { 5, 1, 0 }, 3.0, true)), 0.01);
}

TEST(SceneLightChanges, ABodyThatComesAndGoesIsSeenToDoSo)
{
  TwoBalls of;
  const hasp::PictureView view = BallsView({ 32, 28 });
  std::vector<hasp::LitBody> bodies = of.Bodies(), fewer{ bodies[0], bodies[2] };
  const LitScene with(bodies, {}, of.far), without(fewer, {}, of.far);
  SceneLightCache cache;
  LightOf(cache, with, view, Traced(2), 32);
  const LitPicture gone = LightOf(cache, without, view, Traced(2), 32);
  EXPECT_LT(ErrorOf(gone, PathsOf(without, view, 2, 128)), 0.027);
  const LitPicture back = LightOf(cache, with, view, Traced(2), 32);
  EXPECT_LT(ErrorOf(back, PathsOf(with, view, 2, 128)), 0.027);
}

TEST(SceneLightChanges, AnotherIsovalueIsAnotherSurface)
{
  // New cells of the same body: a ball that shrinks from 5 to 3, on a plane 5 below its middle.
  TwoBalls of;
  const hasp::PictureView view = BallsView({ 32, 28 });
  std::vector<hasp::LitBody> bodies = of.Bodies();
  const auto cellsOf = [&](double radius)
  {
    return TracedCells(
      CubeAround({}, 6.5, 27), [&](const glm::dvec3& p) { return radius - glm::length(p); });
  };
  bodies[1].cells = cellsOf(4.5);
  bodies[1].bodyToWorld = glm::translate(glm::dmat4(1.0), glm::dvec3(6, 0, 4.6));
  SceneLightCache cache;
  LightOf(cache, { bodies, {}, of.far }, view, Traced(2), 32);
  bodies[1].cells = cellsOf(2.5);
  const LitScene smaller(bodies, {}, of.far);
  LightOf(cache, smaller, view, Traced(2));
  EXPECT_GT(cache.NewPixels(), 20);
  EXPECT_LT(
    ErrorOf(LightOf(cache, smaller, view, Traced(2), 47), PathsOf(smaller, view, 2, 128)), 0.027);
}

TEST(SceneLightChanges, BlackEnvironmentsAndLampsLeaveNoLight)
{
  // Light that is black from one picture to the next must be, wherever some was kept or added up.
  const hasp::PictureView view = BallsView({ 24, 20 });
  for (const float specular : { 0.0F, 0.04F })
    for (const auto& request : { Traced(2), Open(20.0) })
    {
      TwoBalls of;
      of.material.specular = specular;
      of.material.roughness = 0.4F;
      of.lamps.emplace_back();
      const std::vector<hasp::LitBody> bodies = of.Bodies();
      for (const auto& far : { Uniform(1.0), SoftSky(), SunnySky() })
      {
        SceneLightCache cache;
        EXPECT_GT(Largest(LightOf(cache, { bodies, of.lamps, far }, view, request, 4)), 0.5);
        EXPECT_EQ(Largest(LightOf(cache, { bodies, {}, Uniform(0.0) }, view, request)), 0.0)
          << specular << (request.kind == Kind::Traced ? " traced" : " openness");
      }
    }
}

TEST(SceneLightChanges, LampsAndBouncesThatChangeLeaveNoLight)
{
  TwoBalls of;
  of.lamps.emplace_back();
  of.far = Uniform(0.0);
  const std::vector<hasp::LitBody> bodies = of.Bodies();
  const LitScene lit(bodies, of.lamps, of.far), dark(bodies, {}, of.far);
  const hasp::PictureView view = BallsView({ 24, 20 });
  const LitPicture direct = PathsOf(lit, view, 1, 1); // without noise: one ray a lamp
  SceneLightCache cache;
  const LitPicture bounced = LightOf(cache, lit, view, Traced(3), 16);
  EXPECT_GT(ErrorOf(bounced, direct), 0.01) << "there is light to be forgotten";
  EXPECT_LT(ErrorOf(LightOf(cache, lit, view, Traced(1)), direct), 1e-6);
  LightOf(cache, lit, view, Traced(3), 16);
  EXPECT_EQ(Largest(LightOf(cache, dark, view, Traced(3))), 0.0);
}

TEST(SceneLightChanges, AnotherEnvironmentIsSeenAtOnce)
{
  TwoBalls of;
  of.material = { glm::vec3(0.8F), 0.0F, 0.5F, 1.0F };
  const std::vector<hasp::LitBody> bodies = of.Bodies();
  const hasp::PictureView view = BallsView({ 28, 24 });
  for (const auto& request : { Traced(2), Open(20.0) })
  {
    SceneLightCache cache, fresh;
    LightOf(cache, { bodies, {}, Uniform(1.0) }, view, request, 32);
    const LitScene dimmer(bodies, {}, Uniform(0.25));
    const LitPicture truth = LightOf(fresh, dimmer, view, request, 64);
    EXPECT_LT(ErrorOf(LightOf(cache, dimmer, view, request, 8), truth), 0.03)
      << (request.kind == Kind::Traced ? "traced" : "openness");
  }
}

TEST(SceneLightChanges, AnotherMaterialIsSeenAtOnce)
{
  TwoBalls of;
  std::vector<hasp::LitBody> bodies = of.Bodies();
  const hasp::PictureView view = BallsView({ 28, 24 });
  SceneLightCache cache;
  LightOf(cache, { bodies, {}, of.far }, view, Traced(2), 32);
  for (auto& body : bodies)
    body.material = Matt(0.2);
  const LitScene darker(bodies, {}, of.far);
  const LitPicture truth = PathsOf(darker, view, 2, 128);
  EXPECT_LT(ErrorOf(LightOf(cache, darker, view, Traced(2)), truth), 0.025);
  EXPECT_EQ(cache.NewPixels(), 0) << "aged, not forgotten";
  EXPECT_LT(ErrorOf(LightOf(cache, darker, view, Traced(2), 32), truth), 0.014);
}

TEST(SceneLightChanges, ForgetBeginsAnew)
{
  TwoBalls of;
  const LitScene scene = of.Scene();
  const hasp::PictureView view = BallsView({ 28, 24 });
  SceneLightCache cache;
  LightOf(cache, scene, view, Traced(2));
  const std::int64_t first = cache.NewPixels();
  LightOf(cache, scene, view, Traced(2));
  EXPECT_EQ(cache.NewPixels(), 0);
  cache.Forget();
  LightOf(cache, scene, view, Traced(2));
  EXPECT_EQ(cache.NewPixels(), first);
}

TEST(SceneLightChanges, LightIsKeptWhileTheViewMoves)
{
  TwoBalls of;
  of.far = SoftSky();
  const LitScene scene = of.Scene();
  SceneLightCache cache;
  double fresh = 0.0, moving = 0.0;
  for (int frame = 0; frame < 24; ++frame)
  {
    const hasp::PictureView view = BallsView({ 32, 28 }, frame);
    const LitPicture picture = LightOf(cache, scene, view, Traced(2));
    if (frame == 0)
      fresh = ErrorOf(picture, PathsOf(scene, view, 2, 128));
    else if (frame > 2)
    {
      ASSERT_LT(cache.NewPixels(), 32 * 28 / 8) << frame;
    }
    if (frame == 23)
      moving = ErrorOf(picture, PathsOf(scene, view, 2, 128));
  }
  RecordProperty("fresh", std::to_string(fresh));
  RecordProperty("moving", std::to_string(moving));
  EXPECT_LT(moving, 0.7 * fresh);
}

/// As a depth buffer of 24 bits has them: of the nearest of some bodies.
std::vector<float> DepthsOf(const LitScene& scene, const hasp::PictureView& view)
{
  const hasp::PictureRays rays(view);
  std::vector<float> depths;
  for (int n = 0; n < view.size.x * view.size.y; ++n)
  {
    hasp::CellRay ray;
    rays.Of(glm::dvec2(n % view.size.x, n / view.size.x) + 0.5, ray);
    const auto hit = scene.Trace(ray.origin, ray.direction, ray.tMin, ray.tMax);
    if (!hit)
    {
      depths.push_back(1.0F);
      continue;
    }
    const glm::dvec4 clip = view.indexToClip * glm::dvec4(hit->position, 1.0);
    const double depth = 0.5 + 0.5 * clip.z / clip.w;
    depths.push_back(static_cast<float>(std::round(depth * 16777215.0) / 16777215.0));
  }
  return depths;
}

TEST(SceneLightChanges, DrawnDepthsSayWhatIsSeen)
{
  TwoBalls of;
  of.far = SoftSky();
  const LitScene scene = of.Scene();
  const hasp::PictureView view = BallsView({ 40, 34 });
  std::vector<float> depths = DepthsOf(scene, view);
  hasp::SceneLightRequest lamps;
  lamps.kind = Kind::Lamps; // without noise, so that pictures may be compared
  SceneLightCache cache;
  LitPicture traced, drawn;
  cache.Light(scene, view, {}, lamps, traced);
  cache.Light(scene, view, { depths }, lamps, drawn);
  for (std::size_t n = 0; n < drawn.size(); ++n)
  {
    ASSERT_EQ(drawn[n].a, depths[n] < 1.0F ? 1.0F : 0.0F) << n;
    ASSERT_EQ(drawn[n].a, traced[n].a) << n;
    ASSERT_LT(glm::distance(drawn[n], traced[n]), 1e-5F) << n;
  }
  // Left out where the depth is 1, and where something else was drawn in front.
  for (std::size_t n = 0; n < depths.size(); n += 3)
    depths[n] = n % 2 ? 1.0F : std::max(0.0F, depths[n] - 0.02F);
  for (const auto& request : { lamps, Open(10.0), Traced(2) })
  {
    cache.Light(scene, view, { depths }, request, drawn);
    for (std::size_t n = 0; n < drawn.size(); ++n)
      ASSERT_EQ(drawn[n].a, n % 3 == 0 ? 0.0F : traced[n].a) << n;
  }
}

TEST(SceneLightChanges, ABodyThatIsNotDrawnIsNotLit)
{
  // Drawn without the ball of triangles: where it would be, what lies behind it is lit.
  TwoBalls of;
  const LitScene scene = of.Scene();
  std::vector<hasp::LitBody> drawnBodies = of.Bodies();
  drawnBodies.erase(drawnBodies.begin());
  const LitScene without(drawnBodies, {}, of.far);
  const hasp::PictureView view = BallsView({ 40, 34 });
  SceneLightCache cache, other;
  hasp::SceneLightRequest lamps;
  lamps.kind = Kind::Lamps;
  LitPicture drawn, truth;
  cache.Light(scene, view, { DepthsOf(without, view) }, lamps, drawn);
  other.Light(without, view, {}, lamps, truth);
  for (std::size_t n = 0; n < drawn.size(); ++n)
    ASSERT_LT(glm::distance(drawn[n], truth[n]), 1e-5F) << n;
}

TEST(SceneLightChanges, AnotherDrawingOfTheSameViewIsSeenAtOnce)
{
  // A dark ball is drawn no more, but still there: what pixels added up of it is not what the
  // bright plane behind it reflects.
  TwoBalls of;
  of.far = SoftSky();
  of.material = { glm::vec3(0.8F), 0.0F, 0.5F, 1.0F };
  std::vector<hasp::LitBody> bodies = of.Bodies();
  bodies[0].material = Scattering({ glm::vec3(0.02F), 0.0F, 0.5F, 1.0F });
  const LitScene scene(bodies, {}, of.far), without({ bodies[1], bodies[2] }, {}, of.far);
  const hasp::PictureView view = BallsView({ 40, 34 });
  const std::vector<float> all = DepthsOf(scene, view), some = DepthsOf(without, view);
  SceneLightCache cache, fresh;
  LitPicture picture, truth;
  const auto light =
    [&](SceneLightCache& by, const std::vector<float>& depths, int frames, LitPicture& lit)
  {
    for (int frame = 0; frame < frames; ++frame)
      by.Light(scene, view, { depths }, Traced(2), lit);
  };
  light(cache, all, 32, picture);
  light(cache, some, 16, picture);
  light(fresh, some, 64, truth);
  EXPECT_LT(ErrorOf(picture, truth, [&](std::size_t n) { return some[n] != all[n]; }), 0.1);
}

} // namespace
