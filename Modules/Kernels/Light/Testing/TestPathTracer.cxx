// Light by paths against closed forms: white furnaces, a ball on a plane, lamps, and what bounces
// add.
#include "Light/Testing/LightScenes.h"

#include <gtest/gtest.h>

namespace
{

using namespace hasp::testing;
using hasp::LitBody;
using hasp::LitHit;
using hasp::LitScene;
using hasp::PathTracer;
using hasp::RandomSequence;
using hasp::SobolSequence;

LitScene Scene(std::vector<LitBody> bodies, std::shared_ptr<const hasp::Environment> far,
  std::vector<hasp::LitLamp> lamps = {})
{
  return { std::move(bodies), std::move(lamps), std::move(far) };
}

/// A gyroid of cells, 40 mm wide: deep pits, where light bounces often.
std::shared_ptr<const hasp::CellTracer> GyroidCells()
{
  return TracedCells(CubeAround({}, 20.0, 33),
    [](const glm::dvec3& p)
    {
      const glm::dvec3 s = glm::sin(p * (2 * Pi / 17)), c = glm::cos(p * (2 * Pi / 17));
      return s.x * c.y + s.y * c.z + s.z * c.x;
    });
}

/// The mean of what paths bring to pixels of a view of the scene, and its standard error.
Sampled MeanOfView(const LitScene& scene, const hasp::PathTracerSettings& settings, int side,
  int paths, std::uint32_t seed = 1)
{
  const glm::dvec3 middle = 0.5 * (scene.Bounds().low + scene.Bounds().high);
  const double size = scene.Bounds().Size();
  const PathTracer<SobolSequence> tracer(scene, settings);
  Sampled mean;
  for (int n = 0; n < side * side; ++n)
  {
    const glm::dvec2 at = (glm::dvec2(n % side, n / side) + 0.5) / double(side) - 0.5;
    const glm::dvec3 from = middle + size * glm::dvec3(1.3, 0.4 + 0.6 * at.x, 0.3 + 0.6 * at.y);
    const auto hit = scene.Trace(from, glm::normalize(middle - from));
    if (!hit)
      continue;
    for (int k = 0; k < paths; ++k)
    {
      SobolSequence points(seed + n, k);
      mean.Add(tracer.Radiance(*hit, glm::normalize(from - hit->position), points).radiance.r);
    }
  }
  return mean;
}

TEST(PathTracer, ConvexDiffuseGivesItsAlbedoExactly)
{
  for (const float albedo : { 0.0F, 0.3F, 0.8F, 1.0F })
  {
    const LitScene cells = Scene({ Body(ConvexCells(), Matt(albedo)) }, Uniform(1.0)),
                   mesh = Scene({ Body(SphereMesh({}, 8.0), Matt(albedo)) }, Uniform(1.0));
    for (const LitScene* scene : { &cells, &mesh })
      for (const int bounces : { 1, 3 })
      {
        const PathTracer<SobolSequence> tracer(*scene, { bounces });
        for (int n = 0; n < 300; ++n)
        {
          const glm::dvec3 from = scene == &cells ? glm::dvec3(1.2) : glm::dvec3(30, 0, 0);
          const glm::dvec3 to = scene == &cells ? glm::dvec3(5 + n % 17, 4 + n % 23, 30 - n % 19)
                                                : glm::dvec3(0, n % 17 - 8, n % 11 - 5) * 0.8;
          const auto hit = scene->Trace(from, glm::normalize(to - from));
          if (!hit)
            continue;
          SobolSequence points(n, n);
          ASSERT_EQ(
            tracer.Radiance(*hit, -glm::normalize(to - from), points).radiance, glm::vec3(albedo));
        }
      }
  }
}

TEST(PathTracer, SphereOfCellsGivesItsAlbedo)
{
  // Trilinear patches of a ball bulge by a hundredth of a voxel and catch few grazing rays.
  for (const double albedo : { 0.3, 0.8 })
  {
    const LitScene scene = Scene({ Body(SphereCells({}, 8.0), Matt(albedo)) }, Uniform(1.0));
    EXPECT_NEAR(MeanOfView(scene, { 3 }, 12, 32).Mean(), albedo, 0.01 * albedo);
  }
  const LitScene white = Scene({ Body(SphereCells({}, 8.0), Matt(1.0)) }, Uniform(1.0));
  const Sampled mean = MeanOfView(white, { 8 }, 12, 32);
  EXPECT_NEAR(mean.Mean(), 1.0, 1e-3);
}

TEST(PathTracer, ConvexWhiteCoatsAndMetalsGiveAllBack)
{
  for (const float roughness : { 0.05F, 0.3F, 0.6F, 1.0F })
    for (const auto& [specular, metallic] : { std::pair(0.04F, 0.0F), std::pair(0.5F, 0.0F),
           std::pair(0.0F, 1.0F), std::pair(0.04F, 0.5F) })
    {
      const LitScene scene =
        Scene({ Body(SphereMesh({}, 8.0, 32),
                Scattering({ glm::vec3(1.0F), specular, roughness, metallic })) },
          Uniform(1.0));
      const Sampled mean = MeanOfView(scene, { 2 }, 16, 64);
      EXPECT_LT(mean.Sigma(), 0.004);
      EXPECT_NEAR(mean.Mean(), 1.0, 0.01) << roughness << " " << specular << " " << metallic;
    }
}

TEST(PathTracer, ConcaveWhiteGivesAllBack)
{
  // At albedo 1 in light of 1 from all sides every place has radiance 1, however light bounces; 64
  // bounces lose what has not left the pits by then.
  const auto gyroid = GyroidCells();
  const glm::vec3 one(1.0F);
  for (const hasp::SurfaceMaterial& material : { hasp::SurfaceMaterial{ one }, { one, 0.04F, 0.3F },
         { one, 0.04F, 1.0F }, { one, 0.0F, 0.5F, 1.0F } })
  {
    const LitScene scene = Scene({ Body(gyroid, Scattering(material)) }, Uniform(1.0));
    const Sampled mean = MeanOfView(scene, { 64, 2 }, 14, material.metallic > 0.0F ? 192 : 64);
    EXPECT_LT(mean.Sigma(), 0.0045);
    EXPECT_NEAR(mean.Mean(), 1.0, 0.01) << material.roughness << " " << material.metallic;
  }
}

TEST(PathTracer, UnevenLightOfConvexIsItsIrradiance)
{
  // A map that samples are drawn from, so both ways of sampling have to share the light rightly.
  const auto far = Surroundings({ 64, 32 }, [](const glm::dvec3& d)
    { return 0.2 + 3.0 * std::pow(std::max(0.0, d.x), 8) + (d.z > 0.5 ? 1.0 : 0.0); });
  ASSERT_TRUE(far->Samples());
  const LitScene scene = Scene({ Body(SphereMesh({}, 8.0, 24), Matt(0.6)) }, far);
  std::mt19937 random(1);
  for (int n = 0; n < 20; ++n)
  {
    const glm::dvec3 from = 30.0 * RandomDirection(random);
    const auto hit = scene.Trace(from, glm::normalize(-from));
    ASSERT_TRUE(hit);
    const double expected = 0.6 * far->Irradiance(hit->normal).r / Pi;
    const Sampled mean = RadianceOf(scene, { 1 }, *hit, -glm::normalize(from), 1024, n);
    // The table of irradiances is good to 0.5% of Total / 4.
    EXPECT_NEAR(mean.Mean(), expected, 4.0 * mean.Sigma() + 0.005 * far->Total() / 4.0 / Pi) << n;
    EXPECT_LT(mean.Sigma(), 0.02 * expected + 0.01);
  }
}

/// A ball of radius 5 whose lowest point touches the plane z = 0.
constexpr double Radius = 5.0;

LitScene BallOnPlane(
  bool ballOfCells, bool planeOfCells, double albedo, std::shared_ptr<const hasp::Environment> far)
{
  const glm::dvec3 middle(0, 0, Radius);
  // Bits of floats that the lowest sample rounds to must not let it sink: 1e-6.
  LitBody ball = ballOfCells ? Body(SphereCells(middle, Radius, 49), Matt(albedo))
                             : Body(SphereMesh(middle, Radius, 64), Matt(albedo));
  const hasp::GridGeometry g{ { 41, 41, 3 }, { -30, -30, -1.5 }, { 1.5, 1.5, 1.5 }, glm::dmat3(1) };
  LitBody plane = planeOfCells
                    ? Body(TracedCells(g, [](const glm::dvec3& p) { return -p.z; }), Matt(albedo))
                    : Body(PlaneMesh(30.0), Matt(albedo));
  return Scene({ std::move(ball), std::move(plane) }, std::move(far));
}

LitHit OnPlane(const LitScene& scene, double x)
{
  // From below the ball's equator: slanted, so that it is not in the way.
  const auto hit = scene.Trace({ x + 12.0, 0, 3.0 }, glm::normalize(glm::dvec3(-12, 0, -3)));
  EXPECT_TRUE(hit && hit->body == 1);
  return *hit;
}

/// The integral over the upper half of f(direction) cos / pi, by points even in azimuth and in the
/// cosine's square.
template <typename F>
double OverHemisphere(const F& f, int side)
{
  double sum = 0.0;
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i)
    {
      const double u = (j + 0.5) / side, turn = 2 * Pi * (i + 0.5) / side;
      const double r = std::sqrt(u);
      sum += f(glm::dvec3(r * std::cos(turn), r * std::sin(turn), std::sqrt(1 - u)));
    }
  return sum / (side * side);
}

