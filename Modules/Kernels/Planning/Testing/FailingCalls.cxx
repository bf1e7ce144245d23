#include "FailingCalls.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <cstdio>

namespace
{
bool armed = false;
int failAt = 0, calls = 0;
failing::Way way = failing::Way::Error;
std::string names;

/// Whether this call is the one to fail.
bool Fails(const char* name)
{
  if (!armed)
    return false;
  names.append(name).append(" ");
  ++calls;
  if (way == failing::Way::Gone ? failAt == 0 || calls < failAt : calls != failAt)
    return false;
  if (way == failing::Way::Crash)
    _exit(99);
  errno = ENOSPC;
  return true;
}
} // namespace

void failing::Arm(int call, Way how)
{
  failAt = call;
  calls = 0;
  names.clear();
  way = how;
  armed = true;
}

std::string failing::Disarm()
{
  armed = false;
  return names;
}

extern "C"
{
  int open(const char* path, int flags, ...)
  {
    va_list list;
    va_start(list, flags);
    const unsigned mode = (flags & O_CREAT) != 0 ? va_arg(list, unsigned) : 0;
    va_end(list);
    return Fails("open") ? -1 : int(syscall(SYS_openat, AT_FDCWD, path, flags, mode));
  }
  ssize_t write(int file, const void* bytes, size_t size)
  {
    if (armed && way == failing::Way::Crash && calls + 1 == failAt)
      syscall(SYS_write, file, bytes, size / 2);
    return Fails("write") ? -1 : syscall(SYS_write, file, bytes, size);
  }
  int fsync(int file)
  {
    return Fails("fsync") ? -1 : int(syscall(SYS_fsync, file));
  }
  int fdatasync(int file)
  {
    return Fails("fdatasync") ? -1 : int(syscall(SYS_fdatasync, file));
  }
  int ftruncate(int file, off_t size) noexcept
  {
    return Fails("ftruncate") ? -1 : int(syscall(SYS_ftruncate, file, size));
  }
  int fcntl(int file, int command, ...)
  {
    va_list list;
    va_start(list, command);
    void* argument = va_arg(list, void*);
    va_end(list);
    return Fails("fcntl") ? -1 : int(syscall(SYS_fcntl, file, command, argument));
  }
  int close(int file)
  {
    const bool fails = Fails("close"); // closed all the same, as Linux does
    const int done = int(syscall(SYS_close, file));
    if (fails)
      errno = ENOSPC;
    return fails ? -1 : done;
  }
  int rename(const char* from, const char* to) noexcept
  {
    return Fails("rename") ? -1 : int(syscall(SYS_renameat, AT_FDCWD, from, AT_FDCWD, to));
  }
  int unlink(const char* path) noexcept
  {
    return Fails("unlink") ? -1 : int(syscall(SYS_unlinkat, AT_FDCWD, path, 0));
  }
  int mkdir(const char* path, mode_t mode) noexcept
  {
    return Fails("mkdir") ? -1 : int(syscall(SYS_mkdirat, AT_FDCWD, path, mode));
  }
}
