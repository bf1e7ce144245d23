#include "ComparePictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace hasp
{
namespace
{

constexpr int blockSize = 16;
constexpr int largestShift = 4;

void CheckSizes(const RGBPicture& got, const RGBPicture& expected)
{
  const auto size = [](const RGBPicture& p)
  { return std::to_string(p.width) + "x" + std::to_string(p.height); };
  if (got.width != expected.width || got.height != expected.height)
    throw std::invalid_argument(
      "pictures differ in size: got " + size(got) + ", expected " + size(expected));
  if (got.width <= 0 || got.height <= 0)
    throw std::invalid_argument("pictures are empty: " + size(got));
}

void MeasurePixels(const RGBPicture& got, const RGBPicture& expected, PictureDifference& result)
{
  std::array<std::size_t, 256> histogram{};
  std::size_t sum = 0;
  for (std::size_t p = 0; p < got.pixels.size(); p += 3)
  {
    int largest = 0;
    for (int c = 0; c < 3; ++c)
    {
      const int d = std::abs(got.pixels[p + c] - expected.pixels[p + c]);
      sum += d;
      largest = std::max(largest, d);
    }
    ++histogram[largest];
  }
  result.mean = static_cast<double>(sum) / got.pixels.size();
  const double wanted = 0.999 * (got.pixels.size() / 3);
  std::size_t seen = 0;
  for (int level = 0; level < 256; ++level)
  {
    if (histogram[level] > 0)
      result.maximum = level;
    if (seen < wanted)
      result.percentile = level;
    seen += histogram[level];
  }
}

/// Calls visit(x0, y0, x1, y1) for blocks that overlap by half; the last block of a row or column
/// ends at the border, so that none is smaller.
template <typename Visit>
void ForEachBlock(const RGBPicture& picture, const Visit& visit)
{
  constexpr int step = blockSize / 2;
  const int w = std::min(blockSize, picture.width), h = std::min(blockSize, picture.height);
  for (int y = 0;; y += step)
  {
    const int y0 = std::min(y, picture.height - h);
    for (int x = 0;; x += step)
    {
      const int x0 = std::min(x, picture.width - w);
      visit(x0, y0, x0 + w, y0 + h);
      if (x0 == picture.width - w)
        break;
    }
    if (y0 == picture.height - h)
      break;
  }
}

void MeasureBlocks(const RGBPicture& got, const RGBPicture& expected, PictureDifference& result)
{
  ForEachBlock(got,
    [&](int x0, int y0, int x1, int y1)
    {
      int sum[3] = {};
      for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x)
          for (int c = 0; c < 3; ++c)
            sum[c] += got.At(x, y)[c] - expected.At(x, y)[c];
      const int largest = std::max({ std::abs(sum[0]), std::abs(sum[1]), std::abs(sum[2]) });
      const double mean = largest / (static_cast<double>(x1 - x0) * (y1 - y0));
      if (mean > result.block)
      {
        result.block = mean;
        result.blockX = x0;
        result.blockY = y0;
      }
    });
}

double Luminance(const std::uint8_t* rgb)
{
  return 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2]; // Rec. 601
}

/// Structural similarity of one window, with the constants of Wang et al. 2004, Eq. 13.
double MeasureWindow(const RGBPicture& a, const RGBPicture& b, int x0, int y0, int x1, int y1)
{
  constexpr double c1 = (0.01 * 255) * (0.01 * 255), c2 = (0.03 * 255) * (0.03 * 255);
  double sumA = 0, sumB = 0, sumAA = 0, sumBB = 0, sumAB = 0;
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x)
    {
      const double va = Luminance(a.At(x, y)), vb = Luminance(b.At(x, y));
      sumA += va;
      sumB += vb;
      sumAA += va * va;
      sumBB += vb * vb;
      sumAB += va * vb;
    }
  const double n = static_cast<double>(x1 - x0) * (y1 - y0);
  const double meanA = sumA / n, meanB = sumB / n;
  const double varianceA = std::max(0.0, sumAA / n - meanA * meanA);
  const double varianceB = std::max(0.0, sumBB / n - meanB * meanB);
  const double covariance = sumAB / n - meanA * meanB;
  return (2 * meanA * meanB + c1) * (2 * covariance + c2) /
         ((meanA * meanA + meanB * meanB + c1) * (varianceA + varianceB + c2));
}

