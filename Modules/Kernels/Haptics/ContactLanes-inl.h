// Private to ContactForceLanes.cxx, and compiled once an instruction set: what a map says of points
// side by side, one a lane.
#if defined(HASP_CONTACT_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HASP_CONTACT_LANES_INL
#undef HASP_CONTACT_LANES_INL
#else
#define HASP_CONTACT_LANES_INL
#endif

#include "Haptics/ContactFrame.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hasp::HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::CappedTag<float, ContactPoints::Lanes> floats;
constexpr hn::RebindToSigned<decltype(floats)> ints;
constexpr int Lanes = static_cast<int>(hn::MaxLanes(floats));

using Floats = hn::Vec<decltype(floats)>;
using Ints = hn::Vec<decltype(ints)>;
using Mask = hn::Mask<decltype(floats)>;
using MapView = DistanceMapView<std::int16_t>;

HWY_INLINE Floats Splat(float v)
{
  return hn::Set(floats, v);
}
HWY_INLINE Ints Splat(std::int32_t v)
{
  return hn::Set(ints, v);
}

struct Vectors3
{
  Floats x, y, z;
};

HWY_INLINE Floats Dot(const Vectors3& a, const Vectors3& b)
{
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}
HWY_INLINE Vectors3 Cross(const Vectors3& a, const Vectors3& b)
{
  return { hn::MulSub(a.y, b.z, hn::Mul(a.z, b.y)), hn::MulSub(a.z, b.x, hn::Mul(a.x, b.z)),
    hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x)) };
}
HWY_INLINE Vectors3 Where(Mask mask, const Vectors3& v)
{
  return { hn::IfThenElseZero(mask, v.x), hn::IfThenElseZero(mask, v.y),
    hn::IfThenElseZero(mask, v.z) };
}
HWY_INLINE Vectors3 Load3(const float* x, const float* y, const float* z, std::size_t first)
{
  return { hn::Load(floats, x + first), hn::Load(floats, y + first), hn::Load(floats, z + first) };
}

/// A matrix that all points are multiplied with.
struct Matrix3
{
  glm::mat3 m;

  HWY_INLINE Vectors3 operator()(const Vectors3& v) const
  {
    return { this->Row(0, v), this->Row(1, v), this->Row(2, v) };
  }
  HWY_INLINE Vectors3 operator()(const Vectors3& v, const glm::vec3& plus) const
  {
    return { this->Row(0, v, plus.x), this->Row(1, v, plus.y), this->Row(2, v, plus.z) };
  }

private:
  HWY_INLINE Floats Row(int r, const Vectors3& v) const
  {
    return hn::MulAdd(Splat(this->m[0][r]), v.x,
      hn::MulAdd(Splat(this->m[1][r]), v.y, hn::Mul(Splat(this->m[2][r]), v.z)));
  }
  HWY_INLINE Floats Row(int r, const Vectors3& v, float plus) const
  {
    return hn::MulAdd(Splat(this->m[0][r]), v.x,
      hn::MulAdd(Splat(this->m[1][r]), v.y, hn::MulAdd(Splat(this->m[2][r]), v.z, Splat(plus))));
  }
};

/// Between the eight samples around each point.
struct Cells
{
  Floats low[4], high[4]; ///< at x and one on, of y and z, y fastest
  Vectors3 at;
};

/// All > 0 where i in (0, last): one comparison for both ends, of numbers that are finite.
HWY_INLINE Mask Inside(const Vectors3& i, const glm::vec3& last)
{
  const Floats x = hn::Mul(i.x, hn::Sub(Splat(last.x), i.x)),
               y = hn::Mul(i.y, hn::Sub(Splat(last.y), i.y)),
               z = hn::Mul(i.z, hn::Sub(Splat(last.z), i.z));
  return hn::Gt(hn::Min(hn::Min(x, y), z), hn::Zero(floats));
}

/// Samples as the lanes hold them: shifted to the upper half of 32 bits, which takes no instruction
/// to undo.
constexpr float PerSample = 65536.0F;

/// Two neighbours along x in one gather of 32 bits: half of the gathers.
HWY_INLINE void Pairs(const std::int16_t* samples, Ints bytes, Floats& low, Floats& high)
{
  const Ints pair = hn::GatherOffset(ints, reinterpret_cast<const std::int32_t*>(samples), bytes);
  low = hn::ConvertTo(floats, hn::ShiftLeft<16>(pair));
  high = hn::ConvertTo(floats, hn::And(pair, Splat(-0x10000)));
}

