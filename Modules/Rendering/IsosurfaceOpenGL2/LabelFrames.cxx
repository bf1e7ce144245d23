#include "LabelFrames.h"

#include <glm/matrix.hpp>
#include <glm/packing.hpp>

LabelFrames::LabelFrames(const hasp::CellLabels& labels, const hasp::GridGeometry& geometry)
  : moves{ glm::dmat4(1.0) }
{
  constexpr std::uint32_t hidden = 0x80000000U, colored = 0x40000000U;
  glm::dmat4 indexToData(geometry.IndexToWorldMatrix());
  indexToData[3] = glm::dvec4(geometry.origin, 1.0);
  const glm::dmat4 dataToIndex = glm::inverse(indexToData);
  const std::size_t count = labels.empty() ? 0 : std::size_t{ labels.rbegin()->first } + 1;
  this->moveOfLabel.assign(count, 0);
  this->table.assign(count + 1, glm::uvec2(0));
  for (const auto& [n, label] : labels)
  {
    if (label.pose && label.visible)
    {
      this->moveOfLabel[n] = static_cast<std::uint32_t>(this->moves.size());
      this->moves.push_back(dataToIndex * *label.pose * indexToData);
    }
    glm::uvec2& entry = this->table[n];
    entry.x = this->moveOfLabel[n] | (label.visible ? 0 : hidden) | (label.color ? colored : 0);
    if (label.color)
      entry.y = glm::packUnorm4x8(*label.color);
  }
}
