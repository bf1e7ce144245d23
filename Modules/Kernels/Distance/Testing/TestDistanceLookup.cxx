#include "Distance/BodyDistance.h"
#include "Distance/DistanceLookup.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

namespace
{

using hasp::GridGeometry;
using hasp::GridView;

struct Sampled
{
  GridGeometry grid;
  std::vector<float> samples;

  template <typename Distance>
  Sampled(const GridGeometry& geometry, const Distance& distance) : grid(geometry)
  {
    for (int k = 0; k < grid.dims.z; ++k)
      for (int j = 0; j < grid.dims.y; ++j)
        for (int i = 0; i < grid.dims.x; ++i)
          samples.push_back(float(distance(grid.IndexToWorld({ i, j, k }))));
  }
  GridView<const float> View() const { return { this->samples.data(), this->grid }; }
};

GridGeometry Grid(double spacing, int samples)
{
  GridGeometry grid;
  grid.dims = glm::ivec3(samples);
  grid.spacing = glm::dvec3(spacing);
  grid.origin = glm::dvec3(-0.5 * spacing * (samples - 1));
  return grid;
}

double Ball(const glm::dvec3& p)
{
  return glm::length(p) - 20.0;
}

double Box(const glm::dvec3& p)
{
  const glm::dvec3 q = glm::abs(p) - glm::dvec3(20, 15, 10);
  return glm::length(glm::max(q, glm::dvec3(0.0))) + std::min(std::max({ q.x, q.y, q.z }), 0.0);
}

glm::dmat4 AnyPose()
{
  return glm::rotate(glm::translate(glm::dmat4(1.0), { 3, -2, 5 }), 0.7, glm::dvec3(0.6, 0.0, 0.8));
}

std::vector<double> AnyPlaces(int count, double reach)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-reach, reach);
  std::vector<double> places;
  for (int n = 0; n < 3 * count; ++n)
    places.push_back(any(random));
  return places;
}

TEST(DistanceLookup, BadSizesGridsAndPosesAreRefused)
{
  const Sampled ball(Grid(5, 12), Ball);
  std::vector<double> places(6);
  std::vector<float> found(2);
  const auto refused = [&](const GridView<const float>& view, const glm::dmat4& pose) {
    EXPECT_THROW(hasp::LookUpDistances<double>(view, pose, places, found), std::invalid_argument);
  };
  refused(ball.View(), glm::scale(glm::dmat4(1.0), glm::dvec3(1.001)));
  glm::dmat4 skew(1.0);
  skew[1][0] = 0.01;
  refused(ball.View(), skew);
  glm::dmat4 nowhere(1.0);
  nowhere[3][0] = std::nan("");
  refused(ball.View(), nowhere);
  GridView<const float> flat = ball.View();
  flat.geometry.dims.z = 1;
  refused(flat, glm::dmat4(1.0));
  found.resize(3);
  refused(ball.View(), glm::dmat4(1.0));
}

TEST(DistanceLookup, ALinearDistanceIsExactInAnyGridAndPose)
{
  GridGeometry grid = Grid(2, 30);
  grid.spacing = { 1.0, 2.0, 3.0 };
  const glm::dmat3 turned(glm::rotate(glm::dmat4(1.0), 1.1, glm::dvec3(0, 0.6, 0.8)));
  grid.direction = glm::dmat3(turned[0], -turned[1], turned[2]); // left-handed, too
  grid.origin = grid.direction * glm::dvec3(-14, -29, -43);
  const glm::dvec3 normal = glm::normalize(glm::dvec3(1, 2, -3));
  const Sampled plane(grid, [&](const glm::dvec3& p) { return glm::dot(p, normal) - 1.5; });
  const auto places = AnyPlaces(500, 6);
  std::vector<float> found(500);
  hasp::LookUpDistances<double>(plane.View(), AnyPose(), places, found);
  for (std::size_t n = 0; n < found.size(); ++n)
  {
    const glm::dvec3 world(
      AnyPose() * glm::dvec4(places[3 * n], places[3 * n + 1], places[3 * n + 2], 1.0));
    EXPECT_NEAR(found[n], glm::dot(world, normal) - 1.5, 1e-5);
  }
}

