#include "Distance/ChamferDistance.h"

#include "Distance/CoverageCheck.h"
#include "Grid/ParallelFor.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hasp
{

namespace
{
constexpr float Infinity = std::numeric_limits<float>::infinity();

/// Lengths of steps by which axes they move along: bit 0 is x.
std::array<float, 8> StepLengths(const glm::dvec3& spacing)
{
  const double share[4] = { 0.0, 1.0, 4.0 / (3.0 * std::sqrt(2.0)), 5.0 / (3.0 * std::sqrt(3.0)) };
  std::array<float, 8> length{};
  for (int step = 1; step < 8; ++step)
  {
    const glm::dvec3 along = glm::dvec3(step & 1, step >> 1 & 1, step >> 2) * spacing;
    length[step] =
      static_cast<float>(share[(step & 1) + (step >> 1 & 1) + (step >> 2)] * glm::length(along));
    for (int axis = 0; axis < 3; ++axis) // no shorter than what it contains
      if (step >> axis & 1)
        length[step] = std::max(length[step], length[step & ~(1 << axis)]);
  }
  return length;
}

/// External and internal distances of all voxels, both positive away from the surface.
class BothSides
{
public:
  BothSides(const GridGeometry& geometry, std::span<const float> coverage)
    : Dims(geometry.dims),
      Spacing(geometry.spacing),
      Alpha(coverage),
      Length(StepLengths(geometry.spacing)),
      Outer(coverage.size()),
      Inner(coverage.size())
  {
  }

  /// What is known without a step: partial voxels, and of those wholly inside, seen from outside,
  /// that the surface lies half a voxel before their centre; that is half their longer side only to
  /// who meets them face to face. Likewise the other way round.
  void Seed(std::int64_t row)
  {
    const glm::dvec3& s = this->Spacing;
    const auto side = static_cast<float>(std::min({ s.x, s.y, s.z }));
    const bool cubes = s.x == s.y && s.x == s.z;
    for (std::size_t v = row * this->Dims.x, end = v + this->Dims.x; v < end; ++v)
    {
      const float a = this->Alpha[v];
      const bool partial = a > 0.0F && a < 1.0F;
      const float known = (0.5F - a) * (partial && !cubes ? this->Across(v) : side);
      const float face = partial || cubes ? Infinity : this->Face(v);
      this->Outer[v] = a == 0.0F ? face : known;
      this->Inner[v] = a == 1.0F ? face : -known;
    }
  }

  /// One row of a raster pass, forwards (1) or backwards (-1): first steps from the four rows that
  /// were there before, voxel by voxel alike, then steps along the row.
  void Pass(std::int64_t j, std::int64_t k, int way)
  {
    const std::size_t row = this->Dims.x, at = (k * this->Dims.y + j) * row;
    const int before[4][2] = { { -way, 0 }, { -way, -way }, { 0, -way }, { way, -way } };
    for (const auto& [dj, dk] : before)
    {
      const std::int64_t y = j + dj, z = k + dk;
      if (y < 0 || y >= this->Dims.y || z < 0 || z >= this->Dims.z)
        continue;
      const std::size_t from = (z * this->Dims.y + y) * row;
      const int step = (dj ? 2 : 0) | (dk ? 4 : 0);
      this->StepAcross(&this->Outer[from], &this->Outer[at], step);
      this->StepAcross(&this->Inner[from], &this->Inner[at], step);
    }
    const float length = this->Length[1];
    std::size_t v = way > 0 ? at : at + row - 1;
    for (float outer = Infinity, inner = Infinity; v >= at && v < at + row; v += way)
    {
      this->Outer[v] = outer = std::min(this->Outer[v], outer + length);
      this->Inner[v] = inner = std::min(this->Inner[v], inner + length);
      if (v == 0 && way < 0)
        break;
    }
  }

  float Signed(std::size_t v) const
  {
    return this->Alpha[v] == 1.0F ? -this->Inner[v] : this->Outer[v];
  }

private:
  void StepAcross(const float* from, float* to, int step) const
  {
    const float straight = this->Length[step], slanted = this->Length[step | 1];
    const int last = this->Dims.x - 1;
    const auto take = [&](int x, float d) { to[x] = std::min(to[x], d); };
    for (int x = 1; x < last; ++x)
      take(x, std::min(from[x] + straight, std::min(from[x - 1], from[x + 1]) + slanted));
    for (const int x : { 0, last })
      take(x, std::min(from[x] + straight,
                std::min(from[std::max(0, x - 1)], from[std::min(last, x + 1)]) +
                  (last ? slanted : straight)));
  }

  /// Calls use(axis, neighbour) for each of the six voxels that share a face with one.
  template <typename F>
  void AcrossFaces(std::size_t v, F&& use) const
  {
    std::size_t stride = 1;
    for (int axis = 0; axis < 3; stride *= this->Dims[axis++])
    {
      const std::size_t index = v / stride % this->Dims[axis];
      if (index > 0)
        use(axis, v - stride);
      if (index + 1 < std::size_t(this->Dims[axis]))
        use(axis, v + stride);
    }
  }

  /// Spacing along the axis on which coverage changes most.
  float Across(std::size_t v) const
  {
    glm::vec3 change(0.0F);
    this->AcrossFaces(v,
      [&](int axis, std::size_t q) { change[axis] += std::abs(this->Alpha[q] - this->Alpha[v]); });
    const int axis = change.x >= change.y && change.x >= change.z ? 0
                     : change.y >= change.z                       ? 1
                                                                  : 2;
    return static_cast<float>(this->Spacing[axis]);
  }

  /// Half a voxel to the nearest face with one of the other kind, if there is any.
  float Face(std::size_t v) const
  {
    double least = Infinity;
    this->AcrossFaces(v,
      [&](int axis, std::size_t q)
      {
        if (this->Alpha[q] == 1.0F - this->Alpha[v])
          least = std::min(least, 0.5 * this->Spacing[axis]);
      });
    return static_cast<float>(least);
  }

  glm::ivec3 Dims;
  glm::dvec3 Spacing;
  std::span<const float> Alpha;
  std::array<float, 8> Length;
  std::vector<float> Outer, Inner;
};
} // namespace

std::vector<float> ChamferDistance(
  const GridGeometry& geometry, std::span<const float> coverage, const ProgressFunction& progress)
{
  CheckCoverage(geometry, coverage, "chamfer distance");
  const std::int64_t ny = geometry.dims.y, nz = geometry.dims.z;
  BothSides sides(geometry, coverage);
  ParallelFor(0, ny * nz, 64,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t row = first; row < last; ++row)
        sides.Seed(row);
    });
  // A row waits for its neighbours before it and below. So rows of one j + 2k do not wait for each
  // other, and all that they wait for have a smaller one.
  const std::int64_t fronts = ny + 2 * (nz - 1);
  for (const int way : { 1, -1 })
    for (std::int64_t front = 0; front < fronts; ++front)
    {
      if (front % 64 == 0)
        ReportProgress(progress, (way > 0 ? 0.0 : 0.5) + 0.5 * double(front) / double(fronts));
      const std::int64_t low = std::max<std::int64_t>(0, (front - ny + 2) / 2);
      const std::int64_t high = std::min(nz - 1, front / 2);
      ParallelFor(low, high + 1, 8,
        [&](std::int64_t first, std::int64_t last)
        {
          for (std::int64_t k = first; k < last; ++k)
            if (const std::int64_t j = front - 2 * k; way > 0)
              sides.Pass(j, k, 1);
            else
              sides.Pass(ny - 1 - j, nz - 1 - k, -1);
        });
    }
  std::vector<float> distance(coverage.size());
  ParallelFor(0, std::int64_t(distance.size()), 1 << 16,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t v = first; v < last; ++v)
        distance[v] = sides.Signed(v);
    });
  ReportProgress(progress, 1.0);
  return distance;
}

} // namespace hasp
