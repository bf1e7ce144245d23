#include "Isosurface/CellWalk.h"
#include "Isosurface/RayRoot.h"

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
#define HASP_INLINE [[gnu::always_inline]] inline

namespace hasp
{

namespace
{

// Ways along the ray inside a box, 4 sqrt(3) voxels at most, are whole numbers of 2^-26 voxel:
// an integer's minimum and sum take a cycle each, a float's four. LongWay stands for what is never
// met.
constexpr double TicksPerVoxel = 67108864.0;
constexpr float LongWay = 1.0e9F; // ticks, more than any; twice as many are still an integer
constexpr std::int32_t Never = std::numeric_limits<std::int32_t>::max();
constexpr double OnStart = 1e-4; // voxels: segments that begin this close to the start touch it
constexpr float Tiny = 1e-30F,
                Huge = 1e36F; // corners are scaled into this range: no under- or overflow

HASP_INLINE Float4 Splat(float v)
{
  return Float4{ v, v, v, v };
}

template <typename V>
HASP_INLINE V Select(Int4 mask, V yes, V no)
{
  return (V)((mask & (Int4)yes) | (~mask & (Int4)no));
}

template <typename V>
HASP_INLINE V Least(V a, V b)
{
  return a < b ? a : b;
}
template <typename V>
HASP_INLINE V Most(V a, V b)
{
  return a > b ? a : b;
}

HASP_INLINE int Bits(Int4 mask) // of the lanes x, y, z
{
  return (mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4);
}

/// Where a pair of corners, (x, y) and (x + 1, y) of a slice, and the pair at y + 1 are stored:
/// what HaspCornersBefore counts, on 64 bits.
struct PairPlaces
{
  std::uint32_t first, second;
};
HASP_INLINE PairPlaces PlacesOfPairs(std::uint64_t cells, unsigned bit) // bit: 8 y + x
{
  constexpr std::uint64_t column = 0x8080808080808080U;
  const std::uint64_t wide = cells | (cells & ~column) << 1U;
  const std::uint64_t square = wide | wide << 8U, above = wide >> 56U;  // rows 0..7, row 8
  const std::uint64_t last = (cells & column) | (cells & column) << 8U; // corners at x = 8
  const unsigned y = bit & 56U;
  const auto below = [](unsigned n) { return (std::uint64_t(1) << n) - 1U; };
  const auto first = std::popcount(square & below(bit)) + std::popcount(last & below(y));
  const std::uint64_t row = (square >> bit | (above << 1U) << (63U - bit)) & 0xFFU;
  return { static_cast<std::uint32_t>(first),
    static_cast<std::uint32_t>(first + std::popcount(row) + int(last >> (y + 7U) & 1U)) };
}

HASP_INLINE std::uint64_t LoadBits(const std::uint32_t* stream, std::uint32_t bit)
{
  std::uint64_t word;
  std::memcpy(&word, reinterpret_cast<const char*>(stream) + (bit >> 3U), sizeof word);
  return word >> (bit & 7U);
}

enum class Kind
{
  Int16,
  UInt16,
  Float32,
  Compact
};

struct Corners
{
  Float4 low, high;
};

/// The 8 corners of an active cell minus the isovalue.
template <Kind kind>
HASP_INLINE Corners Decode(const CellStore& store, const CellCluster& cluster, std::uint32_t place)
{
  const unsigned z = place >> 6U, bit = place & 63U;
  const std::uint64_t here = cluster.active[z];
  const std::uint64_t touchLow = here | (z > 0 ? cluster.active[z - 1] : 0);
  const std::uint64_t touchHigh = here | (z < 7 ? cluster.active[z + 1] : 0);
  const PairPlaces low = PlacesOfPairs(touchLow, bit), high = PlacesOfPairs(touchHigh, bit);
  const std::uint32_t beforeLow = z > 0 ? cluster.cornersBefore[z - 1] : 0,
                      beforeHigh = cluster.cornersBefore[z];
  const std::uint32_t at[4] = { beforeLow + low.first, beforeLow + low.second,
    beforeHigh + high.first, beforeHigh + high.second };
  const std::uint32_t* stream = store.corners + cluster.firstWord;

  if constexpr (kind == Kind::Float32)
  {
    alignas(16) float v[8];
    for (int p = 0; p < 4; ++p)
      std::memcpy(v + 2 * p, stream + at[p], 8);
    const Float4 iso = Splat(store.isovalue);
    return { Float4{ v[0], v[1], v[2], v[3] } - iso, Float4{ v[4], v[5], v[6], v[7] } - iso };
  }
  else if constexpr (kind == Kind::Compact)
  {
    const float* levels = store.levels.data();
    float v[8];
    for (int p = 0; p < 4; ++p)
    {
      const std::uint64_t pair = LoadBits(stream, 8 * at[p]);
      v[2 * p] = levels[pair & 255U];
      v[2 * p + 1] = levels[pair >> 8U & 255U];
    }
    return { Float4{ v[0], v[1], v[2], v[3] }, Float4{ v[4], v[5], v[6], v[7] } };
  }
  else
  {
    const std::uint32_t width = cluster.place.x >> 26U;
    const std::uint64_t mask = (std::uint64_t(1) << width) - 1U;
    std::uint64_t pairs[4];
    for (int p = 0; p < 4; ++p)
    {
      const std::uint64_t pair = LoadBits(stream, width * at[p]);
      pairs[p] = (pair & mask) | (pair >> width & mask) << 32U;
    }
    const std::uint32_t bits = cluster.place.y >> 16U;
    const std::int32_t base =
      kind == Kind::Int16 ? static_cast<std::int16_t>(bits) : static_cast<std::int32_t>(bits);
    using Long2 = std::uint64_t __attribute__((vector_size(16)));
    const Int4 bases{ base, base, base, base };
    const Int4 a = (Int4)Long2{ pairs[0], pairs[1] } + bases,
               b = (Int4)Long2{ pairs[2], pairs[3] } + bases;
    const Float4 iso = Splat(store.isovalue);
    return { __builtin_convertvector(a, Float4) - iso, __builtin_convertvector(b, Float4) - iso };
  }
}

/// HaspRayBernstein, the same operations in the same order, four at a time. False if the trilinear
/// values at all corners of the box between a and b have one sign: so have the coefficients then.
/// always: compute them all the same.
HASP_INLINE bool Bernstein(
  const Corners& c, Float4 a, Float4 b, bool always, glm::vec4& coefficients)
{
  const Float4 one = Splat(1.0F);
  const Float4 az = Splat(a[2]), bz = Splat(b[2]);
  const Float4 ca = c.low * (one - az) + c.high * az, cb = c.low * (one - bz) + c.high * bz;
  // Rows y = 0 (even) and y = 1 (odd) of both, at the two x.
  const Float4 left = __builtin_shuffle(ca, cb, Int4{ 0, 2, 4, 6 }),
               right = __builtin_shuffle(ca, cb, Int4{ 1, 3, 5, 7 });
  const Float4 ax = Splat(a[0]), bx = Splat(b[0]);
  const Float4 ra = (one - ax) * left + ax * right, rb = (one - bx) * left + bx * right;
  const Float4 y0 = __builtin_shuffle(ra, rb, Int4{ 0, 2, 4, 6 }),
               y1 = __builtin_shuffle(ra, rb, Int4{ 1, 3, 5, 7 });
  const Float4 ay = Splat(a[1]), by = Splat(b[1]);
  const Float4 p = y0 * (one - ay) + y1 * ay,
               q = y0 * (one - by) + y1 * by; // (ax,az) (ax,bz) (bx,az) (bx,bz)
  const Int4 pIn = p >= 0.0F, qIn = q >= 0.0F;
  const Int4 all = pIn & qIn, any = pIn | qIn;
  using Long2 = std::int64_t __attribute__((vector_size(16)));
  const Long2 allL = (Long2)all, anyL = (Long2)any;
  if (!always && ((allL[0] & allL[1]) == -1 || (anyL[0] | anyL[1]) == 0))
    return false;
  coefficients = { p[0], (p[2] + q[0] + p[1]) * (1.0F / 3.0F), (q[1] + p[3] + q[2]) * (1.0F / 3.0F),
    q[3] };
  return true;
}

/// The first root of a segment that begins on the surface, other than its beginning: the linear
/// factor is divided out of the cubic, and what stays is a quadratic. A segment that begins
/// towards the other side than the ray is blocked at once (a crease between two cells).
bool RootAfterStart(glm::vec4 c, bool startInside, float& s)
{
  c -= c.x; // the isovalue that the start lies on
  const float largest = std::max({ std::abs(c.y), std::abs(c.z), std::abs(c.w) });
  if (!(largest > 0.0F && largest <= std::numeric_limits<float>::max()))
    return false;                                        // within the surface
  const double q0 = 3.0 * c.y, q1 = 1.5 * c.z, q2 = c.w; // Bernstein, degree 2
  s = 0.0F;
  const double side = startInside ? 1.0 : -1.0;
  if (q0 * side < 0.0)
    return true;
  if (q1 * side >= 0.0 && q2 * side >= 0.0)
    return false;
  const double A = q0 - 2.0 * q1 + q2, B = q1 - q0; // A s^2 + 2 B s + q0
  const double discriminant = B * B - A * q0;
  if (discriminant < 0.0)
    return false;
  const double q = -(B + (B < 0.0 ? -1.0 : 1.0) * std::sqrt(discriminant));
  double best = 2.0;
  for (const double root : { q != 0.0 ? q0 / q : 2.0, A != 0.0 ? q / A : 2.0 })
    if (root >= 0.0 && root <= 1.0)
      best = std::min(best, root);
  s = static_cast<float>(best);
  return best <= 1.0;
}

/// The first root in a cell between a and b; what HaspFirstRoot says.
template <Kind kind>
HASP_INLINE bool FirstRoot(
  Corners c, Float4 a, Float4 b, const CellWalkRay& ray, bool onStart, float& s)
{
  if constexpr (kind == Kind::Float32)
  {
    const Float4 l = Most(c.low, -c.low), h = Most(c.high, -c.high), m = Most(l, h);
    const float largest = std::max(std::max(m[0], m[1]), std::max(m[2], m[3]));
    if (largest < Tiny || largest > Huge)
    {
      const Float4 scale = Splat(largest < Tiny ? 0x1p96F : 0x1p-24F);
      c.low *= scale;
      c.high *= scale;
    }
  }
  glm::vec4 coefficients;
  if (!Bernstein(c, a, b, onStart, coefficients))
    return false;
  return onStart ? RootAfterStart(coefficients, ray.startInside, s)
                 : glsl::HaspFirstRoot(coefficients, s);
}

/// The sizes of boxes, by CellBox::size.
struct BoxSizes
{
  Double4 sizes[64];

