#pragma once
#include <cstddef>

/// How often memory was taken by operator new so far, by any thread: what acts in a tick is held
/// against it. Defined in CountedAllocations.cxx.
std::size_t CountedAllocations() noexcept;
