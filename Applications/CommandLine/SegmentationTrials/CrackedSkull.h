#pragma once
#include "Segmentation/LabelSplit.h"

#include <vector>

namespace hasp
{

/// The phantom's skull with two wavy cracks across each other, as a threshold shows it: large, and
/// made in seconds. For times and memory; its cracks are painted and no truth goes with them.
struct CrackedSkull
{
  GridGeometry geometry;
  std::vector<std::int16_t> samples;
  std::vector<Label> bone;
  /// Four, one in each quarter, then three more: of the same label and of others, off the cracks.
  std::vector<SeedVoxels> strokes;

  static constexpr int First = 4;

  explicit CrackedSkull(double spacingMm);
  GridView<const std::int16_t> Samples() const { return { this->samples.data(), this->geometry }; }
  GridView<const Label> Bone() const { return { this->bone.data(), this->geometry }; }
};

} // namespace hasp
