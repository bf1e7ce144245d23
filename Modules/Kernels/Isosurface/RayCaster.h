#pragma once
#include "Grid/MinMaxBlocks.h"

#include <glm/vec3.hpp>

#include <limits>
#include <optional>

namespace hasp
{

struct RayHit
{
  double t;            ///< hit = origin + t * direction
  glm::dvec3 position; ///< world, mm
  glm::dvec3 gradient; ///< of the volume at the hit, per mm, world directions; points into the bone
  glm::ivec3 cell;     ///< the cell it lies in
};

/// The same in index coordinates.
struct RayCellHit
{
  double t;
  glm::ivec3 cell;
  glm::dvec3 local; ///< in the cell, [0,1]^3
};

/// The first point of the trilinear isosurface along a ray: the exact root in the first cell that
/// has one, found by walking the min-max blocks and, in active ones, their cells (Amanatides and
/// Woo 1987).
///
/// The grid and its blocks must outlive the caster. Const calls from any thread.
class RayCaster
{
public:
  /// Throws std::invalid_argument if the blocks are not of this grid.
  RayCaster(const AnyGridView& grid, const MinMaxBlocks& blocks, double isovalue);

  /// origin and direction in world mm; direction need not be unit but must not be 0.
  /// Nothing if the ray misses, or if a component is not finite.
  /// O(blocks + active cells passed): about 0.3 us on a head CT.
  std::optional<RayHit> Cast(const glm::dvec3& origin, const glm::dvec3& direction,
    double tMin = 0.0, double tMax = std::numeric_limits<double>::infinity()) const;

  /// The same with origin and direction in index coordinates.
  std::optional<RayCellHit> CastInIndex(const glm::dvec3& origin, const glm::dvec3& direction,
    double tMin = 0.0, double tMax = std::numeric_limits<double>::infinity()) const;

private:
  AnyGridView Grid;
  const MinMaxBlocks* Blocks;
  float Isovalue;
};

} // namespace hasp
