#include "Evaluation/VolumeDifference.h"

#include "Grid/ParallelFor.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hasp
{
namespace
{

/// Which axis of the second volume an axis of the first is, and whether it runs the other way.
struct AxisMatch
{
  glm::ivec3 axis{ 0 };
  glm::bvec3 reversed{ false };
};

/// The most parallel axes, of all six pairings.
AxisMatch MatchAxes(const glm::dmat3& a, const glm::dmat3& b)
{
  glm::ivec3 order(0, 1, 2), best = order;
  double most = -1.0;
  do
  {
    double parallel = 0.0;
    for (int n = 0; n < 3; ++n)
      parallel += std::abs(glm::dot(a[n], b[order[n]]));
    if (parallel > most)
    {
      most = parallel;
      best = order;
    }
  } while (std::next_permutation(&order.x, &order.x + 3));
  AxisMatch match{ best, {} };
  for (int n = 0; n < 3; ++n)
    match.reversed[n] = glm::dot(a[n], b[best[n]]) < 0.0;
  return match;
}

glm::ivec3 Matched(const glm::ivec3& index, const AxisMatch& match, const glm::ivec3& dims)
{
  glm::ivec3 other;
  for (int n = 0; n < 3; ++n)
    other[match.axis[n]] = match.reversed[n] ? dims[n] - 1 - index[n] : index[n];
  return other;
}

/// The difference is affine in the index, so it is largest at a corner.
double LargestShift(const GridGeometry& a, const GridGeometry& b, const AxisMatch& match)
{
  double largest = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::ivec3 index =
      (a.dims - 1) * glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
    const glm::ivec3 other = Matched(index, match, a.dims);
    largest = std::max(
      largest, glm::distance(a.IndexToWorld(glm::dvec3(index)), b.IndexToWorld(glm::dvec3(other))));
  }
  return largest;
}

struct SliceDifference
{
  std::size_t samples = 0;
  double largest = 0.0;
  glm::ivec3 first{ -1 };
};

template <typename A, typename B>
SliceDifference CompareSlice(
  const GridView<A>& a, const GridView<B>& b, const AxisMatch& match, int k)
{
  const glm::ivec3& dims = a.geometry.dims;
  SliceDifference result;
  for (int j = 0; j < dims.y; ++j)
    for (int i = 0; i < dims.x; ++i)
    {
      const glm::ivec3 other = Matched({ i, j, k }, match, dims);
      const double left = a(i, j, k), right = b(other.x, other.y, other.z);
      if (left == right)
        continue;
      if (result.samples++ == 0)
        result.first = { i, j, k };
      result.largest = std::max(result.largest, std::abs(left - right));
    }
  return result;
}

} // namespace

VolumeDifference CompareVolumes(const AnyGridView& a, const AnyGridView& b)
{
  const GridGeometry &first = GeometryOf(a), &second = GeometryOf(b);
  const AxisMatch match = MatchAxes(first.direction, second.direction);
  VolumeDifference result;
  for (int n = 0; n < 3; ++n)
    if (first.dims[n] != second.dims[match.axis[n]])
      return result;
  result.sameSize = true;
  result.positionMm = LargestShift(first, second, match);
  std::vector<SliceDifference> slices(first.dims.z); // a slot each: no thread touches another's
  std::visit(
    [&](const auto& left, const auto& right)
    {
      ParallelFor(0, first.dims.z, 1,
        [&](std::int64_t from, std::int64_t to)
        {
          for (std::int64_t k = from; k < to; ++k)
            slices[k] = CompareSlice(left, right, match, static_cast<int>(k));
        });
    },
    a, b);
  for (const SliceDifference& slice : slices)
  {
    if (result.samples == 0)
      result.first = slice.first;
    result.samples += slice.samples;
    result.largest = std::max(result.largest, slice.largest);
  }
  return result;
}

} // namespace hasp
