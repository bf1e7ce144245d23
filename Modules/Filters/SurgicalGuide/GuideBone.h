#pragma once
#include "Grid/GridView.h"
#include "Grid/Progress.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace hasp
{

/// Distances on a guide's working grid, mm, negative inside, x fastest; shared with solids.
using GuideDistances = std::shared_ptr<const std::vector<float>>;

/// How far it is along a ray (unit direction) to bone as below, within `lengthMm`; 0 from inside
/// it. Bone thinner than half a sample's spacing may be missed. Any thread; one core; O(length).
std::optional<double> WayToBone(const AnyGridView& ct, const std::vector<std::uint8_t>& keep,
  double isovalue, const glm::dvec3& from, const glm::dvec3& direction, double lengthMm);

/// Signed distance to bone: what is >= isovalue and marked in `keep`, one byte a sample of `ct`.
/// Infinite everywhere if all or nothing of the grid is bone. Throws as Coverage; Cancelled. All
/// cores.
GuideDistances DistanceToBone(const AnyGridView& ct, const std::vector<std::uint8_t>& keep,
  double isovalue, const GridGeometry& grid, const ProgressFunction& progress);

/// Undercuts blocked out: of the bone and of all that lies under it against the grid's third axis,
/// which is the withdrawal direction. Along each column the least distance to bone seen so far from
/// above; never steeper than distances are. Bone above the grid shadows it, too: distances to that
/// shadow are of whole columns, within half a spacing. `distances` finite. All cores.
GuideDistances BlockUndercuts(const std::vector<float>& distances, const AnyGridView& ct,
  const std::vector<std::uint8_t>& keep, double isovalue, const GridGeometry& grid,
  const ProgressFunction& progress);

} // namespace hasp
