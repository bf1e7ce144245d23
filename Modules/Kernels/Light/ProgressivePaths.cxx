#include "Light/ProgressivePaths.h"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

namespace hasp
{

struct ProgressivePaths::Shared
{
  ProgressiveWork work;
  std::atomic<bool> cancel = false;
  std::thread thread;

  mutable std::mutex mutex; ///< of what follows
  std::condition_variable changed;
  bool running = false;
  PathTracedPicture picture;
  mutable std::exception_ptr fault;

  void Run()
  {
    PathTracedPicture own;
    try
    {
      while (own.samples < this->work.samples && AddPathSample(*this->work.scene, this->work.view,
                                                   this->work.settings, own, &this->cancel))
      {
        const std::lock_guard lock(this->mutex);
        this->picture = own;
        this->changed.notify_all();
      }
    }
    catch (...)
    {
      const std::lock_guard lock(this->mutex);
      this->fault = std::current_exception();
    }
    const std::lock_guard lock(this->mutex);
    this->running = false;
    this->changed.notify_all();
  }
};

ProgressivePaths::ProgressivePaths() = default;

ProgressivePaths::~ProgressivePaths()
{
  this->Cancel();
}

void ProgressivePaths::Start(ProgressiveWork work)
{
  this->Release();
  if (!work.scene)
    throw std::invalid_argument("ProgressivePaths: there is no scene");
  if (work.samples < 1)
    throw std::invalid_argument(
      "ProgressivePaths: " + std::to_string(work.samples) + " samples; at least 1 is needed");
  work.settings.paths.Validate();
  this->Self = std::make_unique<Shared>();
  this->Self->work = std::move(work);
  this->Self->running = true;
  this->Self->thread = std::thread([self = this->Self.get()] { self->Run(); });
}

void ProgressivePaths::Cancel()
{
  if (!this->Self || !this->Self->thread.joinable())
    return;
  this->Self->cancel = true;
  this->Self->thread.join();
}

void ProgressivePaths::Release()
{
  this->Cancel();
  this->Self.reset();
}

void ProgressivePaths::WaitFor(int samples)
{
  if (!this->Self)
    return;
  std::unique_lock lock(this->Self->mutex);
  this->Self->changed.wait(
    lock, [&] { return !this->Self->running || this->Self->picture.samples >= samples; });
}

bool ProgressivePaths::Running() const
{
  if (!this->Self)
    return false;
  const std::lock_guard lock(this->Self->mutex);
  return this->Self->running;
}

int ProgressivePaths::Samples() const
{
  if (!this->Self)
    return 0;
  const std::lock_guard lock(this->Self->mutex);
  return this->Self->picture.samples;
}

bool ProgressivePaths::Latest(PathTracedPicture& picture) const
{
  if (!this->Self)
    return false;
  const std::lock_guard lock(this->Self->mutex);
  if (this->Self->fault)
    std::rethrow_exception(std::exchange(this->Self->fault, nullptr));
  if (this->Self->picture.samples == 0 ||
      (this->Self->picture.samples == picture.samples && this->Self->picture.size == picture.size))
    return false;
  picture = this->Self->picture;
  return true;
}

std::size_t ProgressivePaths::Bytes() const
{
  if (!this->Self)
    return 0;
  const std::lock_guard lock(this->Self->mutex);
  return this->Self->picture.Bytes() * (this->Self->running ? 2 : 1);
}

} // namespace hasp
