#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace hasp::walk
{

/// Four right-hand sides at once: a pass over the graph reads its weights once for all. One SSE or
/// NEON register; other compilers' targets get what the compiler makes of it.
constexpr int LaneCount = 4;
using Lanes = float __attribute__((vector_size(16)));

/// The same in double: two registers, since one of four is not everywhere.
struct WideLanes
{
  using Pair = double __attribute__((vector_size(16)));
  Pair low = Pair{ 0.0, 0.0 };
  Pair high = Pair{ 0.0, 0.0 };

  double operator[](int lane) const { return lane < 2 ? low[lane] : high[lane - 2]; }
  WideLanes& operator+=(const WideLanes& b)
  {
    low += b.low;
    high += b.high;
    return *this;
  }
  WideLanes& operator*=(double factor)
  {
    low *= factor;
    high *= factor;
    return *this;
  }
  friend WideLanes operator+(WideLanes a, const WideLanes& b) { return a += b; }
  friend WideLanes operator*(double factor, WideLanes a) { return a *= factor; }
  friend WideLanes operator*(const WideLanes& a, const WideLanes& b)
  {
    return WideLanes{ a.low * b.low, a.high * b.high };
  }
};

inline WideLanes Widen(Lanes a)
{
  return { WideLanes::Pair{ a[0], a[1] }, WideLanes::Pair{ a[2], a[3] } };
}
inline Lanes Narrow(const WideLanes& a)
{
  return Lanes{ static_cast<float>(a.low[0]), static_cast<float>(a.low[1]),
    static_cast<float>(a.high[0]), static_cast<float>(a.high[1]) };
}
inline Lanes Fill(float value)
{
  return Lanes{ value, value, value, value };
}
inline Lanes Abs(Lanes a)
{
  return a < 0.0F ? -a : a;
}
inline Lanes Max(Lanes a, Lanes b)
{
  return a > b ? a : b;
}

/// A value a node. One more on both sides: the first and the last node read their neighbours along
/// x without asking whether there are any.
class NodeValues
{
public:
  explicit NodeValues(std::int64_t nodes = 0) : values(static_cast<std::size_t>(nodes) + 2, Lanes{})
  {
  }
  Lanes* data() { return values.data() + 1; }
  const Lanes* data() const { return values.data() + 1; }
  std::int64_t Nodes() const { return static_cast<std::int64_t>(values.size()) - 2; }
  std::size_t Bytes() const { return values.capacity() * sizeof(Lanes); }

private:
  std::vector<Lanes> values;
};

} // namespace hasp::walk
