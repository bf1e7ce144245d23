// How surfaces give light back: reciprocal, none too much, and sampled as they say.
#include "Light/SobolSequence.h"
#include "Light/SurfaceMaterial.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace
{

using At = hasp::SurfaceScattering::At;
constexpr double Pi = glm::pi<double>();
const glm::dvec3 Up(0, 0, 1);
constexpr std::array<float, 7> Roughnesses{ 0.03F, 0.1F, 0.2F, 0.35F, 0.5F, 0.75F, 1.0F };
constexpr std::array<double, 7> Cosines{ 1.0, 0.9, 0.6, 0.3, 0.15, 0.05, 0.02 };

glm::dvec3 Direction(double cosine, double turn = 0.0)
{
  const double sine = std::sqrt(1.0 - cosine * cosine);
  return { sine * std::cos(turn), sine * std::sin(turn), cosine };
}

struct Named
{
  const char* name;
  hasp::SurfaceMaterial material;
};

/// Of albedo 1, but for the roughness.
std::vector<Named> White(float roughness)
{
  const glm::vec3 one(1.0F);
  return { { "coat", { one, 0.04F, roughness, 0.0F } }, { "coat 0.3", { one, 0.3F, roughness } },
    { "coat 1", { one, 1.0F, roughness } }, { "metal", { one, 0.0F, roughness, 1.0F } },
    { "half metal", { one, 0.04F, roughness, 0.5F } },
    { "half bare metal", { one, 0.0F, roughness, 0.5F } } };
}

/// The integral of Evaluate over directions: of f cos. By points even in the root of the cosine,
/// for what facets give back by many bounces is grazing, and by mirrored directions of facets even
/// in the share of GGX's facets, which Sample does not use; the two weighted against each other by
/// the balance heuristic. So lobes as narrow as 1e-3 and as wide as all are met.
double GivenBack(const At& at, const glm::dvec3& out, double roughness)
{
  constexpr int Side = 64;
  const double a2 = std::pow(roughness, 4);
  const auto facetDensity = [&](const glm::dvec3& in)
  {
    const glm::dvec3 normal = glm::normalize(out + in);
    const double c = normal.z, t = 1.0 - c * c + c * c * a2, met = glm::dot(out, normal);
    return met > 0.0 ? a2 / (Pi * t * t) * c / (4.0 * met) : 0.0;
  };
  double sum = 0.0;
  const auto add = [&](const glm::dvec3& in)
  {
    if (in.z > 0.0)
      sum += at.Evaluate(in).r / (facetDensity(in) + 0.25 / (Pi * std::sqrt(in.z)));
  };
  for (int j = 0; j < Side; ++j)
    for (int i = 0; i < Side; ++i)
    {
      const double u = (j + 0.5) / Side, turn = 2.0 * Pi * (i + 0.5) / Side;
      add(Direction(u * u, turn));
      const glm::dvec3 normal =
        Direction(std::sqrt((1.0 - u) / (1.0 + (a2 - 1.0) * u)), turn + 0.5 * Pi);
      if (const double met = glm::dot(out, normal); met > 0.0)
        add(2.0 * met * normal - out);
    }
  return sum / (Side * Side);
}

/// The mean weight of Sample, and its standard error.
std::pair<double, double> MeanWeight(const At& at, int samples, std::uint32_t seed)
{
  double sum = 0.0, squares = 0.0;
  for (int n = 0; n < samples; ++n)
  {
    hasp::RandomSequence points(seed, n);
    const glm::dvec2 point = points.Next();
    const double weight = at.Sample(points.Next1(), point).weight.r;
    sum += weight / samples;
    squares += weight * weight / samples;
  }
  return { sum, std::sqrt(std::max(0.0, squares - sum * sum) / samples) };
}

TEST(SurfaceMaterial, LightGoesBothWaysAlike)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit;
  int compared = 0;
  for (const float roughness : Roughnesses)
    for (int n = 0; n < 600; ++n)
    {
      static std::vector<hasp::SurfaceScattering> surfaces; // each takes a table
      const glm::vec3 albedo(unit(random), unit(random), unit(random));
      if (n % 60 == 0)
      {
        const auto share = [&]
        { return static_cast<float>(std::clamp(3.0 * unit(random) - 1.0, 0.0, 1.0)); };
        surfaces.clear();
        surfaces.emplace_back(hasp::SurfaceMaterial{ albedo, share(), roughness, share() });
      }
      const hasp::SurfaceScattering& surface = surfaces.front();
      // Narrow lobes would be missed by chance: every other pair is nearly mirrored.
      const glm::dvec3 a = Direction(0.01 + 0.99 * unit(random), 7 * unit(random));
      const glm::dvec3 b =
        n % 2 ? Direction(0.01 + 0.99 * unit(random), 7 * unit(random))
              : glm::normalize(glm::dvec3(-a.x, -a.y, a.z) + 0.002 * glm::dvec3(0.3, 0.4, 0.5));
      const glm::dvec3 there = glm::dvec3(At(surface, albedo, Up, a).Evaluate(b)) / b.z;
      const glm::dvec3 back = glm::dvec3(At(surface, albedo, Up, b).Evaluate(a)) / a.z;
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(there[c], back[c], 2e-5 * (back[c] + 1e-3)) // float's digits, some sums of them
          << roughness << " " << n;
      compared += back.r > 0.0;
    }
  EXPECT_GT(compared, 3000);
}

