#pragma once
// Private to CellTracer: vectors of four lanes (x, y, z and one that is none), as GCC and Clang
// have them, so that one source is compiled for every instruction set.
#include <cstdint>

#define HASP_INLINE [[gnu::always_inline]] inline

namespace hasp
{

using Float4 = float __attribute__((vector_size(16)));
using Float8 = float __attribute__((vector_size(32)));
using Int4 = std::int32_t __attribute__((vector_size(16)));
using Double4 = double __attribute__((vector_size(32)));
using UShort4 = std::uint16_t __attribute__((vector_size(8)));
using Long4 = std::int64_t __attribute__((vector_size(32)));

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
#if defined(__SSE__)
// What GCC does not find by itself where a bound is a constant.
HASP_INLINE Float4 Least(Float4 a, Float4 b)
{
  return __builtin_ia32_minps(a, b);
}
HASP_INLINE Float4 Most(Float4 a, Float4 b)
{
  return __builtin_ia32_maxps(a, b);
}
#endif
HASP_INLINE Float4 Within(Float4 v, Float4 least, Float4 most)
{
  return Least(Most(v, least), most);
}

HASP_INLINE Double4 SelectWide(Long4 mask, Double4 yes, Double4 no)
{
  return (Double4)((mask & (Long4)yes) | (~mask & (Long4)no));
}

HASP_INLINE int Bits(Int4 mask) // one a lane
{
#if defined(__SSE__)
  return __builtin_ia32_movmskps((Float4)mask);
#else
  return (mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4) | (mask[3] & 8);
#endif
}

} // namespace hasp
