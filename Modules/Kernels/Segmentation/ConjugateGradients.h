#pragma once
#include "Grid/ParallelFor.h"
#include "Grid/Progress.h"
#include "Segmentation/Lanes.h"

#include <algorithm>
#include <cmath>
#include <vector>

/// Internal. WORKER threads.
namespace hasp::walk
{

constexpr std::int64_t ValuesAChunk = 1 << 15;

/// The sum of sum(first, last) over chunks, added in their order: the same bits everywhere.
template <typename Sum>
WideLanes SumOverChunks(std::int64_t count, std::int64_t chunk, Sum sum)
{
  std::vector<WideLanes> sums(static_cast<std::size_t>((count + chunk - 1) / chunk));
  ParallelFor(0, count, chunk,
    [&](std::int64_t first, std::int64_t last) { sums[first / chunk] = sum(first, last); });
  WideLanes all{};
  for (const WideLanes& part : sums)
    all += part;
  return all;
}

/// What one pass over a cycle's answer z says: z . r, z . product (0 if that is empty), and the
/// largest |z|.
struct CycleSums
{
  WideLanes gain, overlap;
  float largest = 0.0F;
};
CycleSums SumCycle(const NodeValues& z, const NodeValues& r, const NodeValues& product);

/// The step to the least of each lane's parabola.
inline Lanes StepAlong(const WideLanes& gain, const WideLanes& curvature)
{
  Lanes step{};
  for (int lane = 0; lane < LaneCount; ++lane)
    if (curvature[lane] > 0.0)
      step[lane] = static_cast<float>(gain[lane] / curvature[lane]);
  return step;
}

/// x += factor * y
void AddScaled(NodeValues& x, Lanes factor, const NodeValues& y);
/// x = factor * x + y
void ScaleAndAdd(NodeValues& x, Lanes factor, const NodeValues& y);

struct SolverRun
{
  int cycles = 0;     ///< calls of Precondition: iterations, and the step that ends them
  float error = 0.0F; ///< estimate of the largest error left in x
  bool converged = false;
  bool left = false; ///< by leave
};

/// Never leaves.
struct StayToTheEnd
{
  bool operator()(const NodeValues&) const { return false; }
};

/// A cycle sees at least about this share of an error: the estimate is its answer over that.
constexpr float SeenShare = 0.25F;

/// Flexible preconditioned conjugate gradients (Notay 2000), each lane with steps of its own.
///
/// system  Multiply(x, product) -> x . product, and Precondition(r, z).
/// x       moves towards the solution.  r  its residual, kept up to date but for the last step.
/// p       a first direction, or empty: then the first cycle gives it.
/// leave   asked about each cycle's answer z: true ends the solve with the step that z leads to.
/// Ends when no lane's error is estimated above tolerance, or after `most` cycles. Throws Cancelled
/// between cycles; x is then as far as it came.
template <typename System, typename Leave = StayToTheEnd>
SolverRun ConjugateGradients(System& system, NodeValues& x, NodeValues& r, NodeValues p,
  double tolerance, int most, const ProgressFunction& progress = {}, Leave leave = {})
{
  const std::int64_t nodes = x.Nodes();
  NodeValues product(p.Nodes()); // none before it is needed
  WideLanes curvature{};
  if (p.Nodes() > 0)
  {
    curvature = system.Multiply(p, product);
    const WideLanes gain = SumCycle(p, r, NodeValues()).gain;
    const Lanes step = StepAlong(gain, curvature);
    AddScaled(x, step, p);
    AddScaled(r, -step, product);
  }
  NodeValues z(nodes);
  SolverRun run;
  float first = 0.0F;
  for (;;)
  {
    system.Precondition(r, z);
    ++run.cycles;
    const CycleSums sums = SumCycle(z, r, product);
    run.error = sums.largest / SeenShare;
    first = run.cycles == 1 ? run.error : first;
    run.converged = run.error <= tolerance;
    run.left = !run.converged && run.cycles < most && leave(z);
    if (run.converged || run.cycles == most)
    {
      AddScaled(x, Fill(1.0F), z); // never overshoots, and is there already
      return run;
    }
    if (p.Nodes() == 0)
    {
      p = NodeValues(nodes);
      product = NodeValues(nodes);
    }
    Lanes beta{};
    for (int lane = 0; lane < LaneCount; ++lane)
      if (curvature[lane] > 0.0)
        beta[lane] = static_cast<float>(-sums.overlap[lane] / curvature[lane]);
    ScaleAndAdd(p, beta, z);
    curvature = system.Multiply(p, product);
    const Lanes alpha = StepAlong(sums.gain, curvature);
    AddScaled(x, alpha, p);
    if (run.left)
      return run;
    AddScaled(r, -alpha, product);
    const double way = std::log(first / tolerance);
    ReportProgress(
      progress, way > 0.0 ? std::clamp(std::log(first / run.error) / way, 0.0, 1.0) : 0.0);
  }
}

} // namespace hasp::walk
