#include "Realtime/EditThread.h"

#include "Realtime/SignalsBlocked.h"

#include <algorithm>
#include <utility>

namespace hasp
{

EditThread::EditThread(std::function<void(Ticket)> undo) : Undo(std::move(undo)) {}

EditThread::~EditThread()
{
  if (!this->Thread.joinable())
    return;
  {
    const std::lock_guard lock(this->Guard);
    this->Ending = true;
    this->GiveUp.store(true, std::memory_order_relaxed);
    this->Waiting.clear();
  }
  this->Changed.notify_all();
  this->Thread.join();
}

void EditThread::Add(Ticket ticket, Edit edit)
{
  if (!this->Thread.joinable())
  {
    const SignalsBlocked inherited;
    this->Thread = std::thread([this] { this->Run(); });
  }
  const std::lock_guard lock(this->Guard);
  this->Waiting.push_back({ ticket, std::move(edit) });
  this->Changed.notify_all();
}

void EditThread::TakeBack(Ticket ticket)
{
  const std::lock_guard lock(this->Guard);
  if (ticket == this->Made)
  {
    this->GiveUp.store(true, std::memory_order_relaxed);
    return;
  }
  const auto is = [ticket](const Work& work) { return work.ticket == ticket; };
  if (std::erase_if(this->Waiting, is) > 0 || !this->Thread.joinable())
    return;
  this->Waiting.push_back({ ticket, {} });
  this->Changed.notify_all();
}

bool EditThread::Idle() const
{
  const std::lock_guard lock(this->Guard);
  return !this->Busy && this->Waiting.empty();
}

void EditThread::Wait() const
{
  std::unique_lock lock(this->Guard);
  this->Changed.wait(lock, [this] { return !this->Busy && this->Waiting.empty(); });
}

void EditThread::Run()
{
  std::unique_lock lock(this->Guard);
  for (;;)
  {
    this->Changed.wait(lock, [this] { return this->Ending || !this->Waiting.empty(); });
    if (this->Ending)
      return;
    const Work work = std::move(this->Waiting.front());
    this->Waiting.pop_front();
    this->Busy = true;
    this->Do(work, lock);
    this->Busy = false;
    this->Changed.notify_all();
  }
}

void EditThread::Do(const Work& work, std::unique_lock<std::mutex>& lock)
{
  this->Made = work.edit ? work.ticket : 0;
  this->GiveUp.store(false, std::memory_order_relaxed);
  this->Done.store(0.0, std::memory_order_relaxed);
  lock.unlock();
  bool takeBack = !work.edit;
  if (work.edit)
  {
    const bool made = work.edit(
      [this](double share)
      {
        this->Done.store(share, std::memory_order_relaxed);
        return !this->GiveUp.load(std::memory_order_relaxed);
      });
    lock.lock();
    this->Made = 0; // who takes it back from now on waits in line
    takeBack = made && this->GiveUp.load(std::memory_order_relaxed) && !this->Ending;
    lock.unlock();
  }
  if (takeBack)
    this->Undo(work.ticket);
  lock.lock();
}

} // namespace hasp
