#include "Isosurface/ClusterCulling.h"
#include "Grid/MinMaxBlocks.h"

#include <glm/vec4.hpp>

#include <algorithm>
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

class Classifier
{
public:
  Classifier(const glm::dmat4& indexToClip, const glm::ivec2& viewport, double pointLimit)
    : Clip(indexToClip),
      Viewport(viewport),
      PointLimit(pointLimit)
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
    bool inside = true, outside[6] = { true, true, true, true, true, true };
    double leastW = std::numeric_limits<double>::infinity();
    for (int c = 0; c < 8; ++c)
    {
      const glm::dvec3 corner =
        origin + double(MinMaxBlocks::Side) * glm::dvec3(c & 1, c >> 1 & 1, c >> 2);
      const glm::dvec4 p = this->Clip * glm::dvec4(corner, 1.0);
      leastW = std::min(leastW, p.w);
      for (int a = 0; a < 3; ++a)
      {
        outside[2 * a] &= p[a] < -p.w;
        outside[2 * a + 1] &= p[a] > p.w;
        inside &= std::abs(p[a]) <= p.w;
      }
    }
    if (std::any_of(std::begin(outside), std::end(outside), [](bool all) { return all; }))
      return Primitive::None;
    return inside && leastW > 0.0 && this->CellPixels(leastW) <= this->PointLimit
             ? Primitive::Point
             : Primitive::Rectangle;
  }

private:
  /// Bound of a cell's extent on screen. Device x is clip x / w with |x / w| <= 1 on screen, so
  /// over a cell it changes by at most (|change of x| + |change of w|) / least w.
  double CellPixels(double leastW) const
  {
    const glm::dvec2 device = (this->CellSize + this->CellDepth) / leastW;
    return std::max(device.x * this->Viewport.x, device.y * this->Viewport.y) * 0.5;
  }

  glm::dmat4 Clip;
  glm::dvec2 Viewport;
  double PointLimit;
  glm::dvec2 CellSize{ 0.0 };
  double CellDepth = 0.0;
};

} // namespace

VisibleClusters CullClusters(const ClusteredCells& cells, const glm::dmat4& indexToClip,
  const glm::ivec2& viewport, double pointLimit)
{
  VisibleClusters visible;
  const Classifier classifier(indexToClip, viewport, pointLimit);
  for (std::size_t c = 0; c < cells.clusters.size(); ++c)
    switch (classifier.Of(glm::dvec3(cells.clusters[c].Origin())))
    {
      case Primitive::Point:
        visible.points.push_back(static_cast<std::uint32_t>(c));
        break;
      case Primitive::Rectangle:
        visible.rectangles.push_back(static_cast<std::uint32_t>(c));
        break;
      case Primitive::None:
        ++visible.culled;
        break;
    }
  return visible;
}

} // namespace hasp
