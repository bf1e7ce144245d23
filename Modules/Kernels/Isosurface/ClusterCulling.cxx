#include "Isosurface/ClusterCulling.h"
#include "Grid/MinMaxBlocks.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace hasp
{

namespace
{

enum class Primitive
{
  None,
  Point,
  Rectangle
};

/// A linear function of the place, at all corners of a cluster: its least and largest value.
class ClusterRange
{
public:
  ClusterRange(const glm::dvec4& function, double margin)
    : Slope(function),
      Middle(function.w),
      Spread(0.0)
  {
    for (int a = 0; a < 3; ++a)
    {
      this->Middle += function[a] * 0.5 * MinMaxBlocks::Side;
      this->Spread += std::abs(function[a]) * (0.5 * MinMaxBlocks::Side + margin);
    }
  }
  double AtMiddle(const glm::dvec3& origin) const
  {
    return glm::dot(this->Slope, origin) + this->Middle;
  }
  double Least(const glm::dvec3& origin) const { return this->AtMiddle(origin) - this->Spread; }
  double Most(const glm::dvec3& origin) const { return this->AtMiddle(origin) + this->Spread; }

private:
  glm::dvec3 Slope;
  double Middle, Spread;
};

class Classifier
{
public:
  Classifier(
    const glm::dmat4& indexToClip, const glm::ivec2& viewport, double pointLimit, double margin)
    : Walls{ Wall(indexToClip, 0, 1, margin), Wall(indexToClip, 0, -1, margin),
        Wall(indexToClip, 1, 1, margin), Wall(indexToClip, 1, -1, margin),
        Wall(indexToClip, 2, 1, margin), Wall(indexToClip, 2, -1, margin) },
      W(glm::row(indexToClip, 3), margin),
      Z(glm::row(indexToClip, 2), margin),
      Viewport(viewport),
      PointLimit(pointLimit / (1.0 + 2.0 * margin))
  {
    const glm::dmat4& m = indexToClip;
    for (int a = 0; a < 3; ++a)
    {
      this->CellSize += glm::dvec2(std::abs(m[a].x), std::abs(m[a].y));
      this->CellDepth += std::abs(m[a].w);
    }
  }

  Primitive Of(const glm::dvec3& origin) const
  {
    bool inside = true;
    for (const ClusterRange& wall : this->Walls)
    {
      if (wall.Most(origin) < 0.0)
        return Primitive::None;
      inside &= wall.Least(origin) >= 0.0;
    }
    const double leastW = this->W.Least(origin);
    return inside && leastW > 0.0 && this->CellPixels(leastW) <= this->PointLimit
             ? Primitive::Point
             : Primitive::Rectangle;
  }

  /// Grows away from the eye, in perspective and parallel projections.
  double Depth(const glm::dvec3& origin) const { return this->Z.AtMiddle(origin); }

private:
  /// Positive on the inner side of one of the six walls of what is seen.
  static ClusterRange Wall(const glm::dmat4& indexToClip, int axis, double sign, double margin)
  {
    return { glm::row(indexToClip, 3) + sign * glm::row(indexToClip, axis), margin };
  }

  /// Bound of a cell's extent on screen. Device x is clip x / w with |x / w| <= 1 on screen, so
  /// over a cell it changes by at most (|change of x| + |change of w|) / least w.
  double CellPixels(double leastW) const
  {
    const glm::dvec2 device = (this->CellSize + this->CellDepth) / leastW;
    return std::max(device.x * this->Viewport.x, device.y * this->Viewport.y) * 0.5;
  }

  std::array<ClusterRange, 6> Walls;
  ClusterRange W, Z;
  glm::dvec2 Viewport;
  double PointLimit;
  glm::dvec2 CellSize{ 0.0 };
  double CellDepth = 0.0;
};

struct Seen
{
  std::uint32_t cluster;
  Primitive primitive;
  double depth;
};

/// From front to back, by counting.
std::vector<Seen> SortByDepth(const std::vector<Seen>& seen)
{
  constexpr std::size_t steps = 4096;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const Seen& s : seen)
  {
    least = std::min(least, s.depth);
    most = std::max(most, s.depth);
  }
  const double scale = most > least ? (steps - 1) / (most - least) : 0.0;
  const auto step = [&](const Seen& s)
  { return static_cast<std::size_t>(std::max(0.0, (s.depth - least) * scale)); };
  std::array<std::size_t, steps + 1> starts{};
  for (const Seen& s : seen)
    ++starts[step(s) + 1];
  for (std::size_t n = 0; n < steps; ++n)
    starts[n + 1] += starts[n];
  std::vector<Seen> sorted(seen.size());
  for (const Seen& s : seen)
    sorted[starts[step(s)]++] = s;
  return sorted;
}

/// What one view sees, of clusters that come in the order of their numbers.
struct View
{
  Classifier classifier;
  std::vector<Seen> seen;

  void Add(std::uint32_t cluster, const glm::dvec3& origin)
  {
    const Primitive primitive = this->classifier.Of(origin);
    if (primitive != Primitive::None)
      this->seen.push_back({ cluster, primitive, this->classifier.Depth(origin) });
  }

  VisibleClusters Visible(std::size_t clusters) const
  {
    VisibleClusters visible;
    visible.culled = clusters - this->seen.size();
    for (const Seen& s : SortByDepth(this->seen))
      (s.primitive == Primitive::Point ? visible.points : visible.rectangles).push_back(s.cluster);
    return visible;
  }
};

} // namespace

