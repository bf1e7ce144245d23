#include "Isosurface/CellWalk.h"
#include "Isosurface/CellSegment.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

// One walk is compiled for several instruction sets and chosen when the library is loaded.
#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(__clang__) &&   \
  !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define HASP_CLONES __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define HASP_CLONES
#endif

namespace hasp
{

namespace
{

using namespace cells;

/// The largest integer, which no way reaches, in the lanes of the mask.
HASP_INLINE Int4 NeverWhere(Int4 mask)
{
  using Word4 = std::uint32_t __attribute__((vector_size(16)));
  return (Int4)((Word4)mask >> 1);
}

/// The largest (F = Most) or least of four lanes, in all of them.
template <typename F>
HASP_INLINE Double4 Across(Double4 v, const F& f)
{
  v = f(v, __builtin_shufflevector(v, v, 2, 3, 0, 1));
  return f(v, __builtin_shufflevector(v, v, 1, 0, 3, 2));
}

template <Kind kind>
HASP_INLINE bool WalkBox(const CellStore& store, std::uint32_t n, CellWalkRay& ray)
{
  const CellBox& box = store.boxes[n];
  const CellCluster& cluster = store.clusters[box.cluster];
  __builtin_prefetch(store.corners + cluster.firstWord);
  std::int64_t word;
  std::memcpy(&word, box.low, sizeof word);
  using Long2 = std::int64_t __attribute__((vector_size(16)));
  using Word4 = std::uint32_t __attribute__((vector_size(16)));
  const auto halves = (Word4)Long2{ word, word };
  // x and y lie in the first 32 bits, z in the second; the last lane stays 0.
  const Int4 lowI =
    (Int4)(__builtin_shufflevector(halves, halves, 0, 0, 1, 1) >> Word4{ 0, 16, 0, 31 }) &
    Int4{ 0xFFFF, 0xFFFF, 0xFFFF, 0 };
  const Int4 firstCell = lowI & 7;
  const Int4 lastCell = firstCell + ((Int4)(__builtin_shufflevector(halves, halves, 1, 1, 1, 1) >>
                                            Word4{ 16, 19, 22, 31 }) &
                                      Int4{ 7, 7, 7, 0 });
  const Double4 base = __builtin_convertvector(lowI - firstCell, Double4);
  const Double4 begin = __builtin_convertvector(firstCell, Double4),
                stop = __builtin_convertvector(lastCell + 1, Double4);

  // Where the ray enters and leaves the box. Every box computes the way to a plane by this one
  // formula and the point there by the next, with the crossed axis exactly in the plane, in
  // coordinates of its cluster: so both sides of a face agree in every bit.
  const Double4 u = (base + begin - ray.origin) * ray.inverse;
  const Double4 v = (base + stop - ray.origin) * ray.inverse;
  const Double4 near = Least(u, v), far = Most(u, v);
  const Double4 enter = Across(near, [](const Double4& a, const Double4& b) { return Most(a, b); });
  const Double4 leave = Across(far, [](const Double4& a, const Double4& b) { return Least(a, b); });
  const double tEnter = enter[0], tLeave = leave[0];
  if (!(tEnter <= tLeave) || tEnter > ray.t)
    return false;

  const Float4 zero = Splat(0.0F), one = Splat(1.0F);
  const Long4 backwards4 = ray.direction < 0.0;
  const auto pointAt = [&](const Double4& t, const Double4& ways, Long4 atStop)
  {
    const Double4 p = ray.origin + t * ray.direction - base;
    const Double4 face = SelectWide(atStop, stop, begin);
    return Most(__builtin_convertvector(SelectWide(ways == t, face, p), Float4), zero);
  };
  const Float4 entry = pointAt(enter, near, backwards4);

  // The cell, the ways to the next face of each axis, and how many faces are left inside the box.
  const Int4 cell = Most(Least(__builtin_convertvector(entry, Int4), lastCell), firstCell);
  Float4 cellF = __builtin_convertvector(cell, Float4);
  const Float4 way = (__builtin_convertvector(cell + ray.forwards, Float4) - entry) * ray.inverseF;
  Int4 next = __builtin_convertvector(Least(Most(way, zero), Splat(LongWay)), Int4);
  Int4 left = Select(ray.forwards > 0, lastCell - cell, cell - firstCell);
  next |= NeverWhere(left == 0); // also in the lane that is none
  const auto end = static_cast<std::int32_t>((tLeave - tEnter) * TicksPerVoxel);

  auto place = static_cast<std::uint32_t>(cell[0] + cell[1] * 8 + cell[2] * 64);
  std::int32_t ticks = 0;
  Int4 crossed{ 0, 0, 0, 0 };
  constexpr auto perTick = static_cast<float>(1.0 / TicksPerVoxel);
  while (true)
  {
    const Int4 m1 = Least(next, __builtin_shufflevector(next, next, 2, 3, 0, 1));
    const Int4 m = Least(m1, __builtin_shufflevector(m1, m1, 1, 0, 3, 2));
    const Int4 crossing = next == m;
    const std::int32_t until = m[0];
    const bool last = until >= end;
    if (cluster.active[place >> 6U] >> (place & 63U) & 1U)
    {
      const Float4 backwards = __builtin_convertvector(1 - ray.forwards, Float4);
      Float4 a = entry + Splat(float(ticks) * perTick) * ray.directionF - cellF;
      a = Within(Select(crossed, backwards, a), zero, one);
      Float4 b;
      if (last)
        b = pointAt(leave, far, ~backwards4) - cellF;
      else
        b = Select(crossing, one - backwards,
          entry + Splat(float(until) * perTick) * ray.directionF - cellF);
      b = Within(b, zero, one);
      const Corners corners = Decode<kind>(store, cluster, place);
      const double tA = tEnter + ticks / TicksPerVoxel;
      float s;
      if (FirstRoot<kind>(corners, a, b, ray, ray.fromSurface && tA < OnStart, s))
      {
        const double tB = last ? tLeave : tEnter + until / TicksPerVoxel, t = tA + s * (tB - tA);
        if (!(t < ray.t || (t == ray.t && box.cluster < ray.cluster)))
          return false;
        ray.t = t;
        ray.cluster = box.cluster;
        ray.place = place;
        ray.low = corners.low;
        ray.high = corners.high;
        ray.local = a * Splat(1.0F - s) + b * Splat(s);
        return true;
      }
    }
    if (last)
      return false;
    ticks = until;
    place += static_cast<std::uint32_t>(ray.Step(Bits(crossing) & 7));
    left += crossing;
    next = (next + (ray.delta & crossing)) | NeverWhere(left == 0);
    cellF += (Float4)((Int4)ray.cellStep & crossing);
    crossed = crossing;
  }
}

HASP_CLONES bool WalkInt16(const CellStore& store, std::uint32_t n, CellWalkRay& ray)
{
  return WalkBox<Kind::Int16>(store, n, ray);
}
HASP_CLONES bool WalkUInt16(const CellStore& store, std::uint32_t n, CellWalkRay& ray)
{
  return WalkBox<Kind::UInt16>(store, n, ray);
}
HASP_CLONES bool WalkFloat32(const CellStore& store, std::uint32_t n, CellWalkRay& ray)
{
  return WalkBox<Kind::Float32>(store, n, ray);
}
HASP_CLONES bool WalkCompact(const CellStore& store, std::uint32_t n, CellWalkRay& ray)
{
  return WalkBox<Kind::Compact>(store, n, ray);
}

} // namespace

CellBox::CellBox(const glm::ivec3& first, const glm::ivec3& last, std::uint32_t number)
  : low{ std::uint16_t(first.x), std::uint16_t(first.y), std::uint16_t(first.z) },
    size(static_cast<std::uint16_t>(
      (last.x - first.x) | (last.y - first.y) << 3 | (last.z - first.z) << 6)),
    cluster(number)
{
}

HASP_INLINE void FinishDirectionOf(CellWalkRay& walk)
{
  const Double4 one{ 1, 1, 1, 1 }, zero{ 0, 0, 0, 0 };
  walk.forwards = __builtin_convertvector(walk.direction < zero, Int4) + 1;
  walk.directionF = __builtin_convertvector(walk.direction, Float4);
  walk.inverseF = __builtin_convertvector(
    Least(Most(walk.inverse, one * -1e20), one * 1e20) * TicksPerVoxel, Float4);
  walk.delta =
    __builtin_convertvector(Least(Most(walk.inverseF, -walk.inverseF), Splat(LongWay)), Int4);
  const Int4 sign = walk.forwards * 2 - 1, by = sign * Int4{ 1, 8, 64, 0 };
  walk.cellStep = __builtin_convertvector(sign, Float4);
  // 0, x, y, x + y; with z the same again. Stored whole: loads wait for what is stored in parts.
  const Int4 plane =
    __builtin_shufflevector(by, by, 3, 0, 3, 0) + __builtin_shufflevector(by, by, 3, 3, 1, 1);
  walk.step = { plane, plane + __builtin_shufflevector(by, by, 2, 2, 2, 2) };
}

HASP_CLONES void CellWalkRay::FinishDirection()
{
  FinishDirectionOf(*this);
}

HASP_CLONES bool BeginWalk(
  const CellRay& ray, const glm::ivec3& cells, CellWalkRay& walk, CellWalkEntry& entry)
{
  const Double4 zero{ 0, 0, 0, 0 }, one{ 1, 1, 1, 1 }, huge = one * 1e300;
  Double4 given{ ray.direction.x, ray.direction.y, ray.direction.z, 0.0 };
  const Double4 origin{ ray.origin.x, ray.origin.y, ray.origin.z, 0.0 };
  const Double4 most{ double(cells.x), double(cells.y), double(cells.z), 0.0 };
  const auto lengthOf = [](const Double4& v)
  {
    const Double4 squares = v * v;
    return std::sqrt(squares[0] + squares[1] + squares[2]);
  };
  double scale = 1.0, length = lengthOf(given);
  if (!(ray.tMin <= ray.tMax) || !std::isfinite(origin[0] + origin[1] + origin[2]))
    return false; // also where one is not a number
  if (!(length > 1e-100 && length < 1e100))
  {
    // Squares vanish or overflow: by the largest component first.
    scale = std::max({ std::abs(given[0]), std::abs(given[1]), std::abs(given[2]) });
    if (!(scale > 0.0 && scale <= std::numeric_limits<double>::max()))
      return false;
    given /= one * scale;
    length = lengthOf(given);
    if (!(length >= 1.0)) // another component is not a number
      return false;
  }
  const Double4 direction = given * (1.0 / length);
  entry.length = scale * length;

  // +-0 counts as positive: a ray within a face belongs to the cell above it, everywhere.
  const Long4 still = given == zero;
  const Double4 plain = one / SelectWide(still, zero, given) * length; // not -0
  const Double4 inverse = Least(Most(plain, -huge), huge);
  const Double4 u = -origin * inverse, v = (most - origin) * inverse;
  const Double4 near = SelectWide(still, -huge, Least(u, v)),
                far = SelectWide(still, huge, Most(u, v));
  const Long4 beside = still & ~((origin >= -Slack) & (origin <= most + Slack));
  const double t0 =
    std::max(std::max(near[0], near[1]), std::max(near[2], ray.tMin * entry.length));
  const double t1 = std::min(std::min(far[0], far[1]), std::min(far[2], ray.tMax * entry.length));
  const double span = t1 - t0;
  if (!(span >= 0.0 && span <= 1e100) || (beside[0] | beside[1] | beside[2]) != 0)
    return false;

  // In the last face of the volume a ray that stays there belongs to the cell below it.
  const Double4 moved = origin + one * t0 * direction;
  const Double4 end = most - SelectWide(still, Double4{ Slack, Slack, Slack, 0.0 }, zero);
  const Double4 last{ 0, 0, 0, span };
  walk.origin = Least(Most(moved, zero), end);
  walk.direction = direction;
  walk.inverse = __builtin_shufflevector(inverse, last, 0, 1, 2, 7);
  FinishDirectionOf(walk);
  entry.moved = t0;
  return true;
}

HASP_CLONES std::uint32_t CellNumber(const CellCluster& cluster, std::uint32_t place)
{
  const std::uint32_t z = place >> 6U;
  auto number = cluster.firstCell;
  for (std::uint32_t slice = 0; slice < z; ++slice)
    number += static_cast<std::uint32_t>(std::popcount(cluster.active[slice]));
  const std::uint64_t before = (std::uint64_t(1) << (place & 63U)) - 1U;
  return number + static_cast<std::uint32_t>(std::popcount(cluster.active[z] & before));
}

CellWalk ChooseCellWalk(CornerType type, CellPrecision precision)
{
  if (precision == CellPrecision::Compact)
    return WalkCompact;
  return type == CornerType::Int16    ? WalkInt16
         : type == CornerType::UInt16 ? WalkUInt16
                                      : WalkFloat32;
}

} // namespace hasp
