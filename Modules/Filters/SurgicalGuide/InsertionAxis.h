#pragma once
#include "Distance/ImplicitSolid.h"
#include "Grid/GridView.h"

#include <cstdint>
#include <vector>

namespace hasp
{

/// A direction to lift a guide off along, and what it costs.
struct InsertionAxis
{
  glm::dvec3 direction;  ///< unit
  double undercut = 0.0; ///< share of the bone's area in the region that it does not reach
};

/// The direction of least undercut within `mostDeg` of `start`, unit; at most 60: five degrees
/// apart, and `start` itself where none is better by a hundredth of the area a full search's angle
/// away.
///
/// Bone is what is >= isovalue and marked in `keep`, one byte a sample of `ct`. Its surface is
/// taken as the samples with a side open, each with the area of its open sides; the region is where
/// `region` is below 0. A sample is undercut along a direction if its surface faces away or lies
/// along it, or bone lies before it. The area is that of all samples that any direction within 60
/// degrees of `start` reaches (15 apart). Accuracy is that of samples: what is undercut by less
/// than one counts as reached. Throws std::runtime_error if no direction asked for reaches bone in
/// the region. All cores, the same result with any number. O(samples + directions * surface
/// samples).
InsertionAxis FindInsertionAxis(const AnyGridView& ct, const std::vector<std::uint8_t>& keep,
  const ImplicitSolid& region, const glm::dvec3& start, double mostDeg);

} // namespace hasp
