#pragma once
#include <cstddef>

namespace hasp::test
{

/// How often this thread has taken memory with new since the program began. CountNew.cxx replaces
/// the global operator.
std::size_t NewCount() noexcept;
std::size_t NewBytes() noexcept; ///< and how much in all

} // namespace hasp::test