/// Where a ray from a place meets the ball; negative if it does not.
double MeetsBall(const glm::dvec3& from, const glm::dvec3& direction)
{
  const glm::dvec3 to = glm::dvec3(0, 0, Radius) - from;
  const double along = glm::dot(to, direction),
               rest = Radius * Radius - glm::dot(to, to) + along * along;
  return along > 0.0 && rest > 0.0 ? along - std::sqrt(rest) : -1.0;
}

class BallOnPlaneOf : public testing::TestWithParam<std::pair<bool, bool>>
{
};

TEST_P(BallOnPlaneOf, DirectUniformLightIsTheClosedForm)
{
  const LitScene scene = BallOnPlane(GetParam().first, GetParam().second, 0.7, Uniform(1.0));
  // The share of the cosine-weighted sky that a ball wholly above the plane hides is
  // (r / d)^2 cos: with r its radius, d the distance of its middle, cos that of the angle up to it.
  for (const double x : { 5.5, 7.0, 10.0, 15.0 })
  {
    const LitHit hit = OnPlane(scene, x);
    const double d2 = x * x + Radius * Radius,
                 open = 1.0 - Radius * Radius / d2 * (Radius / std::sqrt(d2));
    const Sampled mean = RadianceOf(scene, { 1 }, hit, { 0, 0, 1 }, 4096);
    // Sobol's error is far below a random one's; faceted balls hide 1e-3 less.
    EXPECT_NEAR(mean.Mean(), 0.7 * open, 0.002) << x;
  }
}

