#include "Haptics/FieldContact.h"
#include "Haptics/Solve6.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{

FieldContact::FieldContact(
  std::span<const glm::dvec3> points, double stiffness, const ImplicitField& field)
  : Points(points.begin(), points.end()),
    Stiffness(stiffness),
    Field(&field)
{
  if (!std::isfinite(stiffness) || stiffness < 0.0)
    throw std::invalid_argument("A point's stiffness of " + std::to_string(stiffness) +
                                " N/mm; it must be finite and not negative");
  for (const glm::dvec3& point : this->Points)
  {
    const double far = glm::length(point);
    if (!std::isfinite(far))
      throw std::invalid_argument("A point of the tool is not finite");
    this->FarthestMm = std::max(this->FarthestMm, far);
  }
}

ToolContact::Answer FieldContact::At(const RigidPose& tool) noexcept
{
  Answer answer;
  ContactSums& sums = answer.sums;
  double nearest = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& point : this->Points)
  {
    const glm::dvec3 arm = tool.Turn(point);
    const auto [distance, g] = this->Field->At(tool.position + arm);
    nearest = std::min(nearest, distance);
    if (!(distance < 0.0))
      continue;
    const glm::dvec3 force = -this->Stiffness * distance * g;
    sums.contact += { force, glm::cross(arm, force) };
    const glm::dvec3 turn = glm::cross(arm, g);
    const Vector6 j{ g.x, g.y, g.z, turn.x, turn.y, turn.z };
    for (std::size_t row = 0; row < 6; ++row)
      for (std::size_t column = row; column < 6; ++column)
        sums.matrix[UpperIndex(row, column)] += this->Stiffness * j[row] * j[column];
    sums.energy += 0.5 * this->Stiffness * distance * distance;
    sums.deepestMm = std::min(sums.deepestMm, distance);
    ++sums.contacts;
  }
  answer.clearanceMm = std::max(0.0, nearest);
  return answer;
}

} // namespace hasp
