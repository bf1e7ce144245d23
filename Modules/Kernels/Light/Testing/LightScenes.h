#pragma once
// Bodies, environments and views for light, and means of what paths bring.
#include "Isosurface/ActiveCells.h"
#include "Light/PathTracer.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <functional>
#include <random>

namespace hasp::testing
{

constexpr double Pi = glm::pi<double>();
using Field = std::function<double(const glm::dvec3&)>;

/// The cells of a field given at world positions, > 0 inside.
inline std::shared_ptr<const CellTracer> TracedCells(const GridGeometry& g, const Field& field)
{
  std::vector<float> samples;
  samples.reserve(g.Size());
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i)
        samples.push_back(static_cast<float>(field(g.IndexToWorld({ i, j, k }))));
  const AnyGridView grid = GridView<const float>{ samples.data(), g };
  return std::make_shared<const CellTracer>(
    std::make_shared<const ClusteredCells>(ExtractActiveCells(grid, MinMaxBlocks(grid), 0.0)));
}

/// A cube of samples around a place.
inline GridGeometry CubeAround(const glm::dvec3& middle, double halfSide, int samples)
{
  return { glm::ivec3(samples), middle - halfSide, glm::dvec3(2.0 * halfSide / (samples - 1)),
    glm::dmat3(1.0) };
}

inline std::shared_ptr<const CellTracer> SphereCells(
  const glm::dvec3& middle, double radius, int samples = 33)
{
  return TracedCells(CubeAround(middle, 1.2 * radius, samples),
    [&](const glm::dvec3& p) { return radius - glm::distance(p, middle); });
}

/// {xyz >= 1728} within [1, 33]^3: convex to the last digit, for xyz is trilinear and floats hold
/// it. Scale 2^n keeps all digits.
inline std::shared_ptr<const CellTracer> ConvexCells(double scale = 1.0)
{
  return TracedCells({ glm::ivec3(33), glm::dvec3(scale), glm::dvec3(scale), glm::dmat3(1.0) },
    [&](const glm::dvec3& p) { return p.x * p.y * p.z / (scale * scale * scale) - 1728.0; });
}

/// A ball of quads of latitude and longitude, each flat, so that it is convex.
inline LitMesh SphereMesh(const glm::dvec3& middle, double radius, int rows = 16)
{
  LitMesh ball;
  const int around = 2 * rows;
  for (int row = 0; row <= rows; ++row)
    for (int n = 0; n < (row == 0 || row == rows ? 1 : around); ++n)
    {
      const double a = Pi * row / rows, b = 2.0 * Pi * n / around;
      ball.mesh.points.push_back(middle + radius * glm::dvec3(std::sin(a) * std::cos(b),
                                                     std::sin(a) * std::sin(b), std::cos(a)));
    }
  const auto at = [&](int row, int n) -> std::uint32_t
  {
    if (row == 0)
      return 0;
    return row == rows ? 1 + (rows - 1) * around : 1 + (row - 1) * around + n % around;
  };
  for (int row = 0; row < rows; ++row)
    for (int n = 0; n < around; ++n)
    {
      if (row < rows - 1)
        ball.mesh.triangles.push_back({ at(row, n), at(row + 1, n), at(row + 1, n + 1) });
      if (row > 0)
        ball.mesh.triangles.push_back({ at(row, n), at(row + 1, n + 1), at(row, n + 1) });
    }
  return ball;
}

/// Two triangles at a height, from -half to half in x and y.
inline LitMesh PlaneMesh(double half, double z = 0.0)
{
  LitMesh plane;
  plane.mesh.points = { { -half, -half, z }, { half, -half, z }, { half, half, z },
    { -half, half, z } };
  plane.mesh.triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  return plane;
}

inline std::shared_ptr<const SurfaceScattering> Scattering(const SurfaceMaterial& material)
{
  return std::make_shared<const SurfaceScattering>(material);
}

inline std::shared_ptr<const SurfaceScattering> Matt(double albedo)
{
  return Scattering({ glm::vec3(static_cast<float>(albedo)) });
}

inline LitBody Body(std::shared_ptr<const CellTracer> cells,
  std::shared_ptr<const SurfaceScattering> material, const glm::dmat4& bodyToWorld = glm::dmat4(1))
{
  return { std::move(cells), nullptr, bodyToWorld, std::move(material) };
}

inline LitBody Body(LitMesh mesh, std::shared_ptr<const SurfaceScattering> material,
  const glm::dmat4& bodyToWorld = glm::dmat4(1))
{
  return { nullptr, std::make_shared<const TriangleTracer>(std::move(mesh)), bodyToWorld,
    std::move(material) };
}

inline std::shared_ptr<const Environment> Uniform(double radiance)
{
  return std::make_shared<const Environment>(
    Environment::Uniform(glm::vec3(static_cast<float>(radiance))));
}

/// A map with up +z of a function of the direction.
inline std::shared_ptr<const Environment> Surroundings(
  const glm::ivec2& size, const std::function<double(const glm::dvec3&)>& radiance)
{
  EnvironmentMap map{ size, {} };
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
    {
      const double a = Pi * (y + 0.5) / size.y, b = 2.0 * Pi * ((x + 0.5) / size.x - 0.5);
      map.pixels.emplace_back(static_cast<float>(
        radiance({ std::sin(a) * std::sin(b), std::sin(a) * std::cos(b), std::cos(a) })));
    }
  return std::make_shared<const Environment>(std::move(map));
}

/// A camera in the world.
inline PictureView Camera(
  const glm::dvec3& eye, const glm::dvec3& to, const glm::ivec2& size, double degrees = 40.0)
{
  const double far = glm::distance(eye, to);
  const glm::dvec3 up =
    std::abs(to.z - eye.z) > 0.9 * far ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
  return { glm::perspective(
             glm::radians(degrees), double(size.x) / size.y, 1e-3 * far, 10.0 * far) *
             glm::lookAt(eye, to, up),
    size, {} };
}

/// Of unit length, even over the sphere.
template <typename Engine>
glm::dvec3 RandomDirection(Engine& random)
{
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random);
  return glm::normalize(glm::dvec3(x, y, z));
}

/// The same, on the side of a normal.
template <typename Engine>
glm::dvec3 RandomDirection(Engine& random, const glm::dvec3& normal)
{
  const glm::dvec3 d = RandomDirection(random);
  return glm::dot(d, normal) < 0.0 ? -d : d;
}

/// A mean and its standard error.
struct Sampled
{
  double sum = 0.0, squares = 0.0;
  int count = 0;

  void Add(double value)
  {
    this->sum += value;
    this->squares += value * value;
    ++this->count;
  }
  double Mean() const { return this->sum / this->count; }
  double Sigma() const
  {
    const double variance = this->squares / this->count - this->Mean() * this->Mean();
    return std::sqrt(std::max(0.0, variance) / this->count);
  }
};

/// Red of what so many paths bring from a hit towards an eye.
template <typename Points = SobolSequence>
Sampled RadianceOf(const LitScene& scene, const PathTracerSettings& settings, const LitHit& hit,
  const glm::dvec3& towardsEye, int paths, std::uint32_t seed = 1)
{
  const PathTracer<Points> tracer(scene, settings);
  Sampled mean;
  for (int n = 0; n < paths; ++n)
  {
    Points points(seed, n);
    mean.Add(tracer.Radiance(hit, towardsEye, points).radiance.r);
  }
  return mean;
}

} // namespace hasp::testing
