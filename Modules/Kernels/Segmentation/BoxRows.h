#pragma once
#include "Grid/ParallelFor.h"
#include "Segmentation/LabelDelta.h"

#include <algorithm>
#include <functional>
#include <span>

namespace hasp
{

/// The rows along x of a box, j before k, cut into pieces that do not depend on the threads.
class BoxRows
{
public:
  explicit BoxRows(const VoxelBox& box)
    : Box(box),
      Count(std::int64_t(box.Size().y) * box.Size().z),
      PerPiece(std::max<std::int64_t>(1, (1 << 16) / std::max(box.Size().x, 1)))
  {
  }

  std::int64_t Pieces() const
  {
    return this->Box.Empty() ? 0 : (this->Count + this->PerPiece - 1) / this->PerPiece;
  }

  /// Calls body(piece, j, k) for all rows, those of a piece one after the other, pieces side by
  /// side; progress between groups of pieces.
  template <typename Body>
  void ForEach(const ProgressFunction& progress, Body&& body) const
  {
    constexpr std::int64_t group = 64;
    for (std::int64_t from = 0; from < this->Pieces(); from += group)
    {
      ReportProgress(progress, double(from) / double(this->Pieces()));
      ParallelFor(from, std::min(from + group, this->Pieces()), 1,
        [&](std::int64_t piece, std::int64_t)
        {
          const std::int64_t last = std::min(this->Count, (piece + 1) * this->PerPiece);
          for (std::int64_t row = piece * this->PerPiece; row < last; ++row)
            body(static_cast<std::size_t>(piece), this->Box.low.y + int(row % this->Box.Size().y),
              this->Box.low.z + int(row / this->Box.Size().y));
        });
    }
    ReportProgress(progress, 1.0);
  }

private:
  VoxelBox Box;
  std::int64_t Count, PerPiece;
};

/// Writes into `row`, which holds the labels of voxels (box.low.x … box.high.x - 1, j, k), what
/// they shall become.
using RowChange = std::function<void(int j, int k, std::span<Label> row)>;

/// The delta of a change that is told row by row. The map itself is only read, so that who is
/// cancelled, or throws, has changed nothing. Rows side by side.
LabelDelta ProposeRows(GridView<const Label> labels, const VoxelBox& box, const RowChange& change,
  const ProgressFunction& progress);

/// Makes a proposed change and hands it back, with no more memory than it needs.
LabelDelta Made(LabelDelta proposed, GridView<Label> labels);

} // namespace hasp
