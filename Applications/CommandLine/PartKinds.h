#pragma once
#include "PartLine.h"

#include <vector>

namespace hasp
{

/// A kind of random part: makes the part of a seed and says what came of it, with its time.
struct PartKind
{
  const char* name;
  unsigned shares; ///< of all random parts; 0: no part, but counted by itself
  PartLine (*tryOne)(std::uint32_t seed);
};

/// All that `hasp report guides` tries. A new kind is a line.
const std::vector<PartKind>& PartKinds();

} // namespace hasp
