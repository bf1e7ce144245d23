#include "Evaluation/SortedLayers.h"

#include <algorithm>

namespace hasp
{

std::vector<Layer> SortLayers(std::vector<Layer> layers)
{
  std::stable_sort(
    layers.begin(), layers.end(), [](const Layer& a, const Layer& b) { return a.t < b.t; });
  const auto opaque = std::find_if(
    layers.begin(), layers.end(), [](const Layer& layer) { return layer.opacity >= 1.0; });
  if (opaque != layers.end())
    layers.erase(opaque + 1, layers.end());
  return layers;
}

glm::dvec3 BlendLayers(const std::vector<Layer>& sorted, const glm::dvec3& background)
{
  glm::dvec3 color = background;
  for (auto layer = sorted.rbegin(); layer != sorted.rend(); ++layer)
    color = layer->opacity * layer->color + (1.0 - layer->opacity) * color;
  return color;
}

bool SameSurfaces(const std::vector<Layer>& a, const std::vector<Layer>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](const Layer& one, const Layer& other) { return one.surface == other.surface; });
}

} // namespace hasp
