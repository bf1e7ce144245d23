#include "Light/LampLight.h"

#include <algorithm>
#include <cmath>

namespace hasp
{

LampLight::LampLight(const LitLamp& lamp, const glm::dvec3& place)
{
  const glm::dvec3 way = glm::dvec3(lamp.place) - lamp.place.w * place;
  const double length = glm::length(way);
  if (!(length > 0.0)) // it stands on the surface
    return;
  this->direction = way / length;
  this->color = lamp.color;
  if (lamp.place.w == 0.0)
    return;
  this->distance = length;
  const glm::dvec3 factors(lamp.attenuation);
  const double fallOff = factors.x + length * (factors.y + length * factors.z);
  const double cosine = -glm::dot(this->direction, lamp.axis);
  if (lamp.leastCosine > -1.0)
    this->color *= cosine < lamp.leastCosine
                     ? 0.0F
                     : static_cast<float>(std::pow(std::max(cosine, 1e-6), lamp.exponent));
  this->color *= static_cast<float>(1.0 / fallOff);
}

} // namespace hasp
