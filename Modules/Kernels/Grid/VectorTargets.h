#pragma once
#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <vector>

namespace hasp
{

/// What a table of Highway's (HWY_DISPATCH_TABLE) gives for each instruction set that this machine
/// has and the file was compiled for (HWY_TARGETS), the least capable first. Not those of one lane
/// or that play a vector: plain code is better. For files that Highway compiles once a target, to
/// list all of their kernels; only where HASP_ENABLE_HIGHWAY is ON. Any thread.
template <typename Table>
auto OfVectorTargets(const Table& table, std::int64_t compiled)
{
  std::vector<decltype(table[0]())> all;
  for (std::int64_t left = hwy::SupportedTargets() & compiled; left != 0; left &= left - 1)
  {
    const std::int64_t target = left & -left; // the most capable have the lowest bits
    if (target == HWY_SCALAR || target == HWY_EMU128)
      continue;
    hwy::ChosenTarget chosen;
    chosen.Update(target);
    const std::size_t at = std::size(table) == 1 ? 0 : chosen.GetIndex(); // 1: compiled for one
    all.push_back(table[at]());
  }
  std::reverse(all.begin(), all.end());
  return all;
}

} // namespace hasp
