#include "CountNew.h"

#include <cstdlib>
#include <new>

namespace
{

thread_local std::size_t Count = 0, Bytes = 0;

void* Take(std::size_t bytes, std::size_t alignment)
{
  ++Count;
  Bytes += bytes;
  void* taken = nullptr;
  if (posix_memalign(&taken, alignment, bytes ? bytes : 1) != 0)
    throw std::bad_alloc();
  return taken;
}

} // namespace

std::size_t hasp::test::NewCount() noexcept
{
  return Count;
}

std::size_t hasp::test::NewBytes() noexcept
{
  return Bytes;
}

void* operator new(std::size_t bytes)
{
  return Take(bytes, alignof(std::max_align_t));
}
void* operator new(std::size_t bytes, std::align_val_t alignment)
{
  return Take(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* taken) noexcept
{
  std::free(taken);
}
void operator delete(void* taken, std::size_t) noexcept
{
  std::free(taken);
}
void operator delete(void* taken, std::align_val_t) noexcept
{
  std::free(taken);
}
void operator delete(void* taken, std::size_t, std::align_val_t) noexcept
{
  std::free(taken);
}
