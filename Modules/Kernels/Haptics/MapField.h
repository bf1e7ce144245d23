#pragma once
#include "Haptics/DistanceMap.h"
#include "Haptics/ImplicitField.h"

#include <glm/geometric.hpp>

#include <memory>
#include <utility>

namespace hasp
{

/// A baked body for point proxies. Its distances are taken as they are, also where the band ends
/// and their gradients fade: a gradient shorter than 1 is drawn out to 1, and where there is none
/// the normal is any, for nothing touches there. Any thread.
class MapField : public ImplicitField
{
public:
  explicit MapField(std::shared_ptr<const DistanceMap> map) : Map(std::move(map)) {}

  Sample At(const glm::dvec3& world) const noexcept override
  {
    const DistanceMap::Sample sample = this->Map->At(world);
    const double slope = glm::length(sample.gradient);
    if (slope >= 1.0)
      return { sample.mm, sample.gradient };
    return { sample.mm, slope > 0.0 ? sample.gradient / slope : glm::dvec3(1.0, 0.0, 0.0) };
  }

private:
  std::shared_ptr<const DistanceMap> Map;
};

} // namespace hasp
