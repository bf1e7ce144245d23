#pragma once
#include "Segmentation/LabelMap.h"

namespace hasp
{

/// 64 bits that tell label maps apart: dims and labels, not where the grid lies. Each 65,536 labels
/// are hashed by themselves, four to a word, by multiply and shift as in FNV-1a with words and
/// splitmix64's finish; then their hashes likewise, in order. The same on any machine and with any
/// number of threads. Not against forgers. Any thread; no state kept. One pass over the map.
std::uint64_t HashLabels(GridView<const Label> labels);

} // namespace hasp
