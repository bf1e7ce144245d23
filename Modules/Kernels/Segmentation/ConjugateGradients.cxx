#include "Segmentation/ConjugateGradients.h"

namespace hasp::walk
{

CycleSums SumCycle(const NodeValues& z, const NodeValues& r, const NodeValues& product)
{
  const std::int64_t nodes = z.Nodes();
  const bool first = product.Nodes() == 0;
  std::vector<CycleSums> chunks(static_cast<std::size_t>(nodes / ValuesAChunk) + 1);
  ParallelFor(0, nodes, ValuesAChunk,
    [&](std::int64_t begin, std::int64_t end)
    {
      CycleSums& sums = chunks[static_cast<std::size_t>(begin / ValuesAChunk)];
      Lanes largest{};
      for (std::int64_t n = begin; n < end; ++n)
      {
        const Lanes at = z.data()[n];
        sums.gain += Widen(at) * Widen(r.data()[n]);
        if (!first)
          sums.overlap += Widen(at) * Widen(product.data()[n]);
        largest = Max(largest, Abs(at));
      }
      for (int lane = 0; lane < LaneCount; ++lane)
        sums.largest = std::max(sums.largest, largest[lane]);
    });
  CycleSums all;
  for (const CycleSums& sums : chunks)
  {
    all.gain += sums.gain;
    all.overlap += sums.overlap;
    all.largest = std::max(all.largest, sums.largest);
  }
  return all;
}

void AddScaled(NodeValues& x, Lanes factor, const NodeValues& y)
{
  ParallelFor(0, x.Nodes(), ValuesAChunk,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t n = begin; n < end; ++n)
        x.data()[n] += factor * y.data()[n];
    });
}

void ScaleAndAdd(NodeValues& x, Lanes factor, const NodeValues& y)
{
  ParallelFor(0, x.Nodes(), ValuesAChunk,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t n = begin; n < end; ++n)
        x.data()[n] = factor * x.data()[n] + y.data()[n];
    });
}

} // namespace hasp::walk
