#include "MeasuredChild.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <sstream>
#include <stdexcept>

extern "C"
{
#include <sys/pidfd.h> // glibc 2.36 forgets to say that it is C
}

extern char** environ;

namespace hasp
{
namespace
{

/// A file in memory that a child writes to: no pipe that could fill up.
class CaughtOutput
{
public:
  CaughtOutput() : File(memfd_create("hasp-report", MFD_CLOEXEC))
  {
    if (this->File < 0)
      throw std::runtime_error("no file in memory can be made");
  }
  ~CaughtOutput() { close(this->File); }
  CaughtOutput(const CaughtOutput&) = delete;
  CaughtOutput& operator=(const CaughtOutput&) = delete;

  int Descriptor() const { return this->File; }
  std::string Text() const
  {
    std::string text(std::size_t(lseek(this->File, 0, SEEK_END)), '\0');
    const ssize_t got = pread(this->File, text.data(), text.size(), 0);
    text.resize(got > 0 ? std::size_t(got) : 0);
    return text;
  }

private:
  int File;
};

/// A line "RssAnon:   123 kB" of /proc/PID/status; 0 where it has none (a process that has ended).
std::size_t Bytes(const std::string& status, const char* key)
{
  const std::size_t at = status.find(key);
  return at == std::string::npos
           ? 0
           : std::size_t(1024) * std::stoull(status.substr(at + std::string(key).size()));
}

void Sample(pid_t child, MeasuredChild& use)
{
  std::ifstream file("/proc/" + std::to_string(child) + "/status");
  std::stringstream status;
  status << file.rdbuf();
  const std::string text = status.str();
  use.heldBytes = std::max(use.heldBytes, Bytes(text, "RssAnon:") + Bytes(text, "RssShmem:"));
  use.residentBytes = std::max(use.residentBytes, Bytes(text, "VmHWM:"));
}

pid_t Start(
  const std::string& program, const std::vector<std::string>& arguments, int output, int error)
{
  std::vector<std::string> words{ "hasp" };
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, error, STDERR_FILENO);
  pid_t child = 0;
  const int failed =
    posix_spawn(&child, program.c_str(), &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0)
    throw std::runtime_error("a child process cannot be started");
  return child;
}

} // namespace

MeasuredChild RunMeasured(const std::vector<std::string>& arguments, const ChildSettings& settings)
{
  const CaughtOutput output, error;
  MeasuredChild use;
  const auto start = std::chrono::steady_clock::now();
  const auto passed = [&start]
  { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  const pid_t child = Start(settings.program, arguments, output.Descriptor(), error.Descriptor());
  const int watch = pidfd_open(child, 0);
  pollfd ended{ watch, POLLIN, 0 };
  constexpr int intervalMs = 10;
  Sample(child, use); // it may end before the first interval does
  while (watch >= 0 && poll(&ended, 1, intervalMs) == 0)
  {
    Sample(child, use);
    if (settings.limitS > 0.0 && passed() > settings.limitS && !use.late)
    {
      use.late = true;
      kill(child, SIGKILL);
    }
  }
  if (watch >= 0)
    close(watch);
  int status = 0;
  rusage spent{};
  wait4(child, &status, 0, &spent);
  use.seconds = passed();
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  use.cpuSeconds = seconds(spent.ru_utime) + seconds(spent.ru_stime);
  use.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  use.output = output.Text();
  use.error = error.Text();
  if (use.heldBytes == 0)
    throw std::runtime_error("the system does not tell what a child process holds");
  return use;
}

} // namespace hasp
