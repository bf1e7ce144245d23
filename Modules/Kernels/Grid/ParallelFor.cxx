#include "Grid/ParallelFor.h"

#include <algorithm>
#include <stdexcept>

#if HASP_WITH_TBB
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace hasp
{

void ParallelFor(std::int64_t begin, std::int64_t end, std::int64_t grain,
  const std::function<void(std::int64_t, std::int64_t)>& body)
{
  if (grain < 1)
    throw std::invalid_argument("ParallelFor: grain must be >= 1");
  if (begin >= end)
    return;
  const std::int64_t pieces = (end - begin + grain - 1) / grain;
  const auto piece = [&](std::int64_t p)
  { body(begin + p * grain, std::min(end, begin + (p + 1) * grain)); };
#if HASP_WITH_TBB
  tbb::parallel_for(std::int64_t{ 0 }, pieces, piece);
#else
  for (std::int64_t p = 0; p < pieces; ++p)
    piece(p);
#endif
}

int ParallelThreads()
{
#if HASP_WITH_TBB
  return tbb::this_task_arena::max_concurrency();
#else
  return 1;
#endif
}

} // namespace hasp
