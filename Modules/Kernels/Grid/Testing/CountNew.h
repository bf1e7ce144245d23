#pragma once
#include <cstddef>

namespace hasp::test
{

/// How often this thread has taken memory with new since the program began: what must take none is
/// held against it. CountNew.cxx replaces every form of the global operator, so that a program that
/// is built with it counts arrays, aligned memory and what may fail, in its libraries too, also
/// under a sanitizer. What takes memory with malloc is not counted.
std::size_t NewCount() noexcept;
std::size_t NewBytes() noexcept;             ///< and how much in all
std::size_t NewCountOfAllThreads() noexcept; ///< NewCount of every thread together

/// While it lives, all threads but the one that made it take memory with new `left` times more, and
/// then none: new throws std::bad_alloc, and what may fail gives nullptr. One at a time.
class NewRefused
{
public:
  explicit NewRefused(std::size_t left) noexcept;
  ~NewRefused();
  NewRefused(const NewRefused&) = delete;
  NewRefused& operator=(const NewRefused&) = delete;
};

} // namespace hasp::test
