#include "Distance/CoverageDistance.h"

#include "Distance/DistanceBounds.h"
#include "Distance/ElementLanes.h"
#include "Distance/EuclideanDistance.h"
#include "Grid/ParallelFor.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr int Side = ElementLanes::Side, Reach = ElementLanes::Reach;
constexpr float BandVoxels = 4.0F; // no farther than Reach - 1: elements are half a voxel off

constexpr float NearVoxels = 1.6F; // so near no other element is taken for the nearest

constexpr std::int64_t Batch = 1024;  // elements a piece of work
constexpr float NoisyUnits = 0.0085F; // off their neighbours: a scan's, of 1 % noise and more
constexpr int NoisyPasses = 4;
constexpr float AlikeCosine = 0.98F; // of a normal before and after a fit

/// Distances within the band, a brick of voxels at a time.
class Band
{
public:
  Band(const SurfaceElements& surface, const float* coverage, std::vector<float>& distance)
    : Surface(surface),
      Coverage(coverage),
      Distance(distance),
      Bricks((surface.dims + Side - 1) / Side)
  {
  }

  void Fill(const ProgressFunction& progress)
  {
    const std::int64_t slabs = this->Bricks.z,
                       perSlab = std::int64_t(this->Bricks.x) * this->Bricks.y;
    const std::int64_t step = std::max<std::int64_t>(1, slabs / 8); // slabs between two reports
    for (std::int64_t k = 0; k < slabs; k += step)
    {
      ReportProgress(progress, double(k) / double(slabs));
      ParallelFor(k * perSlab, std::min(slabs, k + step) * perSlab, 2,
        [&](std::int64_t first, std::int64_t last)
        {
          for (std::int64_t b = first; b < last; ++b)
            this->FillBrick(
              glm::ivec3(b % this->Bricks.x, b / this->Bricks.x % this->Bricks.y, b / perSlab));
        });
    }
  }

private:
  /// Bits of the elements in and around a brick; false if there are none.
  bool Gather(const glm::ivec3& origin, ElementLanes::Bits& bits) const
  {
    const SurfaceElements& s = this->Surface;
    std::uint32_t any = 0;
    const int x = origin.x - Reach, word = std::max(0, x) / 32;
    for (int z = 0; z < Side + 2 * Reach; ++z)
      for (int y = 0; y < Side + 2 * Reach; ++y)
      {
        const int j = origin.y + y - Reach, k = origin.z + z - Reach;
        std::uint32_t found = 0;
        if (j >= 0 && j < s.dims.y && k >= 0 && k < s.dims.z)
        {
          const std::uint32_t* row =
            &s.bits[(std::size_t(k) * s.dims.y + j) * s.wordsPerRow + word];
          const std::uint64_t both = row[0] | std::uint64_t(row[1]) << 32;
          found = static_cast<std::uint32_t>(x < 0 ? both << -x : both >> (x - 32 * word)) &
                  ((1U << (Side + 2 * Reach)) - 1);
        }
        bits.row[z][y] = found;
        any |= found;
      }
    return any != 0;
  }

  void FillBrick(const glm::ivec3& brick)
  {
    ElementLanes::Bits bits;
    const glm::ivec3 origin = brick * Side;
    if (!this->Gather(origin, bits))
      return;
    const SurfaceElements& s = this->Surface;
    const ElementLanes& lanes = BestElementLanes();
    std::int32_t list[Side * Side * Side + ElementLanes::Padding];
    float found[Side * Side * Side + ElementLanes::Padding];
    // The surface passes up to half a voxel's diagonal from the centre of an element's voxel.
    int count = lanes.listNear(s, bits, BandVoxels + 0.5F * glm::length(s.sides), list);
    const auto at = [&](std::int32_t packed)
    { return origin + glm::ivec3(packed & 15, packed >> 4 & 15, packed >> 8 & 15); };
    if (glm::any(glm::greaterThan(origin + Side, s.dims))) // at the grid's end
    {
      count = int(std::remove_if(list, list + count,
                    [&](std::int32_t packed)
                    { return glm::any(glm::greaterThanEqual(at(packed), s.dims)); }) -
                  list);
      std::fill_n(list + count, count ? ElementLanes::Padding : 0, list[std::max(0, count - 1)]);
    }
    lanes.near(s, this->Coverage, origin, list, count, found);
    for (int n = 0; n < count; ++n)
      if (std::abs(found[n]) < BandVoxels)
      {
        const glm::ivec3 p = at(list[n]);
        this->Distance[(std::size_t(p.z) * s.dims.y + p.y) * s.dims.x + p.x] =
          found[n] * static_cast<float>(s.unit);
      }
  }

