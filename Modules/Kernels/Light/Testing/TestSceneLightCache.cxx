// Kept light against closed forms and against paths of each pixel.
#include "Light/Testing/LitPictures.h"

namespace
{

using namespace hasp::testing;
using hasp::LitPicture;
using hasp::LitScene;
using hasp::SceneLightCache;

TEST(SceneLightCache, OpenPlaneIsOpenFromTheFirstFrame)
{
  const hasp::GridGeometry g = CubeAround({}, 10.0, 21);
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.3, -0.2, 0.9));
  for (const auto& body :
    { Body(TracedCells(g, [&](const glm::dvec3& p) { return -glm::dot(p, normal); }), Matt(0.6)),
      Body(PlaneMesh(10.0), Matt(0.6)) })
  {
    const LitScene scene({ body }, {}, Uniform(0.5));
    SceneLightCache cache;
    for (int frame = 0; frame < 3; ++frame)
      for (const auto& request : { Open(1e9), Traced(1), Traced(3) })
      {
        const LitPicture picture =
          LightOf(cache, scene, Camera(glm::dvec3(1.0 * frame, 2, 30), {}, { 50, 41 }), request);
        int seen = 0;
        for (const glm::vec4& pixel : picture)
          if (pixel.a > 0.0F)
          {
            ++seen;
            // Shares are kept in 64ths of what is open and a quarter more, rounded by chance.
            ASSERT_NEAR(pixel.r, 0.3F, request.kind == Kind::Traced ? 4e-3F : 1e-6F) << frame;
          }
        ASSERT_GT(seen, 500);
        ASSERT_GT(cache.Rays(), 0);
      }
  }
}

/// A floor z = 5 and a wall x = 6 that it ends at, seen from above, away from the wall.
struct FloorAndWall
{
  LitScene scene{ { Body(TracedCells({ { 60, 70, 60 }, {}, glm::dvec3(0.5), glm::dmat3(1) },
                           [](const glm::dvec3& p) { return std::max(5.0 - p.z, 6.0 - p.x); }),
                    Matt(1.0)) },
    {}, Uniform(1.0) };
  hasp::PictureView view = Camera({ 15, 17, 28 }, { 15, 17, 5 }, { 48, 48 }, 22.0);

  LitPicture Expected(const std::function<double(double)>& ofDistance) const
  {
    LitPicture picture;
    const hasp::PictureRays rays(this->view);
    for (int n = 0; n < 48 * 48; ++n)
    {
      hasp::CellRay ray;
      rays.Of(glm::dvec2(n % 48, n / 48) + 0.5, ray);
      const auto hit = this->scene.Trace(ray.origin, ray.direction);
      picture.emplace_back(glm::vec3(float(ofDistance(hit->position.x - 6.0))), 1.0F);
    }
    return picture;
  }
};

TEST(SceneLightCache, FloorBesideAWallConvergesToTheClosedForm)
{
  const FloorAndWall of;
  const double reach = 12.0;
  // As CellTracerLight.WallWithinReachMatchesTheClosedForm has it.
  const LitPicture truth = of.Expected(
    [&](double x)
    {
      const double c = std::min(x / reach, 1.0);
      return 1.0 - (std::acos(c) - c * std::sqrt(1 - c * c)) / Pi;
    });
  SceneLightCache cache;
  const double first = ErrorOf(LightOf(cache, of.scene, of.view, Open(reach)), truth);
  const double later = ErrorOf(LightOf(cache, of.scene, of.view, Open(reach), 31), truth);
  const double last = ErrorOf(LightOf(cache, of.scene, of.view, Open(reach), 96), truth);
  RecordProperty("first", std::to_string(first));
  RecordProperty("last", std::to_string(last));
  EXPECT_LT(first, 0.045);
  EXPECT_LT(later, 0.6 * first);
  EXPECT_LT(last, 0.01);
}

void ExpectPaths(const char* name, std::shared_ptr<const hasp::Environment> far)
{
  TwoBalls of;
  of.far = std::move(far);
  const LitScene scene = of.Scene();
  const hasp::PictureView view = BallsView({ 28, 24 });
  const LitPicture truth = PathsOf(scene, view, 3, 192);
  SceneLightCache cache;
  const double first = ErrorOf(LightOf(cache, scene, view, Traced(3)), truth);
  EXPECT_GT(cache.NewPixels(), 300);
  const double later = ErrorOf(LightOf(cache, scene, view, Traced(3), 15), truth);
  EXPECT_EQ(cache.NewPixels(), 0);
  const double last = ErrorOf(LightOf(cache, scene, view, Traced(3), 80), truth);
  testing::Test::RecordProperty(
    name, std::to_string(first) + " " + std::to_string(later) + " " + std::to_string(last));
  // Light of about 0.5. What stays is blur where the balls meet the plane, and the truth's noise.
  EXPECT_LT(first, 0.06);
  EXPECT_LT(later, 0.65 * first);
  EXPECT_LT(last, 0.018);
}

