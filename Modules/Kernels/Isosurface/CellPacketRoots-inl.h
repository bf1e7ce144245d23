// Private to CellPacketWalk.cxx, and compiled there once an instruction set: the first roots in
// cells, one cell a lane. The operations of CellSegment.h and glsl/RayRoot.glsl in their order, so
// that results agree in every bit.
#if defined(HASP_CELL_PACKET_ROOTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HASP_CELL_PACKET_ROOTS_INL
#undef HASP_CELL_PACKET_ROOTS_INL
#else
#define HASP_CELL_PACKET_ROOTS_INL
#endif

#include "Isosurface/CellLanes-inl.h"
#include "Isosurface/CellSegment.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace hasp::HWY_NAMESPACE
{

using cells::Kind;

/// Bernstein: the coefficients, and where they have not all one sign.
HWY_INLINE Mask Bernstein(
  const Floats (&c)[8], const Floats (&a)[3], const Floats (&b)[3], Floats (&coefficients)[4])
{
  const Floats one = Splat(1.0F);
  Floats value[2][2][2]; // x, y, z of a (0) or b (1)
  auto allIn = MaskOf(~0U), anyIn = MaskOf(0U);
  for (int z = 0; z < 2; ++z)
  {
    const Floats tz = z ? b[2] : a[2], rz = one - tz;
    Floats plane[4];
    for (int n = 0; n < 4; ++n)
      plane[n] = c[n] * rz + c[n + 4] * tz;
    for (int x = 0; x < 2; ++x)
    {
      const Floats tx = x ? b[0] : a[0], rx = one - tx;
      const Floats y0 = rx * plane[0] + tx * plane[1], y1 = rx * plane[2] + tx * plane[3];
      for (int y = 0; y < 2; ++y)
      {
        const Floats ty = y ? b[1] : a[1], v = y0 * (one - ty) + y1 * ty;
        value[x][y][z] = v;
        const Mask in = MaskOf(v >= Splat(0.0F));
        allIn = hn::And(allIn, in);
        anyIn = hn::Or(anyIn, in);
      }
    }
  }
  const Floats third = Splat(1.0F / 3.0F);
  coefficients[0] = value[0][0][0];
  coefficients[1] = (value[1][0][0] + value[0][1][0] + value[0][0][1]) * third;
  coefficients[2] = (value[0][1][1] + value[1][0][1] + value[1][1][0]) * third;
  coefficients[3] = value[1][1][1];
  // Where the 8 values have one sign there is no root, whatever rounding makes of their sums.
  const auto in = [&](int n) HWY_ATTR { return MaskOf(coefficients[n] >= Splat(0.0F)); };
  return hn::And(hn::AndNot(allIn, anyIn),
    hn::Or(hn::Or(hn::Xor(in(0), in(1)), hn::Xor(in(0), in(2))), hn::Xor(in(0), in(3))));
}

/// cells::QuickRoot in lanes of the mask.
HWY_INLINE Mask QuickRoot(const Floats (&c)[4], Mask lanes, Floats& s)
{
  const Floats zero = hn::Zero(floats), two = Splat(2.0F), three = Splat(3.0F);
  const Floats d0 = c[1] - c[0], d1 = c[2] - c[1], d2 = c[3] - c[2];
  const auto rises = hn::And(hn::And(d0 > zero, d1 > zero), d2 > zero),
             falls = hn::And(hn::And(d0 < zero, d1 < zero), d2 < zero);
  const auto turns = hn::Xor(c[0] >= zero, c[3] >= zero);
  const Floats A = d2 - two * d1 + d0, B = three * (d1 - d0), C = three * d0;
  const auto step = [&](const Floats& at) HWY_ATTR
  { return (((A * at + B) * at + C) * at + c[0]) / ((three * A * at + two * B) * at + C); };
  Floats root = c[0] / (c[0] - c[3]);
  root = root - step(root);
  lanes = hn::And(lanes, MaskOf(hn::And(hn::Or(rises, falls), turns)));
  Mask found = MaskOf(0U);
  for (int n = 0; n < 3 && !hn::AllFalse(ints, lanes); ++n)
  {
    const Floats change = step(root);
    root = root - change;
    const Mask last = hn::And(lanes, MaskOf(hn::Abs(change) < Splat(1e-4F)));
    s = Select(last, root, s);
    found = hn::Or(found, last);
    lanes = hn::AndNot(last, lanes);
  }
  return hn::And(found, MaskOf(hn::And(s >= zero, s <= Splat(1.0F))));
}

HWY_INLINE Floats BernsteinValue(const Floats (&c)[4], Floats s)
{
  const Floats r = Splat(1.0F) - s, three = Splat(3.0F);
  return r * r * (r * c[0] + three * s * c[1]) + s * s * (three * r * c[2] + s * c[3]);
}

/// HaspMonotoneRoot in lanes of the mask.
HWY_INLINE Floats MonotoneRoot(
  const Floats (&c)[4], Mask lanes, Floats from, Floats to, Floats valueFrom, Floats valueTo)
{
  const Floats zero = hn::Zero(floats), two = Splat(2.0F), three = Splat(3.0F);
  const Mask inside = MaskOf(valueFrom >= zero);
  Floats s = from + (to - from) * (valueFrom / (valueFrom - valueTo));
  for (int i = 0; i < 24 && !hn::AllFalse(ints, lanes); ++i)
  {
    const Floats value = BernsteinValue(c, s), r = Splat(1.0F) - s;
    const Floats slope =
      three * (r * r * (c[1] - c[0]) + two * r * s * (c[2] - c[1]) + s * s * (c[3] - c[2]));
    const Mask other = hn::Xor(MaskOf(value >= zero), inside);
    from = Select(other, from, s);
    to = Select(other, s, to);
    const Floats newton = s - value / slope;
    const auto within = hn::And(newton >= from, newton <= to);
    const Floats next = hn::IfThenElse(within, newton, Splat(0.5F) * (from + to));
    const Floats change = hn::Abs(next - s);
    s = Select(lanes, next, s);
    lanes = hn::AndNot(MaskOf(change < Splat(1e-4F)), lanes);
  }
  return s;
}

/// HaspFirstRoot in lanes of the mask; where there is a root.
HWY_INLINE Mask FirstRootOf(const Floats (&given)[4], Mask lanes, Floats& s)
{
  const Floats zero = hn::Zero(floats), one = Splat(1.0F);
  const Mask inside = MaskOf(given[0] >= zero);
  const auto differs = [&](const Floats& v) HWY_ATTR { return hn::Xor(MaskOf(v >= zero), inside); };
  lanes = hn::And(lanes, hn::Or(hn::Or(differs(given[1]), differs(given[2])), differs(given[3])));
  const Floats largest = hn::Max(
    hn::Max(hn::Abs(given[3]), hn::Abs(given[2])), hn::Max(hn::Abs(given[1]), hn::Abs(given[0])));
  lanes = hn::And(lanes, MaskOf(largest <= Splat(3.4e38F)));
  const Floats scale = one / largest;
  const Floats c[4] = { given[0] * scale, given[1] * scale, given[2] * scale, given[3] * scale };

  const Floats d0 = c[1] - c[0], d1 = c[2] - c[1], d2 = c[3] - c[2];
  const Floats A = d0 - Splat(2.0F) * d1 + d2, B = d1 - d0, C = d0;
  const Floats discriminant = B * B - A * C;
  const Floats sign = hn::IfThenElse(B < zero, Splat(-1.0F), one);
  const Floats q = hn::Neg(B + sign * hn::Sqrt(discriminant));
  const auto split = [&](const Floats& above, const Floats& below) HWY_ATTR
  {
    const Floats at = above / below;
    const auto good = hn::And(hn::And(at > zero, at < one), discriminant > zero);
    return hn::IfThenElseZero(hn::And(good, below != zero), at);
  };
  const Floats s1 = split(C, q), s2 = split(q, A);
  const Floats first = hn::Min(s1, s2), second = hn::Max(s1, s2);
  const Floats valueFirst = BernsteinValue(c, first), valueSecond = BernsteinValue(c, second);

  const Mask inFirst = hn::And(MaskOf(first > zero), differs(valueFirst));
  const Mask inSecond = hn::AndNot(inFirst, hn::And(MaskOf(second > zero), differs(valueSecond)));
  const Mask inLast = hn::AndNot(hn::Or(inFirst, inSecond), differs(c[3]));
  lanes = hn::And(lanes, hn::Or(hn::Or(inFirst, inSecond), inLast));
  const Floats from = Select(inFirst, zero, Select(inSecond, first, second));
  const Floats to = Select(inFirst, first, Select(inSecond, second, one));
  const Floats valueFrom = Select(inFirst, c[0], Select(inSecond, valueFirst, valueSecond));
  const Floats valueTo = Select(inFirst, valueFirst, Select(inSecond, valueSecond, c[3]));
  s = Select(lanes, MonotoneRoot(c, lanes, from, to, valueFrom, valueTo), s);
  return lanes;
}

/// RootAfterStart, lane by lane: few rays begin on a surface at a time.
HWY_INLINE Mask RootsAfterStart(
  const Floats (&c)[4], CellPacket::Rays lanes, CellPacket::Rays startInside, Floats& s)
{
  alignas(64) float each[4][Lanes], roots[Lanes];
  for (int k = 0; k < 4; ++k)
    hn::Store(c[k], floats, each[k]);
  hn::Store(s, floats, roots);
  CellPacket::Rays found = 0;
  for (; lanes != 0; lanes &= lanes - 1)
  {
    const int n = std::countr_zero(lanes);
    const glm::vec4 one(each[0][n], each[1][n], each[2][n], each[3][n]);
    found |= CellPacket::Rays(cells::RootAfterStart(one, startInside >> n & 1U, roots[n])) << n;
  }
  s = hn::Load(floats, roots);
  return MaskOf(found);
}

/// cells::FirstRoot in lanes that are `on`; those `onStart` begin on the surface.
template <Kind kind>
HWY_INLINE Mask FirstRoot(const Floats (&given)[8], const Floats (&a)[3], const Floats (&b)[3],
  Mask on, CellPacket::Rays onStart, CellPacket::Rays startInside, Floats& s)
{
  Floats corners[8];
  for (int n = 0; n < 8; ++n)
    corners[n] = given[n];
  if constexpr (kind == Kind::Float32)
  {
    Floats most[4];
    for (int n = 0; n < 4; ++n)
      most[n] = hn::Max(
        hn::Max(corners[n], hn::Neg(corners[n])), hn::Max(corners[n + 4], hn::Neg(corners[n + 4])));
    const Floats largest = hn::Max(hn::Max(most[3], most[2]), hn::Max(most[1], most[0]));
    const auto tiny = largest<Splat(cells::Tiny), huge = largest> Splat(cells::Huge);
    const Floats scale =
      hn::IfThenElse(tiny, Splat(0x1p96F), hn::IfThenElse(huge, Splat(0x1p-24F), Splat(1.0F)));
    for (Floats& corner : corners)
      corner = corner * scale;
  }
  Floats c[4];
  const Mask crosses = Bernstein(corners, a, b, c);
  Mask found = MaskOf(0U);
  if (onStart != 0)
  {
    found = RootsAfterStart(c, onStart & BitsOf(on), startInside, s);
    on = hn::AndNot(MaskOf(onStart), on);
  }
  on = hn::And(on, crosses);
  if (hn::AllFalse(ints, on))
    return found;
  const Mask soon = QuickRoot(c, on, s);
  found = hn::Or(found, soon);
  on = hn::AndNot(soon, on);
  return hn::AllFalse(ints, on) ? found : hn::Or(found, FirstRootOf(c, on, s));
}

} // namespace hasp::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
