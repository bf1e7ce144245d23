#pragma once
#include "Grid/Progress.h"

#include <QString>

#include <atomic>
#include <functional>
#include <memory>

namespace hasp
{

class JobQueue;

/// What a layer of a scene has on the WORKER: one job at a time, which is dropped when it is no
/// longer what is wanted. What it gives back comes on RENDER, and never after this is gone.
///
/// Threads: RENDER; the work on the WORKER.
class SceneJob
{
public:
  /// Called on RENDER.
  using Take = std::function<void()>;
  using Work = std::function<Take(const ProgressFunction&)>;

  explicit SceneJob(JobQueue& jobs) : Jobs(jobs) {}
  ~SceneJob() { this->Drop(); }
  SceneJob(const SceneJob&) = delete;
  SceneJob& operator=(const SceneJob&) = delete;

  /// It waits, is at work, or its result is on the way. False after a cancellation, and within
  /// Take.
  bool IsUnderWay() const { return !this->Running.expired(); }
  /// Instead of the one that is under way. `what` is shown. What the work throws, but for
  /// Cancelled, is the queue's to tell: work that fails in part says so by its Take.
  void Begin(const QString& what, Work work);
  /// Its result is not wanted any more, and it ends soon.
  void Drop();

private:
  struct Ticket
  {
    std::atomic<bool> dropped{ false };
  };
  JobQueue& Jobs;
  std::weak_ptr<Ticket> Running; ///< held by the job alone
};

} // namespace hasp
