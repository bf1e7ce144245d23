#include "CountedAllocations.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace
{
std::atomic<std::size_t> count{ 0 };

void* Take(std::size_t bytes)
{
  count.fetch_add(1, std::memory_order_relaxed);
  if (void* memory = std::malloc(bytes ? bytes : 1))
    return memory;
  throw std::bad_alloc();
}
} // namespace

std::size_t CountedAllocations() noexcept
{
  return count.load(std::memory_order_relaxed);
}

void* operator new(std::size_t bytes)
{
  return Take(bytes);
}
void* operator new[](std::size_t bytes)
{
  return Take(bytes);
}
void operator delete(void* memory) noexcept
{
  std::free(memory);
}
void operator delete[](void* memory) noexcept
{
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept
{
  std::free(memory);
}
