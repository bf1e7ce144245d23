#include "Distance/SurfaceElements.h"

#include "Grid/ParallelFor.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr float Least = 0.03F, Most = 0.97F; // outside these the plane is known too poorly

class Extractor
{
public:
  Extractor(const GridGeometry& geometry, std::span<const float> coverage)
    : Geometry(geometry),
      Alpha(coverage)
  {
    for (int n = 0; n < 27; ++n)
    {
      const glm::dvec3 d(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
      this->Gaussian[n] = std::exp(-0.5 * glm::dot(d, d)); // sigma: one voxel
    }
  }

  float At(const glm::ivec3& p) const
  {
    const glm::ivec3 q = glm::clamp(p, glm::ivec3(0), this->Geometry.dims - 1);
    return this
      ->Alpha[(std::size_t(q.z) * this->Geometry.dims.y + q.y) * this->Geometry.dims.x + q.x];
  }
  bool Within(const glm::ivec3& p) const
  {
    return glm::all(glm::greaterThanEqual(p, glm::ivec3(0))) &&
           glm::all(glm::lessThan(p, this->Geometry.dims));
  }

  /// The element of a voxel, if it has one.
  bool Make(const glm::ivec3& p, SurfaceElement& element) const
  {
    const float alpha = this->At(p);
    const glm::dvec3 center = glm::dvec3(p) * this->Geometry.spacing;
    if (alpha > Least && alpha < Most)
    {
      element.normal = this->Normal(p);
      const double d = element.normal == glm::dvec3(0.0)
                         ? 0.0
                         : PlaneDistanceFromCoverage(element.normal, this->Geometry.spacing, alpha);
      element.point = center - d * element.normal;
      return true;
    }
    // Saturated next to saturated of the other kind: the face between them, owned by the inner one.
    if (alpha < Most)
      return false;
    for (int axis = 0; axis < 3; ++axis)
      for (int side = -1; side <= 1; side += 2)
      {
        glm::ivec3 q = p;
        q[axis] += side;
        if (!this->Within(q) || this->At(q) > Least)
          continue;
        glm::dvec3 normal = this->Normal(p);
        if (normal == glm::dvec3(0.0))
          normal[axis] = side;
        element = { center, normal };
        element.point[axis] += 0.5 * side * this->Geometry.spacing[axis];
        return true;
      }
    return false;
  }

  /// Of a voxel that a plane cuts, one neighbour is always clear of the plane.
  bool SaturatedNear(const glm::ivec3& p) const
  {
    for (int n = 0; n < 27; ++n)
      if (const float a = this->At(p + glm::ivec3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1));
          a <= Least || a >= Most)
        return true;
    return false;
  }

private:
  /// Sobel gradient per mm, pointing into the solid.
  glm::dvec3 Gradient(const glm::ivec3& p) const
  {
    constexpr double smooth[3] = { 1, 2, 1 };
    glm::dvec3 g(0.0);
    for (int z = -1; z <= 1; ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
        {
          const double a = this->At(p + glm::ivec3(x, y, z));
          g += a * glm::dvec3(x * smooth[y + 1] * smooth[z + 1], y * smooth[x + 1] * smooth[z + 1],
                     z * smooth[x + 1] * smooth[y + 1]);
        }
    return g / (32.0 * this->Geometry.spacing);
  }

  /// Outward unit normal: one smoothing of the neighbours' normals takes the error of the planes
  /// from 0.05 to below 0.01 voxel. Where they cancel (sheets and specks thinner than a voxel): 0.
  glm::dvec3 Normal(const glm::ivec3& p) const
  {
    glm::dvec3 sum(0.0);
    double weights = 0.0;
    for (int n = 0; n < 27; ++n)
    {
      const glm::ivec3 q = p + glm::ivec3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
      const float alpha = this->At(q);
      if (alpha <= Least || alpha >= Most)
        continue;
      const glm::dvec3 g = this->Gradient(q);
      const double length = glm::length(g);
      if (!(length > 1e-6))
        continue;
      sum += this->Gaussian[n] / length * g;
      weights += this->Gaussian[n];
    }
    if (weights == 0.0)
    {
      sum = this->Gradient(p); // a face between saturated voxels
      weights = glm::length(sum);
    }
    const double length = glm::length(sum);
    return length > 0.1 * weights && length > 0.0 ? -sum / length : glm::dvec3(0.0);
  }

  const GridGeometry& Geometry;
  std::span<const float> Alpha;
  std::array<double, 27> Gaussian{};
};
} // namespace

