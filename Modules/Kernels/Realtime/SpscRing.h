#pragma once
#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace hasp
{

/// Every value, in order, from one thread to another; neither ever waits. Where TripleBuffer drops
/// the old, a full ring refuses the new, and the writer counts what it lost.
///
/// T is trivially copyable and default constructible. Memory is taken at construction alone.
/// Threads: Push on one, Pop on one other; wait-free, so HAPTIC may be either. Construct before
/// either starts and destroy after both have ended. Cost: a copy of T and one atomic store each.
template <class T>
class SpscRing
{
  static_assert(std::is_trivially_copyable_v<T>, "a slot is copied while nobody looks at it");

public:
  /// Room for at least so many: the next power of two, 2 to 2^24.
  explicit SpscRing(std::size_t capacity)
    : Slots(std::bit_ceil(std::clamp<std::size_t>(capacity, 2, std::size_t(1) << 24))),
      Mask(Slots.size() - 1)
  {
  }
  SpscRing(const SpscRing&) = delete;
  SpscRing& operator=(const SpscRing&) = delete;

  std::size_t Capacity() const noexcept { return this->Slots.size(); }

  /// The writer's thread. False if it is full: the value is not in it.
  bool Push(const T& value) noexcept
  {
    const std::size_t at = this->Written.load(std::memory_order_relaxed);
    if (at - this->ReadSeen == this->Slots.size()) // look again only where it seems full
      this->ReadSeen = this->Read.load(std::memory_order_acquire);
    if (at - this->ReadSeen == this->Slots.size())
      return false;
    this->Slots[at & this->Mask] = value;
    this->Written.store(at + 1, std::memory_order_release);
    return true;
  }

  /// The reader's thread. False if it is empty: `value` stays as it is.
  bool Pop(T& value) noexcept
  {
    const std::size_t at = this->Read.load(std::memory_order_relaxed);
    if (at == this->WrittenSeen)
      this->WrittenSeen = this->Written.load(std::memory_order_acquire);
    if (at == this->WrittenSeen)
      return false;
    value = this->Slots[at & this->Mask];
    this->Read.store(at + 1, std::memory_order_release);
    return true;
  }

private:
  std::vector<T> Slots;
  std::size_t Mask;
  alignas(64) std::atomic<std::size_t> Written{ 0 };
  std::size_t ReadSeen = 0; ///< the writer's alone
  alignas(64) std::atomic<std::size_t> Read{ 0 };
  std::size_t WrittenSeen = 0; ///< the reader's alone
};

} // namespace hasp
