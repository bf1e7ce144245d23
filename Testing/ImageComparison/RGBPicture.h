#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace hasp
{

/// A picture of width * height pixels: red, green, blue, 0 to 255; left to right, the bottom row
/// first, as VTK keeps pictures.
struct RGBPicture
{
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels{};

  RGBPicture() = default;
  RGBPicture(int w, int h) : width(w), height(h), pixels(static_cast<std::size_t>(w) * h * 3) {}

  std::uint8_t* At(int x, int y) { return &pixels[(static_cast<std::size_t>(y) * width + x) * 3]; }
  const std::uint8_t* At(int x, int y) const
  {
    return &pixels[(static_cast<std::size_t>(y) * width + x) * 3];
  }
};

} // namespace hasp
