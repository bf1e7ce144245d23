#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#ifndef HWY_INLINE
#define HWY_INLINE inline
#endif

/// What ElementLanes-inl.h asks of Highway, for one number at a time: how it is compiled where
/// Highway is not. Names and meaning as there.
namespace hasp::one_lane
{

template <typename T>
struct Tag
{
};

inline float Set(Tag<float>, float v)
{
  return v;
}
inline std::int32_t Set(Tag<std::int32_t>, std::int32_t v)
{
  return v;
}
inline std::int32_t Iota(Tag<std::int32_t>, std::int32_t first)
{
  return first;
}
template <typename T>
T LoadU(Tag<T>, const T* p)
{
  return *p;
}
template <typename T>
void StoreU(T v, Tag<T>, T* p)
{
  *p = v;
}
template <typename T>
T GatherIndex(Tag<T>, const T* from, std::int32_t n)
{
  return from[n];
}
template <typename T>
void ScatterIndex(T v, Tag<T>, T* to, std::int32_t n)
{
  to[n] = v;
}
inline std::size_t CompressStore(std::int32_t v, bool m, Tag<std::int32_t>, std::int32_t* to)
{
  *to = v;
  return m ? 1 : 0;
}
inline std::uint64_t BitsOf(bool m)
{
  return m ? 1 : 0;
}

template <typename T>
T Add(T a, T b)
{
  return a + b;
}
template <typename T>
T Sub(T a, T b)
{
  return a - b;
}
template <typename T>
T Mul(T a, T b)
{
  return a * b;
}
template <typename T>
T Min(T a, T b)
{
  return std::min(a, b);
}
template <typename T>
T Max(T a, T b)
{
  return std::max(a, b);
}
inline float Div(float a, float b)
{
  return a / b;
}
inline float MulAdd(float a, float b, float c)
{
  return a * b + c;
}
inline float Sqrt(float a)
{
  return std::sqrt(a);
}
inline float Abs(float a)
{
  return std::abs(a);
}
inline float Neg(float a)
{
  return -a;
}
inline float CopySign(float a, float b)
{
  return std::copysign(a, b);
}
inline float ConvertTo(Tag<float>, std::int32_t v)
{
  return static_cast<float>(v);
}
inline std::int32_t NearestInt(float v)
{
  return static_cast<std::int32_t>(std::lrint(v));
}
template <int N>
std::int32_t ShiftLeft(std::int32_t v)
{
  return v << N;
}
template <int N>
std::int32_t ShiftRight(std::int32_t v)
{
  return v >> N;
}
inline std::int32_t Shr(std::int32_t v, std::int32_t n)
{
  return v >> n;
}

template <typename T>
bool Eq(T a, T b)
{
  return a == b;
}
template <typename T>
bool Lt(T a, T b)
{
  return a < b;
}
template <typename T>
bool Le(T a, T b)
{
  return a <= b;
}
template <typename T>
bool Gt(T a, T b)
{
  return a > b;
}
template <typename T>
bool Ge(T a, T b)
{
  return a >= b;
}
inline bool And(bool a, bool b)
{
  return a && b;
}
inline std::int32_t And(std::int32_t a, std::int32_t b)
{
  return a & b;
}
inline bool Or(bool a, bool b)
{
  return a || b;
}
inline std::int32_t Or(std::int32_t a, std::int32_t b)
{
  return a | b;
}
inline bool Not(bool a)
{
  return !a;
}
template <typename T>
bool RebindMask(Tag<T>, bool m)
{
  return m;
}
template <typename T>
T IfThenElse(bool m, T a, T b)
{
  return m ? a : b;
}
template <typename T>
T IfThenElseZero(bool m, T a)
{
  return m ? a : T{};
}

} // namespace hasp::one_lane
