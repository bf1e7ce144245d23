#include "Sandbox/LimitSelf.h"

#include <sys/resource.h>

namespace hasp
{

bool LimitSelf(std::uint64_t memoryBytes, std::uint64_t seconds)
{
  const auto limit = [](auto what, rlim_t most)
  {
    const rlimit both{ most, most };
    return setrlimit(what, &both) == 0;
  };
#if defined(__SANITIZE_ADDRESS__)
  memoryBytes = RLIM_INFINITY; // AddressSanitizer reserves terabytes of addresses for itself
#endif
  return limit(RLIMIT_AS, memoryBytes) && limit(RLIMIT_CPU, seconds) && limit(RLIMIT_CORE, 0);
}

} // namespace hasp
