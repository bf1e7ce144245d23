#pragma once
#include <cstdint>

namespace hasp
{

/// Numbers that look random and depend on nothing but the arguments (SplitMix64's finalizer): the
/// same on every machine, in any order, without a state.
inline std::uint64_t HashOf(std::uint64_t seed, std::uint64_t n) noexcept
{
  std::uint64_t z = (seed + 1) * 0xd1342543de82ef95U + (n + 1) * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

/// In [0, 1).
inline double UnitHash(std::uint64_t seed, std::uint64_t n) noexcept
{
  return static_cast<double>(HashOf(seed, n) >> 11) * 0x1p-53;
}

} // namespace hasp
