#include "Grid/ThreadLimit.h"

#include <stdexcept>
#include <string>

#if HASP_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

namespace hasp
{

void WithThreadLimit(int threads, const std::function<void()>& work)
{
  if (threads < 0 || threads > 1024)
    throw std::invalid_argument(
      "WithThreadLimit: threads is " + std::to_string(threads) + ", must be in [0, 1024]");
  if (threads == 0)
    return work();
#if HASP_WITH_TBB
  const tbb::global_control most(
    tbb::global_control::max_allowed_parallelism, std::size_t(threads));
  tbb::task_arena arena(threads);
  arena.execute(work);
#else
  work();
#endif
}

} // namespace hasp
