#pragma once
#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

namespace hasp
{

/// Hands the newest value from one thread to another; neither ever waits for the other.
///
/// Three slots: the writer fills one, the reader looks at one, the third lies between them. Write
/// and Update swap their slot for that third one, each by one atomic exchange. What is written
/// twice before the reader looks is seen once: the newest wins, older values are lost. For every
/// value, in order, this is the wrong thing.
///
/// T is trivially copyable and default constructible. No memory is taken after construction.
///
/// Threads: Write on one thread, Update and Latest on one other (the same for both); which of
/// RENDER, HAPTIC and WORKER is which is the owner's choice. Construct before either starts and
/// destroy after both have ended. Wait-free: no lock, no retry, so HAPTIC may do either.
/// Cost: a copy of T to write, nothing to read, and an exchange each; bin/BenchKernelTripleBuffer
/// prints nanoseconds beside a mutex's.
template <class T>
class TripleBuffer
{
  static_assert(std::is_trivially_copyable_v<T>, "a slot is copied while nobody looks at it");

public:
  TripleBuffer() = default;
  TripleBuffer(const TripleBuffer&) = delete;
  TripleBuffer& operator=(const TripleBuffer&) = delete;

  /// The writer's thread.
  void Write(const T& value) noexcept
  {
    this->Slots[this->Written].value = value;
    // Release: who takes this slot sees the value. Acquire: the reader is done with the slot got.
    this->Written = this->Between.exchange(this->Written | Fresh, std::memory_order_acq_rel) & Slot;
  }

  /// The reader's thread. True if something was written since the last call; Latest is that now.
  bool Update() noexcept
  {
    if (!(this->Between.load(std::memory_order_relaxed) & Fresh))
      return false;
    this->Read = this->Between.exchange(this->Read, std::memory_order_acq_rel) & Slot;
    this->Any = true;
    return true;
  }

  /// The reader's thread. What the last Update that was true has found; nullptr before. Stays as it
  /// is until the next Update.
  const T* Latest() const noexcept { return this->Any ? &this->Slots[this->Read].value : nullptr; }

private:
  static constexpr std::uint8_t Slot = 3, Fresh = 4;
  struct alignas(64) Padded // a cache line of its own each
  {
    T value{};
  };

  std::array<Padded, 3> Slots;
  alignas(64) std::atomic<std::uint8_t> Between{ 0 };
  alignas(64) std::uint8_t Written = 1; ///< the writer's alone
  alignas(64) std::uint8_t Read = 2;    ///< the reader's alone, as Any
  bool Any = false;

  static_assert(std::atomic<std::uint8_t>::is_always_lock_free);
};

} // namespace hasp