TEST(SurfaceMaterial, DiffuseWhiteGivesAllBackExactly)
{
  const hasp::SurfaceScattering white({ glm::vec3(1.0F) });
  EXPECT_TRUE(white.Diffuse());
  for (const double cosine : Cosines)
  {
    const At at(white, glm::vec3(1.0F), Up, Direction(cosine));
    EXPECT_EQ(MeanWeight(at, 256, 1).first, 1.0);
    EXPECT_NEAR(GivenBack(at, Direction(cosine), 1.0), 1.0, 1e-3); // of the quadrature's points
    EXPECT_EQ(at.BodyAlbedo(), glm::vec3(1.0F));
    EXPECT_FLOAT_EQ(at.Evaluate(Up).r, 1.0F / glm::pi<float>());
  }
}

class SurfaceFurnace : public testing::TestWithParam<float>
{
};

TEST_P(SurfaceFurnace, WhiteGivesAllBack)
{
  double worst = 0.0;
  for (const Named& one : White(GetParam()))
  {
    const hasp::SurfaceScattering surface(one.material);
    EXPECT_FALSE(surface.Diffuse());
    for (const double cosine : Cosines)
    {
      const glm::dvec3 out = Direction(cosine);
      const double all = GivenBack(At(surface, glm::vec3(1.0F), Up, out), out, GetParam());
      worst = std::max(worst, std::abs(all - 1.0));
      EXPECT_NEAR(all, 1.0, 0.01) << one.name << ", cosine " << cosine;
    }
  }
  RecordProperty("worst", std::to_string(worst));
}

TEST_P(SurfaceFurnace, SamplesOfWhiteGiveAllBack)
{
  for (const Named& one : White(GetParam()))
  {
    const hasp::SurfaceScattering surface(one.material);
    for (const double cosine : Cosines)
    {
      const auto [mean, sigma] =
        MeanWeight(At(surface, glm::vec3(1.0F), Up, Direction(cosine)), 4096, 3);
      EXPECT_LT(sigma, 0.06); // grazing bounces between facets are sampled by the body alone
      EXPECT_NEAR(mean, 1.0, 0.01 + 4.0 * sigma) << one.name << ", cosine " << cosine;
    }
  }
}

TEST_P(SurfaceFurnace, NothingGivesMoreThanItGets)
{
  for (const float albedo : { 0.0F, 0.5F, 0.9F, 1.0F })
    for (const float specular : { 0.0F, 0.04F, 0.5F, 1.0F })
      for (const float metallic : { 0.0F, 0.3F, 1.0F })
      {
        const hasp::SurfaceScattering surface(
          { glm::vec3(albedo), specular, GetParam(), metallic });
        double last = 0.0;
        for (const double cosine : { 1.0, 0.5, 0.1, 0.02 })
        {
          const glm::dvec3 out = Direction(cosine);
          const double all = GivenBack(At(surface, glm::vec3(albedo), Up, out), out, GetParam());
          EXPECT_LE(all, 1.01) << albedo << " " << specular << " " << metallic << " " << cosine;
          EXPECT_GE(all, 0.0);
          last = all;
        }
        if (albedo + specular + metallic == 0.0F)
        {
          EXPECT_EQ(last, 0.0);
        }
      }
}