/// A coordinate's cell, in the lowest bits of a float, and the rest of it, in [0, 1]. Adding a
/// large number rounds to whole ones, and takes fewer instructions than conversions with their care
/// for numbers that do not fit. Where it is a tie either cell will do, with a rest of 0 or of 1.
struct Whole
{
  static constexpr float Round = 12582912.0F; ///< 1.5 * 2^23: one unit is the lowest bit
  static constexpr std::uint32_t Bits = 0x4B400000U;

  Ints bits;
  Floats rest;

  HWY_INLINE explicit Whole(Floats at)
  {
    const Floats rounded = hn::Add(hn::Sub(at, Splat(0.5F)), Splat(Round));
    this->bits = hn::BitCast(ints, rounded);
    this->rest = hn::Sub(at, hn::Sub(rounded, Splat(Round)));
  }
};

/// Outside of the grid: of its first block; numbers without meaning.
HWY_INLINE Cells FindCells(const MapView& map, const Vectors3& index, Mask inside)
{
  static_assert(MapView::Side == 8 && MapView::Row == 9 && MapView::Slice == 81);
  const Whole x(index.x), y(index.y), z(index.z);
  Cells cells;
  cells.at = { x.rest, y.rest, z.rest };
  // Blocks, each with Bits / 8 too many; modulo 2^32 the sum's excess is one number.
  const std::uint32_t stepY = static_cast<std::uint32_t>(map.blocks.x),
                      stepZ = stepY * static_cast<std::uint32_t>(map.blocks.y);
  const std::uint32_t excess = (Whole::Bits >> 3U) * (1U + stepY + stepZ);
  const Ints across = hn::Add(hn::ShiftRight<3>(x.bits),
    hn::Mul(hn::ShiftRight<3>(y.bits), Splat(static_cast<std::int32_t>(stepY))));
  const Ints block = hn::Sub(
    hn::Add(across, hn::Mul(hn::ShiftRight<3>(z.bits), Splat(static_cast<std::int32_t>(stepZ)))),
    Splat(static_cast<std::int32_t>(excess)));
  const Ints brick =
    hn::GatherIndex(ints, map.firstSample, hn::IfThenElseZero(hn::RebindMask(ints, inside), block));
  const Ints seven = Splat(MapView::Side - 1);
  const auto nine = [](Ints v) HWY_ATTR { return hn::Add(hn::ShiftLeft<3>(v), v); };
  const Ints slice = hn::Add(nine(hn::And(z.bits, seven)), hn::And(y.bits, seven));
  const Ints sample = hn::Add(brick, hn::Add(nine(slice), hn::And(x.bits, seven)));
  const Ints bytes = hn::ShiftLeft<1>(sample);
  for (int n = 0; n < 4; ++n)
    Pairs(map.samples + (n & 1) * MapView::Row + (n >> 1) * MapView::Slice, bytes, cells.low[n],
      cells.high[n]);
  return cells;
}

HWY_INLINE Floats Mix(Floats a, Floats b, Floats t)
{
  return hn::MulAdd(t, hn::Sub(b, a), a);
}

/// Samples' steps along x, and the trilinear value; the gradient shares what it needs.
struct Mixed
{
  Floats step[4], row[4];
  Floats upLow, upHigh, low, high;

  HWY_INLINE explicit Mixed(const Cells& c)
  {
    for (int n = 0; n < 4; ++n)
    {
      this->step[n] = hn::Sub(c.high[n], c.low[n]);
      this->row[n] = hn::MulAdd(c.at.x, this->step[n], c.low[n]);
    }
    this->upLow = hn::Sub(this->row[1], this->row[0]);
    this->upHigh = hn::Sub(this->row[3], this->row[2]);
    this->low = hn::MulAdd(c.at.y, this->upLow, this->row[0]);
    this->high = hn::MulAdd(c.at.y, this->upHigh, this->row[2]);
  }
  HWY_INLINE Floats Value(const Cells& c) const { return Mix(this->low, this->high, c.at.z); }
  /// Exact derivative of Value, per step of the index.
  HWY_INLINE Vectors3 Gradient(const Cells& c) const
  {
    const Floats low4 = Mix(this->step[0], this->step[1], c.at.y),
                 high4 = Mix(this->step[2], this->step[3], c.at.y);
    return { Mix(low4, high4, c.at.z), Mix(this->upLow, this->upHigh, c.at.z),
      hn::Sub(this->high, this->low) };
  }
};

} // namespace hasp::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
