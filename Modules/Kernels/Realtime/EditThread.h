#pragma once
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace hasp
{

/// Edits that take long, one after the other on a thread of their own, each of which can be taken
/// back whatever has become of it: while it waits, while it is made, when it is made. Who asks
/// never waits, and what he asks for is the same however fast the thread is.
///
/// Threads: one owns it, say RENDER. Edits and take-backs run on a WORKER, which is the thread made
/// here: with all signals blocked, asleep while there is nothing to do.
/// Cost: nothing before the first Add; then a thread and its stack until this is deleted.
class EditThread
{
public:
  /// Told the share done now and then, in [0, 1]; false: give up.
  using Progress = std::function<bool(double)>;
  /// Makes an edit. False: all is as it was. Throws nothing, else the program ends.
  using Edit = std::function<bool(const Progress&)>;
  using Ticket = std::uint64_t; ///< who adds an edit numbers it; never 0

  /// `undo` makes undone what the edit of this ticket has done. It may be called for one that has
  /// failed, too, and then does nothing. Throws nothing.
  explicit EditThread(std::function<void(Ticket)> undo);
  /// Gives up what is made, drops what waits and takes nothing back. Waits for the end of it.
  ~EditThread();
  EditThread(const EditThread&) = delete;
  EditThread& operator=(const EditThread&) = delete;

  /// Behind all others; each with a ticket of its own. Throws std::system_error if there is no
  /// thread to be had; nothing is added then.
  void Add(Ticket ticket, Edit edit);
  /// Drops it, gives it up or takes it back. An edit that is given up and ends all the same is
  /// taken back before anything else is done. Once for each ticket.
  void TakeBack(Ticket ticket);

  /// Is there nothing to do?
  bool Idle() const;
  /// Of the edit that is made now.
  double Share() const noexcept { return this->Done.load(std::memory_order_relaxed); }
  /// Until there is nothing to do. What edits and take-backs wrote may then be read.
  void Wait() const;

private:
  struct Work
  {
    Ticket ticket = 0;
    Edit edit; ///< empty: is to be taken back
  };
  void Run();
  void Do(const Work& work, std::unique_lock<std::mutex>& lock);

  std::function<void(Ticket)> Undo;
  mutable std::mutex Guard; // of all that follows but for what is atomic
  mutable std::condition_variable Changed;
  std::deque<Work> Waiting;
  Ticket Made = 0; ///< the edit that is made now; 0: none
  bool Busy = false;
  bool Ending = false;
  std::atomic<bool> GiveUp{ false }; ///< what is made
  std::atomic<double> Done{ 0.0 };
  std::thread Thread;
};

} // namespace hasp
