#include "SeenDepth.h"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>

#include <cstddef>

namespace hasp
{

glm::dvec3 SeenDepth::Unproject(const glm::dvec2& pixel, double depth) const
{
  const glm::dvec2 device = 2.0 * (pixel - glm::dvec2(this->origin)) / glm::dvec2(this->size) - 1.0;
  const glm::dvec4 world = this->clipToWorld * glm::dvec4(device, 2.0 * depth - 1.0, 1.0);
  return glm::dvec3(world) / world.w;
}

std::optional<PixelPlace> SeenDepth::At(const glm::ivec2& pixel) const
{
  const glm::ivec2 at = pixel - this->origin;
  if (this->depths.empty() || glm::any(glm::lessThan(at, glm::ivec2(0))) ||
      glm::any(glm::greaterThanEqual(at, this->size)))
    return std::nullopt;
  const double depth = this->depths[std::size_t(at.y) * this->size.x + at.x];
  if (!(depth < 1.0))
    return std::nullopt;
  const glm::dvec2 middle = glm::dvec2(pixel) + 0.5;
  const glm::dvec3 world = this->Unproject(middle, depth);
  const glm::dvec3 beside = this->Unproject(middle + glm::dvec2(1, 0), depth);
  return PixelPlace{ world, glm::length(beside - world) };
}

} // namespace hasp
