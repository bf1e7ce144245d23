#pragma once
#include <cstdint>

namespace hasp
{

/// The n-th number of a seed, in (0,1): splitmix64, the same on every machine.
inline double SeededShare(std::uint64_t seed, std::uint64_t n)
{
  std::uint64_t x = seed * 0xd1342543de82ef95U + (n + 1U) * 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return (static_cast<double>((x ^ (x >> 31)) >> 11) + 0.5) * 0x1p-53;
}

} // namespace hasp
