#pragma once
#include "Haptics/ToolContact.h"

namespace hasp
{

struct FrictionSettings
{
  double coefficient = 0.0; ///< Coulomb's mu; 0: none, and nothing is computed
  double stiffness = 0.5;   ///< N/mm, of contact that sticks; > 0
};

/// Dry friction of a tool's contact, as one patch (Hayward and Armstrong 2000, with Coulomb's law):
/// a spring holds the patch's middle to where it stuck; when it pulls more than mu times the normal
/// force, that place slides after. An option on top of contact: it adds to the answer's wrench and
/// to its matrix, where it is positive semidefinite, and so costs no stability.
///
/// Limit: one patch for the whole tool, without friction against turning on the spot; two walls
/// that press from opposite sides cancel their normal forces, and with them friction. Threads: one,
/// HAPTIC; no memory; nothing throws.
class ContactFriction
{
public:
  /// Throws std::invalid_argument with the value and its legal range.
  explicit ContactFriction(const FrictionSettings& settings = {});

  /// Adds friction to what touches the tool at this pose. After every evaluation.
  void Add(const RigidPose& tool, ToolContact::Answer& answer) noexcept;
  /// Once a tick, where the tool has come to rest, by the contact of the last Add: takes hold, lets
  /// the place slide, or go.
  void Settle(const RigidPose& tool) noexcept;
  bool Sticks() const noexcept { return this->Holds; }
  void Restart() noexcept { this->Holds = false; }

private:
  struct Pull
  {
    glm::dvec3 arm, normal, along; ///< from the tool's origin; unit; of the spring, N
    double most;                   ///< N
  };
  Pull PullAt(const RigidPose& tool) const noexcept;
  void TakeHold(const RigidPose& tool) noexcept;

  FrictionSettings Settings;
  glm::dvec3 OnTool{ 0.0 }; ///< tool axes
  glm::dvec3 InWorld{ 0.0 };
  Wrench Contact; ///< the last Add's, without friction
  bool Touches = false, Holds = false;
};

} // namespace hasp
