#pragma once
#include "Haptics/CoarsePhase.h"
#include "Haptics/ContactForce.h"
#include "Haptics/DynamicPointShell.h"
#include "Haptics/ShellDisc.h"
#include "Haptics/ToolContact.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace hasp
{

/// A surface that is moved with the tool: a fragment of the group in hand. Exactly one of both
/// shells is set.
struct HapticShell
{
  std::shared_ptr<const PointShell> shell;
  RigidPose shellInTool; ///< the shell's body axes, seen from the tool's
  std::shared_ptr<const DynamicShellSource> dynamic{}; ///< points are drawn where it touches
};

/// A body that stands still: what can be touched.
struct HapticBody
{
  std::shared_ptr<const DistanceMap> map;
  RigidPose mapInWorld; ///< the map's body axes, seen from the world's
};

/// What the tool is made of and what it meets: every shell before every body, as one ToolContact.
/// Working memory of the HAPTIC thread: made elsewhere, given to the step, given back by it.
///
/// A dynamic shell has a DynamicPointShell for each body; without dynamic shells none is made. Its
/// points have no levels: they count with the coarsest, which is always summed.
class HapticScene : public ToolContact
{
public:
  /// Throws std::invalid_argument if a body is null, a shell is none or both, a pose is none
  /// (IsPose; what its turn's length is off by is taken away), or as DynamicPointShell does.
  /// kernels: the fastest here unless given.
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
  /// The dynamic shells' tick, where the tool is now: HAPTIC, once a tick, after Set and before At.
  void Update(const RigidPose& tool) noexcept;
  Answer At(const RigidPose& tool) noexcept override;

  /// Of a dynamic shell, felt from the next Update on; others have none. Scenes that follow and
  /// have the same shell keep it (TakeGrowth). Not finite: nothing is felt of the shell. HAPTIC.
  void SetIsovalue(std::size_t shell, double isovalue) noexcept;
  /// The dynamic shells' living points, TOOL axes; as many as there is room for. Returns how many.
  /// HAPTIC: takes no memory. A shell that meets several bodies has points for each.
  std::uint32_t CopyDynamicDiscs(std::span<ShellDisc> out) const noexcept;

  /// Points in contact range, by level, as the last At has found them: what a level would cost.
  const std::vector<std::uint32_t>& NearPoints() const noexcept { return this->Near; }
  std::uint32_t PointsDone() const noexcept { return this->Done; } ///< by the last At

  int Levels() const noexcept { return static_cast<int>(this->Near.size()); }
  double RadiusMm() const noexcept { return this->FarthestMm; }      ///< of the tool's ball
  double SmallestSpacing() const noexcept { return this->FinestMm; } ///< infinite without bodies
  /// Pairs of shell and body that `before` had as well, at the same places, are as grown as they
  /// are there; new ones begin at 0, as all do after null: HAPTIC. Stiffness and attraction are
  /// scaled by its cube: contact is far stiffer than a coupling, and a small share of it is felt
  /// already. 1 when a scene is made. Points of dynamic shells, and their isovalues, come over,
  /// too: `before` is left with the new scene's, which has none yet.
  void TakeGrowth(HapticScene* before) noexcept;
  /// By `share`, to 1 at most.
  void Grow(double share) noexcept;
  /// The working memory; shells, maps and volumes list themselves.
  void ListResources(ResourceList& list) const;

private:
  struct Pair
  {
    std::size_t shell, body;
    DistanceMapView<std::int16_t> view;
    double grown = 1.0;                         ///< in [0, 1]
    std::optional<CoarsePhase> coarse;          ///< of a static shell
    std::unique_ptr<DynamicPointShell> dynamic; ///< of a dynamic one
  };
  bool Attracts() const noexcept
  {
    return this->Now.contact.attraction * this->Now.contact.fade > 0.0F;
  }
  RigidPose ShellInMap(const Pair& pair, const RigidPose& tool) const noexcept;
  void AddPair(Pair& pair, const RigidPose& tool, ContactTerms terms, Answer& answer) noexcept;
  double AddStatic(
    Pair& pair, const ContactPlacement& at, ContactTerms terms, ContactSums& sums) noexcept;
  double AddDynamic(
    Pair& pair, const ContactPlacement& at, ContactTerms terms, ContactSums& sums) noexcept;

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
