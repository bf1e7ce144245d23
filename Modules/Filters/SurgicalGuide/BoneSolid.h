#pragma once
#include "Distance/ImplicitSolid.h"
#include "FragmentCutter.h"

#include <memory>
#include <span>
#include <vector>

namespace hasp
{

/// Bone as samples of its distance, so that it can be a solid in any pose.
struct BoneDistance
{
  std::shared_ptr<const std::vector<float>> distance; ///< mm, NEGATIVE INSIDE, a band
  GridGeometry grid;

  SolidPointer Solid() const;
};

/// Samples that are bone: 1, else 0; islands of less than ignoreBelowMm3 are not, without labels.
/// Throws std::invalid_argument, beginning with `who`, as CheckLabelGrid does.
std::vector<std::uint8_t> MarkBone(const char* who, const BoneImage& bone, double isovalue,
  double ignoreBelowMm3, const ProgressFunction& progress);

/// The island of MarkBone that is nearest to a place: 1, else 0. Empty if there is none within
/// `withinMm` of it.
std::vector<std::uint8_t> IslandNear(const char* who, const BoneImage& bone, double isovalue,
  double ignoreBelowMm3, const glm::dvec3& place, double withinMm,
  const ProgressFunction& progress);

/// keep   one byte a sample of `grey`: bone is value >= isovalue, there
/// The grid has the volume's axes and reaches four spacings beyond what is kept. Throws
/// std::invalid_argument, beginning with `who`, if nothing is kept or it had over 2e8 points.
BoneDistance DistanceOfBone(const char* who, const AnyGridView& grey, double isovalue,
  std::span<const std::uint8_t> keep, double spacingMm, const ProgressFunction& progress);

/// The same place with other steps.
GridGeometry WithSpacing(const GridGeometry& grid, double spacingMm);

} // namespace hasp
