#pragma once
#include "Segmentation/Brush.h"
#include "Segmentation/LabelMap.h"
#include "Segmentation/LabelSplit.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace hasp
{

/// What methods of others are given. Lives as long as runs do.
struct SplitInput
{
  GridView<const std::int16_t> grey;
  GridView<const Label> bone; ///< not 0 where there is bone
  std::vector<SeedVoxels> seeds;
};

/// A method of others on its input, which it has in its own form already.
class SplitRun
{
public:
  virtual ~SplitRun() = default;
  virtual void Run() = 0;                        ///< what is timed
  virtual std::vector<Label> Labels() const = 0; ///< of the last run, one a voxel
};

/// A library that is not there gives `absent`, and no run.
struct SplitRival
{
  std::string name; ///< with version and settings
  std::string absent{};
  std::function<std::unique_ptr<SplitRun>(const SplitInput&)> make{};
};

/// ITK's MorphologicalWatershedFromMarkersImageFilter (HASP_ENABLE_ITK), seeded by the strokes,
/// without lines between basins: of the inverted grey values, in which cracks are ridges, and of
/// the gradient's size. VTK 9.1 has no watershed.
std::vector<SplitRival> WatershedRivals();

} // namespace hasp
