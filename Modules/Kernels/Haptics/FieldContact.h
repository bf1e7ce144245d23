#pragma once
#include "Haptics/ImplicitField.h"
#include "Haptics/ToolContact.h"

#include <span>
#include <vector>

namespace hasp
{

/// Points of a tool against a signed distance given as a function, one after the other in double:
/// the same law as the contact kernels' (Matrix, without hardening), for bodies in closed form, and
/// what those kernels and the couplings are held against. No attraction. Threads: one. Cost: the
/// field's, and 50 flops a point in contact.
class FieldContact : public ToolContact
{
public:
  /// points      of the tool's surface, tool axes, mm
  /// stiffness   of each point, N/mm (k A of ContactSettings); >= 0
  /// field       1-Lipschitz, as a distance is; somebody else's, longer than this.
  /// Throws std::invalid_argument if a point or the stiffness is not finite or negative.
  FieldContact(std::span<const glm::dvec3> points, double stiffness, const ImplicitField& field);

  Answer At(const RigidPose& tool) noexcept override;
  /// Takes effect with the next At: what a change of stiffness in contact looks like.
  void SetStiffness(double stiffness) noexcept { this->Stiffness = stiffness; }
  void SetField(const ImplicitField& field) noexcept { this->Field = &field; }
  double Radius() const noexcept { return this->FarthestMm; } ///< of the ball that holds the points

private:
  std::vector<glm::dvec3> Points;
  double Stiffness;
  double FarthestMm = 0.0;
  const ImplicitField* Field;
};

} // namespace hasp
