#pragma once
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace hasp
{

/// Disjoint sets of 0..n-1.
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t n) : Parent(n) { std::iota(Parent.begin(), Parent.end(), 0U); }
  std::uint32_t Root(std::uint32_t n)
  {
    while (this->Parent[n] != n)
      n = this->Parent[n] = this->Parent[this->Parent[n]];
    return n;
  }
  void Join(std::uint32_t a, std::uint32_t b) { this->Parent[this->Root(a)] = this->Root(b); }

private:
  std::vector<std::uint32_t> Parent;
};

} // namespace hasp
