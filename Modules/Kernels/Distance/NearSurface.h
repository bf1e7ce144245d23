#pragma once
#include "Distance/ImplicitSolid.h"
#include "Grid/GridGeometry.h"
#include "Grid/Progress.h"

#include <array>
#include <vector>

namespace hasp
{

/// A solid's values on a grid, held only where its surface is near: in blocks of 8^3 samples. What
/// is between is farther than the band from the surface, on one side of it.
struct NearSurface
{
  static constexpr int Edge = 8;           ///< samples of a block along each axis
  static constexpr int BlockSamples = 512; ///< x fastest

  enum class Side : std::uint8_t
  {
    Outside, ///< value >= bandMm everywhere in the block
    Inside,  ///< value <= -bandMm
    Near     ///< held
  };

  GridGeometry geometry;
  double bandMm = 0.0;
  glm::ivec3 blocks{ 0 };          ///< along each axis; the last ones may reach over the grid's end
  std::vector<Side> sides;         ///< of each block, x fastest
  std::vector<std::uint32_t> near; ///< numbers of the blocks held, ascending
  /// BlockSamples for each of `near`, mm, NEGATIVE INSIDE, within +-bandMm; bandMm over the end.
  std::vector<float> values;

  /// The sample that a block begins with.
  glm::ivec3 FirstSample(std::uint32_t block) const;
};

/// Asks a solid only where |value| may be below bandMm: whole blocks, and boxes of 8^3 blocks
/// before them, are left out by one value in their middle, since none is steeper than the solid
/// promises.
///
/// bandMm     > 0, finite; two or three times the longest spacing for a contour
/// Throws std::invalid_argument on an invalid geometry, more than 2^32 - 1 blocks, or a band that
/// is not above 0; Cancelled. Any thread; all cores, the same result with any number; O(samples
/// near the surface) and one byte a block.
NearSurface EvaluateNearSurface(const ImplicitSolid& solid, const GridGeometry& geometry,
  double bandMm, const ProgressFunction& progress = {});

/// All samples of the grid, x fastest: the solid's values, as floats, cut off at +-bandMm, just as
/// if each had been asked. Any thread; O(samples), 4 bytes each.
std::vector<float> DenseValues(const NearSurface& field);

} // namespace hasp
