// The first process of the guest: mounts what the tests look at, loads the kernel's modules, runs
// the tests on the serial console, says how they ended, and ends the machine.
#include <fcntl.h>
#include <sys/klog.h>
#include <sys/mount.h>
#include <sys/reboot.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>

namespace
{
bool Said(bool good, const std::string& what)
{
  if (!good)
    std::printf("guest: %s: %s\n", what.c_str(), std::strerror(errno));
  return good;
}

bool Mount(const char* type, const char* folder)
{
  mkdir(folder, 0755);
  // devtmpfs may be there already: the kernel can be told to mount it.
  return Said(
    mount(type, folder, type, 0, nullptr) == 0 || errno == EBUSY, std::string("mounting ") + type);
}

bool Load(const std::string& file, const std::string& parameters)
{
  const int module = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  const bool loaded = module >= 0 && syscall(SYS_finit_module, module, parameters.c_str(), 0) == 0;
  Said(loaded, "loading " + file);
  close(module);
  return loaded;
}

/// Lines of "file parameters…", each after those that it needs.
bool LoadAll(const char* list)
{
  std::ifstream lines(list);
  bool all = Said(lines.good(), "the list of modules");
  for (std::string line; std::getline(lines, line);)
  {
    std::istringstream words(line);
    std::string file, parameters;
    words >> file;
    std::getline(words >> std::ws, parameters);
    all = Load(file, parameters) && all;
  }
  return all;
}

/// How a program ended: its exit code, or -1 if it did not come to that.
int Run(const char* program)
{
  const pid_t child = fork();
  if (child == 0)
  {
    execl(program, program, "--gtest_color=no", nullptr);
    std::perror(program);
    _exit(127);
  }
  for (;;) // orphans of others end here, too
  {
    int status = 0;
    const pid_t ended = wait(&status);
    if (ended < 0 && errno != EINTR)
      return -1;
    if (ended == child)
      return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
}

/// Warnings of the kernel and worse, each line with its level in front. Not when they come: they
/// would fall into the middle of what the tests print.
void PrintKernelLog()
{
  constexpr int readAll = 3, mostLevel = 4; // of syslog(2); warnings
  std::string log(1 << 20, '\0');
  const int size = klogctl(readAll, log.data(), static_cast<int>(log.size()));
  std::istringstream lines(log.substr(0, size > 0 ? static_cast<std::size_t>(size) : 0));
  for (std::string line; std::getline(lines, line);)
    if (line.size() > 2 && line[0] == '<' && line[2] == '>' && line[1] - '0' <= mostLevel)
      std::printf("kernel: %s\n", line.c_str());
}
} // namespace

int main()
{
  if (getpid() != 1)
  {
    std::fputs("This is for a machine of its own: it ends the one that it runs on.\n", stderr);
    return 1;
  }
  mkdir("/tmp", 01777);
  bool ready = Mount("proc", "/proc");
  ready = Mount("sysfs", "/sys") && ready;
  ready = Mount("devtmpfs", "/dev") && ready;
  ready = LoadAll("/modules/list") && ready;
  ready = Mount("configfs", "/sys/kernel/config") && ready; // which is a module
  if (ready)
  {
    std::puts("guest: the tests begin");
    std::fflush(stdout);
    std::printf("guest: the tests ended with %d\n", Run("/tests"));
    std::fflush(stdout);
  }
  PrintKernelLog();
  std::fflush(stdout);
  sync();
  reboot(RB_AUTOBOOT); // QEMU is told to end then
}