TEST(SceneLightCache, TracedEvenLightBecomesThatOfPaths)
{
  ExpectPaths("uniform", Uniform(1.0));
}

TEST(SceneLightCache, TracedSkylightBecomesThatOfPaths)
{
  ExpectPaths("sky", SoftSky());
}

TEST(SceneLightCache, SunsShadowsAreThoseOfPaths)
{
  TwoBalls of;
  of.far = SunnySky();
  const LitScene scene = of.Scene();
  const hasp::PictureView view = BallsView({ 28, 24 });
  const LitPicture truth = PathsOf(scene, view, 2, 192);
  SceneLightCache cache;
  const double error = ErrorOf(LightOf(cache, scene, view, Traced(2), 80), truth);
  testing::Test::RecordProperty("error", std::to_string(error));
  EXPECT_LT(error, 0.018); // of a mean of about 0.8
}

class SceneLightGloss : public testing::TestWithParam<std::pair<float, float>>
{
};

TEST_P(SceneLightGloss, IsThatOfPaths)
{
  const auto [roughness, metallic] = GetParam();
  TwoBalls of;
  of.far = SoftSky();
  of.material = { glm::vec3(0.7F, 0.5F, 0.3F), 0.04F, roughness, metallic };
  const LitScene scene = of.Scene();
  const hasp::PictureView view = BallsView({ 26, 22 });
  const LitPicture truth = PathsOf(scene, view, 2, 192);
  SceneLightCache cache;
  const double first = ErrorOf(LightOf(cache, scene, view, Traced(2)), truth);
  const double last = ErrorOf(LightOf(cache, scene, view, Traced(2), 80), truth);
  RecordProperty("errors", std::to_string(first) + " " + std::to_string(last));
  EXPECT_LT(last, 0.5 * first);
  // What a reflection meets is taken as diffuse: metal in metal is off.
  EXPECT_LT(last, metallic > 0.0F ? 0.06 : 0.02);
}

INSTANTIATE_TEST_SUITE_P(CoatsAndMetals, SceneLightGloss,
  testing::Values(std::pair(0.2F, 0.0F), std::pair(0.6F, 0.0F), std::pair(0.4F, 1.0F)),
  [](const auto& info)
  {
    return (info.param.second > 0.0F ? "Metal" : "Coat") +
           std::to_string(int(std::lround(100 * info.param.first)));
  });

TEST(SceneLightCache, ViewsWithoutPerspectiveAreLit)
{
  TwoBalls of;
  of.far = SoftSky();
  of.material.specular = 0.04F; // gloss asks where the eye is
  of.lamps.emplace_back();
  const LitScene scene = of.Scene();
  const hasp::PictureView view{ glm::ortho(-12.0, 12.0, -10.0, 10.0, -50.0, 50.0) *
                                  glm::lookAt(
                                    glm::dvec3(20, -30, 25), glm::dvec3(0), glm::dvec3(0, 0, 1)),
    { 25, 21 }, {} };
  const LitPicture truth = PathsOf(scene, view, 2, 192);
  SceneLightCache cache;
  EXPECT_LT(ErrorOf(LightOf(cache, scene, view, Traced(2), 64), truth), 0.026);
}

TEST(SceneLightCache, LampsKeepNothing)
{
  TwoBalls of;
  of.far = SoftSky();
  of.lamps.emplace_back();
  const LitScene scene = of.Scene();
  const hasp::PictureView view = BallsView({ 32, 28 });
  SceneLightCache cache;
  hasp::SceneLightRequest lamps;
  lamps.kind = Kind::Lamps;
  for (int frame = 0; frame < 2; ++frame)
  {
    const LitPicture picture = LightOf(cache, scene, view, lamps);
    EXPECT_EQ(cache.Bytes(), 0);
    EXPECT_EQ(cache.NewPixels(), 0);
    const hasp::PictureRays rays(view);
    int shadowed = 0;
    for (int n = 0; n < 32 * 28; ++n)
    {
      hasp::CellRay ray;
      rays.Of(glm::dvec2(n % 32, n / 32) + 0.5, ray);
      const auto hit = scene.Trace(ray.origin, ray.direction);
      ASSERT_EQ(hit.has_value(), picture[n].a == 1.0F) << n;
      if (!hit)
        continue;
      const bool dark = hit->normal.z <= 0.0 || scene.OccludedFrom(*hit, { 0, 0, 1 });
      shadowed += dark && hit->normal.z > 0.0;
      const glm::dvec3 open = glm::dvec3(of.far->Irradiance(hit->shading)) / Pi;
      const glm::dvec3 expected =
        glm::dvec3(hit->albedo) * (open + (dark ? 0.0 : std::max(0.0, hit->shading.z)));
      ASSERT_LT(glm::distance(glm::dvec3(picture[n]), expected), 1e-5) << n;
    }
    EXPECT_GT(shadowed, 10);
  }
  lamps.shadows = false;
  LightOf(cache, scene, view, lamps);
  EXPECT_EQ(cache.Rays(), 0) << "nothing is between";
  // After kept light, nothing is held either.
  LightOf(cache, scene, view, Traced(2));
  EXPECT_GT(cache.Bytes(), 0);
  LightOf(cache, scene, view, lamps);
  EXPECT_EQ(cache.Bytes(), 0);
}

