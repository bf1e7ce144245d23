#include "WorkingGrid.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <sstream>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr double MostPoints = 2e8;
} // namespace

glm::dmat3 AxesAlong(const glm::dvec3& z)
{
  glm::dvec3 least(0.0); // the world axis farthest from z
  const glm::dvec3 size = glm::abs(z);
  least[size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2] = 1.0;
  const glm::dvec3 x = glm::normalize(glm::cross(least, z));
  return { x, glm::cross(z, x), z };
}

void CheckPoints(const char* who, const glm::dvec3& count, double spacingMm, const char* remedy)
{
  const double points = count.x * count.y * count.z;
  if (points <= MostPoints)
    return;
  std::ostringstream text;
  text << who << ": the working grid would have " << points << " points, at most " << MostPoints
       << " are allowed; " << remedy << " (now " << spacingMm << " mm)";
  throw std::invalid_argument(text.str());
}

GridGeometry GridIn(
  const char* who, const ImplicitSolid::Box& local, const glm::dmat3& axes, double spacingMm)
{
  const glm::dvec3 count = glm::ceil((local.high - local.low) / spacingMm) + 1.0;
  CheckPoints(who, count, spacingMm, "raise spacingMm");
  return { glm::max(glm::ivec3(count), 2), axes * local.low, glm::dvec3(spacingMm), axes };
}

} // namespace hasp
