#include "Grid/Testing/CountNew.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>

namespace
{

thread_local std::size_t Count = 0, Bytes = 0;
std::atomic<std::size_t> CountOfAll{ 0 };
thread_local bool IsSpared = false; ///< of NewRefused
std::atomic<bool> Refusing{ false };
std::atomic<std::int64_t> Left{ 0 };

constexpr std::align_val_t Usual{ alignof(std::max_align_t) };

void* Take(std::size_t bytes, std::align_val_t alignment) noexcept
{
  if (Refusing.load() && !IsSpared && Left.fetch_sub(1) <= 0)
    return nullptr;
  ++Count;
  Bytes += bytes;
  CountOfAll.fetch_add(1, std::memory_order_relaxed);
  void* taken = nullptr;
  const std::size_t least = std::max(static_cast<std::size_t>(alignment), sizeof(void*));
  return posix_memalign(&taken, least, bytes ? bytes : 1) == 0 ? taken : nullptr;
}

void* TakeOrThrow(std::size_t bytes, std::align_val_t alignment)
{
  if (void* const taken = Take(bytes, alignment))
    return taken;
  throw std::bad_alloc();
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

std::size_t hasp::test::NewCountOfAllThreads() noexcept
{
  return CountOfAll.load(std::memory_order_relaxed);
}

hasp::test::NewRefused::NewRefused(std::size_t left) noexcept
{
  IsSpared = true;
  Left.store(static_cast<std::int64_t>(left));
  Refusing.store(true);
}

hasp::test::NewRefused::~NewRefused()
{
  Refusing.store(false);
  IsSpared = false;
}

// Every form: one that is left out is a sanitizer's own, whose memory may not be freed here.
void* operator new(std::size_t bytes)
{
  return TakeOrThrow(bytes, Usual);
}
void* operator new[](std::size_t bytes)
{
  return TakeOrThrow(bytes, Usual);
}
void* operator new(std::size_t bytes, std::align_val_t alignment)
{
  return TakeOrThrow(bytes, alignment);
}
void* operator new[](std::size_t bytes, std::align_val_t alignment)
{
  return TakeOrThrow(bytes, alignment);
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept
{
  return Take(bytes, Usual);
}
void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept
{
  return Take(bytes, Usual);
}
void* operator new(std::size_t bytes, std::align_val_t alignment, const std::nothrow_t&) noexcept
{
  return Take(bytes, alignment);
}
void* operator new[](std::size_t bytes, std::align_val_t alignment, const std::nothrow_t&) noexcept
{
  return Take(bytes, alignment);
}

void operator delete(void* taken) noexcept
{
  std::free(taken);
}
void operator delete[](void* taken) noexcept
{
  std::free(taken);
}
void operator delete(void* taken, std::size_t) noexcept
{
  std::free(taken);
}
void operator delete[](void* taken, std::size_t) noexcept
{
  std::free(taken);
}
void operator delete(void* taken, std::align_val_t) noexcept
{
  std::free(taken);
}
void operator delete[](void* taken, std::align_val_t) noexcept
{
  std::free(taken);
}
void operator delete(void* taken, std::size_t, std::align_val_t) noexcept
{
  std::free(taken);
}
void operator delete[](void* taken, std::size_t, std::align_val_t) noexcept
{
  std::free(taken);
}
void operator delete(void* taken, const std::nothrow_t&) noexcept
{
  std::free(taken);
}
void operator delete[](void* taken, const std::nothrow_t&) noexcept
{
  std::free(taken);
}
void operator delete(void* taken, std::align_val_t, const std::nothrow_t&) noexcept
{
  std::free(taken);
}
void operator delete[](void* taken, std::align_val_t, const std::nothrow_t&) noexcept
{
  std::free(taken);
}
