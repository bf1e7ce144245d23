#pragma once
#include "Grid/RigidPose.h"
#include "Reduction/FractureFit.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

/// A block of 30 x 20 x 24 mm broken across the middle, in closed form: both halves lie in the
/// world as they were before, so that the truth is the identity.
struct BrokenBlock
{
  double wave = 1.5;  ///< height of the face's waves, mm; 0: a flat face
  double lost = 0.0;  ///< the most that the upper half's face lost, from place to place, mm
  double wider = 0.0; ///< the lower half reaches so much farther to all sides, mm
  double spacing = 0.5;
  bool mirrored = false; ///< the upper half is its own mirror image, in x

  /// Height of the face. Its waves are no multiples of each other: no shift fits as well.
  double Height(double x, double y) const
  {
    return this->wave *
           (std::sin(0.55 * x + 0.3) * std::cos(0.43 * y) + 0.5 * std::sin(0.83 * y - 0.71 * x));
  }

  hasp::PlacedBody Half(bool upper) const
  {
    hasp::GridGeometry grid;
    grid.spacing = glm::dvec3(this->spacing);
    const glm::dvec2 side = glm::dvec2(15.0, 10.0) + (upper ? 0.0 : this->wider);
    const glm::dvec3 low(-side, upper ? -3.0 : -12.0), high(side, upper ? 12.0 : 3.0);
    const double margin = 9.0;
    grid.origin = low - margin;
    grid.dims = glm::ivec3(glm::ceil((high - low + 2.0 * margin) / this->spacing)) + 1;
    std::vector<float> distances(grid.Size());
    std::size_t n = 0;
    for (int k = 0; k < grid.dims.z; ++k)
      for (int j = 0; j < grid.dims.y; ++j)
        for (int i = 0; i < grid.dims.x; ++i)
          distances[n++] = float(this->Distance(grid.IndexToWorld({ i, j, k }), upper));
    const hasp::GridView<const float> view{ distances.data(), grid };
    const glm::dvec3 origin(0.0, 0.0, upper ? 6.0 : -6.0);
    auto map = std::make_shared<const hasp::DistanceMap>(
      view, hasp::DistanceMapSettings{ .rangeMm = 8.0, .origin = origin });
    auto shell = hasp::PointShell::OfSurface(view, origin, { .points = 4096 });
    return { std::make_shared<const hasp::FitBody>(std::move(map), std::move(shell)), { origin } };
  }

private:
  double Lost(const glm::dvec3& x) const
  {
    return 0.5 * this->lost * (1.0 + std::sin(0.9 * x.x + 1.0) * std::sin(1.1 * x.y));
  }

  double Distance(const glm::dvec3& x, bool upper) const
  {
    const double wider = upper ? 0.0 : this->wider;
    const glm::dvec3 q = glm::abs(x) - glm::dvec3(15.0 + wider, 10.0 + wider, 12.0);
    const double box =
      glm::length(glm::max(q, glm::dvec3(0.0))) + std::min(0.0, std::max({ q.x, q.y, q.z }));
    const double own = this->mirrored && upper ? -x.x : x.x;
    const double height = this->Height(own, x.y), step = 1e-4;
    const double dx = (this->Height(own + step, x.y) - height) / step;
    const double dy = (this->Height(own, x.y + step) - height) / step;
    const double above = (x.z - height) / std::sqrt(1.0 + dx * dx + dy * dy);
    return std::max(box, upper ? -above + this->Lost(x) : above);
  }
};

/// The upper half, to be moved, before the lower one.
struct Halves
{
  hasp::PlacedBody upper, lower;
  std::vector<hasp::GroupBody> moved;
  hasp::FitScene scene;

  explicit Halves(const BrokenBlock& block) : upper(block.Half(true)), lower(block.Half(false))
  {
    this->moved = { { this->upper.body, {} } };
    this->scene.partners = { this->lower };
  }
  double Off(const hasp::FractureFit& fit) const
  {
    return hasp::RmsWay(this->moved, this->upper.bodyInWorld, fit.groupInWorld);
  }
};

/// A pose that stands `mm` and `degrees` off another, about the body's origin.
inline hasp::RigidPose Moved(
  const hasp::RigidPose& from, const glm::dvec3& shift, const glm::dvec3& axis, double degrees)
{
  return { from.position + shift,
    hasp::TurnBy(glm::normalize(axis) * glm::radians(degrees)) * from.orientation };
}

inline double DegreesBetween(const hasp::RigidPose& a, const hasp::RigidPose& b)
{
  return glm::degrees(
    glm::length(hasp::RotationVector(a.orientation * glm::conjugate(b.orientation))));
}
