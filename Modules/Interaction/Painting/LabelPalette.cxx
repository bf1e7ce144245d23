#include "LabelPalette.h"

#include <glm/common.hpp>

#include <cmath>

namespace hasp
{

glm::dvec3 PaletteColour(Label label)
{
  if (label == 0)
    return glm::dvec3(0.5);
  if (label == 1)
    return glm::dvec3(227, 218, 201) / 255.0; // LabelName's
  constexpr double GoldenTurn = 0.61803398874989485;
  const double hue = std::fmod(GoldenTurn * (label - 2), 1.0); // of a turn; 2 is red
  const glm::dvec3 full =
    glm::clamp(glm::abs(glm::fract(hue + glm::dvec3(0, 2, 1) / 3.0) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
  constexpr double Saturation = 0.75, Value = 0.95;
  return Value * (1.0 - Saturation + Saturation * full);
}

bool IsColour(int label, const glm::dvec3& colour)
{
  const auto share = [](double value) { return value >= 0.0 && value <= 1.0; };
  return label >= 0 && label <= MaxLabel && share(colour.x) && share(colour.y) && share(colour.z);
}

} // namespace hasp
