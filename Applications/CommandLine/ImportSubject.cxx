#include "ImportSubject.h"

#include "Grid/Phantom.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <limits>

namespace hasp
{
namespace
{

/// Samples that no other equals, in an L with three unequal legs: any flip, swap or shift moves
/// one.
struct Marker
{
  glm::ivec3 index;
  std::int16_t value;
};

std::array<Marker, 4> MarkersOf(const glm::ivec3& dims)
{
  const glm::ivec3 corner = dims / 5;
  return { Marker{ corner, 32001 }, Marker{ corner + glm::ivec3(dims.x / 2, 0, 0), 32002 },
    Marker{ corner + glm::ivec3(0, dims.y / 3, 0), 32003 },
    Marker{ corner + glm::ivec3(0, 0, dims.z / 4), 32004 } };
}

} // namespace

ImportSubject MakeImportSubject(int dims)
{
  GridGeometry grid;
  grid.dims = glm::ivec3(dims);
  grid.spacing = glm::dvec3(200.0 / dims, 204.0 / dims, 208.0 / dims);
  const glm::dvec3 row = glm::normalize(glm::dvec3(0.97, 0.2, -0.1));
  const glm::dvec3 column = glm::normalize(glm::cross(glm::dvec3(0.05, 0.15, 1.0), row));
  grid.direction = glm::dmat3(row, column, glm::cross(row, column));
  grid.origin = grid.IndexToWorldMatrix() * (-0.5 * glm::dvec3(grid.dims - 1));
  std::vector<std::int16_t> samples = SamplePhantom(grid);
  for (const Marker& marker : MarkersOf(grid.dims))
    samples[marker.index.x +
            std::size_t(dims) * (marker.index.y + std::size_t(dims) * marker.index.z)] =
      marker.value;
  return { "phantom" + std::to_string(dims), MakeImage(grid, samples), grid };
}

double PlaceError(vtkImageData* image, const ImportSubject& subject)
{
  const AnyGridView grid = ViewImage(image);
  double largest = 0.0;
  for (const Marker& marker : MarkersOf(subject.geometry.dims))
  {
    const double error = std::visit(
      [&](const auto& view)
      {
        const auto* end = view.data + view.geometry.Size();
        const auto* at =
          std::find_if(view.data, end, [&](auto v) { return double(v) == marker.value; });
        if (at == end)
          return std::numeric_limits<double>::infinity();
        const std::size_t n = static_cast<std::size_t>(at - view.data);
        const std::size_t x = view.geometry.dims.x, y = view.geometry.dims.y;
        const glm::dvec3 index(double(n % x), double(n / x % y), double(n / x / y));
        return glm::length(view.geometry.IndexToWorld(index) -
                           subject.geometry.IndexToWorld(glm::dvec3(marker.index)));
      },
      grid);
    largest = std::max(largest, error);
  }
  return largest;
}

} // namespace hasp
