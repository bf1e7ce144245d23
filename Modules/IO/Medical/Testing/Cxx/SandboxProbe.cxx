// A decoder that tries what the sandbox forbids: the act is the name of the file it is to read. It
// ends with code 70 if the act was done, 71 if the system refused it and let it go on. With
// HASP_PROBE_NO_FILTER set it first makes the kernel refuse filters, as some containers do.
#include "Dicom/DicomWire.h"
#include "Sandbox/Confinement.h"

#include <fcntl.h>
#include <pthread.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <string>

namespace
{

void RefuseFilters()
{
  scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
  seccomp_rule_add(filter, SCMP_ACT_ERRNO(EINVAL), SCMP_SYS(seccomp), 0);
  seccomp_rule_add(
    filter, SCMP_ACT_ERRNO(EINVAL), SCMP_SYS(prctl), 1, SCMP_A0(SCMP_CMP_EQ, PR_SET_SECCOMP));
  if (seccomp_load(filter) != 0)
    std::exit(72);
}

bool Spawned(pid_t child)
{
  if (child == 0)
    _exit(0);
  return child > 0;
}

bool OpenedAs(const std::string& path, int flags)
{
  return open(path.c_str(), flags, 0600) >= 0;
}

/// Each returns whether it was done. `here` is a file that exists.
const std::map<std::string, std::function<bool(const std::string& here)>> Acts = {
  { "exec", [](const auto&) { return execl("/bin/true", "true", nullptr) == 0; } },
  { "fork", [](const auto&) { return Spawned(fork()); } },
  { "thread",
    [](const auto&)
    {
      pthread_t thread;
      return pthread_create(
               &thread, nullptr, [](void*) -> void* { return nullptr; }, nullptr) == 0;
    } },
  { "socket", [](const auto&) { return socket(AF_INET, SOCK_STREAM, 0) >= 0; } },
  { "local socket", [](const auto&) { return socket(AF_UNIX, SOCK_STREAM, 0) >= 0; } },
  { "write", [](const auto& here) { return OpenedAs(here, O_WRONLY); } },
  { "append", [](const auto& here) { return OpenedAs(here, O_WRONLY | O_APPEND); } },
  { "both", [](const auto& here) { return OpenedAs(here, O_RDWR); } },
  { "create", [](const auto& here) { return OpenedAs(here + ".new", O_WRONLY | O_CREAT); } },
  { "touch", [](const auto& here) { return OpenedAs(here + ".new", O_RDONLY | O_CREAT); } },
  { "truncate", [](const auto& here) { return OpenedAs(here, O_RDONLY | O_TRUNC); } },
  { "cut", [](const auto& here) { return truncate(here.c_str(), 0) == 0; } },
  { "unlink", [](const auto& here) { return unlink(here.c_str()) == 0; } },
  { "rename", [](const auto& here) { return rename(here.c_str(), (here + "2").c_str()) == 0; } },
  { "link", [](const auto& here) { return link(here.c_str(), (here + "2").c_str()) == 0; } },
  { "mkdir", [](const auto& here) { return mkdir((here + "2").c_str(), 0700) == 0; } },
  { "chmod", [](const auto& here) { return chmod(here.c_str(), 0777) == 0; } },
  { "ptrace", [](const auto&) { return ptrace(PTRACE_ATTACH, getppid(), nullptr, nullptr) == 0; } },
  { "kill", [](const auto&) { return kill(getppid(), SIGCONT) == 0; } },
  { "code",
    [](const auto&)
    {
      return mmap(nullptr, 4096, PROT_READ | PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS,
               -1, 0) != MAP_FAILED;
    } },
  { "prctl", [](const auto&) { return prctl(PR_SET_NAME, "other", 0, 0, 0) == 0; } },
};

/// Made before the sandbox: a descriptor to write to, which only the limit on files' sizes stops.
int inherited = -1;

bool Inherited()
{
  return fcntl(inherited, F_GETFD) >= 0;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 4)
    return 2;
  inherited = dup2(open("/dev/null", O_RDONLY), 37);
  if (std::getenv("HASP_PROBE_NO_FILTER"))
    RefuseFilters();
  const auto confinement =
    hasp::EnterSandbox(std::strtoull(argv[2], nullptr, 10), std::strtoull(argv[3], nullptr, 10));
  if (confinement == hasp::Confinement::None)
    return 4;
  std::string path;
  for (std::uint32_t index = 0; std::getline(std::cin, path, '\0'); ++index)
  {
    path.erase(0, path.find(':') + 1); // the frame
    const std::string act = std::filesystem::path(path).stem().string();
    if (act == "descriptor") // asking is itself forbidden where calls are filtered
    {
      if (confinement == hasp::Confinement::Limits)
        return Inherited() ? 70 : 71;
      char byte = 0;
      return read(inherited, &byte, 1) < 0 && errno == EBADF ? 71 : 70;
    }
    if (act == "read") // allowed
      return open(path.c_str(), O_RDONLY) >= 0 ? 70 : 71;
    if (act == "many files")
    {
      int opened = 0;
      while (opened < 100 && open(path.c_str(), O_RDONLY) >= 0)
        ++opened;
      return opened < 100 ? 71 : 70;
    }
    if (act == "memory")
      return std::malloc(std::size_t(1) << 30) ? 70 : 71;
    if (act == "grow") // only where calls are not filtered can it come so far
    {
      const int file = open(path.c_str(), O_WRONLY);
      return file >= 0 && write(file, "x", 1) == 1 ? 70 : 71;
    }
    if (act == "state")
      return confinement == hasp::Confinement::Filtered ? 70 : 71;
    return Acts.at(act)(path) ? 70 : 71;
  }
  return 0;
}
