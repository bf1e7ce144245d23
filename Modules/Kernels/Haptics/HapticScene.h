#pragma once
#include "Haptics/CoarsePhase.h"
#include "Haptics/ContactForce.h"
#include "Haptics/CostModel.h"
#include "Haptics/ToolContact.h"

#include <memory>
#include <vector>

namespace hasp
{

/// A surface that is moved with the tool: a fragment of the group in hand.
struct HapticShell
{
  std::shared_ptr<const PointShell> shell;
  RigidPose shellInTool; ///< the shell's body axes, seen from the tool's
};

/// A body that stands still: what can be touched.
struct HapticBody
{
  std::shared_ptr<const DistanceMap> map;
  RigidPose mapInWorld; ///< the map's body axes, seen from the world's
};

/// What the tool is made of and what it meets: every shell before every body, as one ToolContact.
/// Working memory of the HAPTIC thread: made by a WORKER, given to the step, given back by it.
class HapticScene : public ToolContact
{
public:
  /// Throws std::invalid_argument if something is null or a pose is none. kernels: the fastest here
  /// unless given.
  HapticScene(std::vector<HapticShell> shells, std::vector<HapticBody> bodies,
    const ContactKernels& kernels = FastestContactKernels());

  /// What At shall sum, from now on: HAPTIC.
  struct Plan
  {
    ContactSettings contact; ///< fade 0 or attraction 0: attraction is not computed
    /// Levels whose points count. Between two, the finer one is blended in: 2.25 is a quarter of
    /// the way from 3 levels to 4.
    double finest = 0.0;
  };
  void Set(const Plan& plan) noexcept { this->Now = plan; }
  Answer At(const RigidPose& tool) noexcept override;

  /// Points in contact range, by level, as the last At has found them: what a level would cost.
  const std::vector<std::uint32_t>& NearPoints() const noexcept { return this->Near; }
  std::uint32_t PointsDone() const noexcept { return this->Done; } ///< by the last At

  int Levels() const noexcept { return static_cast<int>(this->Near.size()); }
  double RadiusMm() const noexcept { return this->FarthestMm; }      ///< of the tool's ball
  double SmallestSpacing() const noexcept { return this->FinestMm; } ///< infinite without bodies
  /// Pairs of shell and body that `before` had as well, at the same places, are as grown as they
  /// are there; new ones begin at 0, as all do after null: HAPTIC. Stiffness and attraction are
  /// scaled by its cube: contact is far stiffer than a coupling, and a small share of it is felt
  /// already. 1 when a scene is made.
  void TakeGrowth(const HapticScene* before) noexcept;
  /// By `share`, to 1 at most.
  void Grow(double share) noexcept;

private:
  struct Pair
  {
    std::size_t shell, body;
    CoarsePhase coarse;
    DistanceMapView<std::int16_t> view;
    double grown; ///< in [0, 1]
  };
  void AddPair(Pair& pair, const RigidPose& tool, ContactTerms terms, Answer& answer) noexcept;

  std::vector<HapticShell> Shells;
  std::vector<HapticBody> Bodies;
  ContactKernels Kernels;
  std::vector<Pair> Pairs;
  std::vector<std::uint32_t> Near;
  Plan Now;
  std::uint32_t Done = 0;
  double FarthestMm = 0.0, FinestMm;
};

/// Sums about a shell's origin in a map's axes, seen from the world's axes about the tool's origin.
/// turn: map to world; arm: from the tool's origin to the shell's, world.
ContactSums Moved(const ContactSums& sums, const glm::dquat& turn, const glm::dvec3& arm) noexcept;

} // namespace hasp
