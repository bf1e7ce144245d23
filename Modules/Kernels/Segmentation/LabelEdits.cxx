#include "Segmentation/LabelEdits.h"

#include "Grid/ProgressPart.h"
#include "Segmentation/BoxRows.h"

#include <stdexcept>
#include <string>
#include <utility>

namespace hasp
{

LabelDelta PaintVoxels(GridView<Label> labels, std::span<const VoxelRun> voxels, Label label,
  Label only, const ProgressFunction& progress)
{
  const std::uint64_t size = labels.geometry.Size();
  LabelDelta delta{ labels.geometry.dims, {} };
  for (std::size_t n = 0; n < voxels.size(); ++n)
  {
    if (n % 4096 == 0)
      ReportProgress(progress, double(n) / double(voxels.size()));
    const VoxelRun& run = voxels[n];
    if (run.first >= size || run.length > size - run.first)
      throw std::invalid_argument("paint: voxels up to " + std::to_string(run.first + run.length) +
                                  " do not lie in a map of " + std::to_string(size));
    const std::uint64_t end = run.first + run.length;
    for (std::uint64_t v = run.first, next = v; v < end; v = next)
    {
      const Label before = labels.data[v];
      for (next = v + 1; next < end && labels.data[next] == before;)
        ++next;
      if (only == 0 || before == only)
        delta.Append({ v, std::uint32_t(next - v), before, label });
    }
  }
  ReportProgress(progress, 1.0);
  return Made(std::move(delta), labels);
}

LabelDelta MergeLabels(
  GridView<Label> labels, Label from, Label into, const ProgressFunction& progress)
{
  if (from == 0)
    throw std::invalid_argument(
      "merge: label 0 is nothing and cannot be merged, must be in [1, 65535]");
  const GridView<const Label> before{ labels.data, labels.geometry };
  LabelDelta delta = ProposeRows(
    before, BoxOfLabel(before, from, PartOf(progress, 0.0, 0.5)),
    [from, into](int, int, std::span<Label> row)
    { std::replace(row.begin(), row.end(), from, into); },
    PartOf(progress, 0.5, 1.0));
  return Made(std::move(delta), labels);
}

} // namespace hasp
