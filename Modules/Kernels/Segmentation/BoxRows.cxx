#include "Segmentation/BoxRows.h"

namespace hasp
{

LabelDelta ProposeRows(GridView<const Label> labels, const VoxelBox& box, const RowChange& change,
  const ProgressFunction& progress)
{
  const BoxRows rows(box);
  const auto width = static_cast<std::size_t>(box.Size().x);
  std::vector<LabelDelta> pieces(static_cast<std::size_t>(rows.Pieces()));
  rows.ForEach(progress,
    [&](std::size_t piece, int j, int k)
    {
      const std::size_t start = labels.Offset(box.low.x, j, k);
      const Label* before = labels.data + start;
      std::vector<Label> after(before, before + width);
      change(j, k, after);
      const auto differs = [&](std::size_t i)
      {
        return std::size_t(
          std::mismatch(after.begin() + std::ptrdiff_t(i), after.end(), before + i).first -
          after.begin());
      };
      for (std::size_t i = differs(0), end = 0; i < width; i = differs(end))
      {
        for (end = i + 1; end < width && before[end] == before[i] && after[end] == after[i];)
          ++end;
        pieces[piece].Append({ start + i, std::uint32_t(end - i), before[i], after[i] });
      }
    });
  LabelDelta all{ labels.geometry.dims, {} };
  std::size_t count = 0;
  for (const LabelDelta& piece : pieces)
    count += piece.runs.size();
  all.runs.reserve(count);
  for (const LabelDelta& piece : pieces)
    for (const LabelRun& run : piece.runs)
      all.Append(run);
  return all;
}

LabelDelta Made(LabelDelta proposed, GridView<Label> labels)
{
  proposed.runs.shrink_to_fit();
  ApplyDelta(proposed, labels);
  return proposed;
}

} // namespace hasp
