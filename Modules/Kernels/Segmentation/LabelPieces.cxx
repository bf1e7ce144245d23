#include "Segmentation/LabelPieces.h"

#include "Grid/ProgressPart.h"
#include "Segmentation/BoxRows.h"

#include <limits>
#include <stdexcept>

namespace hasp
{
namespace
{

/// Runs of the label in a row, or of all else.
template <typename Emit>
void ForRuns(const Label* row, int low, int high, Label label, bool of, Emit&& emit)
{
  for (int i = low; i < high;)
  {
    while (i < high && (row[i] == label) != of)
      ++i;
    const int begin = i;
    while (i < high && (row[i] == label) == of)
      ++i;
    if (i > begin)
      emit(begin, i);
  }
}

/// Joins what touches. While it works, `piece` of a run is an earlier run of its piece, or itself.
class PieceJoiner
{
public:
  explicit PieceJoiner(LabelPieces& pieces) : Pieces(pieces) {}

  /// Within slices first <= k < last. Touches runs of these alone.
  void JoinSlab(int first, int last)
  {
    for (int k = first; k < last; ++k)
      for (int j = this->Pieces.box.low.y; j < this->Pieces.box.high.y; ++j)
      {
        if (j > this->Pieces.box.low.y)
          this->JoinRows(this->RowOf(j - 1, k), this->RowOf(j, k));
        if (k > first)
          this->JoinRows(this->RowOf(j, k - 1), this->RowOf(j, k));
      }
  }

  /// Slice k with the one before.
  void JoinSeam(int k)
  {
    for (int j = this->Pieces.box.low.y; j < this->Pieces.box.high.y; ++j)
      this->JoinRows(this->RowOf(j, k - 1), this->RowOf(j, k));
  }

  /// Numbers the pieces from 0. Roots come before all others of their piece.
  void Number()
  {
    std::vector<LabelPieces::Run>& runs = this->Pieces.runs;
    for (std::size_t r = 0; r < runs.size(); ++r)
      runs[r].piece = runs[r].piece == r ? this->Pieces.count++ : runs[runs[r].piece].piece;
  }

private:
  std::size_t RowOf(int j, int k) const
  {
    const VoxelBox& box = this->Pieces.box;
    return std::size_t(k - box.low.z) * box.Size().y + (j - box.low.y);
  }

  std::uint32_t Root(std::uint32_t r)
  {
    std::vector<LabelPieces::Run>& runs = this->Pieces.runs;
    while (runs[r].piece != r)
      r = runs[r].piece = runs[runs[r].piece].piece;
    return r;
  }

  void JoinRows(std::size_t rowA, std::size_t rowB)
  {
    std::uint64_t a = this->Pieces.rowStart[rowA], b = this->Pieces.rowStart[rowB];
    const std::uint64_t endA = this->Pieces.rowStart[rowA + 1];
    const std::uint64_t endB = this->Pieces.rowStart[rowB + 1];
    while (a < endA && b < endB)
    {
      const LabelPieces::Run &runA = this->Pieces.runs[a], &runB = this->Pieces.runs[b];
      if (runA.begin < runB.end && runB.begin < runA.end)
      {
        const std::uint32_t rootA = this->Root(std::uint32_t(a)),
                            rootB = this->Root(std::uint32_t(b));
        this->Pieces.runs[std::max(rootA, rootB)].piece = std::min(rootA, rootB);
      }
      ++(runA.end < runB.end ? a : b);
    }
  }

  LabelPieces& Pieces;
};

/// Fills rowStart and runs, each of which is a piece of its own.
void FindRuns(LabelPieces& pieces, GridView<const Label> labels, Label label, bool of,
  const ProgressFunction& progress)
{
  const VoxelBox& box = pieces.box;
  const BoxRows rows(box);
  const auto rowOf = [&box](int j, int k)
  { return std::size_t(k - box.low.z) * box.Size().y + (j - box.low.y); };
  pieces.rowStart.assign(std::size_t(box.Size().y) * box.Size().z + 1, 0);
  rows.ForEach(PartOf(progress, 0.0, 0.5),
    [&](std::size_t, int j, int k)
    {
      std::uint64_t& count = pieces.rowStart[rowOf(j, k) + 1];
      ForRuns(&labels(0, j, k), box.low.x, box.high.x, label, of, [&count](int, int) { ++count; });
    });
  for (std::size_t row = 1; row < pieces.rowStart.size(); ++row)
    pieces.rowStart[row] += pieces.rowStart[row - 1];
  if (pieces.rowStart.back() >= std::numeric_limits<std::uint32_t>::max())
    throw std::runtime_error("pieces of a label: " + std::to_string(pieces.rowStart.back()) +
                             " runs of voxels, must be fewer than 2^32 - 1; filter the scan, or "
                             "choose a box");
  pieces.runs.resize(pieces.rowStart.back());
  rows.ForEach(PartOf(progress, 0.5, 1.0),
    [&](std::size_t, int j, int k)
    {
      std::uint64_t next = pieces.rowStart[rowOf(j, k)];
      ForRuns(&labels(0, j, k), box.low.x, box.high.x, label, of,
        [&](int begin, int end)
        {
          pieces.runs[next] = { begin, end, std::uint32_t(next) };
          ++next;
        });
    });
}

} // namespace

LabelPieces FindLabelPieces(GridView<const Label> labels, const VoxelBox& box, Label label, bool of,
  const ProgressFunction& progress)
{
  LabelPieces pieces;
  pieces.box = box;
  FindRuns(pieces, labels, label, of, PartOf(progress, 0.0, 0.5));
  PieceJoiner joiner(pieces);
  constexpr int slab = 8, group = 8 * slab;
  for (int from = box.low.z; from < box.high.z; from += group)
  {
    ReportProgress(progress, 0.5 + 0.5 * double(from - box.low.z) / box.Size().z);
    const int to = std::min(from + group, box.high.z);
    ParallelFor(from, to, slab,
      [&](std::int64_t first, std::int64_t last) { joiner.JoinSlab(int(first), int(last)); });
    for (int k = from; k < to; k += slab)
      if (k > box.low.z)
        joiner.JoinSeam(k);
  }
  joiner.Number();
  ReportProgress(progress, 1.0);
  return pieces;
}

} // namespace hasp
