// What paths bring on average and at most: lamps, both ways alike, even points against random ones,
// and maps of one bright pixel.
#include "Light/Testing/LightScenes.h"

#include <gtest/gtest.h>

namespace
{

using namespace hasp::testing;
using hasp::LitHit;
using hasp::LitLamp;
using hasp::LitScene;
using hasp::PathTracer;
using hasp::RandomSequence;
using hasp::SobolSequence;

/// A ball 2 above a plane, and one beside it that touches the plane.
std::vector<hasp::LitBody> BallsAbovePlane(const hasp::SurfaceMaterial& material)
{
  const auto surface = Scattering(material);
  return { Body(SphereMesh({ 0, 0, 6 }, 4.0, 24), surface), Body(PlaneMesh(40.0), surface),
    Body(SphereCells({ 7, 2, 3 }, 3.0, 25), surface) };
}

glm::vec3 Lit(const LitLamp& lamp, const LitHit& hit, hasp::SurfaceMaterial material = {})
{
  material.albedo = glm::vec3(1.0F);
  const LitScene scene({ Body(PlaneMesh(50.0), Scattering(material)) }, { lamp }, Uniform(0.0));
  const PathTracer<SobolSequence> tracer(scene, { 1 });
  SobolSequence points(1, 1);
  return tracer.Radiance(hit, { 0, 0, 1 }, points).radiance;
}

LitHit OnPlane(double x = 0.0)
{
  const LitScene scene({ Body(PlaneMesh(50.0), Matt(1.0)) }, {}, Uniform(0.0));
  return *scene.Trace({ x, 0, 5 }, { 0, 0, -1 });
}

TEST(PathTracerLamps, WhiteThatFacesALampShowsItsColour)
{
  LitLamp lamp;
  lamp.color = { 0.9F, 0.5F, 0.2F };
  const auto expect = [](const glm::vec3& value, const glm::vec3& expected)
  {
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(value[c], expected[c], 1e-6F * (1.0F + expected[c]));
  };
  expect(Lit(lamp, OnPlane()), lamp.color);
  lamp.place = { 0, 0, 7, 0 }; // of any length
  expect(Lit(lamp, OnPlane()), lamp.color);
  lamp.place = { 0, std::sqrt(3.0), 1, 0 };
  expect(Lit(lamp, OnPlane()), 0.5F * lamp.color); // Lambert's cosine
  lamp.place = { 0, 1, -1, 0 };
  expect(Lit(lamp, OnPlane()), glm::vec3(0.0F)); // from behind
  lamp.place = { 0, 0, 0, 1 };
  expect(Lit(lamp, OnPlane()), glm::vec3(0.0F)); // on the surface itself
}

TEST(PathTracerLamps, PlacesAttenuationAndConesAreVtks)
{
  LitLamp lamp;
  lamp.color = { 1.0F, 0.5F, 0.25F };
  lamp.place = { 0, 0, 4, 1 };
  const auto red = [&](double x) { return double(Lit(lamp, OnPlane(x)).r); };
  EXPECT_NEAR(red(0), 1.0, 1e-6);
  EXPECT_NEAR(red(3), 0.8, 1e-6); // the cosine: 4 of 5
  lamp.attenuation = { 0.5F, 0.25F, 0.125F };
  EXPECT_NEAR(red(0), 1.0 / (0.5 + 0.25 * 4 + 0.125 * 16), 1e-6);
  EXPECT_NEAR(red(3), 0.8 / (0.5 + 0.25 * 5 + 0.125 * 25), 1e-6);
  EXPECT_NEAR(Lit(lamp, OnPlane(3)).b, 0.25 * 0.8 / (0.5 + 0.25 * 5 + 0.125 * 25), 1e-6);
  lamp.attenuation = { 1.0F, 0.0F, 0.0F };
  lamp.axis = { 0, 0, -1 };
  lamp.leastCosine = 0.79;
  EXPECT_NEAR(red(3), 0.8, 1e-6);
  lamp.exponent = 3.0;
  EXPECT_NEAR(red(0), 1.0, 1e-6);
  EXPECT_NEAR(red(3), 0.8 * std::pow(0.8, 3), 1e-6);
  lamp.leastCosine = 0.81;
  EXPECT_EQ(red(3), 0.0);
  lamp.axis = { 0, 0, 1 };
  EXPECT_EQ(red(0), 0.0) << "it points away";
}

TEST(PathTracerLamps, ShadowsEndWhereTheBallsDo)
{
  // A lamp straight above a ball of radius 4, and one at a place 16 above the plane.
  LitLamp above, near;
  near.place = { 0, 0, 16, 1 };
  for (const bool cells : { false, true })
  {
    std::vector<hasp::LitBody> bodies{ cells ? Body(SphereCells({ 0, 0, 6 }, 4.0, 33), Matt(0.8))
                                             : Body(SphereMesh({ 0, 0, 6 }, 4.0, 32), Matt(0.8)),
      Body(PlaneMesh(60.0), Matt(0.8)) };
    // The cone from 10 above the ball's middle that touches it: sine 4 / 10.
    const double edge = 16.0 * std::tan(std::asin(0.4));
    for (const auto& [lamp, radius] : { std::pair(above, 4.0), std::pair(near, edge) })
    {
      const LitScene scene(bodies, { lamp }, Uniform(0.0));
      const PathTracer<SobolSequence> tracer(scene, { 1 });
      for (const double share : { 0.0, 0.5, 0.97, 1.03, 1.5 })
      {
        const auto hit = scene.Trace({ share * radius, 0, 1.0 }, { 0, 0, -1 }); // below the ball
        ASSERT_TRUE(hit && hit->body == 1);
        SobolSequence points(1, 1);
        const auto sample = tracer.Radiance(*hit, { 0, 0, 1 }, points);
        EXPECT_EQ(sample.radiance.r > 0.0F, share > 1.0) << cells << " " << share;
        EXPECT_EQ(sample.rays, 1) << "no ray of a black environment";
      }
    }
    // A lamp between ball and plane is not hidden by what lies beyond it.
    LitLamp between;
    between.place = { 0, 0, 1, 1 };
    const LitScene scene(bodies, { between }, Uniform(0.0));
    const PathTracer<SobolSequence> tracer(scene, { 1 });
    SobolSequence points(1, 1);
    const auto hit = scene.Trace({ 0, 0, 0.5 }, { 0, 0, -1 });
    EXPECT_NEAR(tracer.Radiance(*hit, { 0, 0, 1 }, points).radiance.r, 0.8, 1e-6);
  }
}

TEST(PathTracerLamps, LampsOfOneBounceMatchTheirIntegral)
{
  // A lamp lights a plane, and that a wall: radiance of the wall is the integral over the plane of
  // albedo^2 color cos cos / (pi d^2), closed for an endless plane seen from a wall upon it: half.
  hasp::LitMesh wall;
  wall.mesh.points = { { -0.5, 0, 0 }, { 0.5, 0, 0 }, { 0.5, 0, 0.5 }, { -0.5, 0, 0.5 } };
  wall.mesh.triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  const LitScene scene(
    { Body(wall, Matt(0.9)), Body(PlaneMesh(1e4), Matt(0.6)) }, { LitLamp() }, Uniform(0.0));
  const auto hit = scene.Trace({ 0, 5, 0.25 }, { 0, -1, 0 });
  ASSERT_TRUE(hit && hit->body == 0);
  const Sampled mean = RadianceOf(scene, { 2, 8 }, *hit, { 0, 1, 0 }, 4096);
  // The wall's own direct light is 0: the lamp is above it, along it. Its shadow is a line.
  EXPECT_NEAR(mean.Mean(), 0.9 * 0.6 * 0.5, 0.004);
  EXPECT_EQ(RadianceOf(scene, { 1 }, *hit, { 0, 1, 0 }, 16).Mean(), 0.0);
}

TEST(PathTracer, LightGoesBothWaysAlike)
{
  // A lamp far away along d seen from e, a picture summed over all that is seen, is what it is with
  // d and e changed about: seen by a camera without perspective, the sum over pixels of radiance
  // for a lamp's irradiance E is E times the area times the f of the whole scene, and that is
  // reciprocal. All bounces up to 3, concave and convex bodies under a coat.
  const LitScene bodies(BallsAbovePlane({ glm::vec3(0.7F), 0.04F, 0.4F }), {}, Uniform(0.0));
  const auto transported = [&](const glm::dvec3& from, const glm::dvec3& towards, int bounces)
  {
    LitLamp lamp;
    lamp.place = glm::dvec4(from, 0.0);
    const LitScene scene(bodies.Bodies(), { lamp }, Uniform(0.0));
    const PathTracer<SobolSequence> tracer(scene, { bounces, 2 });
    const glm::dvec3 u = glm::normalize(glm::cross(towards, glm::dvec3(0.1, 0.2, 1.0))),
                     v = glm::cross(towards, u);
    Sampled mean; // over a disc about the balls, which all of the plane's light that matters meets
    for (int n = 0; n < 150'000; ++n)
    {
      SobolSequence points(3, n);
      const glm::dvec2 at = 120.0 * (points.Next() - 0.5);
      const auto hit = scene.Trace(200.0 * towards + at.x * u + at.y * v, -towards);
      mean.Add(hit ? tracer.Radiance(*hit, towards, points).radiance.r : 0.0);
    }
    return mean;
  };
  const glm::dvec3 d = glm::normalize(glm::dvec3(0.8, 0.1, 0.5)),
                   e = glm::normalize(glm::dvec3(-0.2, 0.6, 1.2));
  for (const int bounces : { 1, 3 })
  {
    const Sampled there = transported(d, e, bounces), back = transported(e, d, bounces);
    // The picture's points are even: 4 sigma of random ones bound it well.
    EXPECT_NEAR(there.Mean(), back.Mean(), 4.0 * std::hypot(there.Sigma(), back.Sigma()));
    EXPECT_LT(there.Sigma(), 0.01 * there.Mean());
    EXPECT_LT(back.Sigma(), 0.01 * back.Mean());
  }
}

TEST(PathTracer, EvenPointsBeatRandomOnes)
{
  const auto far = Surroundings(
    { 32, 16 }, [](const glm::dvec3& d) { return 0.5 + 0.5 * d.z + (d.x > 0.8 ? 2.0 : 0.0); });
  const LitScene scene(BallsAbovePlane({ glm::vec3(0.7F) }), {}, far);
  const auto hit = scene.Trace({ 4.0, -3, 2 }, { 0, 0, -1 });
  ASSERT_TRUE(hit && hit->body == 1);
  const glm::dvec3 eye(0, 0, 1);
  const hasp::PathTracerSettings settings{ 2 };
  const Sampled truth = RadianceOf<SobolSequence>(scene, settings, *hit, eye, 1 << 17, 999);
  constexpr int Seeds = 24;
  const auto errors = [&]<typename Points>(int samples, Sampled& means)
  {
    double sum = 0.0;
    for (int seed = 0; seed < Seeds; ++seed)
    {
      const double mean = RadianceOf<Points>(scene, settings, *hit, eye, samples, seed).Mean();
      means.Add(mean);
      sum += std::pow(mean - truth.Mean(), 2);
    }
    return std::sqrt(sum / Seeds);
  };
  const auto slope = [](double first, double last)
  { return std::log(last / first) / std::log(64.0); };
  Sampled even, random;
  const double sobol16 = errors.operator()<SobolSequence>(16, even),
               sobol256 = errors.operator()<SobolSequence>(256, even),
               sobol1024 = errors.operator()<SobolSequence>(1024, even),
               random16 = errors.operator()<RandomSequence>(16, random),
               random256 = errors.operator()<RandomSequence>(256, random),
               random1024 = errors.operator()<RandomSequence>(1024, random);
  RecordProperty("factor256", std::to_string(random256 / sobol256));
  RecordProperty("sobolSlope", std::to_string(slope(sobol16, sobol1024)));
  RecordProperty("randomSlope", std::to_string(slope(random16, random1024)));
  EXPECT_NEAR(slope(random16, random1024), -0.5, 0.12);
  EXPECT_LT(slope(sobol16, sobol1024), slope(random16, random1024) - 0.1);
  EXPECT_GT(random256 / sobol256, 2.0);
  // Unbiased: the mean over seeds is the truth.
  EXPECT_NEAR(even.Mean(), truth.Mean(), 4.0 * even.Sigma());
  EXPECT_NEAR(random.Mean(), truth.Mean(), 4.0 * random.Sigma());
}

TEST(PathTracer, OneBrightPixelMakesNoFireflies)
{
  // A pixel of a million among ones: 64 x 32 pixels. Bounded, whatever the chance.
  const auto far = Surroundings({ 64, 32 }, [](const glm::dvec3& d)
    { return glm::distance(d, glm::normalize(glm::dvec3(0.3, 0.5, 0.8))) < 0.06 ? 1e6 : 1.0; });
  ASSERT_EQ(far->Brightest(), 1e6);
  const LitScene scene(BallsAbovePlane({ glm::vec3(0.8F) }), {}, far);
  const PathTracer<SobolSequence> tracer(scene, { 3 });
  const double most = tracer.BrightestSample();
  double brightest = 0.0;
  for (const double x : { 20.0, -1.0 }) // in the light, and in the shadow
  {
    const auto hit = scene.Trace({ x, 0, 1.0 }, { 0, 0, -1 });
    Sampled mean;
    for (int n = 0; n < 50'000; ++n)
    {
      SobolSequence points(7, n);
      const glm::vec3 light = tracer.Radiance(*hit, { 0, 0, 1 }, points).radiance;
      ASSERT_TRUE(light.r >= 0.0F && light.r <= most) << n << " " << light.r;
      brightest = std::max(brightest, double(light.r));
      mean.Add(light.r);
    }
    const double open = 0.8 * far->Irradiance({ 0, 0, 1 }).r / Pi;
    if (x > 0)
    {
      EXPECT_NEAR(mean.Mean(), open, 0.05 * open) << "what the balls reflect and hide";
      EXPECT_LT(mean.Sigma(), 0.02 * open);
    }
    else
    {
      EXPECT_LT(mean.Mean(), 0.5 * open);
      EXPECT_GT(mean.Mean(), 0.001 * open);
    }
  }
  EXPECT_GT(brightest, 1e-3 * most) << "the bound says something";
}

TEST(PathTracer, BlackBringsNothingAndCostsNoRay)
{
  for (const auto& black :
    { Uniform(0.0), Surroundings({ 16, 8 }, [](const glm::dvec3&) { return 0.0; }) })
  {
    const LitScene scene(BallsAbovePlane({ glm::vec3(0.8F) }), {}, black);
    const PathTracer<SobolSequence> one(scene, { 1 }), many(scene, { 3 });
    EXPECT_EQ(one.BrightestSample(), 0.0);
    const auto hit = scene.Trace({ 20, 0, 1 }, { 0, 0, -1 });
    for (int n = 0; n < 64; ++n)
    {
      SobolSequence points(1, n);
      const auto direct = one.Radiance(*hit, { 0, 0, 1 }, points);
      EXPECT_EQ(direct.radiance, glm::vec3(0.0F));
      EXPECT_EQ(direct.rays, 0);
      const auto bounced = many.Radiance(*hit, { 0, 0, 1 }, points);
      EXPECT_EQ(bounced.radiance, glm::vec3(0.0F));
      EXPECT_LE(bounced.rays, 2) << "to other surfaces, that lamps may light";
    }
  }
}

TEST(PathTracer, WhiteRadianceIsWhatAWhitePlaceSends)
{
  const auto far =
    Surroundings({ 32, 16 }, [](const glm::dvec3& d) { return 1.5 + d.z + 0.4 * d.x; });
  const auto bodies = BallsAbovePlane({ glm::vec3(0.5F) });
  const auto white = Matt(1.0);
  std::vector<hasp::LitBody> whitePlane = bodies;
  whitePlane[1].material = white;
  const LitScene scene(bodies, {}, far);
  const LitScene direct(whitePlane, {}, far);
  const auto hit = scene.Trace({ 3, 0, 1 }, { 0, 0, -1 });
  const PathTracer<SobolSequence> tracer(scene, { 1 });
  Sampled kept;
  for (int n = 0; n < 2048; ++n)
  {
    SobolSequence points(2, n);
    kept.Add(tracer.WhiteRadiance(*hit, points).radiance.r);
  }
  const auto whiteHit = direct.Trace({ 3, 0, 1 }, { 0, 0, -1 });
  const Sampled own = RadianceOf(direct, { 1 }, *whiteHit, { 0, 0, 1 }, 2048, 5);
  EXPECT_NEAR(kept.Mean(), own.Mean(), 3.0 * std::hypot(kept.Sigma(), own.Sigma()));
  // Lit itself by something else, its surroundings still by the scene's: of one bounce, nothing.
  const hasp::Environment none = hasp::Environment::Uniform(glm::vec3(0.0F));
  SobolSequence points(2, 1);
  EXPECT_EQ(tracer.WhiteRadiance(*hit, points, &none).radiance, glm::vec3(0.0F));
}

} // namespace
