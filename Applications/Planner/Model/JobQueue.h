#pragma once
#include "Grid/Progress.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace hasp
{

/// Long work, one job after the other on a WORKER thread, while the window stays live.
///
/// A job reads what it was given (immutable, or its own), reports its share, and returns what is to
/// be done with its result; that is then called on RENDER, and never for a job that was cancelled.
/// What a job throws is told by Failed, Cancelled by GaveUp; either way nothing has changed.
///
/// Threads: RENDER; Work runs on the WORKER, the Finish that it returns on RENDER. Cost: nothing
/// before the first job; then a thread, asleep while there is nothing to do.
class JobQueue : public QObject
{
  Q_OBJECT
public:
  using Finish = std::function<void()>;
  using Work = std::function<Finish(const ProgressFunction&)>;

  explicit JobQueue(QObject* parent = nullptr);
  ~JobQueue() override; ///< gives up what runs and waits for its end

  /// Behind all others. `what` is shown: "Making guide 8".
  void Add(const QString& what, Work work);
  /// The job that runs, and all that wait.
  void CancelAll();

  bool IsIdle() const;
  QString What() const; ///< of the job that runs; empty: none
  /// The job whose Finish or Failed is being called; empty: none.
  const QString& Delivering() const { return this->Delivered; }
  double Share() const; ///< of it, [0, 1]

Q_SIGNALS:
  void Began(const QString& what);
  void Progressed(double share);   ///< 10 times a second at most
  void Ended(const QString& what); ///< however it ended, after Finish, Failed or GaveUp
  void Failed(const QString& what, const QString& text);
  void GaveUp(const QString& what);

private:
  struct Job
  {
    QString what;
    Work work;
  };
  struct Result
  {
    Finish finish;
    std::optional<QString> error; ///< none and no finish: cancelled
  };
  void Run();
  Result DoJob(const Job& job);
  void Deliver(const QString& what, const Result& result, unsigned long long round);
  void Tell(const QString& what, const Result& result, unsigned long long round);
  void DoFinish(const QString& what, const Finish& finish);
  void Conclude(const QString& what);

  mutable std::mutex Guard; // of Waiting, Running, Ending
  std::condition_variable Changed;
  std::deque<Job> Waiting;
  QString Running;
  bool Busy = false; ///< from Began until its result is delivered
  bool Ending = false;
  QString Delivered; ///< RENDER's
  std::atomic<bool> GiveUp{ false };
  std::atomic<unsigned long long> Round{ 0 }; ///< of cancellations: older results are dropped
  std::atomic<double> Done{ 0.0 };
  std::thread Thread;
};

} // namespace hasp