TEST_P(BallOnPlaneOf, DirectUnevenLightIsTheIntegral)
{
  // Cosine-shaped light from aside, and its even part.
  const glm::dvec3 main = glm::normalize(glm::dvec3(-1, 0.3, 0.8));
  const auto radiance = [&](const glm::dvec3& d) { return std::max(0.0, glm::dot(d, main)); };
  const LitScene scene =
    BallOnPlane(GetParam().first, GetParam().second, 0.7, Surroundings({ 128, 64 }, radiance));
  for (const double x : { 5.5, 8.0, 15.0 })
  {
    const LitHit hit = OnPlane(scene, x);
    const double expected = 0.7 * OverHemisphere(
                                    [&](const glm::dvec3& d) {
                                      return MeetsBall({ x, 0, 0 }, d) < 0 ? radiance(d) : 0;
                                    },
                                    400);
    const Sampled mean = RadianceOf(scene, { 1 }, hit, { 0, 0, 1 }, 4096);
    EXPECT_NEAR(mean.Mean(), expected, 0.003) << x; // pixels of 3 degrees, faceted balls
  }
}

TEST_P(BallOnPlaneOf, OneBounceIsTheIntegral)
{
  // Two surfaces: what the ball gets from the sky that the plane leaves open, (1 + cos) / 2 of its
  // normal's angle from up for an endless plane, comes back from where the plane's place sees it.
  // This plane ends at 30; the sky below its edge adds up to what a wider one takes away, and the
  // bounds say how much that may be.
  const LitScene scene = BallOnPlane(GetParam().first, GetParam().second, 0.7, Uniform(1.0));
  for (const double x : { 6.0, 9.0 })
  {
    const LitHit hit = OnPlane(scene, x);
    const auto lit = [&](const glm::dvec3& d)
    {
      const double t = MeetsBall({ x, 0, 0 }, d);
      if (t < 0)
        return 1.0;
      const glm::dvec3 at = glm::dvec3(x, 0, 0) + t * d,
                       normal = (at - glm::dvec3(0, 0, Radius)) / Radius;
      double open = 0.0; // of the cosine-weighted sky there, the plane's end counted
      constexpr int Side = 24;
      const glm::dvec3 u = glm::normalize(glm::cross(normal, glm::dvec3(0.3, 1, 0.1))),
                       v = glm::cross(normal, u);
      open = OverHemisphere(
        [&](const glm::dvec3& w)
        {
          const glm::dvec3 way = w.x * u + w.y * v + w.z * normal;
          const glm::dvec3 end = at - way * (at.z / way.z);
          return way.z < 0 && std::max(std::abs(end.x), std::abs(end.y)) < 30 ? 0.0 : 1.0;
        },
        Side);
      return 0.7 * open;
    };
    const double expected = 0.7 * OverHemisphere(lit, 96);
    const Sampled mean = RadianceOf(scene, { 2 }, hit, { 0, 0, 1 }, 8192);
    EXPECT_NEAR(mean.Mean(), expected, 0.004) << x; // of quadratures and facets
  }
}