TEST(SceneLightCache, SmallTableIsStillRight)
{
  TwoBalls of;
  of.far = SoftSky();
  const LitScene scene = of.Scene();
  const hasp::PictureView view = BallsView({ 32, 28 });
  const LitPicture truth = PathsOf(scene, view, 2, 128);
  SceneLightCache cache({ 64 });
  // What has no room is lit by a path of its own: the mean over frames is right, a frame is noisy.
  LitPicture mean(truth.size(), glm::vec4(0.0F));
  constexpr int Frames = 64;
  for (int n = 0; n < Frames; ++n)
  {
    const LitPicture one = LightOf(cache, scene, view, Traced(2));
    for (std::size_t p = 0; p < one.size(); ++p)
    {
      ASSERT_TRUE(one[p].r >= 0.0F && one[p].r < 20.0F);
      mean[p] += one[p] / float(Frames);
    }
  }
  EXPECT_EQ(cache.Bytes(), 64 * 1036 + 32 * 28 * 16) << "the table, and pixels at rest";
  EXPECT_LT(ErrorOf(mean, truth), 0.045);
}

TEST(SceneLightCache, NothingThereIsNothingLit)
{
  const LitScene empty({}, {}, Uniform(1.0));
  TwoBalls of;
  const LitScene scene = of.Scene();
  SceneLightCache cache;
  for (const glm::vec4& pixel : LightOf(cache, empty, BallsView({ 8, 8 }), Traced(1)))
    EXPECT_EQ(pixel, glm::vec4(0.0F));
  const auto away = Camera({ 100, 0, 50 }, { 200, 0, 50 }, { 8, 8 });
  for (const glm::vec4& pixel : LightOf(cache, scene, away, Traced(1)))
    EXPECT_EQ(pixel, glm::vec4(0.0F));
  EXPECT_EQ(cache.Rays(), 0);
  hasp::PictureView none = BallsView({ 8, 8 });
  none.size = { 0, 8 };
  EXPECT_TRUE(LightOf(cache, scene, none, Traced(1)).empty());
}

TEST(SceneLightCache, WhatIsOutOfRangeIsRefused)
{
  const auto settings = [](hasp::SceneLightSettings bad)
  { EXPECT_THROW(SceneLightCache{ bad }, std::invalid_argument); };
  settings({ 32 });
  settings({ 100 });
  settings({ std::size_t(1) << 25 });
  settings({ 64, 0.0 });
  settings({ 64, std::nan("") });
  settings({ 64, std::numeric_limits<double>::infinity() });
  settings({ 64, 1.0, 0.0 });
  settings({ 64, 1.0, 4.5 });
  TwoBalls of;
  const LitScene scene = of.Scene();
  SceneLightCache cache;
  LitPicture picture;
  const auto refused = [&](const hasp::PictureView& view, std::size_t depths,
                         const hasp::SceneLightRequest& request, const char* says)
  {
    try
    {
      const std::vector<float> given(depths, 0.5F);
      cache.Light(scene, view, { given }, request, picture);
      ADD_FAILURE() << says;
    }
    catch (const std::invalid_argument& e)
    {
      EXPECT_NE(std::string(e.what()).find(says), std::string::npos) << e.what();
    }
  };
  const hasp::PictureView view = BallsView({ 8, 8 });
  refused(view, 63, {}, "63");
  refused(view, 0, Open(0.0), "distance");
  refused(view, 0, Open(std::nan("")), "distance");
  refused(view, 0, Traced(0), "bounces");
  hasp::PictureView bad = view;
  bad.size.x = -2;
  refused(bad, 0, {}, "-2");
  bad = view;
  bad.indexToClip = glm::dmat4(0.0);
  EXPECT_THROW(cache.Light(scene, bad, {}, {}, picture), std::invalid_argument);
}

} // namespace
