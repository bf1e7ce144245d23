#pragma once
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hasp
{

/// A place on a surface and the surface's outward normal, unit.
struct OrientedPoint
{
  glm::dvec3 place, normal;
};

/// Points in boxes, so that those near a place are found. Immutable; any thread.
class PointBoxes
{
public:
  /// boxMm > 0; made larger where there would be more than 2^24 boxes.
  PointBoxes(std::span<const OrientedPoint> points, double boxMm);

  /// visit(index) for each point in the boxes that the ball touches: all in the ball, and some
  /// more. In an order that is always the same.
  template <typename Visit>
  void NearTo(const glm::dvec3& center, double radiusMm, Visit&& visit) const
  {
    const glm::ivec3 first = this->BoxOf(center - radiusMm), last = this->BoxOf(center + radiusMm);
    const glm::ivec3 from = glm::max(first, glm::ivec3(0)), to = glm::min(last, this->Counts - 1);
    for (int z = from.z; z <= to.z; ++z)
      for (int y = from.y; y <= to.y; ++y)
      {
        const std::size_t row = (std::size_t(z) * this->Counts.y + y) * this->Counts.x;
        for (std::uint32_t n = this->Starts[row + from.x];
             from.x <= to.x && n < this->Starts[row + to.x + 1]; ++n)
          visit(this->Order[n]);
      }
  }

private:
  glm::ivec3 BoxOf(const glm::dvec3& place) const
  {
    // Clamped before it is an int: places may be far away.
    return glm::ivec3(glm::clamp(
      glm::floor((place - this->Low) / this->BoxMm), glm::dvec3(-1.0), glm::dvec3(this->Counts)));
  }

  glm::dvec3 Low{ 0.0 };
  glm::ivec3 Counts{ 1 };
  double BoxMm;
  std::vector<std::uint32_t> Starts; ///< of each box in Order, x fastest; one more at the end
  std::vector<std::uint32_t> Order;
};

/// The points of a surface around which it is smooth: outer surfaces of bone, and no edge, as a
/// rule no face of a fracture. A point's normal is the mean of those within `radiusMm` that are on
/// the same side of the body, and it is smooth if that mean is at least `flatness` long.
class SmoothPoints
{
public:
  /// all    evenly spread; each stands for `areaMm2`
  /// keptMm2   every n-th is kept, so that each stands for about so much
  SmoothPoints(std::span<const OrientedPoint> all, double areaMm2, double radiusMm, double flatness,
    double keptMm2);

  std::span<const OrientedPoint> Points() const noexcept { return this->Kept; }
  double AreaOfPoint() const noexcept { return this->Area; } ///< mm^2
  /// visit(index of a point) for those near a place, as PointBoxes.
  template <typename Visit>
  void NearTo(const glm::dvec3& center, double radiusMm, Visit&& visit) const
  {
    this->Boxes.NearTo(center, radiusMm, visit);
  }

private:
  std::vector<OrientedPoint> Kept;
  double Area;
  PointBoxes Boxes;
};

} // namespace hasp