TEST(DistanceLookup, ErrorOnABallAndABoxIsWhatTheHeaderSays)
{
  for (const auto& [name, distance, bound] :
    { std::tuple{ "ball", &Ball, 0.5 * 0.25 / 19.0 + 1e-5 }, { "box", &Box, 0.25 * 0.5 } })
  {
    const Sampled body(Grid(0.5, 121), distance);
    std::vector<double> places;
    for (std::size_t n = 0; places.size() < 60'000; ++n) // near the surface, where it is looked at
    {
      const auto some = AnyPlaces(100'000, 25);
      for (std::size_t m = 0; m + 3 <= some.size() && places.size() < 60'000; m += 3)
        if (std::abs(distance({ some[m], some[m + 1], some[m + 2] })) < 1.0)
          places.insert(
            places.end(), some.begin() + std::ptrdiff_t(m), some.begin() + std::ptrdiff_t(m) + 3);
    }
    std::vector<float> found(places.size() / 3);
    hasp::LookUpDistances<double>(body.View(), glm::dmat4(1.0), places, found);
    double most = 0, square = 0;
    for (std::size_t n = 0; n < found.size(); ++n)
    {
      const double off =
        found[n] - distance({ places[3 * n], places[3 * n + 1], places[3 * n + 2] });
      most = std::max(most, std::abs(off));
      square += off * off;
    }
    std::printf("%s, samples 0.5 mm apart: rms %.4f mm, most %.4f mm\n", name,
      std::sqrt(square / double(found.size())), most);
    EXPECT_LT(most, bound) << name;
  }
}

TEST(DistanceLookup, BeyondTheSamplesItIsNeverTooSmall)
{
  const Sampled ball(Grid(1, 51), Ball); // to 25 mm
  const auto places = AnyPlaces(2000, 80);
  std::vector<float> found(2000);
  hasp::LookUpDistances<double>(ball.View(), glm::dmat4(1.0), places, found);
  for (std::size_t n = 0; n < found.size(); ++n)
  {
    const glm::dvec3 p(places[3 * n], places[3 * n + 1], places[3 * n + 2]);
    const double beyond = glm::distance(p, glm::clamp(p, glm::dvec3(-25.0), glm::dvec3(25.0)));
    EXPECT_GT(found[n], Ball(p) - 0.05);
    EXPECT_LT(found[n], Ball(p) + 2.0 * beyond + 0.6); // 0.6: the ball's middle has an edge
  }
}

TEST(DistanceLookup, PlacesThatAreNoneHaveNoDistance)
{
  const Sampled ball(Grid(5, 12), Ball);
  const std::vector<float> places{ 0, std::numeric_limits<float>::infinity(), 0, 1, 2,
    std::nanf(""), 0, 0, 20 };
  std::vector<float> found(3);
  hasp::LookUpDistances<float>(ball.View(), glm::dmat4(1.0), places, found);
  EXPECT_TRUE(std::isnan(found[0]) && std::isnan(found[1]));
  EXPECT_NEAR(found[2], 0.0, 0.4); // samples 5 mm apart: 25 / (4 * 17)
}

TEST(DistanceLookup, TwoHundredThousandPlacesArePrinted)
{
  const Sampled ball(Grid(0.4, 160), Ball);
  std::vector<float> places;
  for (int n = 0; n < 200'000; ++n) // on a ball, one beside the other, as a mesh has them
  {
    const double z = 1.0 - (n + 0.5) / 100'000.0, r = std::sqrt(1.0 - z * z), a = 0.001 * n;
    for (const double c : { 21 * r * std::cos(a), 21 * r * std::sin(a), 21 * z })
      places.push_back(float(c));
  }
  std::vector<float> found(200'000);
  double least = 1e300;
  for (int n = 0; n < 10; ++n)
  {
    const auto start = std::chrono::steady_clock::now();
    hasp::LookUpDistances<float>(ball.View(), AnyPose(), places, found);
    const std::chrono::duration<double, std::milli> spent =
      std::chrono::steady_clock::now() - start;
    least = std::min(least, spent.count());
  }
  std::printf("200,000 places: %.2f ms\n", least);
}

} // namespace