INSTANTIATE_TEST_SUITE_P(AllRoughnesses, SurfaceFurnace, testing::ValuesIn(Roughnesses),
  [](const auto& info) { return std::to_string(int(std::lround(100 * info.param))); });

TEST(SurfaceMaterial, SampleDensityAndEvaluateAgree)
{
  for (const float roughness : Roughnesses)
    for (const Named& one : White(roughness))
    {
      const hasp::SurfaceScattering surface(one.material);
      const glm::dvec3 normal = glm::normalize(glm::dvec3(0.4, -0.7, 0.2));
      for (const double tilt : { 0.0, 0.8, 1.5 })
      {
        const glm::dvec3 across = glm::normalize(glm::cross(normal, glm::dvec3(0, 0, 1)));
        const glm::dvec3 out = std::cos(tilt) * normal + std::sin(tilt) * across;
        const At at(surface, glm::vec3(1.0F), normal, out);
        for (int n = 0; n < 64; ++n)
        {
          hasp::SobolSequence points(4, n);
          const glm::dvec2 point = points.Next();
          const auto sample = at.Sample(points.Next1(), point);
          ASSERT_NEAR(glm::length(sample.direction), 1.0, 1e-12);
          if (sample.weight == glm::vec3(0.0F))
            continue;
          ASSERT_GT(glm::dot(sample.direction, normal), 0.0);
          // A lobe of alpha 1e-3 turns a direction's last digits into 1e-9 of its density.
          ASSERT_NEAR(at.Density(sample.direction) / sample.density, 1.0, 1e-6);
          const double given = at.Evaluate(sample.direction).r;
          ASSERT_NEAR(sample.weight.r * sample.density, given, 1e-5 * given) << one.name;
          const auto gloss = at.SampleGloss(point);
          if (gloss.weight == glm::vec3(0.0F))
            continue;
          const auto again = at.Gloss(gloss.direction);
          ASSERT_NEAR(again.density / gloss.density, 1.0, 1e-6) << one.name;
          ASSERT_NEAR(again.weight.r, gloss.weight.r, 1e-5 * gloss.weight.r) << one.name;
        }
        // Below the surface there is nothing.
        EXPECT_EQ(at.Evaluate(-normal), glm::vec3(0.0F));
        EXPECT_EQ(at.Density(-normal), 0.0);
        EXPECT_EQ(at.Gloss(-normal).density, 0.0);
      }
    }
}

/// Counts of directions in cells even in the cosine and the turn, against the density's integral.
template <typename Next, typename Density>
void ExpectHistogram(const Next& next, const Density& density, int samples)
{
  constexpr int Rows = 8, Columns = 8, Fine = 24;
  std::array<double, std::size_t(Rows * Columns)> counts{}, expected{};
  for (int n = 0; n < samples; ++n)
  {
    const glm::dvec3 d = next(n);
    if (!(d.z > 0.0))
      continue;
    const double turn = std::atan2(d.y, d.x) / (2 * Pi) + 0.5;
    const int row = std::min(Rows - 1, int(d.z * Rows)),
              column = std::min(Columns - 1, int(turn * Columns));
    counts[std::size_t(row * Columns + column)] += 1.0;
  }
  double all = 0.0;
  for (int j = 0; j < Rows * Fine; ++j)
    for (int i = 0; i < Columns * Fine; ++i)
    {
      const double z = (j + 0.5) / (Rows * Fine),
                   turn = 2 * Pi * ((i + 0.5) / (Columns * Fine) - 0.5);
      const double share = density(Direction(z, turn)) * 2 * Pi / (Rows * Fine * Columns * Fine);
      expected[std::size_t(j / Fine * Columns + i / Fine)] += share * samples;
      all += share;
    }
  EXPECT_LE(all, 1.002);                          // of the quadrature's points
  for (std::size_t n = 0; n < counts.size(); ++n) // 5 sigma of random points; Sobol's are better
    EXPECT_NEAR(counts[n], expected[n], 5.0 * std::sqrt(expected[n] + 1.0) + 0.01 * expected[n])
      << n;
}

