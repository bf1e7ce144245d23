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

// Ways along the ray inside a cluster, 8 sqrt(3) voxels at most, are whole numbers of 2^-26 voxel:
// an integer's minimum and sum take a cycle each, a float's four. LongWay stands for what is never
// met.
constexpr double TicksPerVoxel = 67108864.0;
constexpr double LongWay = 15.9;
constexpr std::int32_t Never = std::numeric_limits<std::int32_t>::max();
// What four faces of a box may add up to in rounding: a face this close to the box's is the box's.
constexpr std::int32_t TicksRounded = 4;
constexpr std::uint32_t OutOfCluster = 0x888U; // guard bits of a packed place x | y << 4 | z << 8
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
  const unsigned z = place >> 8U, bit = (place >> 1U & 56U) | (place & 7U);
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

template <Kind kind>
HASP_INLINE bool WalkBox(const CellStore& store, std::uint32_t n, CellWalkRay& ray)
{
  const CellBox box = store.boxes[n];
  const CellCluster& cluster = store.clusters[box.cluster];
  const std::uint32_t word = cluster.place.x, wordZ = cluster.place.y;
  const Int4 origin{ int(word & 0x1FFFU) * 8, int(word >> 13U & 0x1FFFU) * 8,
    int(wordZ & 0x1FFFU) * 8, 0 };
  const int k = static_cast<int>(box.packed);
  const Int4 low{ k & 7, k >> 3 & 7, k >> 6 & 7, 0 },
    high{ k >> 9 & 7, k >> 12 & 7, k >> 15 & 7, 0 };

  // Where the ray enters and leaves the box. Every box and cluster computes the way to a plane by
  // this one formula, and the point there by the next: so both sides of a face agree in every bit.
  const Double4 base = __builtin_convertvector(origin, Double4);
  const Double4 lowF = __builtin_convertvector(low, Double4),
                highF = __builtin_convertvector(high + 1, Double4);
  const Double4 u = (lowF + base - ray.origin) * ray.inverse,
                v = (highF + base - ray.origin) * ray.inverse;
  const Double4 near = Least(u, v), far = Most(u, v);
  const double tEnter = std::max(std::max(near[0], near[1]), std::max(near[2], ray.tMin));
  const double tExit = std::min(std::min(far[0], far[1]), std::min(far[2], ray.tMax));
  if (!(tEnter <= tExit) || tEnter > ray.t)
    return false;

  const auto pointAt = [&](double t, const Float4& least, const Float4& most)
  {
    const Double4 tt{ t, t, t, t };
    const Float4 p = __builtin_convertvector(ray.origin + tt * ray.direction - base, Float4);
    return Least(Most(p, least), most);
  };
  const Float4 least = __builtin_convertvector(low, Float4),
               most = __builtin_convertvector(high + 1, Float4);
  const Float4 entry = pointAt(tEnter, least, most);
  const Int4 enterHigh = __builtin_convertvector((Long4)(ray.enterSide > 0.0), Int4);
  const auto masked = [](double t, const Double4& ways)
  {
    return __builtin_convertvector((Long4)(ways == Double4{ t, t, t, t }), Int4) &
           Int4{ -1, -1, -1, 0 };
  };

  // The cell, and the ways to the next face of each axis.
  const Int4 cell = Least(__builtin_convertvector(entry, Int4), high);
  const Double4 nextFace = __builtin_convertvector(cell + 1 + enterHigh, Double4) + base;
  const Double4 enter4{ tEnter, tEnter, tEnter, tEnter };
  Double4 way = (nextFace - ray.origin) * ray.inverse - enter4;
  way = Least(Most(way, Double4{ 0, 0, 0, 0 }), Double4{ LongWay, LongWay, LongWay, LongWay });
  Int4 next = __builtin_convertvector(way * TicksPerVoxel + 0.5, Int4);
  next[3] = Never;
  const auto end = static_cast<std::int32_t>((tExit - tEnter) * TicksPerVoxel) - TicksRounded;

  std::uint32_t place = static_cast<std::uint32_t>(cell[0] | cell[1] << 4 | cell[2] << 8);
  std::int32_t ticks = 0;
  Int4 crossed = masked(tEnter, near);
  constexpr auto perTick = static_cast<float>(1.0 / TicksPerVoxel);
  while (true)
  {
    const Int4 m1 = Least(next, __builtin_shuffle(next, Int4{ 2, 3, 0, 1 }));
    const Int4 m = Least(m1, __builtin_shuffle(m1, Int4{ 1, 0, 3, 2 }));
    const Int4 crossing = next == m;
    const std::int32_t leave = m[0];
    const std::uint32_t nextPlace = place + ray.step[Bits(crossing)];
    const bool last = leave >= end || (nextPlace & OutOfCluster) != 0;
    if (cluster.active[place >> 8U] >> ((place >> 1U & 56U) | (place & 7U)) & 1U)
    {
      const Int4 c{ int(place & 7U), int(place >> 4U & 7U), int(place >> 8U), 0 };
      const Float4 cellF = __builtin_convertvector(c, Float4);
      const Float4 zero = Splat(0.0F), one = Splat(1.0F);
      const Float4 enterSide = Select(enterHigh, one, zero);
      Float4 a = entry + Splat(float(ticks) * perTick) * ray.directionF - cellF;
      a = Least(Most(Select(crossed, enterSide, a), zero), one);
      Float4 b =
        last ? pointAt(tExit, least, most) : entry + Splat(float(leave) * perTick) * ray.directionF;
      b = Least(
        Most(Select(last ? masked(tExit, far) : crossing, one - enterSide, b - cellF), zero), one);
      const Corners corners = Decode<kind>(store, cluster, place);
      const double tA = tEnter + ticks / TicksPerVoxel;
      float s;
      if (FirstRoot<kind>(corners, a, b, ray, ray.fromSurface && tA - ray.tMin < OnStart, s))
      {
        const double tB = last ? tExit : tEnter + leave / TicksPerVoxel, t = tA + s * (tB - tA);
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
    ticks = leave;
    next += ray.delta & crossing;
    crossed = crossing;
    place = nextPlace;
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

void PrepareWalk(CellWalkRay& ray, const glm::dvec3& origin, const glm::dvec3& direction)
{
  const std::int32_t steps[3] = { 1, 16, 256 };
  std::int32_t step[3];
  for (int a = 0; a < 3; ++a)
  {
    const double d = direction[a];
    ray.origin[a] = origin[a];
    ray.direction[a] = d;
    // +-0 counts as positive: a ray within a face belongs to the cell above it, everywhere.
    ray.inverse[a] = d == 0.0 ? 1e300 : std::clamp(1.0 / d, -1e300, 1e300);
    ray.enterSide[a] = d < 0.0 ? 1.0 : 0.0;
    ray.directionF[a] = static_cast<float>(d);
    ray.delta[a] =
      static_cast<std::int32_t>(std::min(std::abs(ray.inverse[a]), LongWay) * TicksPerVoxel + 0.5);
    step[a] = d < 0.0 ? -steps[a] : steps[a];
  }
  ray.origin[3] = ray.direction[3] = ray.enterSide[3] = 0.0;
  ray.inverse[3] = 1.0;
  ray.directionF[3] = 0.0F;
  ray.delta[3] = 0;
  for (int bits = 0; bits < 8; ++bits)
    ray.step[bits] = static_cast<std::uint32_t>(
      (bits & 1 ? step[0] : 0) + (bits & 2 ? step[1] : 0) + (bits & 4 ? step[2] : 0));
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