INSTANTIATE_TEST_SUITE_P(CellsAndMeshes, BallOnPlaneOf,
  testing::Values(
    std::pair(true, true), std::pair(true, false), std::pair(false, true), std::pair(false, false)),
  [](const auto& info)
  {
    return std::string(info.param.first ? "CellsOn" : "MeshOn") +
           (info.param.second ? "Cells" : "Mesh");
  });

TEST(PathTracer, MoreBouncesBringMoreLightBelowTheBound)
{
  const LitScene scene = Scene({ Body(GyroidCells(), Matt(0.9)) }, Uniform(1.0));
  double last = 0.0, sigma = 0.0;
  for (int bounces = 1; bounces <= 8; ++bounces)
  {
    const Sampled mean = MeanOfView(scene, { bounces, 8 }, 12, 32);
    EXPECT_GT(mean.Mean(), last - 3.0 * (sigma + mean.Sigma())) << bounces;
    if (bounces <= 3)
    {
      EXPECT_GT(mean.Mean(), last + 0.01) << bounces;
    }
    last = mean.Mean();
    sigma = mean.Sigma();
    EXPECT_LE(last, 0.9 + 1e-6) << "what an open white place of that albedo has";
  }
}

TEST(PathTracer, RouletteChangesNoMean)
{
  const LitScene scene =
    Scene({ Body(GyroidCells(), Scattering({ glm::vec3(0.7F, 0.5F, 0.2F), 0.04F, 0.4F })) },
      Uniform(1.0));
  const Sampled none = MeanOfView(scene, { 16, 64 }, 12, 96, 5);
  for (const int from : { 1, 2, 4 })
  {
    const Sampled some = MeanOfView(scene, { 16, from }, 12, 96, 7);
    EXPECT_NEAR(some.Mean(), none.Mean(), 4.0 * std::hypot(some.Sigma(), none.Sigma())) << from;
    EXPECT_LT(some.Sigma(), 0.006);
  }
}

TEST(PathTracer, SettingsOutOfRangeAreRefused)
{
  const LitScene scene = Scene({}, Uniform(1.0));
  for (const auto& [settings, value] : { std::pair(hasp::PathTracerSettings{ 0 }, "bounces 0"),
         std::pair(hasp::PathTracerSettings{ 65 }, "bounces 65"),
         std::pair(hasp::PathTracerSettings{ 3, 0 }, "roulette 0") })
    try
    {
      const PathTracer<SobolSequence> tracer(scene, settings);
      ADD_FAILURE() << value;
    }
    catch (const std::invalid_argument& e)
    {
      EXPECT_NE(std::string(e.what()).find(value), std::string::npos) << e.what();
    }
}

TEST(PathTracer, NothingMetIsTheEnvironment)
{
  const auto far = Surroundings({ 16, 8 }, [](const glm::dvec3& d) { return 2.0 + d.z; });
  const LitScene scene = Scene({ Body(SphereMesh({}, 1.0), Matt(0.5)) }, far);
  const PathTracer<RandomSequence> tracer(scene, {});
  RandomSequence points(1, 1);
  const auto sample = tracer.Incoming({ 5, 0, 0 }, { 0, 0, 1 }, points);
  EXPECT_EQ(sample.radiance, far->Radiance({ 0, 0, 1 }));
  EXPECT_EQ(sample.rays, 1);
  EXPECT_GT(tracer.Incoming({ 5, 0, 0 }, { -1, 0, 0 }, points).rays, 1);
}

} // namespace