VisibleClusters CullClusters(const ClusteredCells& cells, const glm::dmat4& indexToClip,
  const glm::ivec2& viewport, double pointLimit, double margin)
{
  View view{ Classifier(indexToClip, viewport, pointLimit, margin), {} };
  for (std::size_t c = 0; c < cells.clusters.size(); ++c)
    view.Add(static_cast<std::uint32_t>(c), glm::dvec3(cells.clusters[c].Origin()));
  return view.Visible(cells.clusters.size());
}

std::vector<VisibleClusters> CullClusters(const ClusteredCells& cells,
  std::span<const glm::dmat4> indexToClip, const glm::ivec2& viewport, double pointLimit,
  double margin)
{
  std::vector<VisibleClusters> visible;
  if (indexToClip.size() == 1) // a list of views would cost a twelfth more
  {
    visible.push_back(CullClusters(cells, indexToClip[0], viewport, pointLimit, margin));
    return visible;
  }
  std::vector<View> views;
  for (const glm::dmat4& matrix : indexToClip)
    views.push_back({ Classifier(matrix, viewport, pointLimit, margin), {} });
  for (std::size_t c = 0; c < cells.clusters.size(); ++c)
  {
    const glm::dvec3 origin(cells.clusters[c].Origin());
    for (View& view : views)
      view.Add(static_cast<std::uint32_t>(c), origin);
  }
  for (const View& view : views)
    visible.push_back(view.Visible(cells.clusters.size()));
  return visible;
}

std::uint32_t UnseenState(const CellCluster& cluster)
{
  std::uint64_t all = 0;
  glsl::uvec3 first(7), last(0);
  for (std::uint32_t z = 0; z < 8; ++z)
    if (cluster.active[z])
    {
      all |= cluster.active[z];
      first.z = std::min(first.z, z);
      last.z = z;
    }
  first.y = std::countr_zero(all) / 8;
  last.y = 7 - std::countl_zero(all) / 8;
  std::uint8_t columns = 0;
  for (int y = 0; y < 8; ++y)
    columns |= static_cast<std::uint8_t>(all >> 8 * y);
  first.x = std::countr_zero(columns);
  last.x = 7 - std::countl_zero(columns);
  return glsl::HaspPackBox(first, last);
}

} // namespace hasp
