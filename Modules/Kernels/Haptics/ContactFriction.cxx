#include "Haptics/ContactFriction.h"
#include "Haptics/Solve6.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

constexpr double LeastForce = 1e-9; // N: below it there is no normal

} // namespace

ContactFriction::ContactFriction(const FrictionSettings& settings) : Settings(settings)
{
  if (!(settings.coefficient >= 0.0) || !std::isfinite(settings.coefficient))
    throw std::invalid_argument("A coefficient of friction is " +
                                std::to_string(settings.coefficient) +
                                "; it must be finite and not negative");
  if (!(settings.stiffness > 0.0) || !std::isfinite(settings.stiffness))
    throw std::invalid_argument("A stiffness of friction is " + std::to_string(settings.stiffness) +
                                " N/mm; it must be positive and finite");
}

ContactFriction::Pull ContactFriction::PullAt(const RigidPose& tool) const noexcept
{
  const double force = glm::length(this->Contact.force);
  const glm::dvec3 normal = this->Contact.force / force;
  const glm::dvec3 arm = tool.Turn(this->OnTool);
  const glm::dvec3 away = this->InWorld - (tool.position + arm);
  const glm::dvec3 along = away - glm::dot(away, normal) * normal;
  return { arm, normal, this->Settings.stiffness * along, this->Settings.coefficient * force };
}

void ContactFriction::Add(const RigidPose& tool, ToolContact::Answer& answer) noexcept
{
  if (this->Settings.coefficient == 0.0)
    return;
  this->Contact = answer.sums.contact;
  const double pressed = glm::length(this->Contact.force);
  this->Touches = pressed > LeastForce && std::isfinite(pressed);
  if (!this->Holds || !this->Touches)
    return;
  const Pull pull = this->PullAt(tool);
  const double length = glm::length(pull.along);
  // The secant's stiffness again: what slides is softer, and no step overshoots.
  const double share = length > pull.most ? pull.most / length : 1.0;
  const glm::dvec3 force = share * pull.along;
  answer.sums.contact += { force, glm::cross(pull.arm, force) };
  for (int axis = 0; axis < 3; ++axis)
  {
    // A row of I - n n^T, which is its own square.
    glm::dvec3 g = -pull.normal[axis] * pull.normal;
    g[axis] += 1.0;
    const glm::dvec3 turn = glm::cross(pull.arm, g);
    const Vector6 j{ g.x, g.y, g.z, turn.x, turn.y, turn.z };
    for (std::size_t row = 0; row < 6; ++row)
      for (std::size_t column = row; column < 6; ++column)
        answer.sums.matrix[UpperIndex(row, column)] +=
          share * this->Settings.stiffness * j[row] * j[column];
  }
}

void ContactFriction::TakeHold(const RigidPose& tool) noexcept
{
  // The middle of pressure: nearest to the tool's origin on the line that the force acts along.
  const glm::dvec3& force = this->Contact.force;
  const glm::dvec3 arm = glm::cross(force, this->Contact.torque) / glm::dot(force, force);
  this->InWorld = tool.position + arm;
  this->OnTool = glm::conjugate(tool.orientation) * arm;
  this->Holds = true;
}

void ContactFriction::Settle(const RigidPose& tool) noexcept
{
  if (!this->Touches)
    this->Holds = false;
  else if (!this->Holds)
    this->TakeHold(tool);
  else
  {
    const Pull pull = this->PullAt(tool);
    const double length = glm::length(pull.along);
    const bool slides = length > pull.most;
    const glm::dvec3 behind =
      (slides ? pull.most / length : 1.0) * pull.along / this->Settings.stiffness;
    if (slides)
      this->TakeHold(tool); // where it presses now
    // Along the normal the place follows; along the surface as far as friction lets it.
    this->InWorld = tool.Place(this->OnTool) + behind;
  }
}

} // namespace hasp
