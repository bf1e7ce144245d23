#include "FragmentBaking.h"

#include "Grid/MinMaxBlocks.h"
#include "Grid/ParallelFor.h"
#include "Grid/ProgressPart.h"
#include "Grid/Stopwatch.h"
#include "Isosurface/ActiveCells.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

namespace hasp
{

namespace
{
/// A grid of more samples keeps all cores busy by itself; side by side, such grids would only take
/// more memory (25 bytes a sample).
constexpr double LargeSamples = 4e6;

/// Adds up what several works report, and asks for cancel on the thread that made it.
class WorkMeter
{
public:
  WorkMeter(const ProgressFunction& progress, const std::vector<FragmentTask>& tasks)
    : Progress(progress),
      Shares(tasks.size())
  {
    for (const FragmentTask& task : tasks)
      this->Weights.push_back(task.samples);
    this->Whole = std::accumulate(this->Weights.begin(), this->Weights.end(), 0.0);
  }

  ProgressFunction Of(std::size_t task)
  {
    return [this, task](double share)
    {
      this->Shares[task].store(share, std::memory_order_relaxed);
      return this->GoOn();
    };
  }

  bool GoOn()
  {
    if (this->Progress && std::this_thread::get_id() == this->Caller && !this->Stopped())
    {
      double done = 0.0;
      for (std::size_t n = 0; n < this->Shares.size(); ++n)
        done += this->Weights[n] * this->Shares[n].load(std::memory_order_relaxed);
      if (!this->Progress(std::min(1.0, done / this->Whole)))
        this->Stop();
    }
    return !this->Stopped();
  }
  void Stop() { this->Stopping.store(true, std::memory_order_relaxed); }
  bool Stopped() const { return this->Stopping.load(std::memory_order_relaxed); }

private:
  ProgressFunction Progress;
  std::thread::id Caller = std::this_thread::get_id();
  std::vector<double> Weights;
  double Whole = 0.0;
  std::vector<std::atomic<double>> Shares;
  std::atomic<bool> Stopping{ false };
};

/// What went wrong, by label.
using Faults = std::map<std::uint16_t, std::string>;

void ThrowFaults(const Faults& faults)
{
  if (faults.empty())
    return;
  std::ostringstream text;
  text << faults.begin()->second;
  if (faults.size() > 1)
  {
    text << "; nor could labels";
    for (auto fault = std::next(faults.begin()); fault != faults.end(); ++fault)
      text << " " << fault->first;
    text << " be made";
  }
  throw std::runtime_error(text.str());
}

} // namespace

std::shared_ptr<const ClusteredCells> ExtractBone(
  const FragmentScan& scan, const ProgressFunction& progress)
{
  ReportProgress(progress, 0.0);
  const MinMaxBlocks blocks(scan.grey);
  return std::make_shared<const ClusteredCells>(ExtractActiveCells(
    scan.grey, blocks, scan.isovalue, CellPrecision::Exact, PartOf(progress, 0.5, 1.0)));
}

FragmentBaking::FragmentBaking(std::unique_ptr<Internals> made) : Inside(std::move(made)) {}
FragmentBaking::~FragmentBaking() = default;

const std::vector<std::uint16_t>& FragmentBaking::Outdated() const
{
  return this->Inside->outdated;
}

std::size_t FragmentBaking::Samples() const
{
  return this->Inside->samples;
}

void FragmentBaking::Run(const ProgressFunction& progress)
{
  Internals& in = *this->Inside;
  std::vector<FragmentTask> tasks = std::exchange(in.tasks, {});
  double from = 0.0; // of the progress
  if (std::exchange(in.cells, false))
  {
    from = tasks.empty() ? 1.0 : 0.1;
    const Stopwatch time;
    const auto cells = ExtractBone(in.scan, PartOf(progress, 0.0, from));
    in.table->PutCells(cells, time.Milliseconds());
  }
  // Large before small: the last ones are short, and nobody waits long for the others' end.
  std::stable_sort(tasks.begin(), tasks.end(),
    [](const FragmentTask& a, const FragmentTask& b) { return a.samples > b.samples; });
  WorkMeter meter(tasks.empty() ? ProgressFunction{} : PartOf(progress, from, 1.0), tasks);
  Faults faults;
  std::mutex guard; // of faults and of what is said in `in`
  const auto bake = [&](std::size_t n)
  {
    const FragmentCrop crop = std::exchange(tasks[n].crop, {}); // its memory goes with the work
    try
    {
      BakedFragment baked = BakeFragment(in.scan.grey, in.scan.isovalue, crop, in.settings,
        tasks[n].wants, tasks[n].origin, meter.Of(n));
      const std::size_t samples = baked.samples;
      const bool taken = in.table->Put(crop.label, tasks[n].version, std::move(baked));
      const std::lock_guard lock(guard);
      in.samples += samples;
      if (!taken)
        in.outdated.push_back(crop.label);
    }
    catch (const Cancelled&)
    {
      meter.Stop();
    }
    catch (const std::runtime_error& error)
    {
      const std::lock_guard lock(guard);
      faults.emplace(crop.label, error.what());
    }
    catch (const std::invalid_argument& error)
    {
      const std::lock_guard lock(guard);
      faults.emplace(crop.label, error.what());
    }
    catch (...)
    {
      meter.Stop(); // no memory: nor is there for the others
      throw;
    }
  };
  std::size_t large = 0;
  for (; large < tasks.size() && tasks[large].samples > LargeSamples && meter.GoOn(); ++large)
    bake(large);
  // As many lanes as threads, each with one fragment at a time: a bound of the memory.
  std::atomic<std::size_t> next{ large };
  ParallelFor(0, std::min<std::int64_t>(ParallelThreads(), std::int64_t(tasks.size() - large)), 1,
    [&](std::int64_t, std::int64_t)
    {
      for (std::size_t n; meter.GoOn() && (n = next.fetch_add(1)) < tasks.size();)
        bake(n);
    });
  std::sort(in.outdated.begin(), in.outdated.end());
  if (meter.Stopped())
    throw Cancelled();
  ReportProgress(progress, 1.0);
  ThrowFaults(faults);
}

} // namespace hasp
