#pragma once
// Private to CellTracer: a ray through the cells of one box, in vectors of four lanes (x, y, z,
// none).
#include "Isosurface/CellTracer.h"

namespace hasp
{

using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));
using Double4 = double __attribute__((vector_size(32)));
using Long4 = std::int64_t __attribute__((vector_size(32)));

/// The part of a cluster that Embree's tree knows as one thing: cells low <= cell <= high.
struct CellBox
{
  std::uint32_t cluster;
  std::uint32_t packed; ///< low x | y << 3 | z << 6, high << 9 the same way; cells in the cluster

  glm::ivec3 Low() const { return Unpack(this->packed); }
  glm::ivec3 High() const { return Unpack(this->packed >> 9U); }
  static std::uint32_t Pack(const glm::ivec3& low, const glm::ivec3& high)
  {
    return static_cast<std::uint32_t>(
      low.x | low.y << 3 | low.z << 6 | high.x << 9 | high.y << 12 | high.z << 15);
  }

private:
  static glm::ivec3 Unpack(std::uint32_t p) { return { p & 7U, p >> 3U & 7U, p >> 6U & 7U }; }
};

/// The cells as a walk reads them.
struct CellStore
{
  const CellCluster* clusters;
  const std::uint32_t* corners;
  const CellBox* boxes;
  float isovalue;
  std::vector<float> levels; ///< Compact: what each of the 256 codes stands for, minus the isovalue
};

/// A ray on its way, and the nearest hit so far. 32-byte aligned; t in voxels.
struct CellWalkRay
{
  Double4 origin,
    direction;       ///< index coordinates; direction is unit, origin where it enters the volume
  Double4 inverse;   ///< of direction; +-1e300 instead of infinity
  Double4 enterSide; ///< 1 where the ray enters a cell through its high face, else 0
  Float4 directionF;
  Int4 delta;            ///< ticks from a face to the next, 0 in the last lane
  std::uint32_t step[8]; ///< change of the packed place when axes cross, by their bits
  double tMin = 0.0, tMax = 0.0;
  bool fromSurface = false; ///< starts on the surface: that root does not count
  bool startInside = false; ///< and goes to the inside

  double t = std::numeric_limits<double>::infinity(); ///< of the nearest hit
  std::uint32_t cluster = 0, place = 0;               ///< its cell, packed as in the walk
  Float4 low, high, local;                            ///< its corners minus the isovalue; the hit

  bool Hit() const { return this->t < std::numeric_limits<double>::infinity(); }
};

/// Makes `ray` ready for directions of any length, also with zeros. direction must be unit.
void PrepareWalk(CellWalkRay& ray, const glm::dvec3& origin, const glm::dvec3& direction);

/// Meets the ray with the cells of box n; if a hit is nearer than ray.t it is kept there. True
/// then.
using CellWalk = bool (*)(const CellStore& store, std::uint32_t n, CellWalkRay& ray);

/// The walk for cells of this kind, in the CPU's widest instructions; the result is the same in
/// all.
CellWalk ChooseCellWalk(CornerType type, CellPrecision precision);

} // namespace hasp
