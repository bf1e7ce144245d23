// Private to CellTracer's packets, and compiled once an instruction set: vectors of rays, one a
// lane.
#if defined(HASP_CELL_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HASP_CELL_LANES_INL
#undef HASP_CELL_LANES_INL
#else
#define HASP_CELL_LANES_INL
#endif

#include "Isosurface/CellPacket.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hasp::HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::CappedTag<float, CellPacket::Size> floats;
constexpr hn::RebindToSigned<decltype(floats)> ints;
constexpr hn::RebindToUnsigned<decltype(floats)> words;
constexpr hn::Half<decltype(floats)> halfFloats;
constexpr hn::Half<decltype(ints)> halfInts;
constexpr hn::Half<decltype(words)> halfWords;
constexpr hn::Rebind<double, decltype(halfFloats)> doubles;
constexpr hn::Rebind<std::uint64_t, decltype(halfFloats)> longs;
constexpr int Lanes = static_cast<int>(hn::MaxLanes(floats));

using Floats = hn::Vec<decltype(floats)>;
using Ints = hn::Vec<decltype(ints)>;
using Words = hn::Vec<decltype(words)>;
using Doubles = hn::Vec<decltype(doubles)>;
using Mask = hn::Mask<decltype(ints)>;

HWY_INLINE Floats Splat(float v)
{
  return hn::Set(floats, v);
}
HWY_INLINE Ints Splat(std::int32_t v)
{
  return hn::Set(ints, v);
}
template <typename V>
HWY_INLINE V Select(Mask mask, V yes, V no)
{
  return hn::IfThenElse(hn::RebindMask(hn::DFromV<V>(), mask), yes, no);
}
HWY_INLINE Mask MaskOf(hn::Mask<decltype(floats)> mask)
{
  return hn::RebindMask(ints, mask);
}
HWY_INLINE CellPacket::Rays BitsOf(Mask mask)
{
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(ints, mask, bits);
  return static_cast<CellPacket::Rays>(bits[0] | bits[1] << 8);
}
HWY_INLINE Mask MaskOf(CellPacket::Rays rays)
{
  const std::uint8_t bits[8] = { static_cast<std::uint8_t>(rays),
    static_cast<std::uint8_t>(rays >> 8U) };
  return hn::LoadMaskBits(ints, bits);
}

/// Double precision for as many rays as there are lanes of floats.
struct Wide
{
  Doubles low, high;

  HWY_INLINE Wide(Doubles first, Doubles second) : low(first), high(second) {}
  HWY_INLINE explicit Wide(double v) : low(hn::Set(doubles, v)), high(low) {}
  HWY_INLINE explicit Wide(const double* from)
    : low(hn::Load(doubles, from)),
      high(hn::Load(doubles, from + Lanes / 2))
  {
  }
  HWY_INLINE explicit Wide(Floats v)
    : low(hn::PromoteTo(doubles, hn::LowerHalf(halfFloats, v))),
      high(hn::PromoteTo(doubles, hn::UpperHalf(halfFloats, v)))
  {
  }
  HWY_INLINE explicit Wide(Ints v)
    : low(hn::PromoteTo(doubles, hn::LowerHalf(halfInts, v))),
      high(hn::PromoteTo(doubles, hn::UpperHalf(halfInts, v)))
  {
  }
  HWY_INLINE Floats ToFloats() const
  {
    return hn::Combine(
      floats, hn::DemoteTo(halfFloats, this->high), hn::DemoteTo(halfFloats, this->low));
  }
  HWY_INLINE Ints ToInts() const
  {
    return hn::Combine(ints, hn::DemoteTo(halfInts, this->high), hn::DemoteTo(halfInts, this->low));
  }
};
struct WideMask
{
  hn::Mask<decltype(doubles)> low, high;

  HWY_INLINE CellPacket::Rays Bits() const
  {
    std::uint8_t bits[16] = {};
    hn::StoreMaskBits(doubles, this->low, bits);
    hn::StoreMaskBits(doubles, this->high, bits + 8);
    return static_cast<CellPacket::Rays>(bits[0] | bits[8] << Lanes / 2);
  }
};
HWY_INLINE WideMask WideMaskOf(CellPacket::Rays rays)
{
  const std::uint8_t low[8] = { static_cast<std::uint8_t>(rays & ((1U << Lanes / 2) - 1U)) };
  const std::uint8_t high[8] = { static_cast<std::uint8_t>(rays >> Lanes / 2) };
  return { hn::LoadMaskBits(doubles, low), hn::LoadMaskBits(doubles, high) };
}
HWY_INLINE Wide operator+(Wide a, Wide b)
{
  return { a.low + b.low, a.high + b.high };
}
HWY_INLINE Wide operator-(Wide a, Wide b)
{
  return { a.low - b.low, a.high - b.high };
}
HWY_INLINE Wide operator*(Wide a, Wide b)
{
  return { a.low * b.low, a.high * b.high };
}
HWY_INLINE Wide Root(Wide v)
{
  return { hn::Sqrt(v.low), hn::Sqrt(v.high) };
}
HWY_INLINE Wide operator/(Wide a, Wide b)
{
  return { a.low / b.low, a.high / b.high };
}
HWY_INLINE Wide Negative(Wide v)
{
  return { hn::Neg(v.low), hn::Neg(v.high) };
}
HWY_INLINE WideMask operator<(Wide a, Wide b)
{
  return { a.low < b.low, a.high < b.high };
}
HWY_INLINE WideMask operator<=(Wide a, Wide b)
{
  return { a.low <= b.low, a.high <= b.high };
}
HWY_INLINE WideMask operator==(Wide a, Wide b)
{
  return { a.low == b.low, a.high == b.high };
}
HWY_INLINE Wide Least(Wide a, Wide b)
{
  return { hn::Min(a.low, b.low), hn::Min(a.high, b.high) };
}
HWY_INLINE Wide Most(Wide a, Wide b)
{
  return { hn::Max(a.low, b.low), hn::Max(a.high, b.high) };
}
HWY_INLINE Wide Select(WideMask mask, Wide yes, Wide no)
{
  return { hn::IfThenElse(mask.low, yes.low, no.low),
    hn::IfThenElse(mask.high, yes.high, no.high) };
}
HWY_INLINE void Store(Wide v, double* to)
{
  hn::Store(v.low, doubles, to);
  hn::Store(v.high, doubles, to + Lanes / 2);
}
HWY_INLINE void StoreWhere(CellPacket::Rays rays, Wide v, double* to)
{
  const WideMask mask = WideMaskOf(rays);
  hn::BlendedStore(v.low, mask.low, doubles, to);
  hn::BlendedStore(v.high, mask.high, doubles, to + Lanes / 2);
}

} // namespace hasp::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
