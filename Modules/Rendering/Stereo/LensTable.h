#pragma once
#include "LensModel.h"
#include "vtkHaspRenderingStereoModule.h" // for export macro

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

/// A lens as whole numbers, one sample position for each pixel: what the GPU and the CPU do with it
/// is integer arithmetic and gives the same bytes. Any thread.
namespace hasp
{

/// Where each pixel of the panel takes its colour from in the eye's picture.
struct LensTable
{
  static constexpr int Steps = 256;        ///< of a pixel
  static constexpr float Dark = -16777216; ///< x of what lies outside the picture: black

  glm::ivec2 size{ 0 }; ///< pixels of the panel and of the picture
  int channels = 1;     ///< 3 where colours are scaled differently, each with a table of its own
  /// x, y in 1/256 pixel from the middle of the picture's first pixel; 2 * size.x * size.y values
  /// a channel, one channel after the other. Whole numbers, for which a float is exact.
  std::vector<float> positions{};
};

/// O(pixels). `aspect` as in LensModel.h. Throws like ValidateLens, and std::invalid_argument for
/// a picture without pixels or with more than 32768 a side.
VTKHASPRENDERINGSTEREO_EXPORT LensTable MakeLensTable(
  const LensModel& lens, StereoEye eye, glm::ivec2 size, double aspect);

/// Red, green and blue that the panel shows at `pixel`: each bilinear between four pixels of the
/// picture `rgb` (3 bytes a pixel of table.size).
VTKHASPRENDERINGSTEREO_EXPORT std::array<int, 3> SampleThroughLens(
  const LensTable& table, std::span<const std::uint8_t> rgb, glm::ivec2 pixel);

} // namespace hasp