  const SurfaceElements& Surface;
  const float* Coverage;
  std::vector<float>& Distance;
  glm::ivec3 Bricks;
};

/// Fits elements [first, last) to their neighbours, into the same places of `to`.
void Refine(const SurfaceElements& surface, const float* coverage, std::int64_t first,
  std::int64_t last, SurfaceElements::Element* to)
{
  const ElementLanes& lanes = BestElementLanes();
  ParallelFor(first, last, Batch,
    [&](std::int64_t from, std::int64_t end) { lanes.refine(surface, coverage, from, end, to); });
}

/// Cosine between two normals; of an element at an edge and what is fitted to it, less than 1.
float Facing(const SurfaceElements::Element& a, const SurfaceElements::Element& b)
{
  return a.normal[0] * b.normal[0] + a.normal[1] * b.normal[1] + a.normal[2] * b.normal[2];
}

/// How far elements lie off what their neighbours span, units: half of what lies between the
/// quartiles, of every eighth batch. That all lie too deep by their curvature does not count.
float NoiseOf(const SurfaceElements& surface, const float* coverage)
{
  const auto count = std::int64_t(surface.elements.size());
  std::vector<float> off;
  std::size_t asked = 0;
  std::vector<SurfaceElements::Element> fitted(surface.elements.size());
  for (std::int64_t first = 0; first < count; first += 8 * Batch)
  {
    const std::int64_t last = std::min(count, first + Batch);
    asked += std::size_t(last - first);
    Refine(surface, coverage, first, last, fitted.data());
    for (std::int64_t n = first; n < last; ++n)
    {
      const SurfaceElements::Element &was = surface.elements[n], &is = fitted[n];
      float along = 0.0F;
      for (int a = 0; a < 3; ++a)
        along += is.normal[a] * (is.point[a] - was.point[a]);
      if (Facing(was, is) > AlikeCosine)
        off.push_back(along);
    }
  }
  if (2 * off.size() < asked)
    return 0.0F;
  const auto quarter = std::ptrdiff_t(off.size() / 4);
  const auto low = off.begin() + quarter, high = off.begin() + 3 * quarter;
  std::nth_element(off.begin(), high, off.end());
  std::nth_element(off.begin(), low, high);
  return 0.5F * (*high - *low);
}

/// Elements of noisy scans each move to what they span together, a few times over: what is left of
/// noise is less by half. Fits are exact on quadrics, so that surfaces do not shrink; edges would.
void SmoothNoise(SurfaceElements& surface, const float* values)
{
  if (NoiseOf(surface, values) < NoisyUnits)
    return;
  std::vector<SurfaceElements::Element> fitted(surface.elements.size());
  for (int pass = 0; pass < NoisyPasses; ++pass)
  {
    Refine(surface, values, 0, std::int64_t(fitted.size()), fitted.data());
    for (std::size_t n = 0; n < fitted.size(); ++n)
      if (!(Facing(surface.elements[n], fitted[n]) > AlikeCosine))
        fitted[n] = surface.elements[n];
    surface.elements.swap(fitted);
  }
}

/// Distances to the elements of the nearest voxels, beyond the band.
void FillFar(const GridGeometry& geometry, const SurfaceElements& surface, const float* coverage,
  float band, std::vector<float>& distance, const ProgressFunction& progress)
{
  const ElementLanes& lanes = BestElementLanes();
  std::vector<SurfaceElements::Element> refined(surface.elements.size());
  Refine(surface, coverage, 0, std::int64_t(refined.size()), refined.data());
  std::vector<std::uint8_t> seeds(distance.size());
  std::transform(surface.at.begin(), surface.at.end(), seeds.begin(),
    [](std::int32_t id) { return id == SurfaceElements::None ? 0 : 1; });
  GridGeometry inUnits = geometry; // so that what is equally near is so at any size
  inUnits.spacing /= surface.unit;
  const FeatureTransform nearest =
    NearestSeeds(inUnits, seeds, [&](double share) { return !progress || progress(0.8 * share); });
  const std::int64_t nx = geometry.dims.x, ny = geometry.dims.y;
  ParallelFor(0, ny * geometry.dims.z, 16,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t row = first; row < last; ++row)
        lanes.farRow(surface, refined.data(), int(row % ny), int(row / ny),
          nearest.seed.data() + row * nx, band, distance.data() + row * nx);
    });
}

