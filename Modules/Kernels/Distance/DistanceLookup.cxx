#include "Distance/DistanceLookup.h"

#include "Grid/ParallelFor.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{

void Check(
  const GridGeometry& grid, const glm::dmat4& placeToWorld, std::size_t places, std::size_t found)
{
  if (places != 3 * found)
    throw std::invalid_argument("distance look-up: " + std::to_string(places) +
                                " coordinates for " + std::to_string(found) +
                                " distances; there must be three for each");
  if (std::min({ grid.dims.x, grid.dims.y, grid.dims.z }) < 2)
    throw std::invalid_argument("distance look-up: the distances have one sample along an axis; "
                                "two are needed along each");
  const glm::dmat3 turn(placeToWorld);
  const glm::dmat3 unit = glm::transpose(turn) * turn;
  double off = 0.0;
  for (int c = 0; c < 3; ++c)
    off = std::max(off, glm::length(unit[c] - glm::dmat3(1.0)[c]));
  const bool affine = placeToWorld[0][3] == 0.0 && placeToWorld[1][3] == 0.0 &&
                      placeToWorld[2][3] == 0.0 && placeToWorld[3][3] == 1.0;
  if (!(off <= 1e-5) || !affine || !std::isfinite(glm::length(glm::dvec3(placeToWorld[3]))))
    throw std::invalid_argument("distance look-up: the pose is off a rigid one by " +
                                std::to_string(off) +
                                ", must be within 1e-5: distances are mm; turns and shifts only");
}

} // namespace

template <typename Coordinate>
void LookUpDistances(const GridView<const float>& distances, const glm::dmat4& placeToWorld,
  std::span<const Coordinate> places, std::span<float> found)
{
  const GridGeometry& grid = distances.geometry;
  Check(grid, placeToWorld, places.size(), found.size());
  const auto index = [&](const glm::dvec3& place)
  { return grid.WorldToIndex(glm::dvec3(placeToWorld * glm::dvec4(place, 1.0))); };
  const glm::dvec3 shift = index(glm::dvec3(0.0));
  const glm::dmat3 toIndex(
    index({ 1, 0, 0 }) - shift, index({ 0, 1, 0 }) - shift, index({ 0, 0, 1 }) - shift);
  const glm::dvec3 last(grid.dims - 1);
  const std::size_t row = std::size_t(grid.dims.x), slice = row * std::size_t(grid.dims.y);
  const auto look = [&](const glm::dvec3& at) -> float
  {
    const glm::dvec3 in = glm::clamp(at, glm::dvec3(0.0), last);
    const glm::ivec3 cell = glm::min(glm::ivec3(in), grid.dims - 2);
    const glm::vec3 t(in - glm::dvec3(cell));
    const float* p = distances.data + (std::size_t(cell.z) * slice + std::size_t(cell.y) * row +
                                        std::size_t(cell.x));
    const auto lerp = [](float a, float b, float s) { return a + s * (b - a); };
    const float low = lerp(lerp(p[0], p[1], t.x), lerp(p[row], p[row + 1], t.x), t.y);
    p += slice;
    const float high = lerp(lerp(p[0], p[1], t.x), lerp(p[row], p[row + 1], t.x), t.y);
    const float inside = lerp(low, high, t.z);
    return in == at ? inside : inside + float(glm::length((at - in) * grid.spacing));
  };
  ParallelFor(0, std::int64_t(found.size()), 4096,
    [&](std::int64_t first, std::int64_t end)
    {
      for (auto n = std::size_t(first); n < std::size_t(end); ++n)
      {
        const glm::dvec3 place(places[3 * n], places[3 * n + 1], places[3 * n + 2]);
        const glm::dvec3 at = toIndex * place + shift;
        found[n] =
          std::isfinite(at.x + at.y + at.z) ? look(at) : std::numeric_limits<float>::quiet_NaN();
      }
    });
}

template void LookUpDistances<float>(
  const GridView<const float>&, const glm::dmat4&, std::span<const float>, std::span<float>);
template void LookUpDistances<double>(
  const GridView<const float>&, const glm::dmat4&, std::span<const double>, std::span<float>);

} // namespace hasp
