#pragma once
#include "Haptics/BlockSurface.h"
#include "Haptics/MapClearance.h"
#include "Haptics/PointRing.h"

#include <glm/mat3x3.hpp>

#include <cstdint>

namespace hasp
{

/// A block that has points, or is about to.
struct ServedBlock
{
  BlockSurface* surface = nullptr; ///< apart, for it is large
  double area = 0.0;               ///< of the surface when it was last measured, mm^2
  glm::ivec3 block{ 0 };
  std::uint64_t number = 0; ///< of the block: what its points are drawn by
  bool used = false, near = false;
  MapClearance::State hot;               ///< may it touch, and not only soon?
  std::int32_t newest = PointRing::None; ///< of its chunks
  int fresh = 0, replaced = 0;           ///< chunks that are not leaving
  std::uint32_t drawn = 0;               ///< chunks so far
  std::uint32_t points = 0;              ///< alive
  double shown = 0.0;                    ///< area that its points have together now, mm^2
  double step = 0.0;                     ///< that it comes nearer to the surface's each tick
  bool settled = false;                  ///< nothing fades
};

/// What is done with the points of a block: drawn, moved, retired, blended. HAPTIC: takes memory
/// when it is made.
class BlockPoints
{
public:
  /// As DynamicPointShell's. WORKER: it is there that the fastest kernels are found.
  BlockPoints(const GridGeometry& geometry, const glm::dvec3& origin, std::uint32_t points,
    int blendTicks, std::uint32_t seed);

  PointRing& Ring() noexcept { return this->Points; }
  const PointRing& Ring() const noexcept { return this->Points; }

  /// Finds the block's crossed cells, and sets out for their area.
  void Measure(ServedBlock& served) const noexcept;
  /// 16 points more, evenly over the block's area. Returns how many were found on the surface; -1
  /// if there is no room, or no surface.
  int Draw(ServedBlock& served) noexcept;
  /// The surface is another one: none of the chunks has been moved to it.
  void SetIsovalue(ServedBlock& served, double isovalue, bool insideAbove) noexcept;
  /// Moves chunks to it that have not been moved yet, the newest first, until `most` are: those
  /// that cannot be moved go. `left`: points that may still be moved. Returns how many were.
  std::uint32_t Move(ServedBlock& served, int most, int& left) noexcept;
  /// Chunks that are more than `target` leave, one a tick, the oldest first; those of another
  /// surface as soon as there are as many new ones.
  void Retire(ServedBlock& served, int target) noexcept;
  /// Fades chunks in and out, and shares the block's area among its points.
  void Blend(ServedBlock& served) noexcept;
  /// All of its points, at once.
  void GiveBack(ServedBlock& served) noexcept;

private:
  /// The chunk's points, where they were found on the surface; the others go, or stay away.
  void SetChunk(const ServedBlock& served, std::int32_t chunk, const BlockPlaces& places,
    std::uint32_t found) noexcept;
  bool MoveChunk(const ServedBlock& served, std::int32_t chunk) noexcept;

  const BlockKernels& Kernels;
  glm::ivec3 Cells;
  glm::dmat3 Direction, ToBody, ToIndex; ///< of the grid; of index steps, and back
  glm::dvec3 First;                      ///< sample of the grid, body axes, mm
  int BlendTicks;
  std::uint32_t Seed;
  PointRing Points;
};

} // namespace hasp
