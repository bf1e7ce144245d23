// The planner, where nothing may open a socket but those of this machine alone (AF_UNIX: the
// display's): whatever opens another, in it or in a process that it starts, ends it by SIGSYS at
// once. Takes the planner's words. For tests of whole sessions.
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstddef>
#include <cstdio>
#include <iterator>

namespace
{

#if defined(__x86_64__)
constexpr unsigned int Machine = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr unsigned int Machine = AUDIT_ARCH_AARCH64;
#endif
constexpr unsigned int OtherCalls = 0x40000000; ///< those of x32

bool ForbidSockets()
{
  sock_filter program[] = {
    BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch)),
    BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, Machine, 1, 0),
    BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS),
    BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
    BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, OtherCalls, 4, 0),
    BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_io_uring_setup, 3, 0), // it opens sockets, too
    BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_socket, 0, 3),
    BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, args)), // little-endian: the low half
    BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, AF_UNIX, 1, 0),
    BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS),
    BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const sock_fprog filter{ static_cast<unsigned short>(std::size(program)), program };
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
}

} // namespace

int main(int, char* argv[])
{
  if (!ForbidSockets())
  {
    std::perror("OfflinePlanner: sockets cannot be forbidden here");
    return 125;
  }
  execv(HASP_PLANNER, argv);
  std::perror("OfflinePlanner");
  return 126;
}