std::vector<float> Distances(const GridGeometry& geometry, std::span<const float> coverage,
  bool isCoverage, bool everywhere, const ProgressFunction& progress)
{
  geometry.Validate();
  std::vector<float> distance(coverage.size());
  const auto part = [&](double from, double to)
  {
    return [&progress, from, to](double share)
    { return !progress || progress(from + (to - from) * share); };
  };
  ReportProgress(progress, 0.0);
  const float band =
    BandVoxels *
    static_cast<float>(std::min({ geometry.spacing.x, geometry.spacing.y, geometry.spacing.z }));
  SurfaceElements surface = isCoverage
                              ? ExtractSurfaceElements(geometry, coverage, distance, band)
                              : ExtractIsosurfaceElements(geometry, coverage, distance, band);
  if (surface.elements.empty())
  {
    constexpr float far = std::numeric_limits<float>::infinity();
    std::fill(distance.begin(), distance.end(), coverage.front() >= 0.5F ? -far : far);
    return distance;
  }
  if (!isCoverage)
    SmoothNoise(surface, coverage.data());
  Band(surface, coverage.data(), distance).Fill(part(0.2, everywhere ? 0.5 : 1.0));
  if (!isCoverage)
    BoundByCrossings(geometry, coverage, distance);
  BoundByNeighbours(geometry, 0.0F, distance);
  if (BoundByNearVoxels(geometry, NearVoxels / BandVoxels * band, band, distance))
    BoundByNeighbours(geometry, 0.0F, distance);
  if (everywhere)
  {
    FillFar(geometry, surface, coverage.data(), band, distance, part(0.5, 1.0));
    BoundByNeighbours(geometry, band, distance);
  }
  ReportProgress(progress, 1.0);
  return distance;
}

/// What takes samples to at least 0.5 off the isovalue somewhere: of less, little would be left in
/// floats around 0.5. A power of two, 1 at least.
double ScaleOf(const AnyGridView& image, double isovalue)
{
  constexpr std::int64_t Piece = 1 << 16;
  const std::int64_t size = std::int64_t(GeometryOf(image).Size());
  std::vector<double> most((size + Piece - 1) / Piece, 0.0);
  std::visit(
    [&](const auto& view)
    {
      ParallelFor(0, size, Piece,
        [&](std::int64_t first, std::int64_t last)
        {
          double& here = most[first / Piece];
          for (std::int64_t v = first; v < last && here < 0.5; ++v)
            here = std::max(here, std::abs(double(view.data[v]) - isovalue));
        });
    },
    image);
  const double furthest = *std::max_element(most.begin(), most.end());
  return furthest > 0.0 && furthest < 0.5 ? std::exp2(std::min(-1 - std::ilogb(furthest), 1000))
                                          : 1.0;
}
} // namespace

std::vector<float> CoverageDistance(
  const GridGeometry& geometry, std::span<const float> coverage, const ProgressFunction& progress)
{
  return Distances(geometry, coverage, true, true, progress);
}

std::vector<float> CoverageDistanceBand(
  const GridGeometry& geometry, std::span<const float> coverage, const ProgressFunction& progress)
{
  return Distances(geometry, coverage, true, false, progress);
}

std::vector<float> GreyDistance(
  const AnyGridView& image, double isovalue, const ProgressFunction& progress)
{
  const GridGeometry& geometry = GeometryOf(image);
  geometry.Validate();
  if (!std::isfinite(isovalue))
    throw std::invalid_argument("grey distance: isovalue must be finite");
  const double scale = ScaleOf(image, isovalue);
  std::vector<float> values(geometry.Size());
  std::visit(
    [&](const auto& view)
    {
      ParallelFor(0, std::int64_t(values.size()), 1 << 16,
        [&](std::int64_t first, std::int64_t last)
        {
          for (std::int64_t v = first; v < last; ++v)
            values[v] = static_cast<float>(scale * (double(view.data[v]) - isovalue)) + 0.5F;
        });
    },
    image);
  return Distances(geometry, values, false, true, progress);
}

std::vector<float> ImageDistance(
  const GridView<const float>& image, const ProgressFunction& progress)
{
  const GridGeometry& geometry = image.geometry;
  const std::span<const float> values(image.data, geometry.Size());
  return MeasureEdges(geometry, values).Coverage() ? CoverageDistance(geometry, values, progress)
                                                   : GreyDistance(image, 0.5, progress);
}

} // namespace hasp
