#pragma once
#include "Grid/GridView.h"
#include "Segmentation/LabelMap.h"

#include <span>
#include <vector>

namespace hasp
{

struct CoarseScanSettings
{
  /// mm, of the new grid along the old one's axes; at least the old spacing each. 0: as it was.
  glm::dvec3 spacingMm{ 0.0 };
  glm::dvec3 blurMm{ 0.0 }; ///< standard deviation of a Gaussian along each axis, [0, 10]
};

/// A scan as a coarser scanner has it: each sample is the mean of the old ones over the new voxel's
/// box, blurred. The new grid begins where the old one does: its first voxel's outer faces are the
/// old one's, so that all of the box is in the old grid but for a remainder at the far end.
class CoarseScan
{
public:
  /// Throws std::invalid_argument with field, value and range.
  CoarseScan(const GridGeometry& fine, const CoarseScanSettings& settings);

  const GridGeometry& Geometry() const { return this->Coarse; }

  /// The scan of samples x fastest. Sizes are the old grid's. Rounded to the nearest. All cores,
  /// the same bytes with any number of threads. O(samples), 4 bytes a sample while it works.
  std::vector<std::int16_t> Samples(std::span<const std::int16_t> fine) const;
  /// Of the old voxels in a new one's box the label of most volume, 0 apart: the smaller number of
  /// equals; 0 where none has a label, and where the new sample is below boneHU.
  std::vector<Label> Labels(
    std::span<const Label> fine, std::span<const std::int16_t> coarse, double boneHU) const;

private:
  /// What one new sample takes of the old ones along an axis.
  struct Row
  {
    int first = 0;
    std::vector<float> weights; ///< sum 1
  };
  static std::vector<Row> RowsOf(int fineCount, int coarseCount, double ratio, double blur);

  GridGeometry Fine, Coarse;
  std::vector<Row> Rows[3], Boxes[3]; ///< with the blur; without
};

} // namespace hasp