double PlaneDistanceFromCoverage(const glm::dvec3& normal, const glm::dvec3& sides, double covered)
{
  // Symmetric about the centre: solve for the smaller part, cut off at depth D from the corner.
  const glm::dvec3 reach = glm::abs(normal) * sides;
  const double whole = reach.x + reach.y + reach.z;
  const glm::dvec3 m = glm::max(reach, glm::dvec3(1e-4 * whole));
  const double total = m.x + m.y + m.z;
  const double part = std::clamp(std::min(covered, 1.0 - covered), 0.0, 0.5);
  const auto cube = [](double v) { return v > 0.0 ? v * v * v : 0.0; };
  const auto square = [](double v) { return v > 0.0 ? v * v : 0.0; };
  const double norm = 1.0 / (6.0 * m.x * m.y * m.z);
  double low = 0.0, high = 0.5 * total, depth = 0.5 * total * std::cbrt(2.0 * part);
  for (int n = 0; n < 60 && high - low > 1e-9 * total; ++n)
  {
    double volume = cube(depth), slope = square(depth);
    for (int a = 0; a < 3; ++a)
    {
      volume -= cube(depth - m[a]) - cube(depth - m[a] - m[(a + 1) % 3]);
      slope -= square(depth - m[a]) - square(depth - m[a] - m[(a + 1) % 3]);
    }
    const double excess = volume * norm - part;
    (excess > 0.0 ? high : low) = depth;
    const double next = depth - excess / (3.0 * norm * slope);
    if (std::abs(next - depth) < 1e-10 * total)
      break;
    depth = next > low && next < high ? next : 0.5 * (low + high);
  }
  const double fromCenter = 0.5 * total - depth; // of the plane that cuts off `part`
  return covered <= 0.5 ? fromCenter : -fromCenter;
}

SurfaceElements ExtractSurfaceElements(
  const GridGeometry& geometry, std::span<const float> coverage)
{
  geometry.Validate();
  if (coverage.size() != geometry.Size())
    throw std::invalid_argument("surface elements: " + std::to_string(coverage.size()) +
                                " coverage values for " + std::to_string(geometry.Size()) +
                                " voxels");
  const Extractor extractor(geometry, coverage);
  const std::int64_t nx = geometry.dims.x, ny = geometry.dims.y, nz = geometry.dims.z;
  std::vector<std::vector<std::pair<std::size_t, SurfaceElement>>> perSlice(nz);
  std::atomic<std::size_t> partial{ 0 }, lonely{ 0 };
  ParallelFor(0, nz, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t k = first; k < last; ++k)
        for (std::int64_t j = 0; j < ny; ++j)
          for (std::int64_t i = 0; i < nx; ++i)
          {
            const std::size_t voxel = (k * ny + j) * nx + i;
            if (!(coverage[voxel] > Least))
              continue;
            SurfaceElement element;
            if (extractor.Make(glm::ivec3(i, j, k), element))
              perSlice[k].emplace_back(voxel, element);
            if (coverage[voxel] < Most)
            {
              ++partial;
              lonely += !extractor.SaturatedNear(glm::ivec3(i, j, k));
            }
          }
    });
  if (lonely * 5 > partial)
    throw std::invalid_argument("surface elements: " + std::to_string(lonely) + " of " +
                                std::to_string(partial) +
                                " partial voxels have only partial neighbours; this is a "
                                "blurred image, not coverage (make that with Coverage)");
  SurfaceElements result;
  result.at.assign(coverage.size(), SurfaceElements::None);
  for (const auto& slice : perSlice)
    for (const auto& [voxel, element] : slice)
    {
      result.at[voxel] = static_cast<std::uint32_t>(result.elements.size());
      result.elements.push_back(element);
    }
  return result;
}

} // namespace hasp
