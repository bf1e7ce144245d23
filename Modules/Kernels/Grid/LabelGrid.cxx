#include "Grid/LabelGrid.h"

#include "Grid/ParallelFor.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace hasp
{
namespace
{

double ToleranceMm(const GridGeometry& scan)
{
  return 0.01 * glm::min(scan.spacing.x, glm::min(scan.spacing.y, scan.spacing.z));
}

std::ostringstream OfAnotherGrid(const char* who)
{
  std::ostringstream text;
  text << who << ": the labels are of another grid than the volume: ";
  return text;
}

void SayBoth(std::ostringstream& text, const char* what, const auto& labels, const auto& scan)
{
  text << "their " << what << " is (" << labels.x << ", " << labels.y << ", " << labels.z
       << "), the volume's (" << scan.x << ", " << scan.y << ", " << scan.z << ")";
}

/// Index of a scan's sample at an index of the labels: origin + the sum of index[a] * step[a].
struct IndexMap
{
  glm::dvec3 origin{ 0.0 }; ///< whole numbers, as those of the steps: exact in double
  glm::dvec3 step[3];       ///< one of +-1, two of 0
  glm::dvec3 operator()(const glm::dvec3& index) const
  {
    return this->origin + index.x * this->step[0] + index.y * this->step[1] +
           index.z * this->step[2];
  }
};

/// The nearest map there is; whether it is near enough is asked of the corners.
IndexMap NearestMap(const GridGeometry& labels, const GridGeometry& scan)
{
  IndexMap map;
  map.origin = glm::round(scan.WorldToIndex(labels.origin));
  const glm::dmat3 steps = labels.IndexToWorldMatrix(), axes = scan.direction;
  for (int a = 0; a < 3; ++a)
  {
    int nearest = 0;
    for (int b = 1; b < 3; ++b)
      if (std::abs(glm::dot(steps[a], axes[b])) > std::abs(glm::dot(steps[a], axes[nearest])))
        nearest = b;
    map.step[a] = glm::dvec3(0.0);
    map.step[a][nearest] = glm::dot(steps[a], axes[nearest]) < 0.0 ? -1.0 : 1.0;
  }
  return map;
}

/// How far the labels' farthest corner lies from the sample that the map gives it, mm.
double WorstCornerMm(const GridGeometry& labels, const GridGeometry& scan, const IndexMap& map)
{
  double worst = 0.0;
  const glm::dvec3 last(labels.Cells());
  for (int c = 0; c < 8; ++c)
  {
    const glm::dvec3 index = last * glm::dvec3(c & 1, c >> 1 & 1, c >> 2);
    const double mm = glm::distance(labels.IndexToWorld(index), scan.IndexToWorld(map(index)));
    if (!(mm <= worst)) // true for NaN, too, which then stays
      worst = std::isnan(worst) ? worst : mm;
  }
  return worst;
}

IndexMap MapOnto(const char* who, const GridGeometry& labels, const GridGeometry& scan)
{
  labels.Validate();
  scan.Validate();
  const IndexMap map = NearestMap(labels, scan);
  const double worst = WorstCornerMm(labels, scan, map);
  // A thousand scans away no whole number of steps is lost in a double, nor in an int.
  const bool near = glm::all(glm::lessThan(glm::abs(map.origin), glm::dvec3(1e9)));
  if (worst <= ToleranceMm(scan) && near)
    return map;
  std::ostringstream text = OfAnotherGrid(who);
  if (!near)
    SayBoth(text, "origin", labels.origin, scan.origin);
  else if (!(glm::distance(labels.spacing, scan.spacing) <= ToleranceMm(scan)))
    SayBoth(text, "spacing", labels.spacing, scan.spacing);
  else
    text << "they lie up to " << worst << " mm beside its samples";
  text << "; resample them onto its grid";
  throw std::invalid_argument(text.str());
}

} // namespace

void CheckLabelGrid(const char* who, const GridGeometry& scan, const GridGeometry& labels)
{
  std::ostringstream text = OfAnotherGrid(who);
  // How far the step changes what is at the far end, and then where the first sample is.
  const double tolerance = ToleranceMm(scan);
  const glm::dvec3 size(scan.Cells());
  const auto farEndsMove = [&](const glm::dmat3& a, const glm::dmat3& b)
  {
    bool moves = false;
    for (int axis = 0; axis < 3; ++axis)
      moves = moves || !(size[axis] * glm::distance(a[axis], b[axis]) <= tolerance);
    return moves;
  };
  if (scan.dims != labels.dims)
    SayBoth(text, "size", labels.dims, scan.dims);
  else if (!glm::all(glm::lessThanEqual(
             size * glm::abs(labels.spacing - scan.spacing), glm::dvec3(tolerance))))
    SayBoth(text, "spacing", labels.spacing, scan.spacing);
  else if (farEndsMove(labels.IndexToWorldMatrix(), scan.IndexToWorldMatrix()))
    text << "their axes have other directions";
  else if (!(glm::distance(labels.origin, scan.origin) <= tolerance))
    SayBoth(text, "origin", labels.origin, scan.origin);
  else
    return;
  text << "; resample them onto its grid";
  throw std::invalid_argument(text.str());
}

void PlaceLabels(const char* who, GridView<const std::uint16_t> labels,
  GridView<std::uint16_t> scan, const ProgressFunction& progress)
{
  const IndexMap map = MapOnto(who, labels.geometry, scan.geometry);
  constexpr std::int64_t grain = 1 << 20;
  ParallelFor(0, static_cast<std::int64_t>(scan.geometry.Size()), grain,
    [&](std::int64_t first, std::int64_t last)
    { std::fill(scan.data + first, scan.data + last, std::uint16_t(0)); });
  const glm::ivec3 dims = labels.geometry.dims, room = scan.geometry.dims;
  const glm::ivec3 along(map.step[0]);
  std::atomic<std::size_t> outside{ 0 };
  const auto placeSlice = [&](int k)
  {
    std::size_t lost = 0;
    for (int j = 0; j < dims.y; ++j)
    {
      glm::ivec3 at(map(glm::dvec3(0, j, k)));
      for (int i = 0; i < dims.x; ++i, at += along)
        if (const std::uint16_t label = labels(i, j, k); label != 0)
        {
          const bool inside =
            glm::all(glm::greaterThanEqual(at, glm::ivec3(0))) && glm::all(glm::lessThan(at, room));
          if (inside)
            scan(at.x, at.y, at.z) = label;
          lost += !inside;
        }
    }
    outside += lost;
  };
  constexpr int slices = 16; // between two looks at progress
  for (int k = 0; k < dims.z; k += slices)
  {
    ReportProgress(progress, double(k) / dims.z);
    ParallelFor(k, glm::min(k + slices, dims.z), 1,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t slice = first; slice < last; ++slice)
          placeSlice(static_cast<int>(slice));
      });
  }
  if (outside > 0)
    throw std::invalid_argument(std::string(who) + ": " + std::to_string(outside) +
                                " samples with labels lie outside of the volume: are these "
                                "labels of another scan? Crop them to it");
  ReportProgress(progress, 1.0);
}

} // namespace hasp
