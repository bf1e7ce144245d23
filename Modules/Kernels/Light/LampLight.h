#pragma once
// Private to paths and to SceneLightCache: what lamps give.
#include "Light/LitScene.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

namespace hasp
{

/// What reaches a place of a lamp's light, and along which way.
struct LampLight
{
  glm::dvec3 direction{ 0.0 };
  double distance = std::numeric_limits<double>::infinity();
  glm::vec3 color{ 0.0F }; ///< black where nothing does

  LampLight(const LitLamp& lamp, const glm::dvec3& place);
};

/// Radiance towards the eye of the lamp's light on a surface; less or 0 where it does not reach, if
/// shadows are wanted. Counts its rays.
template <typename Count>
glm::vec3 LampRadiance(const LitScene& scene, const LitLamp& lamp, const LitHit& hit,
  const SurfaceScattering::At& at, bool shadows, Count& rays)
{
  const LampLight light(lamp, hit.position);
  if (light.color == glm::vec3(0.0F) || !(glm::dot(light.direction, hit.normal) > 0.0))
    return glm::vec3(0.0F);
  const glm::vec3 given = at.Evaluate(light.direction) * light.color * glm::pi<float>();
  if (given == glm::vec3(0.0F) || !shadows || lamp.shadow == 0.0F)
    return given;
  ++rays;
  return scene.OccludedFrom(hit, light.direction, light.distance) ? (1.0F - lamp.shadow) * given
                                                                  : given;
}

} // namespace hasp
