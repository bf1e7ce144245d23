#include "Grid/SideBySide.h"

#include <exception>

#if HASP_WITH_TBB
#include <tbb/task_group.h>
#endif

namespace hasp
{

namespace
{
std::exception_ptr Try(const std::function<void()>& work)
{
  try
  {
    work();
    return nullptr;
  }
  catch (...)
  {
    return std::current_exception();
  }
}
} // namespace

void SideBySide(const std::function<void()>& beside, const std::function<void()>& here)
{
  std::exception_ptr thrownBeside;
#if HASP_WITH_TBB
  tbb::task_group group;
  group.run([&] { thrownBeside = Try(beside); });
  const std::exception_ptr thrownHere = Try(here);
  group.wait();
#else
  thrownBeside = Try(beside);
  const std::exception_ptr thrownHere = Try(here);
#endif
  for (const std::exception_ptr& thrown : { thrownHere, thrownBeside })
    if (thrown)
      std::rethrow_exception(thrown);
}

} // namespace hasp
