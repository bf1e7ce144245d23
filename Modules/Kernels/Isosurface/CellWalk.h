#pragma once
// Private to CellTracer: a ray through the cells of one box.
#include "Isosurface/CellTracer.h"
#include "Isosurface/CellVectors.h"

#include <array>

namespace hasp
{

namespace cells
{
// Ways along the ray inside a box, 8 sqrt(3) voxels at most, are whole numbers of 2^-26 voxel:
// an integer's minimum and sum take a cycle each, a float's four. LongWay stands for what is never
// met.
constexpr double TicksPerVoxel = 67108864.0;
constexpr float LongWay = 1.0e9F; // ticks, more than any; twice as many are still an integer
constexpr double OnStart = 1e-4;  // voxels: segments that begin this close to the start touch it
constexpr double Slack = 1e-9;    // voxels: what a turn into index coordinates may round off
} // namespace cells

/// The part of a cluster that Embree's tree knows as one thing.
struct CellBox
{
  std::uint16_t low[3]; ///< its first cell in the volume
  std::uint16_t size;   ///< cells along x less 1 | y << 3 | z << 6
  std::uint32_t cluster;

  /// first and last cell lie in that cluster.
  CellBox(const glm::ivec3& first, const glm::ivec3& last, std::uint32_t number);
  glm::ivec3 Low() const { return { this->low[0], this->low[1], this->low[2] }; }
  glm::ivec3 High() const
  {
    return this->Low() + glm::ivec3(this->size & 7, this->size >> 3 & 7, this->size >> 6);
  }
};

struct CellStore;
struct CellWalkRay;

/// Meets the ray with the cells of box n; if a hit is nearer than ray.t it is kept there. True
/// then.
using CellWalk = bool (*)(const CellStore& store, std::uint32_t n, CellWalkRay& ray);

/// The cells as a walk reads them.
struct CellStore
{
  CellWalk walk; ///< for cells of their kind
  const CellCluster* clusters;
  const std::uint32_t* corners;
  const CellBox* boxes;
  float isovalue;
  std::vector<float> levels; ///< Compact: what each of the 256 codes stands for, minus the isovalue
};

/// A ray on its way, and the nearest hit so far. t in voxels.
struct CellWalkRay
{
  Double4 origin, direction; ///< index coordinates; direction is unit
  Double4 inverse;           ///< of direction; +-1e300 instead of infinity; then where the ray ends
  Float4 directionF, inverseF; ///< inverseF: ticks a voxel
  Float4 cellStep;             ///< +-1
  Int4 delta;                  ///< ticks from a face to the next
  Int4 forwards;               ///< 1 where direction is not negative, else 0
  std::array<Int4, 2> step;    ///< change of the place when axes cross, by their bits
  bool fromSurface = false;    ///< starts on the surface: that root does not count
  bool startInside = false;    ///< and goes to the inside

  double t = std::numeric_limits<double>::infinity(); ///< of the nearest hit
  std::uint32_t cluster = 0, place = 0; ///< its cell: x | y << 3 | z << 6 in the cluster
  Float4 low, high, local;              ///< its corners minus the isovalue; the hit

  /// What follows from direction and inverse.
  void FinishDirection();

  std::int32_t Step(int axes) const { return this->step[axes >> 2][axes & 3]; }
  double End() const { return this->inverse[3]; }
  bool Hit() const { return this->t < std::numeric_limits<double>::infinity(); }
};

/// How a ray was moved: its t is (moved + t of the walk) / length.
struct CellWalkEntry
{
  double moved, length; ///< voxels
};

/// Makes `walk` ready for a ray through a volume of so many cells, from where it enters it. False
/// if the ray does not meet the volume or is not finite.
bool BeginWalk(
  const CellRay& ray, const glm::ivec3& cells, CellWalkRay& walk, CellWalkEntry& entry);

/// The number of the active cell at a place x | y << 3 | z << 6 of the cluster.
std::uint32_t CellNumber(const CellCluster& cluster, std::uint32_t place);
/// The lowest sample of the cell there.
inline glm::ivec3 CellAt(const CellCluster& cluster, std::uint32_t place)
{
  return cluster.Origin() + glm::ivec3(place & 7U, place >> 3U & 7U, place >> 6U);
}

/// The walk for cells of this kind, in the CPU's widest instructions; the result is the same in
/// all.
CellWalk ChooseCellWalk(CornerType type, CellPrecision precision);

} // namespace hasp
