#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace hasp
{

/// One of the seeds with one to four faults: bits turned, bytes replaced by telling values, pieces
/// removed, doubled, zeroed or taken from another seed, the end cut off, a number in a text
/// replaced by a wild one. Half of the faults fall into the first kibibyte, where headers are.
///
/// The same (seeds, number) give the same bytes on every machine. Throws std::invalid_argument if
/// there are no seeds.
std::string Mutate(const std::vector<std::string>& seeds, std::uint64_t number);

} // namespace hasp
