#include "Segmentation/VoxelBox.h"

#include "Segmentation/BoxRows.h"

namespace hasp
{

VoxelBox BoxOfLabel(GridView<const Label> labels, Label label, const ProgressFunction& progress)
{
  const VoxelBox whole{ glm::ivec3(0), labels.geometry.dims };
  const BoxRows rows(whole);
  std::vector<VoxelBox> boxes(static_cast<std::size_t>(rows.Pieces()),
    VoxelBox{ whole.high, whole.low }); // grows from nothing
  rows.ForEach(progress,
    [&](std::size_t piece, int j, int k)
    {
      const Label* row = &labels(0, j, k);
      const Label* end = row + whole.high.x;
      const Label* first = std::find(row, end, label);
      if (first == end)
        return;
      const Label* last = end - 1;
      while (*last != label)
        --last;
      VoxelBox& box = boxes[piece];
      box.low = glm::min(box.low, glm::ivec3(first - row, j, k));
      box.high = glm::max(box.high, glm::ivec3(last - row + 1, j + 1, k + 1));
    });
  VoxelBox all{ whole.high, whole.low };
  for (const VoxelBox& box : boxes)
    all = { glm::min(all.low, box.low), glm::max(all.high, box.high) };
  return all.Empty() ? VoxelBox{} : all;
}

} // namespace hasp
