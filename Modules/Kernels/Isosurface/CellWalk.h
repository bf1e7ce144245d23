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

/// The part of a cluster that Embree's tree knows as one thing: at most 4 cells along each axis.
struct CellBox
{
  std::uint16_t low[3]; ///< its first cell in the volume
  std::uint16_t size;   ///< cells along x less 1 | y << 2 | z << 4
  std::uint32_t cluster;

  CellBox(const glm::ivec3& first, const glm::ivec3& last, std::uint32_t number);
  glm::ivec3 Low() const { return { this->low[0], this->low[1], this->low[2] }; }
  glm::ivec3 High() const
  {
    return this->Low() + glm::ivec3(this->size & 3, this->size >> 2 & 3, this->size >> 4);
  }
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

/// A ray on its way, and the nearest hit so far. t in voxels.
struct CellWalkRay
{
  Double4 origin, direction;  ///< index coordinates, at tMin; direction is unit
  Double4 inverse;            ///< of direction; +-1e300 instead of infinity
  Double4 backwards;          ///< 1 where direction is negative, else 0
  Float4 directionF, inverseF; ///< inverseF: ticks a voxel
  Float4 cellStep;            ///< +-1
  Int4 delta;                 ///< ticks from a face to the next
  Int4 forwards;              ///< 1 where direction is not negative, else 0
  std::int32_t step[8];       ///< change of the place when axes cross, by their bits
  double tMax = 0.0;          ///< of [0, tMax]
  bool fromSurface = false;   ///< starts on the surface: that root does not count
  bool startInside = false;   ///< and goes to the inside

  double t = std::numeric_limits<double>::infinity(); ///< of the nearest hit
  std::uint32_t cluster = 0, place = 0; ///< its cell: x | y << 3 | z << 6 in the cluster
  Float4 low, high, local;              ///< its corners minus the isovalue; the hit

  bool Hit() const { return this->t < std::numeric_limits<double>::infinity(); }
};

/// How a ray was moved: its t is (moved + t of the walk) / length.
struct CellWalkEntry
{
  double moved, length; ///< voxels
};

/// Makes `walk` ready for a ray through a volume of so many cells, from where it enters it. False if
/// the ray does not meet the volume or is not finite.
bool BeginWalk(
  const CellRay& ray, const glm::ivec3& cells, CellWalkRay& walk, CellWalkEntry& entry);

/// Meets the ray with the cells of box n; if a hit is nearer than ray.t it is kept there. True then.
using CellWalk = bool (*)(const CellStore& store, std::uint32_t n, CellWalkRay& ray);

/// The walk for cells of this kind, in the CPU's widest instructions; the result is the same in all.
CellWalk ChooseCellWalk(CornerType type, CellPrecision precision);

} // namespace hasp
