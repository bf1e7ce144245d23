#include "Distance/CoverageDistance.h"

#include "Distance/EuclideanDistance.h"
#include "Distance/SurfaceElements.h"
#include "Grid/ParallelFor.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hasp
{

namespace
{
constexpr double BandVoxels = 4.0;   // least squares within, discs beyond
constexpr double DiscVoxels = 0.75;  // elements lie less than a voxel apart: discs overlap
constexpr double KernelVoxels = 1.7; // where a neighbour's weight falls to zero
constexpr double DoubtVoxels = 0.25; // farther apart than this, both answers straddle an edge

/// Distance of one voxel from the elements near its nearest seed.
class Evaluator
{
public:
  Evaluator(const GridGeometry& geometry, const SurfaceElements& surface)
    : Geometry(geometry),
      Surface(surface),
      PerVoxel(1.0 / geometry.spacing),
      Voxel(std::min({ geometry.spacing.x, geometry.spacing.y, geometry.spacing.z }))
  {
  }

  /// Signed mm; `inside` decides the sign away from the surface.
  double operator()(const glm::dvec3& x, std::size_t seed, bool inside) const
  {
    Neighbours near;
    this->Gather(seed, near);
    const SurfaceElement* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (int n = 0; n < near.count; ++n)
      if (const double d = this->SquaredToDisc(x, *near.element[n]); d < least)
      {
        least = d;
        best = near.element[n];
      }
    least = std::sqrt(least);
    const double disc = inside ? -least : least;
    if (best->normal == glm::dvec3(0.0))
      return disc;
    const double facing = glm::dot(best->normal, x - best->point);
    if (least > BandVoxels * this->Voxel)
      return disc;
    const double fine = this->LeastSquares(x, *best, facing, near);
    const double signedDisc = std::copysign(least, least < this->Voxel ? facing : disc);
    return std::abs(fine - signedDisc) < DoubtVoxels * this->Voxel ? fine : signedDisc;
  }

private:
  struct Neighbours
  {
    const SurfaceElement* element[27];
    int count = 0;
  };

  void Gather(std::size_t seed, Neighbours& near) const
  {
    const std::size_t row = this->Geometry.dims.x, slice = row * this->Geometry.dims.y;
    const glm::ivec3 c(seed % row, seed / row % this->Geometry.dims.y, seed / slice);
    const glm::ivec3 low = glm::max(c - 1, glm::ivec3(0));
    const glm::ivec3 high = glm::min(c + 1, this->Geometry.dims - 1);
    for (int k = low.z; k <= high.z; ++k)
      for (int j = low.y; j <= high.y; ++j)
        for (int i = low.x; i <= high.x; ++i)
          if (const auto id = this->Surface.at[k * slice + j * row + i];
              id != SurfaceElements::None)
            near.element[near.count++] = &this->Surface.elements[id];
  }

  /// Squared, mm^2: what is compared 27 times a voxel needs no root.
  double SquaredToDisc(const glm::dvec3& x, const SurfaceElement& e) const
  {
    const glm::dvec3 v = x - e.point;
    const double height = glm::dot(v, e.normal);
    const glm::dvec3 lateral = v - height * e.normal, scaled = lateral * this->PerVoxel;
    const double voxels = glm::dot(scaled, scaled);
    const double radius = e.normal == glm::dvec3(0.0) ? 0.0 : DiscVoxels;
    if (voxels <= radius * radius)
      return height * height;
    const double beyond = 1.0 - radius / std::sqrt(voxels); // share of the way outside the disc
    return height * height + glm::dot(lateral, lateral) * beyond * beyond;
  }

  /// Implicit moving least squares around the foot point f. The mean of n_q and the local normal
  /// m, (n_q + m)/2 . (f - p_q), is exact on spheres, so averaging adds no curvature bias.
  double LeastSquares(
    const glm::dvec3& x, const SurfaceElement& best, double facing, const Neighbours& near) const
  {
    glm::dvec3 m = best.normal, f = x - facing * m;
    double distance = facing;
    for (int iteration = 0; iteration < 2; ++iteration)
    {
      double weight[27], sum = 0.0, residual = 0.0;
      glm::dvec3 mean(0.0);
      for (int n = 0; n < near.count; ++n)
      {
        const glm::dvec3 v = (f - near.element[n]->point) * (this->PerVoxel / KernelVoxels);
        const double w = std::max(0.0, 1.0 - glm::dot(v, v));
        weight[n] = w * w * w;
        sum += weight[n];
        mean += weight[n] * near.element[n]->normal;
      }
      const double length = glm::length(mean);
      if (!(length > 0.1 * sum))
        return facing;
      m = mean / length;
      for (int n = 0; n < near.count; ++n)
        residual +=
          weight[n] * 0.5 * glm::dot(near.element[n]->normal + m, f - near.element[n]->point);
      distance = glm::dot(m, x - f) + residual / sum;
      f = x - distance * m;
    }
    return distance;
  }

  const GridGeometry& Geometry;
  const SurfaceElements& Surface;
  glm::dvec3 PerVoxel;
  double Voxel;
};
} // namespace

std::vector<float> CoverageDistance(
  const GridGeometry& geometry, std::span<const float> coverage, const ProgressFunction& progress)
{
  const SurfaceElements surface = ExtractSurfaceElements(geometry, coverage);
  ReportProgress(progress, 0.2);
  std::vector<float> distance(coverage.size());
  if (surface.elements.empty())
  {
    constexpr float far = std::numeric_limits<float>::infinity();
    std::fill(
      distance.begin(), distance.end(), !coverage.empty() && coverage.front() >= 0.5F ? -far : far);
    return distance;
  }
  std::vector<std::uint8_t> seeds(coverage.size());
  std::transform(surface.at.begin(), surface.at.end(), seeds.begin(),
    [](std::uint32_t id) { return id == SurfaceElements::None ? 0 : 1; });
  const FeatureTransform nearest = NearestSeeds(
    geometry, seeds, [&](double share) { return !progress || progress(0.2 + 0.4 * share); });
  const Evaluator evaluate(geometry, surface);
  const std::int64_t nx = geometry.dims.x, ny = geometry.dims.y, nz = geometry.dims.z;
  const std::int64_t step = std::max<std::int64_t>(1, nz / 8); // slices between two reports
  for (std::int64_t k = 0; k < nz; k += step)
  {
    ReportProgress(progress, 0.6 + 0.4 * double(k) / double(nz));
    ParallelFor(k * ny, std::min(nz, k + step) * ny, 16,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t row = first; row < last; ++row)
          for (std::int64_t i = 0; i < nx; ++i)
          {
            const std::size_t voxel = row * nx + i;
            const glm::dvec3 x = glm::dvec3(i, row % ny, row / ny) * geometry.spacing;
            distance[voxel] =
              static_cast<float>(evaluate(x, nearest.seed[voxel], coverage[voxel] >= 0.5F));
          }
      });
  }
  ReportProgress(progress, 1.0);
  return distance;
}

} // namespace hasp
