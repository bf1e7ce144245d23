#include "Grid/Phantom.h"
#include "Grid/PhantomScene.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace
{

using glm::dvec3;
using hasp::GridGeometry;
using hasp::PhantomSettings;
using Samples = std::vector<std::int16_t>;

/// Everything that a sample can depend on.
PhantomSettings AllFaults()
{
  PhantomSettings s;
  s.anatomy = hasp::PhantomAnatomy::HeadAndFibula;
  s.noiseHU = 20.0;
  s.grain = true;
  s.blurMm = { 0.5, 0.6, 0.8 };
  s.sliceMm = 1.5;
  s.metal.on = true;
  s.coneBeam.on = true;
  s.fieldRadiusMm = 90.0;
  return s;
}

/// Grids that a scanner, or a test of a reader, may make: turned, flipped, flat, coarse, tiny.
std::vector<GridGeometry> Grids()
{
  const double c = std::cos(0.4), q = std::sin(0.4);
  return { { { 23, 21, 29 }, { -70, -100, -110 }, { 7.1, 8.3, 6.1 } },
    { { 25, 21, 17 }, { 50, -60, -100 }, { 6.1, 7.3, 9.0 }, { c, q, 0, q, -c, 0, 0, 0, 1 } },
    { { 90, 40, 3 }, { 10, -90, -84 }, { 0.3, 0.3, 3.0 } },
    { { 1, 1, 1 }, { 0, -88, 0 }, { 1, 1, 1 } },
    { { 40, 1, 50 }, { -70, 0, -110 }, { 3.5, 3.5, 3.6 } },
    { { 5, 5, 5 }, { -2e5, -2e5, -2e5 }, { 1e5, 1e5, 1e5 } } };
}

TEST(PhantomScanner, WrongSlabsAreRefused)
{
  const GridGeometry g{ { 4, 4, 4 }, {}, { 1, 1, 1 } };
  Samples samples(32);
  EXPECT_THROW(hasp::SamplePhantomSlab(g, {}, 2, 5, samples), std::invalid_argument);
  EXPECT_THROW(hasp::SamplePhantomSlab(g, {}, -1, 1, samples), std::invalid_argument);
  EXPECT_THROW(hasp::SamplePhantomSlab(g, {}, 2, 1, samples), std::invalid_argument);
  EXPECT_THROW(hasp::SamplePhantomSlab(g, {}, 0, 1, samples), std::invalid_argument);
  EXPECT_THROW(
    hasp::SamplePhantomSlab({ { 4, 0, 4 }, {}, { 1, 1, 1 } }, {}, 0, 0, {}), std::invalid_argument);
}

TEST(PhantomScanner, BoxesAndSlabsChangeNoSample)
{
  for (const PhantomSettings& s : { PhantomSettings(), AllFaults() })
    for (const GridGeometry& g : Grids())
    {
      Samples plain(g.Size()), slabs(g.Size());
      hasp::SamplePhantomPlainly(g, s, 0, g.dims.z, plain);
      const std::size_t slice = std::size_t(g.dims.x) * g.dims.y;
      for (int k = 0; k < g.dims.z; k += 11)
      {
        const int last = std::min(k + 11, g.dims.z);
        hasp::SamplePhantomSlab(
          g, s, k, last, std::span(slabs).subspan(slice * k, slice * (last - k)));
      }
      EXPECT_EQ(plain, slabs) << g.dims.x;
      EXPECT_EQ(plain, hasp::SamplePhantom(g, s)) << g.dims.x;
    }
}

TEST(PhantomScanner, ProgressRisesAndCancels)
{
  const GridGeometry g{ { 8, 8, 100 }, { 0, 0, -50 }, { 1, 1, 1 } };
  Samples samples(g.Size());
  std::vector<double> shares;
  hasp::SamplePhantomSlab(g, {}, 0, 100, samples,
    [&](double share)
    {
      shares.push_back(share);
      return true;
    });
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_GT(shares.size(), 4u);
  EXPECT_EQ(shares.back(), 1.0);
  int calls = 0;
  EXPECT_THROW(hasp::SamplePhantomSlab(g, {}, 0, 100, samples, [&](double) { return ++calls < 3; }),
    hasp::Cancelled);
  EXPECT_EQ(calls, 3);
}

TEST(PhantomScanner, TissuesHaveTheirValues)
{
  PhantomSettings s;
  s.anatomy = hasp::PhantomAnatomy::HeadAndFibula;
  const auto at = [&](const dvec3& p) {
    return hasp::SamplePhantom({ { 1, 1, 1 }, p, { 1, 1, 1 } }, s).at(0);
  };
  EXPECT_EQ(at({ 0, 0, 95 }), -1000) << "air";
  EXPECT_EQ(at({ 0, 0, 89 }), 40) << "scalp";
  EXPECT_EQ(at({ 0, 0, 85 }), 1000) << "outer table";
  EXPECT_EQ(at({ 0, 0, 82.5 }), 500) << "diploe";
  EXPECT_EQ(at({ 0, 0, 80 }), 1000) << "inner table";
  EXPECT_EQ(at({ 0, 0, 60 }), 40) << "brain";
  EXPECT_EQ(at(hasp::DefectOf(s).center - 3.0 * hasp::DefectOf(s).outward), 40) << "defect";
  EXPECT_EQ(at({ 0, -72, -42 }), -1000) << "nose";
  EXPECT_EQ(at({ 32, -78, -18 }), 40) << "orbit";
  EXPECT_EQ(at({ 0, -80, -96 }), 300) << "marrow of the mandible";
  EXPECT_EQ(at({ 0, -80 - 4.5, -96 }), 1000) << "cortex of the mandible";
  EXPECT_EQ(at({ 150, -5, 0 }), -30) << "canal of the fibula";
  for (const hasp::PhantomLandmark& mark : hasp::PhantomLandmarks(s))
    if (mark.name == "incisor 11")
    {
      EXPECT_EQ(at(mark.point + dvec3(0, 0, 0.6)), 2800) << "enamel";
      EXPECT_EQ(at(mark.point + dvec3(0, 0, 9.0)), 1700) << "root";
    }
}

/// A low-discrepancy point in the unit cube (the R3 sequence), as offsets of a Gaussian and a box.
dvec3 Spread(int n, const PhantomSettings& s)
{
  constexpr double G = 1.2207440846057596; // its powers fill the cube evenly
  const auto part = [&](int power) { return std::fmod(0.5 + n / std::pow(G, power), 1.0); };
  const auto normal = [](double share) // Newton on the normal distribution
  {
    double x = 0.0;
    for (int k = 0; k < 60; ++k)
      x += std::clamp((share - 0.5 * std::erfc(-x / std::sqrt(2.0))) * std::sqrt(2.0 * M_PI) *
                        std::exp(0.5 * x * x),
        -1.0, 1.0);
    return x;
  };
  return s.blurMm * dvec3(normal(part(1)), normal(part(2)), normal(part(3))) +
         dvec3(0.0, 0.0, s.sliceMm * (std::fmod(0.5 + n * 0.7548776662466927, 1.0) - 0.5));
}

struct BlurError
{
  double rms = 0.0, most = 0.0; ///< HU
};

/// The response against an average over the point spread, at random points near bone.
BlurError ErrorOfBlur(const PhantomSettings& s, int points, int spread)
{
  PhantomSettings sharp = s;
  sharp.blurMm = dvec3(0.0);
  sharp.sliceMm = 0.0;
  sharp.edgeMm = 1e-6;
  const hasp::PhantomScene blurred(s), exact(sharp);
  std::vector<dvec3> offsets;
  for (int n = 0; n < spread; ++n)
    offsets.push_back(Spread(n, s));
  const hasp::AnalyticSolid bone = hasp::PhantomSolid(s);
  const hasp::Box box = bone.Bounds();
  std::mt19937 random(13);
  std::uniform_real_distribution<double> any(0, 1);
  BlurError error;
  for (int n = 0; n < points;)
  {
    const dvec3 p = box.low + (box.high - box.low) * dvec3(any(random), any(random), any(random));
    if (std::abs(bone.Bound(p).mm) > 1.0)
      continue;
    const hasp::PhantomScene near = exact.Near(p, 8.0);
    double sum = 0.0;
    for (const dvec3& offset : offsets)
      sum += near.Value(p + offset);
    const double wrong = std::abs(blurred.Value(p) - sum / spread);
    error.rms += wrong * wrong / points;
    error.most = std::max(error.most, wrong);
    ++n;
  }
  error.rms = std::sqrt(error.rms);
  return error;
}

TEST(PhantomScanner, BlurOfAFlatSurfaceIsExact)
{
  PhantomSettings s;
  s.blurMm = { 0.7, 0.7, 0.7 };
  s.sliceMm = 2.0;
  const hasp::SurfaceStep step(s);
  for (const dvec3& normal :
    { dvec3(1, 0, 0), dvec3(0, 0, 1), glm::normalize(dvec3(1, 2, 3)), dvec3(0.6, 0, 0.8) })
    for (double depth = -4.0; depth <= 4.0; depth += 0.25)
    {
      double share = 0.0; // 40,000 points of the spread: 1e-3 of a step
      constexpr int Points = 40000;
      static const std::vector<dvec3> Offsets = [&]
      {
        std::vector<dvec3> offsets;
        for (int n = 0; n < Points; ++n)
          offsets.push_back(Spread(n, s));
        return offsets;
      }();
      for (const dvec3& offset : Offsets)
        share += depth - glm::dot(offset, normal) > 0.0;
      ASSERT_NEAR(step(depth, normal), share / Points, 2e-3) << depth;
    }
  EXPECT_EQ(step(step.reachMm, { 1, 0, 0 }), 1.0);
  EXPECT_EQ(step(-step.reachMm, { 1, 0, 0 }), 0.0);
}

TEST(PhantomScanner, ErrorOfBlurAtCurvedAndThinBoneIsAsStated)
{
  for (const auto& [sigma, slice, rms] :
    { std::tuple(0.3, 0.0, 18.0), std::tuple(0.6, 0.6, 60.0), std::tuple(1.0, 2.0, 95.0) })
  {
    PhantomSettings s;
    s.blurMm = dvec3(sigma);
    s.sliceMm = slice;
    const BlurError error = ErrorOfBlur(s, 150, 600);
    std::printf("blur %.1f mm, slice %.1f mm: error rms %.1f HU, largest %.0f HU\n", sigma, slice,
      error.rms, error.most);
    EXPECT_LT(error.rms, rms) << sigma;
  }
}

/// Mean, deviation and correlation of neighbours of uniform soft tissue.
struct NoiseFigures
{
  double mean, deviation, neighbours;
};
NoiseFigures Measure(PhantomSettings s)
{
  const GridGeometry brain{ { 40, 40, 10 }, { -10, -10, 20 }, { 0.5, 0.5, 0.5 } };
  const Samples a = hasp::SamplePhantom(brain, s);
  double sum = 0, squares = 0, products = 0;
  for (std::size_t n = 0; n + 1 < a.size(); ++n)
  {
    sum += a[n] - s.softHU;
    squares += (a[n] - s.softHU) * (a[n] - s.softHU);
    products += (a[n] - s.softHU) * (a[n + 1] - s.softHU);
  }
  const double count = a.size() - 1.0;
  return { sum / count, std::sqrt(squares / count), products / squares };
}

TEST(PhantomScanner, GrainCorrelatesNeighboursAndKeepsTheSpread)
{
  PhantomSettings s;
  s.noiseHU = 25.0;
  // 16000 draws: standard errors are 0.2 HU, 0.14 HU and 0.008; five of each. Grain has fewer
  // independent draws: by (1 + 2 * (2/3)^2 + 2 * (1/6)^2)^2 = 3.8, so twice the errors.
  const NoiseFigures white = Measure(s);
  EXPECT_NEAR(white.mean, 0.0, 1.0);
  EXPECT_NEAR(white.deviation, 25.0, 0.7);
  EXPECT_NEAR(white.neighbours, 0.0, 0.04);
  s.grain = true;
  const NoiseFigures grain = Measure(s);
  EXPECT_NEAR(grain.mean, 0.0, 4.0); // means add up correlations: 16 / 6 times the error
  EXPECT_NEAR(grain.deviation, 25.0, 1.4);
  EXPECT_NEAR(grain.neighbours, 2.0 / 3.0, 0.08); // (1 2 1) * (1 2 1) at a shift of one
}

TEST(PhantomScanner, MetalMakesABandBetweenTheCrownsAndFadesAway)
{
  PhantomSettings s, clean;
  s.metal.on = true;
  const hasp::PhantomShapes shapes = hasp::MakePhantomShapes(s);
  ASSERT_EQ(shapes.metal.size(), 2u);
  EXPECT_LT(shapes.metal[0].a.x * shapes.metal[1].a.x, 0.0) << "one on either side";
  const auto at = [](const PhantomSettings& which, const dvec3& p) {
    return hasp::SamplePhantom({ { 1, 1, 1 }, p, { 1, 1, 1 } }, which).at(0);
  };
  const auto middle = [&](std::size_t n) { return 0.5 * (shapes.metal[n].a + shapes.metal[n].b); };
  EXPECT_NEAR(at(s, middle(0)), 8000, 200) << "rays of the other crown";
  const dvec3 between = 0.5 * (middle(0) + middle(1));
  EXPECT_LT(at(s, between), at(clean, between) - 200);
  const dvec3 above(0, 0, 45); // nine times sliceMm
  EXPECT_EQ(at(s, between + above), at(clean, between + above));
  // Rays: bright and dark on a ring around a crown, weaker on a wider one.
  const auto swing = [&](double radius)
  {
    int low = 32767, high = -32768;
    for (double angle = 0.0; angle < 6.28; angle += 0.05)
    {
      const dvec3 p = middle(1) + radius * dvec3(std::cos(angle), std::sin(angle), 0.0);
      const int change = at(s, p) - at(clean, p);
      low = std::min(low, change);
      high = std::max(high, change);
    }
    return high - low;
  };
  EXPECT_GT(swing(8.0), 400);
  EXPECT_LT(swing(90.0), 0.4 * swing(8.0));
  s.seed = 2;
  EXPECT_NE(at(s, between + dvec3(3, 3, 0)), at(AllFaults(), between + dvec3(3, 3, 0)));
}

TEST(PhantomScanner, ConeBeamCupsScalesAndCuts)
{
  PhantomSettings s;
  s.coneBeam.on = true;
  s.coneBeam.cupRadiusMm = 60.0;
  s.fieldRadiusMm = 70.0;
  const auto at = [&](const dvec3& p) {
    return hasp::SamplePhantom({ { 1, 1, 1 }, p, { 1, 1, 1 } }, s).at(0);
  };
  const hasp::ConeBeamModel& m = s.coneBeam;
  const auto grey = [&](double hu, double share)
  { return std::round(m.scale * ((hu + 1000.0) * share - 1000.0) + m.offset); };
  EXPECT_EQ(at({ 0, 0, 50 }), grey(40, 1.0 - m.cupping)) << "brain on the axis";
  EXPECT_EQ(at({ 0, 30, 50 }), grey(40, 1.0 - 0.75 * m.cupping)) << "half way out";
  EXPECT_EQ(at({ 0, 61, 0 }), grey(40, 1.0)) << "beyond the cup";
  EXPECT_EQ(at({ 0, 86, 0 }), grey(-1000, 1.0)) << "bone outside the field is not seen";
}

TEST(PhantomScanner, GridsOfASizeHoldTheSameBox)
{
  const GridGeometry fine = hasp::PhantomGridOfSize({ 512, 512, 512 });
  EXPECT_EQ(fine.dims, glm::ivec3(512));
  const GridGeometry largest = hasp::PhantomGridOfSize({ 2048, 2048, 2048 });
  EXPECT_EQ(largest.Size(), std::size_t(1) << 33);
  const dvec3 last = fine.IndexToWorld({ 511, 511, 511 });
  EXPECT_LT(glm::length(last - largest.IndexToWorld({ 2047, 2047, 2047 })), 1e-9);
  // A slice in the middle of what memory would not hold.
  Samples slice(std::size_t(2048) * 2048);
  hasp::SamplePhantomSlab(largest, {}, 1200, 1201, slice);
  EXPECT_EQ(slice.front(), -1000);
  EXPECT_EQ(*std::max_element(slice.begin(), slice.end()), 1000);
}

} // namespace