  BoxSizes()
  {
    for (int n = 0; n < 64; ++n)
      this->sizes[n] = Double4{ 1.0 + (n & 3), 1.0 + (n >> 2 & 3), 1.0 + (n >> 4), 0.0 };
  }
};
const BoxSizes Sizes;

/// The largest (F = Most) or least of four lanes, in all of them.
template <typename F>
HASP_INLINE Double4 Across(Double4 v, const F& f)
{
  v = f(v, __builtin_shuffle(v, Long4{ 2, 3, 0, 1 }));
  return f(v, __builtin_shuffle(v, Long4{ 1, 0, 3, 2 }));
}

template <Kind kind>
HASP_INLINE bool WalkBox(const CellStore& store, std::uint32_t n, CellWalkRay& ray)
{
  const CellBox& box = store.boxes[n];
  const Double4 low = __builtin_convertvector(Int4{ box.low[0], box.low[1], box.low[2], 0 }, Double4);
  const Double4 size = Sizes.sizes[box.size];

  // Where the ray enters and leaves the box. Every box computes the way to a plane by this one formula and
  // the point there by the next, with the crossed axis exactly in the plane: so both sides of a face
  // agree in every bit.
  const Double4 u = (low - ray.origin) * ray.inverse, v = (low + size - ray.origin) * ray.inverse;
  const Double4 near = Least(u, v), far = Most(u, v);
  const Double4 enter = Across(__builtin_shuffle(near, Double4{ 0, 0, 0, 0 }, Long4{ 0, 1, 2, 7 }),
    [](const Double4& a, const Double4& b) { return Most(a, b); });
  const Double4 leave =
    Across(__builtin_shuffle(far, Double4{ 0, 0, 0, ray.tMax }, Long4{ 0, 1, 2, 7 }),
      [](const Double4& a, const Double4& b) { return Least(a, b); });
  const double tEnter = enter[0], tLeave = leave[0];
  if (!(tEnter <= tLeave) || tEnter > ray.t)
    return false;

  const Float4 zero = Splat(0.0F), one = Splat(1.0F);
  const Float4 sizeF = __builtin_convertvector(size, Float4);
  const Double4 nearSide = ray.backwards * size; // of the box, where rays enter
  const auto pointAt = [&](const Double4& t, const Double4& ways, const Double4& side)
  {
    const Double4 p = ray.origin + t * ray.direction - low;
    const Long4 crossed = ways == t;
    const Double4 snapped = (Double4)((crossed & (Long4)side) | (~crossed & (Long4)p));
    return Least(Most(__builtin_convertvector(snapped, Float4), zero), sizeF);
  };
  const Float4 entry = pointAt(enter, near, nearSide);

  // The cell, the ways to the next face of each axis, and how many faces are left inside the box.
  const Int4 lastCell = __builtin_convertvector(size, Int4) - 1;
  const Int4 cell = Least(__builtin_convertvector(entry, Int4), lastCell);
  Float4 cellF = __builtin_convertvector(cell, Float4);
  const Float4 way = (__builtin_convertvector(cell + ray.forwards, Float4) - entry) * ray.inverseF;
  Int4 next = __builtin_convertvector(Least(Most(way, zero), Splat(LongWay)) + Splat(0.5F), Int4);
  Int4 left = Select(ray.forwards > 0, lastCell - cell, cell);
  next |= (left == 0) & Never; // also in the lane that is none
  const auto end = static_cast<std::int32_t>((tLeave - tEnter) * TicksPerVoxel);

  const CellCluster& cluster = store.clusters[box.cluster];
  std::uint32_t place = ((box.low[0] & 7U) + cell[0]) | ((box.low[1] & 7U) + cell[1]) << 3U |
                        ((box.low[2] & 7U) + cell[2]) << 6U;
  std::int32_t ticks = 0;
  Int4 crossed{ 0, 0, 0, 0 };
  constexpr auto perTick = static_cast<float>(1.0 / TicksPerVoxel);
  while (true)
  {
    const Int4 m1 = Least(next, __builtin_shuffle(next, Int4{ 2, 3, 0, 1 }));
    const Int4 m = Least(m1, __builtin_shuffle(m1, Int4{ 1, 0, 3, 2 }));
    const Int4 crossing = next == m;
    const std::int32_t until = m[0];
    const bool last = until >= end;
    if (cluster.active[place >> 6U] >> (place & 63U) & 1U)
    {
      const Float4 backwards = __builtin_convertvector(1 - ray.forwards, Float4);
      Float4 a = entry + Splat(float(ticks) * perTick) * ray.directionF - cellF;
      a = Least(Most(Select(crossed, backwards, a), zero), one);
      Float4 b;
      if (last)
        b = pointAt(leave, far, size - nearSide) - cellF;
      else
        b = Select(crossing, one - backwards,
          entry + Splat(float(until) * perTick) * ray.directionF - cellF);
      b = Least(Most(b, zero), one);
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
    place += static_cast<std::uint32_t>(ray.step[Bits(crossing)]);
    left += crossing;
    next = (next + (ray.delta & crossing)) | ((left == 0) & Never);
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
      (last.x - first.x) | (last.y - first.y) << 2 | (last.z - first.z) << 4)),
    cluster(number)
{
}

HASP_CLONES bool BeginWalk(
  const CellRay& ray, const glm::ivec3& cells, CellWalkRay& walk, CellWalkEntry& entry)
{
  const Double4 given{ ray.direction.x, ray.direction.y, ray.direction.z, 0.0 };
  const Double4 origin{ ray.origin.x, ray.origin.y, ray.origin.z, 0.0 };
  const Double4 most{ double(cells.x), double(cells.y), double(cells.z), 0.0 };
  const auto lengthOf = [](const Double4& v)
  {
    const Double4 squares = v * v;
    return std::sqrt(squares[0] + squares[1] + squares[2]);
  };
  Double4 direction = given;
  double scale = 1.0, length = lengthOf(direction);
  if (!(length > 1e-100 && length < 1e100)) // squares vanish or overflow: by the largest component first
  {
    scale = std::max({ std::abs(given[0]), std::abs(given[1]), std::abs(given[2]) });
    if (!(scale > 0.0 && scale <= std::numeric_limits<double>::max()))
      return false;
    direction = given / Double4{ scale, scale, scale, scale };
    length = lengthOf(direction);
  }
  direction /= Double4{ length, length, length, length };
  entry.length = scale * length;

  // +-0 counts as positive: a ray within a face belongs to the cell above it, everywhere.
  constexpr double slack = 1e-9; // voxels: what a turn into index coordinates may round off
  const Double4 huge{ 1e300, 1e300, 1e300, 1e300 }, none{ 0, 0, 0, 0 };
  const Long4 still = direction == none;
  const Double4 inverse = Least(Most(1.0 / (Double4)(~still & (Long4)direction), -huge), huge);
  const Double4 u = -origin * inverse, v = (most - origin) * inverse;
  const Double4 near = Least(u, v), far = Most(u, v);
  double t0 = ray.tMin * entry.length, t1 = ray.tMax * entry.length;
  for (int a = 0; a < 3; ++a)
    if (still[a] == 0)
    {
      t0 = std::max(t0, near[a]);
      t1 = std::min(t1, far[a]);
    }
    else if (!(origin[a] >= -slack && origin[a] <= most[a] + slack))
      return false;
  if (!(t0 <= t1 && t1 - t0 <= std::numeric_limits<double>::max())) // NaN stops here too
    return false;

  // In the last face of the volume a ray that stays there belongs to the cell below it.
  const Double4 moved = origin + Double4{ t0, t0, t0, t0 } * direction;
  const Double4 end = most - (Double4)(still & (Long4)Double4{ slack, slack, slack, slack });
  walk.origin = Least(Most(moved, none), end);
  walk.direction = direction;
  walk.inverse = inverse;
  const Long4 negative = direction < none;
  walk.backwards = (Double4)(negative & (Long4)Double4{ 1, 1, 1, 1 });
  walk.forwards = __builtin_convertvector(negative, Int4) + 1;
  walk.directionF = __builtin_convertvector(direction, Float4);
  const Double4 ticks = Least(Most(inverse, -Double4{ 1e20, 1e20, 1e20, 1e20 }), Double4{ 1e20, 1e20, 1e20, 1e20 }) * TicksPerVoxel;
  walk.inverseF = __builtin_convertvector(ticks, Float4);
  walk.delta = __builtin_convertvector(Least(Most(walk.inverseF, -walk.inverseF), Splat(LongWay)) + 0.5F, Int4);
  walk.cellStep = __builtin_convertvector(walk.forwards * 2 - 1, Float4);
  const std::int32_t x = walk.forwards[0] * 2 - 1, y = walk.forwards[1] * 16 - 8, z = walk.forwards[2] * 128 - 64;
  const std::int32_t steps[8] = { 0, x, y, x + y, z, z + x, z + y, z + x + y };
  std::copy(steps, steps + 8, walk.step);
  walk.tMax = t1 - t0;
  entry.moved = t0;
  return true;
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