TEST(SurfaceMaterial, DirectionsFallAsTheirDensitySays)
{
  for (const float roughness : { 0.5F, 0.75F, 1.0F }) // narrower lobes fall into one cell
    for (const Named& one : White(roughness))
      for (const double cosine : { 0.9, 0.15 })
      {
        SCOPED_TRACE(std::string(one.name) + " " + std::to_string(cosine));
        const hasp::SurfaceScattering surface(one.material);
        const At at(surface, glm::vec3(1.0F), Up, Direction(cosine, 0.4));
        ExpectHistogram(
          [&](int n)
          {
            hasp::RandomSequence points(5, n);
            const glm::dvec2 point = points.Next();
            return at.Sample(points.Next1(), point).direction;
          },
          [&](const glm::dvec3& d) { return at.Density(d); }, 8192);
        ExpectHistogram([&](int n)
          { return at.SampleGloss(hasp::RandomSequence(6, n).Next()).direction; },
          [&](const glm::dvec3& d) { return at.Gloss(d).density; }, 8192);
      }
}

TEST(SurfaceMaterial, GlossAndBodyAreAllThereIs)
{
  // White, from all sides: what the body gives back and what the gloss does. The table of angles
  // is linear between its 33: 1%.
  for (const float roughness : Roughnesses)
    for (const double cosine : Cosines)
    {
      const hasp::SurfaceScattering surface({ glm::vec3(1.0F), 0.04F, roughness, 0.0F });
      const At at(surface, glm::vec3(1.0F), Up, Direction(cosine));
      double gloss = 0.0;
      constexpr int Samples = 1024;
      for (int n = 0; n < Samples; ++n)
        gloss += at.SampleGloss(hasp::SobolSequence(7, n).Next()).weight.r / Samples;
      EXPECT_NEAR(gloss + at.BodyAlbedo().r, 1.0, 0.01) << roughness << " " << cosine;
    }
}

TEST(SurfaceMaterial, DiffuseHasNoGloss)
{
  const hasp::SurfaceScattering surface({ glm::vec3(0.3F) });
  const At at(surface, glm::vec3(0.2F, 0.4F, 0.6F), Up, Direction(0.7));
  EXPECT_EQ(at.SampleGloss({ 0.3, 0.4 }).density, 0.0);
  EXPECT_EQ(at.Gloss(Up).density, 0.0);
  EXPECT_EQ(at.Sample(0.0, { 0.3, 0.4 }).weight, glm::vec3(0.2F, 0.4F, 0.6F)) << "the place's own";
}

TEST(SurfaceMaterial, ErrorsNameValueAndRange)
{
  const auto expect =
    [](hasp::SurfaceMaterial material, const char* what, const char* value, const char* range)
  {
    try
    {
      const hasp::SurfaceScattering surface(material);
      FAIL() << what << " " << value;
    }
    catch (const std::invalid_argument& e)
    {
      const std::string said = e.what();
      EXPECT_NE(said.find(what), std::string::npos) << said;
      EXPECT_NE(said.find(value), std::string::npos) << said;
      EXPECT_NE(said.find(range), std::string::npos) << said;
    }
  };
  expect({ { 0.5F, 1.5F, 0.5F } }, "albedo", "1.5", "[0, 1]");
  expect({ { 0.5F, 0.5F, -0.25F } }, "albedo", "-0.25", "[0, 1]");
  expect({ glm::vec3(std::nanf("")) }, "albedo", "nan", "[0, 1]");
  expect({ glm::vec3(0.5F), 1.25F }, "specular", "1.25", "[0, 1]");
  expect({ glm::vec3(0.5F), 0.04F, 0.02F }, "roughness", "0.02", "[0.03, 1]");
  expect({ glm::vec3(0.5F), 0.04F, 1.5F }, "roughness", "1.5", "[0.03, 1]");
  expect({ glm::vec3(0.5F), 0.04F, 0.5F, -1.0F }, "metallic", "-1.0", "[0, 1]");
}

} // namespace
