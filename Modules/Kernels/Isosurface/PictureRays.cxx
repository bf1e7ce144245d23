#include "Isosurface/PictureRays.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hasp
{

PictureRays::PictureRays(const PictureView& view)
  : ToIndex(glm::inverse(view.indexToClip)),
    PixelSize(2.0 / glm::dvec2(view.size)),
    Planes(view.planes)
{
  const glm::dvec4 depth = glm::row(view.indexToClip, 2), w = glm::row(view.indexToClip, 3);
  this->Planes.push_back(w + depth);
  this->Planes.push_back(w - depth);
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      if (!std::isfinite(this->ToIndex[c][r]))
        throw std::invalid_argument("PictureRays: indexToClip cannot be inverted");
}

bool PictureRays::Of(const glm::dvec2& place, CellRay& ray) const
{
  const glm::dvec2 device = place * this->PixelSize - 1.0;
  // Points (a + z b) / (a.w + z b.w) for depths z; their derivative points along the ray.
  const glm::dvec4 a = this->ToIndex[0] * device.x + this->ToIndex[1] * device.y + this->ToIndex[3];
  const glm::dvec4& b = this->ToIndex[2];
  ray.origin = glm::dvec3(a) / a.w;
  ray.direction = glm::dvec3(b) * a.w - glm::dvec3(a) * b.w;
  ray.tMin = -std::numeric_limits<double>::infinity();
  ray.tMax = std::numeric_limits<double>::infinity();
  for (const glm::dvec4& plane : this->Planes)
  {
    const double at = glm::dot(glm::dvec3(plane), ray.origin) + plane.w;
    const double slope = glm::dot(glm::dvec3(plane), ray.direction);
    if (slope > 0.0)
      ray.tMin = std::max(ray.tMin, -at / slope);
    else if (slope < 0.0)
      ray.tMax = std::min(ray.tMax, -at / slope);
    else if (at < 0.0)
      return false;
  }
  return ray.tMin <= ray.tMax;
}

} // namespace hasp
