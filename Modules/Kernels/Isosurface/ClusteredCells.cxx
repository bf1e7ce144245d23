#include "Isosurface/ClusteredCells.h"

#include <cstring>

namespace hasp
{

glm::ivec3 ClusteredCells::Cell(std::size_t n) const
{
  const std::uint32_t word = this->words[n * this->Stride()];
  return glm::ivec3(glsl::HaspClusterOrigin(this->clusters[glsl::HaspCellCluster(word)]) +
                    glsl::HaspCellInCluster(word));
}

std::array<float, 8> ClusteredCells::Corners(std::size_t n) const
{
  const std::uint32_t* word = &this->words[n * this->Stride() + 1];
  std::array<float, 8> corners{};
  if (this->cornerType == CornerType::Float32)
  {
    std::memcpy(corners.data(), word, sizeof corners);
    return corners;
  }
  for (int c = 0; c < 8; ++c)
  {
    const auto half = static_cast<std::uint16_t>(word[c / 2] >> (c % 2 * 16));
    corners[c] = this->cornerType == CornerType::Int16
                   ? static_cast<float>(static_cast<std::int16_t>(half))
                   : static_cast<float>(half);
  }
  return corners;
}

} // namespace hasp
