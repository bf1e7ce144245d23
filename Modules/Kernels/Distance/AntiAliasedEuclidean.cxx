#include "Distance/AntiAliasedEuclidean.h"

#include "Distance/CoverageCheck.h"
#include "Distance/SurfaceElements.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_precision.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr float Infinity = std::numeric_limits<float>::infinity();

class Propagation
{
public:
  Propagation(const GridGeometry& geometry, std::span<const float> coverage)
    : Dims(geometry.dims),
      Spacing(geometry.spacing),
      Alpha(coverage),
      Offset(coverage.size(), glm::i16vec3(0)),
      Edge(coverage.size()),
      Away(coverage.size(), Infinity),
      Changed(std::size_t(geometry.dims.y) * geometry.dims.z, -1)
  {
    const auto half =
      0.5F * static_cast<float>(std::min({ this->Spacing.x, this->Spacing.y, this->Spacing.z }));
    std::size_t v = 0;
    for (int z = 0; z < this->Dims.z; ++z)
      for (int y = 0; y < this->Dims.y; ++y)
        for (int x = 0; x < this->Dims.x; ++x, ++v)
          if (const float a = coverage[v]; a > 0.0F && a < 1.0F)
            this->Edge[v] = this->PlaneOf({ x, y, z }, a);
          else
            this->Edge[v] = a > 0.0F ? -half : half;
  }

  /// Raster pass number `pass`, forwards if even; false if it changed nothing. Rows are left out if
  /// nothing around them has changed since the last pass this way.
  bool Pass(int pass)
  {
    bool changed = false;
    const bool forwards = pass % 2 == 0;
    const auto at = [forwards](int n, int count) { return forwards ? n : count - 1 - n; };
    for (int k = 0; k < this->Dims.z; ++k)
      for (int j = 0; j < this->Dims.y; ++j)
      {
        const int y = at(j, this->Dims.y), z = at(k, this->Dims.z);
        if (pass > 1 && this->LastChange(y, z) < pass - 2)
          continue;
        bool row = false;
        for (int i = 0; i < this->Dims.x; ++i)
          row |= this->AskNeighbours({ at(i, this->Dims.x), y, z }, forwards);
        if (row)
          this->Changed[std::size_t(z) * this->Dims.y + y] = pass;
        changed |= row;
      }
    return changed;
  }

  float Signed(std::size_t v) const
  {
    if (this->Alpha[v] > 0.0F && this->Alpha[v] < 1.0F)
      return this->Edge[v];
    return this->Alpha[v] > 0.0F ? -this->Away[v] : this->Away[v];
  }

private:
  std::size_t Index(const glm::ivec3& p) const
  {
    return (std::size_t(p.z) * this->Dims.y + p.y) * this->Dims.x + p.x;
  }
  float At(const glm::ivec3& p) const
  {
    return this->Alpha[this->Index(glm::clamp(p, glm::ivec3(0), this->Dims - 1))];
  }

  /// Signed distance of a partial voxel's centre to the plane that leaves its share covered.
  float PlaneOf(const glm::ivec3& p, float alpha) const
  {
    constexpr double smooth[3] = { 1, 2, 1 };
    glm::dvec3 g(0.0);
    for (int n = 0; n < 27; ++n)
    {
      const glm::ivec3 d(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
      const double a = this->At(p + d);
      for (int axis = 0; axis < 3; ++axis)
        g[axis] += a * d[axis] * smooth[d[(axis + 1) % 3] + 1] * smooth[d[(axis + 2) % 3] + 1];
    }
    g /= this->Spacing;
    const double length = glm::length(g);
    if (!(length > 1e-6))
      return static_cast<float>(
        (0.5 - double(alpha)) * std::min({ this->Spacing.x, this->Spacing.y, this->Spacing.z }));
    return static_cast<float>(PlaneDistanceFromCoverage(-g / length, this->Spacing, alpha));
  }

  /// The last pass that changed one of the nine rows around.
  int LastChange(int y, int z) const
  {
    int last = -1;
    for (int k = std::max(0, z - 1); k <= std::min(this->Dims.z - 1, z + 1); ++k)
      for (int j = std::max(0, y - 1); j <= std::min(this->Dims.y - 1, y + 1); ++j)
        last = std::max(last, this->Changed[std::size_t(k) * this->Dims.y + j]);
    return last;
  }

  /// Of the 26 neighbours, those that a pass comes to before.
  bool AskNeighbours(const glm::ivec3& p, bool forwards)
  {
    const std::size_t v = this->Index(p);
    if (this->Alpha[v] > 0.0F && this->Alpha[v] < 1.0F)
      return false;
    bool changed = false;
    for (int n = 0; n < 13; ++n)
    {
      const glm::ivec3 step(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
      changed |= this->Ask(p, v, forwards ? step : -step);
    }
    return changed;
  }

  /// Takes the offset of a neighbour, or the neighbour itself if it is of another kind, if nearer.
  bool Ask(const glm::ivec3& p, std::size_t v, const glm::ivec3& step)
  {
    const glm::ivec3 q = p + step;
    if (glm::any(glm::lessThan(q, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(q, this->Dims)))
      return false;
    const std::size_t w = this->Index(q);
    glm::ivec3 offset = step;
    if (this->Alpha[w] == this->Alpha[v])
    {
      if (this->Away[w] == Infinity)
        return false;
      offset += glm::ivec3(this->Offset[w]);
    }
    const float edge = this->Edge[this->Index(p + offset)];
    const auto away = static_cast<float>(glm::length(glm::dvec3(offset) * this->Spacing)) +
                      (this->Alpha[v] > 0.0F ? -edge : edge);
    if (!(away < this->Away[v]))
      return false;
    this->Away[v] = away;
    this->Offset[v] = glm::i16vec3(offset);
    return true;
  }

  glm::ivec3 Dims;
  glm::dvec3 Spacing;
  std::span<const float> Alpha;
  std::vector<glm::i16vec3> Offset; ///< to a voxel of another kind, where Away is finite
  std::vector<float> Edge;          ///< signed distance of a voxel's centre to the plane in it
  std::vector<float> Away;          ///< of voxels that are not partial, to the surface
  std::vector<int> Changed;         ///< the last pass that changed a row
};
} // namespace

std::vector<float> AntiAliasedEuclideanDistance(
  const GridGeometry& geometry, std::span<const float> coverage, const ProgressFunction& progress)
{
  CheckCoverage(geometry, coverage, "anti-aliased distance");
  const glm::ivec3 d = geometry.dims;
  if (const int longest = std::max({ d.x, d.y, d.z });
      longest > std::numeric_limits<std::int16_t>::max())
    throw std::invalid_argument(
      "anti-aliased distance: an axis of " + std::to_string(longest) + " samples, at most 32767");
  ReportProgress(progress, 0.0);
  Propagation propagation(geometry, coverage);
  // How many passes there will be is not known; most take less than ten.
  for (int pass = 0, idle = 0; idle < 2; ++pass)
  {
    idle = propagation.Pass(pass) ? 0 : idle + 1;
    ReportProgress(progress, std::min(0.9, 0.1 * (pass + 1)));
  }
  std::vector<float> distance(coverage.size());
  for (std::size_t v = 0; v < distance.size(); ++v)
    distance[v] = propagation.Signed(v);
  ReportProgress(progress, 1.0);
  return distance;
}

} // namespace hasp
