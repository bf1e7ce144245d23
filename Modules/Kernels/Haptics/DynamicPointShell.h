#pragma once
#include "Grid/GridView.h"
#include "Grid/MinMaxBlocks.h"
#include "Grid/ResourceUse.h"
#include "Grid/RigidPose.h"
#include "Haptics/ContactPoints.h"
#include "Haptics/DistanceMap.h"

#include <cstdint>
#include <memory>

namespace hasp
{

/// A volume whose isosurface is the surface of a body that touches: grey values, or distances.
struct ShellVolume
{
  AnyGridView grid;                           ///< at least 2 samples along each axis
  std::shared_ptr<const MinMaxBlocks> blocks; ///< of that grid: the ray caster's own, say
  std::shared_ptr<const void> owner;          ///< of the samples: held as long as they are read
  double isovalue = 0.0;
  bool insideAbove = true; ///< inside is value >= isovalue; false: value <= isovalue, a distance
};

struct DynamicPointShellSettings
{
  int points = 16'384;     ///< the ring's room; in [512, 1048576]
  int pointsPerTick = 512; ///< drawn anew in a tick at most; in [64, points]
  double spacingMm = 0.0;  ///< no denser than this; 0: 0.4 of the smallest spacing
  double marginMm = 0.0;   ///< so far ahead of the reach points are drawn; 0: 4 smallest spacings
  int blendTicks = 8;      ///< a point's area comes and goes in so many ticks; in [5, 100]
  std::uint32_t seed = 1;
};

/// All of it that does not depend on what it meets: immutable, shared by all scenes that it is in.
struct DynamicShellSource
{
  ShellVolume volume;
  glm::dvec3 origin{ 0.0 }; ///< of the body's own axes, world, as the volume lies
  DynamicPointShellSettings settings;
};

/// Points on a body's isosurface only where it may touch, drawn while it moves, without any
/// preparation (thesis 3.3.1, Paper VII; the paper's algorithm is not published, this is ours).
///
/// Each tick: the blocks of the volume that hold a piece of the surface and come within reach of
/// the other body's distance map are looked for, in groups of 4x4x4 blocks and as long as need be
/// only (MapClearance). Of a block that is new its crossed cells are measured. Then as many points
/// are drawn as the tick's budget allows, 16 at a time, spread evenly over a block's area, into a
/// ring; blocks with few go first. The points of a block share its area, so that stiffness does not
/// depend on how many there are; what comes fades in, what goes fades out. Blocks that can no
/// longer touch give their points back at once.
///
/// Another isovalue is felt in the very next tick: each block's first 16 points and more, as far as
/// twice the budget goes, move along the gradient to the new surface, all others vanish; in the
/// ticks after them all are drawn anew.
///
/// Threads: made on a WORKER; then HAPTIC, one thread at a time: takes no memory, no lock, and does
/// not throw. The same calls give the same points, with the same instruction set; with another one
/// within 1e-5 of a voxel, but for one in thousands (BlockKernels.h). One for each pair of body and
/// map. Memory: 28 B a point, 7 KB a block that may be served at once (one for 32 points), 20 B a
/// block of the volume.
class DynamicPointShell
{
public:
  /// origin: of the body's own axes, world, as the volume lies. Throws std::invalid_argument on an
  /// invalid geometry or setting, or blocks that are not the grid's. O(blocks).
  DynamicPointShell(ShellVolume volume, std::shared_ptr<const DistanceMap> map,
    const glm::dvec3& origin, const DynamicPointShellSettings& settings = {});
  ~DynamicPointShell();

  /// From the next Update on. Not finite: no surface at all.
  void SetIsovalue(double isovalue) noexcept;
  double Isovalue() const noexcept;
  /// One tick.
  /// bodyInMap  the body's axes in the axes of the map's body, mm; if it is not finite nothing
  ///            changes
  /// reachMm    distances that matter: 0 for contact; with the margin, within the map's range
  void Update(const RigidPose& bodyInMap, double reachMm) noexcept;

  /// As far as every point of the body may go from there, any way, before one touches that does not
  /// touch now, mm; 0 within reach and margin of the other body, and before the first Update. It
  /// holds for poses to which the body comes between this Update and the next.
  double ClearanceMm(const RigidPose& bodyInMap) const noexcept;

  /// All of the ring, dead points far away, each point with an area of its own; none if none lives.
  /// Body axes, mm. Until the next Update.
  ContactPoints Points() const noexcept;

  struct Facts
  {
    std::uint32_t points = 0;       ///< alive
    std::uint32_t drawn = 0;        ///< in the last tick
    std::uint32_t projected = 0;    ///< in the last tick, onto another isovalue's surface
    std::uint32_t nearBlocks = 0;   ///< may touch
    std::uint32_t servedBlocks = 0; ///< of these have points
    double areaMm2 = 0.0;           ///< of the points together
  };
  const Facts& LastTick() const noexcept;
  void ListResources(ResourceList& list) const;

private:
  struct Internals;
  std::unique_ptr<Internals> Inside;
};

} // namespace hasp
