#pragma once
// Private to CellWalk.cxx: a ray's segment in one active cell. Its corners, from the bits of the
// cluster, and the first root.
#include "Isosurface/CellWalk.h"
#include "Isosurface/RayRoot.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace hasp::cells
{

constexpr float Tiny = 1e-30F,
                Huge = 1e36F; // corners are scaled into this range: no under- or overflow

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
    // All four pairs at once, each in 64 bits: the first of it below, the second above.
    const auto width = static_cast<std::int32_t>(cluster.place.x >> 26U);
    const Int4 bits = Int4{ int(at[0]), int(at[1]), int(at[2]), int(at[3]) } * width;
    const Int4 bytes = bits >> 3;
    const char* first = reinterpret_cast<const char*>(stream);
    const auto load = [&](std::int32_t byte)
    {
      std::int64_t word;
      std::memcpy(&word, first + byte, sizeof word);
      return word;
    };
    const Long4 words{ load(bytes[0]), load(bytes[1]), load(bytes[2]), load(bytes[3]) };
    using Word4 = std::uint64_t __attribute__((vector_size(32)));
    const Word4 pairs = (Word4)words >> __builtin_convertvector(bits & 7, Word4);
    const std::uint64_t mask = (std::uint64_t(1) << width) - 1U;
    const Word4 both = (pairs & mask) | ((pairs << (32 - width)) & (mask << 32U));
    const std::uint32_t base = cluster.place.y >> 16U;
    using Int8 = std::int32_t __attribute__((vector_size(32)));
    const Int8 samples = (Int8)both + (kind == Kind::Int16 ? static_cast<std::int16_t>(base)
                                                           : static_cast<std::int32_t>(base));
    const auto values = __builtin_convertvector(samples, Float8) - store.isovalue;
    return { __builtin_shufflevector(values, values, 0, 1, 2, 3),
      __builtin_shufflevector(values, values, 4, 5, 6, 7) };
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
  const Float4 left = __builtin_shufflevector(ca, cb, 0, 2, 4, 6),
               right = __builtin_shufflevector(ca, cb, 1, 3, 5, 7);
  const Float4 ax = Splat(a[0]), bx = Splat(b[0]);
  const Float4 ra = (one - ax) * left + ax * right, rb = (one - bx) * left + bx * right;
  const Float4 y0 = __builtin_shufflevector(ra, rb, 0, 2, 4, 6),
               y1 = __builtin_shufflevector(ra, rb, 1, 3, 5, 7);
  const Float4 ay = Splat(a[1]), by = Splat(b[1]);
  const Float4 p = y0 * (one - ay) + y1 * ay,
               q = y0 * (one - by) + y1 * by; // (ax,az) (ax,bz) (bx,az) (bx,bz)
  const Int4 pIn = p >= 0.0F, qIn = q >= 0.0F;
  if (!always && (Bits(pIn & qIn) == 15 || Bits(pIn | qIn) == 0))
    return false;
  coefficients = { p[0], (p[2] + q[0] + p[1]) * (1.0F / 3.0F), (q[1] + p[3] + q[2]) * (1.0F / 3.0F),
    q[3] };
  return true;
}

/// The first root of a segment that begins on the surface, other than its beginning: the linear
/// factor is divided out of the cubic, and what stays is a quadratic. A segment that begins
/// towards the other side than the ray is blocked at once (a crease between two cells).
inline bool RootAfterStart(glm::vec4 c, bool startInside, float& s)
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

/// The root of a cubic that rises or falls all the way and changes its sign, after two to four
/// steps of Newton from the secant's root. False where it is no such cubic, or they were too few.
HASP_INLINE bool QuickRoot(const glm::vec4& c, float& s)
{
  const float d0 = c.y - c.x, d1 = c.z - c.y, d2 = c.w - c.z;
  const bool rises = d0 > 0.0F && d1 > 0.0F && d2 > 0.0F,
             falls = d0 < 0.0F && d1 < 0.0F && d2 < 0.0F;
  if (!(rises || falls) || (c.x >= 0.0F) == (c.w >= 0.0F))
    return false;
  const float A = d2 - 2.0F * d1 + d0, B = 3.0F * (d1 - d0), C = 3.0F * d0;
  const auto step = [&](float at)
  { return (((A * at + B) * at + C) * at + c.x) / ((3.0F * A * at + 2.0F * B) * at + C); };
  s = c.x / (c.x - c.w);
  s -= step(s);
  for (int n = 0; n < 3; ++n)
  {
    const float change = step(s);
    s -= change;
    if (std::abs(change) < 1e-4F) // the next step would be its square
      return s >= 0.0F && s <= 1.0F;
  }
  return false;
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
  if (onStart)
    return RootAfterStart(coefficients, ray.startInside, s);
  return QuickRoot(coefficients, s) || glsl::HaspFirstRoot(coefficients, s);
}

} // namespace hasp::cells
