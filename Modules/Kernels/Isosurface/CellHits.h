#pragma once
#include "Isosurface/ClusteredCells.h"

#include <functional>
#include <optional>

namespace hasp
{

/// Where a line meets the surface.
struct LineHit
{
  std::size_t cell;    ///< number of the active cell
  double t;            ///< the hit is from + t * (to - from), t in [0, 1]
  glm::dvec3 index;    ///< where it is, in index coordinates
  glm::dvec3 gradient; ///< of the samples there, per index step; points to the inside
};

/// Where a line first meets the surface inside active cell n: the root that drawing finds. from and
/// to in index coordinates. Nothing if it does not, or if a coordinate is not finite. Any thread.
/// O(log clusters).
std::optional<LineHit> HitCell(
  const ClusteredCells& cells, std::size_t n, const glm::dvec3& from, const glm::dvec3& to);

/// The first such hit among the cells that `counts` accepts; all do if it is empty. For single
/// lines, picks: O(clusters) and the active cells of those it passes; no tree is built. Any thread.
std::optional<LineHit> FirstHit(const ClusteredCells& cells, const glm::dvec3& from,
  const glm::dvec3& to, const std::function<bool(std::size_t)>& counts = {});

} // namespace hasp
