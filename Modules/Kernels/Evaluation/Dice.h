#pragma once
#include "Grid/GridView.h"
#include "Grid/Progress.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/// How far a segmentation agrees with a truth on the same grid: Dice of volumes, and of surfaces at
/// a tolerance (Nikolov et al. 2018).
namespace hasp
{

/// Which label of a result stands for a label of the truth.
enum class LabelPairing
{
  SameNumber, ///< the one of the same number
  BestMatch   ///< each at most one, so that the sum of Dice is largest (BestMatch.h)
};

struct DiceSettings
{
  /// Of surface Dice: as far apart surfaces still agree, >= 0. "One voxel" is, where spacing
  /// differs per axis, the largest spacing: across slices no surface is known better.
  double toleranceMm = 1.0;
  LabelPairing pairing = LabelPairing::SameNumber;
};

/// One label of the truth and what stands for it.
///
/// A surface voxel has a face, or more, that another label lies behind, or label 0; the grid's
/// border is no face, since nobody knows what lies behind it. Its weight is the area of those
/// faces. It is near if the centre of a surface voxel of the other map's label is at most
/// toleranceMm away (and 1e-9 of it, for rounding), by exact Euclidean distance.
struct LabelDice
{
  std::uint16_t truth = 0;  ///< >= 1
  std::uint16_t result = 0; ///< 0: none stands for it
  ///@{
  /// Voxels of the label in each map, and in both.
  std::size_t truthVoxels = 0, resultVoxels = 0, sharedVoxels = 0;
  ///@}
  ///@{
  /// mm^2 of each map's surface of the label, and of what of it is near the other's.
  double truthAreaMm2 = 0.0, resultAreaMm2 = 0.0, truthNearMm2 = 0.0, resultNearMm2 = 0.0;
  ///@}

  /// 2 |A and B| / (|A| + |B|), in [0,1].
  double Dice() const;
  /// (near of A + near of B) / (area of A + area of B), in [0,1]. Where neither has a surface, both
  /// fill the grid or one is not there: 1 and 0.
  double SurfaceDice() const;
};

struct SegmentationDice
{
  std::vector<LabelDice> labels; ///< of the truth, by number; at least one
  std::size_t strayVoxels = 0;   ///< of labels >= 1 of the result that stand for none

  const LabelDice& Worst() const;        ///< of the lowest Dice, the first of equals
  const LabelDice& WorstSurface() const; ///< of the lowest surface Dice
};

/// truth, result   labels on one grid; 0 is nothing. Spacing may differ per axis.
///
/// Throws std::invalid_argument if the grids differ in size or by more than a hundredth of a voxel
/// in place, if the truth has no label, if toleranceMm is negative, not finite or reaches more than
/// 2^20 voxels, and if more than 2,048 labels of a map are to be matched; Cancelled. All cores, the
/// same figures with any number of threads. Two passes over both maps; surface voxels that are not
/// near ask all voxels within the tolerance. No memory that grows with the grid.
SegmentationDice CompareLabels(GridView<const std::uint16_t> truth,
  GridView<const std::uint16_t> result, const DiceSettings& settings = {},
  const ProgressFunction& progress = {});

} // namespace hasp
