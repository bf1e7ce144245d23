#include "Distance/SurfaceElements.h"

#include "Distance/ElementLanes.h"
#include "Grid/ParallelFor.h"

#include <glm/common.hpp>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
using Element = SurfaceElements::Element;

constexpr std::int64_t Batch = 1024; // elements a piece of work

/// One after the other, what SurfaceElements consists of.
class Extractor
{
public:
  Extractor(const GridGeometry& geometry, std::span<const float> coverage, bool isCoverage)
    : Coverage(coverage.data()),
      IsCoverage(isCoverage)
  {
    geometry.Validate();
    if (coverage.size() != geometry.Size() ||
        coverage.size() > std::size_t(std::numeric_limits<std::int32_t>::max()))
      throw std::invalid_argument("surface elements: " + std::to_string(coverage.size()) +
                                  " values for " + std::to_string(geometry.Size()) +
                                  " voxels; both must be the same and below 2^31");
    SurfaceElements& s = this->Surface;
    s.dims = geometry.dims;
    s.unit = std::min({ geometry.spacing.x, geometry.spacing.y, geometry.spacing.z });
    s.sides = glm::vec3(geometry.spacing / s.unit);
    // A word more, so that what lies around a brick may be read as 64 bits.
    s.wordsPerRow = std::size_t(s.dims.x) / 32 + 2;
    s.bits.assign(s.wordsPerRow * s.dims.y * s.dims.z, 0U);
    s.at.assign(coverage.size(), SurfaceElements::None);
  }

  /// Which voxels have an element.
  void Scan(std::span<float> sides, float beyond)
  {
    const ElementLanes& lanes = BestElementLanes();
    SurfaceElements& s = this->Surface;
    const std::int64_t nx = s.dims.x, ny = s.dims.y, rows = ny * s.dims.z;
    std::atomic<bool> sound{ true };
    ParallelFor(0, rows, 64,
      [&](std::int64_t first, std::int64_t last)
      {
        std::vector<float> padded(nx + 2 + ElementLanes::Padding, 0.0F);
        for (std::int64_t r = first; r < last; ++r)
        {
          const float* here = this->Coverage + r * nx;
          std::copy(here, here + nx, padded.begin() + 1);
          padded[0] = here[0];
          padded[nx + 1] = here[nx - 1];
          const std::int64_t y = r % ny, slice = ny * nx;
          const ElementLanes::Row row{ padded.data() + 1,
            { y > 0 ? here - nx : here, y + 1 < ny ? here + nx : here,
              r >= ny ? here - slice : here, r + ny < rows ? here + slice : here },
            int(nx) };
          if (!lanes.scanRow(row, this->IsCoverage, &s.bits[r * s.wordsPerRow],
                sides.empty() ? nullptr : sides.data() + r * nx, beyond))
            sound = false;
        }
      });
    if (!sound)
      throw std::invalid_argument(this->IsCoverage
                                    ? "surface elements: coverage must be in [0, 1]"
                                    : "surface elements: a value is NaN; replace it by a number, "
                                      "such as the least of the image");
  }

  /// Numbers them.
  void List()
  {
    SurfaceElements& s = this->Surface;
    const std::int64_t rows = std::int64_t(s.dims.y) * s.dims.z;
    std::vector<std::size_t> first(rows + 1, 0);
    ParallelFor(0, rows, 256,
      [&](std::int64_t low, std::int64_t high)
      {
        for (std::int64_t r = low; r < high; ++r)
          for (std::size_t w = 0; w < s.wordsPerRow; ++w)
            first[r + 1] += std::popcount(s.bits[r * s.wordsPerRow + w]);
      });
    for (std::int64_t r = 0; r < rows; ++r)
      first[r + 1] += first[r];
    s.places.resize(first.back());
    s.elements.resize(first.back());
    ParallelFor(0, rows, 256,
      [&](std::int64_t low, std::int64_t high)
      {
        for (std::int64_t r = low; r < high; ++r)
        {
          std::size_t n = first[r];
          for (std::size_t w = 0; w < s.wordsPerRow; ++w)
            for (std::uint32_t left = s.bits[r * s.wordsPerRow + w]; left; left &= left - 1)
            {
              const auto x = static_cast<std::int32_t>(w * 32 + std::countr_zero(left));
              const auto voxel = static_cast<std::int32_t>(r * s.dims.x + x);
              s.at[voxel] = static_cast<std::int32_t>(n);
              s.places[n++] = { x, std::int32_t(r % s.dims.y), std::int32_t(r / s.dims.y), voxel };
            }
        }
      });
  }

  /// Gradients of all elements, as their normals.
  EdgeFacts Gradients()
  {
    const ElementLanes& lanes = BestElementLanes();
    SurfaceElements& s = this->Surface;
    std::atomic<std::size_t> partial{ 0 }, blurred{ 0 }, stray{ 0 };
    ParallelFor(0, std::int64_t(s.elements.size()), Batch,
      [&](std::int64_t first, std::int64_t last)
      {
        const EdgeFacts found = lanes.gradients(s, this->Coverage, first, last, s.elements.data());
        partial += found.partial;
        blurred += found.blurred;
        stray += found.stray;
      });
    return { partial, blurred, stray };
  }

  /// Replaces all elements by what one of the lanes' functions makes of them.
  void Apply(decltype(ElementLanes::planes) make)
  {
    SurfaceElements& s = this->Surface;
    std::vector<Element> made(s.elements.size());
    ParallelFor(0, std::int64_t(made.size()), Batch,
      [&](std::int64_t first, std::int64_t last)
      { make(s, this->Coverage, first, last, made.data()); });
    s.elements.swap(made);
  }

  SurfaceElements Surface;

private:
  const float* Coverage;
  bool IsCoverage;
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

EdgeFacts MeasureEdges(const GridGeometry& geometry, std::span<const float> values)
{
  Extractor extractor(geometry, values, true);
  extractor.Scan({}, 0.0F);
  extractor.List();
  return extractor.Gradients();
}

SurfaceElements ExtractSurfaceElements(const GridGeometry& geometry,
  std::span<const float> coverage, std::span<float> sides, float beyond)
{
  Extractor extractor(geometry, coverage, true);
  extractor.Scan(sides, beyond);
  extractor.List();
  if (const EdgeFacts facts = extractor.Gradients(); !facts.Coverage())
    throw std::invalid_argument(
      "surface elements: of " + std::to_string(facts.partial) + " partial voxels " +
      std::to_string(facts.blurred) + " are partial to both sides, and " +
      std::to_string(facts.stray) +
      " have no surface near; this is a grey or noisy image, not coverage, whose edges are a voxel "
      "wide (make that with Coverage, or take GreyDistance)");
  const ElementLanes& lanes = BestElementLanes();
  extractor.Apply(lanes.planes);
  extractor.Apply(lanes.polish);
  // Mean of the parabola over a cross-section: h^2 / 12 along each of two axes, half of it each.
  extractor.Surface.section = 1.0F / 24.0F;
  return std::move(extractor.Surface);
}

SurfaceElements ExtractIsosurfaceElements(
  const GridGeometry& geometry, std::span<const float> values, std::span<float> sides, float beyond)
{
  Extractor extractor(geometry, values, false);
  extractor.Scan(sides, beyond);
  extractor.List();
  extractor.Gradients();
  extractor.Apply(BestElementLanes().isoPlanes);
  return std::move(extractor.Surface);
}

} // namespace hasp
