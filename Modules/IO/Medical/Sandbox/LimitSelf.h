#pragma once
#include <cstdint>

namespace hasp
{

/// For the child programs, first thing in main: no more memory and processor time than this, no
/// core file. What is exceeded later fails (std::bad_alloc) or ends the program. False if the
/// system refuses.
bool LimitSelf(std::uint64_t memoryBytes, std::uint64_t seconds);

} // namespace hasp
