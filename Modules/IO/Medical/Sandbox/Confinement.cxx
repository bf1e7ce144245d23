#include "Sandbox/Confinement.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <fstream>

// AddressSanitizer reserves terabytes of addresses for itself and starts helpers at its end.
#if defined(__SANITIZE_ADDRESS__)
#define HASP_SANITIZED 1
#else
#define HASP_SANITIZED 0
#endif

#if HASP_WITH_SECCOMP && !HASP_SANITIZED
#include <seccomp.h>
#endif

namespace hasp
{
namespace
{

bool Limit(int what, rlim_t most)
{
  const rlimit both{ most, most };
  return setrlimit(static_cast<__rlimit_resource>(what), &both) == 0;
}

/// Addresses in use, bytes; 0 if the system does not say.
std::uint64_t AddressesInUse()
{
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

bool LimitSelf(std::uint64_t memoryBytes, std::uint64_t processorSeconds)
{
  const std::uint64_t own = AddressesInUse();
  if (own == 0)
    return false;
  closefrom(STDERR_FILENO + 1);
  return (HASP_SANITIZED || Limit(RLIMIT_AS, own + memoryBytes)) &&
         Limit(RLIMIT_CPU, processorSeconds) && Limit(RLIMIT_CORE, 0) && Limit(RLIMIT_FSIZE, 0) &&
         Limit(RLIMIT_NOFILE, 16) && (HASP_SANITIZED || Limit(RLIMIT_NPROC, 0)) &&
         prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0;
}

#if HASP_WITH_SECCOMP && !HASP_SANITIZED
/// The calls that are left. False if the kernel takes no filter.
bool FilterCalls()
{
  scmp_filter_ctx filter = seccomp_init(SCMP_ACT_KILL_PROCESS);
  if (!filter)
    return false;
  bool good = true;
  const auto allow = [&](int call, auto... conditions)
  {
    good = good && seccomp_rule_add(
                     filter, SCMP_ACT_ALLOW, call, sizeof...(conditions), conditions...) == 0;
  };
  for (const int call : { SCMP_SYS(read), SCMP_SYS(readv), SCMP_SYS(pread64), SCMP_SYS(write),
         SCMP_SYS(writev), SCMP_SYS(close), SCMP_SYS(lseek), SCMP_SYS(_llseek), SCMP_SYS(stat),
         SCMP_SYS(stat64), SCMP_SYS(fstat), SCMP_SYS(fstat64), SCMP_SYS(fstatat64),
         SCMP_SYS(newfstatat), SCMP_SYS(statx), SCMP_SYS(access), SCMP_SYS(faccessat),
         SCMP_SYS(faccessat2), SCMP_SYS(fadvise64) })
    allow(call);
  for (const int call : { SCMP_SYS(brk), SCMP_SYS(munmap), SCMP_SYS(mremap), SCMP_SYS(madvise),
         SCMP_SYS(futex), SCMP_SYS(getrandom), SCMP_SYS(sysinfo), SCMP_SYS(clock_gettime),
         SCMP_SYS(gettimeofday), SCMP_SYS(time), SCMP_SYS(getpid), SCMP_SYS(gettid),
         SCMP_SYS(rt_sigaction), SCMP_SYS(rt_sigprocmask), SCMP_SYS(rt_sigreturn),
         SCMP_SYS(restart_syscall), SCMP_SYS(exit), SCMP_SYS(exit_group) })
    allow(call);
  // Reading only. openat2 hides its flags in memory, where no filter sees them: not allowed.
  constexpr scmp_datum_t writing =
    O_ACCMODE | O_CREAT | O_TRUNC | O_APPEND | (O_TMPFILE & ~O_DIRECTORY);
  allow(SCMP_SYS(open), SCMP_A1(SCMP_CMP_MASKED_EQ, writing, O_RDONLY));
  allow(SCMP_SYS(openat), SCMP_A2(SCMP_CMP_MASKED_EQ, writing, O_RDONLY));
  for (const int call : { SCMP_SYS(mmap), SCMP_SYS(mmap2), SCMP_SYS(mprotect) })
    allow(call, SCMP_A2(SCMP_CMP_MASKED_EQ, PROT_EXEC, 0)); // no new code
  // abort() signals its own process, and its core is to be told from a forbidden call.
  allow(SCMP_SYS(tgkill), SCMP_A0(SCMP_CMP_EQ, static_cast<scmp_datum_t>(getpid())));
  // A program asks so whether it writes to a terminal; it does not.
  good = good && seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOTTY), SCMP_SYS(ioctl), 0) == 0;
  good = good && seccomp_load(filter) == 0;
  seccomp_release(filter);
  return good;
}
#else
bool FilterCalls()
{
  return false;
}
#endif

} // namespace

Confinement EnterSandbox(std::uint64_t memoryBytes, std::uint64_t processorSeconds)
{
  if (!LimitSelf(memoryBytes, processorSeconds))
    return Confinement::None;
  return FilterCalls() ? Confinement::Filtered : Confinement::Limits;
}

} // namespace hasp