/// Mean absolute difference of the green channel where `got`, moved back by (dx, dy), lies on
/// `expected`.
double MeanWhenShifted(const RGBPicture& got, const RGBPicture& expected, int dx, int dy)
{
  std::size_t sum = 0;
  for (int y = largestShift; y < got.height - largestShift; ++y)
    for (int x = largestShift; x < got.width - largestShift; ++x)
      sum += std::abs(got.At(x + dx, y + dy)[1] - expected.At(x, y)[1]);
  return static_cast<double>(sum);
}

void FindShift(const RGBPicture& got, const RGBPicture& expected, PictureDifference& result)
{
  if (got.width <= 2 * largestShift || got.height <= 2 * largestShift)
    return;
  // "Most of the difference": what remains after moving is less than half.
  double best = MeanWhenShifted(got, expected, 0, 0) / 2;
  for (int dy = -largestShift; dy <= largestShift; ++dy)
    for (int dx = -largestShift; dx <= largestShift; ++dx)
    {
      const double moved = MeanWhenShifted(got, expected, dx, dy);
      if (moved < best)
      {
        best = moved;
        result.shiftX = dx;
        result.shiftY = dy;
      }
    }
}

} // namespace

PictureDifference ComparePictures(const RGBPicture& got, const RGBPicture& expected)
{
  CheckSizes(got, expected);
  PictureDifference result;
  MeasurePixels(got, expected, result);
  if (result.maximum == 0)
    return result;
  MeasureBlocks(got, expected, result);
  ForEachBlock(got, [&](int x0, int y0, int x1, int y1)
    { result.ssim = std::min(result.ssim, MeasureWindow(got, expected, x0, y0, x1, y1)); });
  FindShift(got, expected, result);
  return result;
}

std::vector<std::string> FindBrokenLimits(
  const PictureDifference& difference, const PictureLimits& limits)
{
  std::vector<std::string> broken;
  if (!(difference.mean < limits.mean))
    broken.emplace_back("the mean difference is too large");
  if (!(difference.percentile < limits.percentile))
    broken.emplace_back("too many pixels differ clearly");
  if (!(difference.block < limits.block))
    broken.emplace_back("a region has another shade or shape");
  if (!(difference.ssim > limits.ssim))
    broken.emplace_back("the structure differs somewhere");
  return broken;
}

std::string Describe(const PictureDifference& d, const PictureLimits& limits)
{
  std::ostringstream text;
  text.precision(3);
  text << "mean " << d.mean << " (< " << limits.mean << "), 99.9 % " << d.percentile << " (< "
       << limits.percentile << "), max " << d.maximum << ", block " << d.block << " (< "
       << limits.block << ") at (" << d.blockX << ", " << d.blockY << "), SSIM " << d.ssim << " (> "
       << limits.ssim << ")";
  if (d.shiftX != 0 || d.shiftY != 0)
    text << ", looks moved by (" << d.shiftX << ", " << d.shiftY << ") pixels";
  return text.str();
}

RGBPicture DrawDifference(const RGBPicture& got, const RGBPicture& expected)
{
  CheckSizes(got, expected);
  RGBPicture result(got.width, got.height);
  for (std::size_t p = 0; p < got.pixels.size(); ++p)
    result.pixels[p] =
      static_cast<std::uint8_t>(std::min(255, 8 * std::abs(got.pixels[p] - expected.pixels[p])));
  return result;
}

} // namespace hasp
