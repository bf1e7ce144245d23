#pragma once
// Private to CellTracer: rays that walk together, one a lane.
#include "Isosurface/CellWalk.h"

namespace hasp
{

/// Rays on their way, as CellWalkRay, number by number: [axis][ray].
struct alignas(64) CellPacket
{
  static constexpr int Size = 16;
  using Rays = std::uint32_t; ///< a bit a ray

  double origin[3][Size], direction[3][Size], inverse[3][Size], end[Size];
  float directionF[3][Size], inverseF[3][Size];
  std::int32_t delta[3][Size];

  double t[Size]; ///< of the nearest hits
  std::int32_t cluster[Size], place[Size];
  float corners[8][Size], local[3][Size];

  Rays fromSurface, startInside;

  /// One of them, to walk by itself.
  CellWalkRay Ray(int n) const;
  void SetRay(int n, const CellWalkRay& ray); ///< all of it
  void SetHit(int n, const CellWalkRay& ray); ///< its nearest hit
};

/// CellWalk for all rays given; which of them it was nearer for. The same hits, bit for bit.
using CellPacketWalk = CellPacket::Rays (*)(
  const CellStore& store, std::uint32_t n, CellPacket::Rays rays, CellPacket& packet);

/// In the CPU's widest instructions, rays side by side; where there are none, one after the other.
CellPacketWalk ChooseCellPacketWalk(CornerType type, CellPrecision precision);

} // namespace hasp
