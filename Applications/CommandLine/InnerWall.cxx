#include "InnerWall.h"

#include "Evaluation/FitFaults.h"
#include "Evaluation/SurfaceDistance.h"

#include <glm/geometric.hpp>

namespace hasp
{

InnerWall FindInnerWall(const TriangleMesh& part, const AnyGridView& bone, const PartClaims& claims)
{
  const GuideGapSettings settings = GapSettingsOf(claims);
  std::vector<glm::dvec3> middles;
  middles.reserve(part.triangles.size());
  for (const glm::uvec3& t : part.triangles)
    middles.push_back((part.points[t.x] + part.points[t.y] + part.points[t.z]) / 3.0);
  const auto nearest = DistanceToIsosurface(bone, settings.isovalue, middles, settings.nearMm);
  InnerWall wall;
  wall.colours.reserve(middles.size());
  for (std::size_t n = 0; n < middles.size(); ++n)
  {
    const glm::uvec3& t = part.triangles[n];
    const glm::dvec3 twice =
      glm::cross(part.points[t.y] - part.points[t.x], part.points[t.z] - part.points[t.x]);
    const double area = glm::length(twice);
    const bool inner =
      nearest[n] && area > 0.0 && glm::dot(twice, -nearest[n]->outward) >= settings.facing * area;
    wall.colours.push_back(inner ? GapColour(*claims.shell, nearest[n]->distance) : NoInnerWall);
    if (inner)
      wall.away -= twice;
  }
  return wall;
}

} // namespace hasp
