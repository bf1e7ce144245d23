#pragma once
#include "Segmentation/ConeBeamBlocks.h"

#include <vector>

namespace hasp
{

/// What FitThinPlate is to follow, one each a block.
struct BlockData
{
  std::vector<double> weight; ///< >= 0; 1 is a block full of samples that count
  std::vector<double> value;  ///< matters where weight > 0
};

/// The field that is smooth over lengthMm and follows the data: the minimum of
///   sum weight (f - value)^2 + (lengthMm / 2 pi)^4 sum |second differences of f, per mm^2|^2,
/// so that at weight 1 a wave of length lengthMm is halved, and whatever is linear is kept. Begins
/// at `field`, one a block, and ends there. Conjugate gradients; serial. Throws Cancelled.
void FitThinPlate(const BlockGrid& grid, const BlockData& data, double lengthMm, double tolerance,
  std::vector<double>& field, const ProgressFunction& progress);

/// Each value becomes the sum over a Gaussian window, zero beyond the grid; the weights of a whole
/// window sum to 1.
void BlurBlocks(const BlockGrid& grid, double sigmaMm, std::vector<double>& values);

} // namespace hasp
