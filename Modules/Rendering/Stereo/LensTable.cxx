#include "LensTable.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{

LensTable MakeLensTable(const LensModel& lens, StereoEye eye, glm::ivec2 size, double aspect)
{
  constexpr int most = 32768; // 1/256 of it is a whole number for a float
  ValidateLens(lens, aspect);
  if (size.x < 1 || size.y < 1 || size.x > most || size.y > most)
    throw std::invalid_argument("lens: a picture of " + std::to_string(size.x) + " x " +
                                std::to_string(size.y) + " pixels, must be 1 to " +
                                std::to_string(most) + " a side");
  const glm::dvec3& scale = lens.colorScale;
  LensTable table;
  table.size = size;
  table.channels = scale.x == scale.y && scale.y == scale.z ? 1 : 3;
  table.positions.reserve(std::size_t(2) * table.channels * size.x * size.y);
  const glm::dvec2 half(aspect, 1.0), pixels(size);
  for (int channel = 0; channel < table.channels; ++channel)
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
      {
        const glm::dvec2 panel = (2.0 * glm::dvec2(x + 0.5, y + 0.5) / pixels - 1.0) * half;
        const glm::dvec2 seen = SeenThroughLens(lens, eye, channel, panel) / half;
        const bool inside = std::abs(seen.x) <= 1.0 && std::abs(seen.y) <= 1.0;
        const glm::dvec2 at = (seen + 1.0) * 0.5 * pixels - 0.5;
        table.positions.push_back(
          inside ? static_cast<float>(std::lround(LensTable::Steps * at.x)) : LensTable::Dark);
        table.positions.push_back(
          inside ? static_cast<float>(std::lround(LensTable::Steps * at.y)) : LensTable::Dark);
      }
  return table;
}

std::array<int, 3> SampleThroughLens(
  const LensTable& table, std::span<const std::uint8_t> rgb, glm::ivec2 pixel)
{
  std::array<int, 3> result{};
  for (int color = 0; color < 3; ++color)
  {
    const int row = pixel.y + (table.channels == 3 ? color * table.size.y : 0);
    const float* position =
      &table.positions[2 * (static_cast<std::size_t>(row) * table.size.x + pixel.x)];
    if (position[0] == LensTable::Dark)
      continue;
    const glm::ivec2 at(static_cast<int>(position[0]), static_cast<int>(position[1]));
    const glm::ivec2 low(at.x >> 8, at.y >> 8), part(at.x & 255, at.y & 255);
    const auto value = [&](int x, int y)
    {
      x = std::clamp(low.x + x, 0, table.size.x - 1);
      y = std::clamp(low.y + y, 0, table.size.y - 1);
      return rgb[3 * (static_cast<std::size_t>(y) * table.size.x + x) + color];
    };
    const int lower = value(0, 0) * (256 - part.x) + value(1, 0) * part.x;
    const int upper = value(0, 1) * (256 - part.x) + value(1, 1) * part.x;
    result[color] = (lower * (256 - part.y) + upper * part.y + 32768) >> 16;
  }
  return result;
}

} // namespace hasp
