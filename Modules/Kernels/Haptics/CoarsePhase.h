#pragma once
#include "Haptics/MapClearance.h"
#include "Haptics/PointShell.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace hasp
{

/// Which clusters of a shell may touch a body, and which need not even be asked for some time.
///
/// The distance at the middle of a cluster's ball, read once from the map, less what the distance
/// can fall by on the way to a point of the ball (the map's steepest slope), says how far the
/// cluster may be moved before any of its points comes within reach; the same number below 0, how
/// far it must be moved before that can end. It is not looked at until the shell has moved that
/// far: every tick adds how far its farthest point moved. So whatever the motion, no point within
/// reach is ever left out, and a shell far away costs one comparison a level.
///
/// HAPTIC, one thread at a time; takes memory only when it is made (WORKER). One for each pair of
/// shell and map. 1 ns a cluster, and 40 ns for each that is looked at.
class CoarsePhase
{
public:
  CoarsePhase(std::shared_ptr<const PointShell> shell, std::shared_ptr<const DistanceMap> map);

  /// Begins a tick.
  /// shellInMap  the shell's body in the axes of the map's body, mm; if it is not finite all
  ///             clusters are near
  /// reachMm     distances that matter: 0 for contact, Snap-to-fit's capture distance for
  ///             attraction; within the map's range
  void Begin(const RigidPose& shellInMap, double reachMm) noexcept;
  /// The points of a level that may be within reach, in whole clusters, neighbours joined. Their
  /// area is that of the level being the last: a step that goes on to finer ones sets it. Valid
  /// until the next Begin.
  std::span<const ContactPoints> Near(int level) noexcept;
  /// Asks about all again at the next Near. Begin does it by itself where
  /// it must.
  void WakeAll() noexcept;

  /// Of the clusters of the levels asked for since Begin.
  struct Counts
  {
    std::uint32_t near = 0;   ///< may touch
    std::uint32_t far = 0;    ///< cannot
    std::uint32_t looked = 0; ///< of both together; the others slept
    /// As far as all their points may be moved, any way, before one is within reach; 0 if some are
    /// near. mm; infinite if there are none.
    double clearanceMm = std::numeric_limits<double>::infinity();
  };
  const Counts& Asked() const noexcept { return this->Seen; }
  std::size_t Bytes() const noexcept;

private:
  struct Level
  {
    std::uint32_t first = 0;  ///< of its clusters in States and of its room in Runs
    double allFarUntil = 0.0; ///< in terms of Travelled
  };
  std::shared_ptr<const PointShell> Shell;
  MapClearance Clearance;
  std::vector<Level> Levels;
  std::vector<MapClearance::State> States; ///< by cluster
  std::vector<ContactPoints> Runs;
  Counts Seen;
};

} // namespace hasp
