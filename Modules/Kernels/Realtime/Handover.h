#pragma once
#include <atomic>
#include <memory>

namespace hasp
{

/// Hands objects that own memory to a thread that may not free any, and takes them back from it.
///
/// RENDER offers; HAPTIC takes what was offered last, and gives back what it is done with: the one
/// it had before, or the same one, filled. RENDER collects that and frees it, or uses it again.
/// What is offered twice before HAPTIC looks is seen once: the newest wins, the older one comes
/// back from Offer. No more than one is on its way back: until RENDER has collected it nothing new
/// is taken. So call Collect after each Offer, or once a frame.
///
/// Threads: Offer and Collect on one (RENDER), Take and GiveBack on one other (HAPTIC). Construct
/// before either starts and destroy after both have ended: what is on its way is freed then.
/// Wait-free: one atomic exchange each, no retry. Take and GiveBack take and free no memory.
template <class T>
class Handover
{
public:
  Handover() = default;
  ~Handover()
  {
    delete this->Offered.load(std::memory_order_acquire);
    delete this->Returned.load(std::memory_order_acquire);
  }
  Handover(const Handover&) = delete;
  Handover& operator=(const Handover&) = delete;

  /// RENDER. Gives back the offer before, if nobody has taken it. Null takes that one back.
  std::unique_ptr<T> Offer(std::unique_ptr<T> next) noexcept
  {
    return std::unique_ptr<T>(this->Offered.exchange(next.release(), std::memory_order_acq_rel));
  }
  /// RENDER. What came back, or null.
  std::unique_ptr<T> Collect() noexcept
  {
    return std::unique_ptr<T>(this->Returned.exchange(nullptr, std::memory_order_acq_rel));
  }

  /// HAPTIC. The newest offer; null if there is none, or if what went back before still lies there.
  /// Each that is not null is followed by one GiveBack.
  std::unique_ptr<T> Take() noexcept
  {
    // A glance first: nearly all ticks find nothing, and an exchange costs more.
    if (this->Offered.load(std::memory_order_relaxed) == nullptr ||
        this->Returned.load(std::memory_order_relaxed) != nullptr)
      return {};
    return std::unique_ptr<T>(this->Offered.exchange(nullptr, std::memory_order_acq_rel));
  }
  /// HAPTIC. What is null goes nowhere. Returned is empty: Take has seen to it, and only GiveBack
  /// fills it.
  void GiveBack(std::unique_ptr<T> done) noexcept
  {
    if (done)
      this->Returned.store(done.release(), std::memory_order_release);
  }

private:
  alignas(64) std::atomic<T*> Offered{ nullptr };
  alignas(64) std::atomic<T*> Returned{ nullptr };

  static_assert(std::atomic<T*>::is_always_lock_free);
};

} // namespace hasp
