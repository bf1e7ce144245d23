#pragma once
#include "RGBPicture.h"

#include <string>
#include <vector>

namespace hasp
{

/// What may differ between two renderings of the same scene. The figures are those of a picture
/// drawn anew by the same Mesa (byte for byte the same) or by its slow cousin softpipe (at most 6
/// levels, mean 0.06): room for these, and for little else.
struct PictureLimits
{
  double mean = 0.5;   ///< mean absolute difference of all channels, 0 to 255
  int percentile = 12; ///< 99.9 % of the pixels differ less than this in every channel
  double block = 1.5;  ///< largest mean difference, with its sign, of a channel in a 16x16 block
  double ssim = 0.9;   ///< smallest structural similarity of a 16x16 block, luminance, at most 1
};

/// How far two pictures of the same size are apart.
struct PictureDifference
{
  double mean = 0;
  int percentile = 0; ///< 99.9 % of the pixels differ at most this much
  int maximum = 0;
  double block = 0; ///< catches a faint change of shade, which the others lose in the mean
  int blockX = 0;   ///< lower left pixel of that block
  int blockY = 0;
  double ssim = 1; ///< catches changed structure of low contrast; Wang et al. 2004
  int shiftX = 0; ///< moved by this many pixels, at most 4, if that explains most of the difference
  int shiftY = 0;
};

/// Throws std::invalid_argument if the sizes differ or are zero. Any thread. O(pixels) for equal
/// pictures, 81 times that if they differ, for the shift.
PictureDifference ComparePictures(const RGBPicture& got, const RGBPicture& expected);

/// One sentence for each limit that is broken; empty: the pictures are the same.
std::vector<std::string> FindBrokenLimits(
  const PictureDifference& difference, const PictureLimits& limits = {});

/// "mean 0.06 (< 0.5), 99.9 % 3 (< 12), max 6, block 0.3 (< 1.5) at (16, 32), SSIM 0.99 (> 0.9)"
std::string Describe(const PictureDifference& difference, const PictureLimits& limits = {});

/// Absolute differences, eight times as bright, to look at. Throws like ComparePictures.
RGBPicture DrawDifference(const RGBPicture& got, const RGBPicture& expected);

} // namespace hasp
