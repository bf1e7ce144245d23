#include "Sandbox/ChildProcess.h"
#include "Files/FileError.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <stdexcept>

extern char** environ;

namespace hasp
{
namespace
{

/// Closes a file descriptor at the end of its scope.
struct Descriptor
{
  int number = -1;
  ~Descriptor()
  {
    if (this->number >= 0)
      close(this->number);
  }
};

[[noreturn]] void ThrowSystem(const ChildProgram& program, const std::string& what)
{
  throw std::runtime_error(program.name + " cannot be started: " + what + ": " + strerror(errno));
}

/// What the child reads lies in memory, not in a pipe: parent and child can then never wait for
/// each other, and no path touches the disk.
void WriteInput(const ChildProgram& program, int into, std::string_view input)
{
  for (std::size_t done = 0; done < input.size();)
  {
    const ssize_t wrote = write(into, input.data() + done, input.size() - done);
    if (wrote < 0 && errno != EINTR)
      ThrowSystem(program, "its list of files");
    done += wrote > 0 ? static_cast<std::size_t>(wrote) : 0;
  }
  if (lseek(into, 0, SEEK_SET) != 0)
    ThrowSystem(program, "its list of files");
}

int Spawn(const ChildProgram& program, const std::filesystem::path& file,
  std::vector<std::string>& words, int input, int output)
{
  std::vector<char*> arguments;
  for (std::string& word : words)
    arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
  pid_t child = -1;
  const int error = posix_spawn(&child, file.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0)
  {
    errno = error;
    ThrowSystem(program, program.file);
  }
  return child;
}

/// Returns once the child has ended, or after so long.
void AwaitEnd(int child, int milliseconds)
{
  const Descriptor process{ static_cast<int>(syscall(SYS_pidfd_open, child, 0)) };
  pollfd wait{ process.number, POLLIN, 0 };
  if (process.number >= 0)
    poll(&wait, 1, milliseconds);
}

} // namespace

ChildProcess::ChildProcess(
  std::vector<std::string> words, std::string_view input, ChildSettings settings)
  : Settings(std::move(settings)),
    Started(Clock::now())
{
  const ChildProgram& program = this->Settings.program;
  const auto file = FindProgram(program);
  const Descriptor list{ memfd_create("hasp-files", MFD_CLOEXEC) };
  if (list.number < 0)
    ThrowSystem(program, "its list of files");
  WriteInput(program, list.number, input);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    ThrowSystem(program, "a pipe");
  this->Output = ends[0];
  const Descriptor childEnd{ ends[1] };
  try
  {
    this->Child = Spawn(program, file, words, list.number, childEnd.number);
  }
  catch (...)
  {
    close(this->Output); // no destructor runs for what was never made
    throw;
  }
}

ChildProcess::~ChildProcess()
{
  if (this->Output >= 0)
    close(this->Output);
  if (this->Child > 0)
  {
    kill(this->Child, SIGKILL);
    this->Reap();
  }
}

int ChildProcess::Reap()
{
  int status = 0;
  while (waitpid(this->Child, &status, 0) < 0 && errno == EINTR)
    ;
  this->Child = -1;
  return status;
}

std::size_t ChildProcess::ReadSome(void* into, std::size_t size, const Beat& beat)
{
  const auto asked = Clock::now();
  const double silenceSeconds = this->Settings.silenceSeconds();
  for (;;)
  {
    beat();
    const auto since = [](Clock::time_point then)
    { return std::chrono::duration<double>(Clock::now() - then).count(); };
    const double silent = since(asked), total = since(this->Started);
    const double left = std::min(silenceSeconds - silent, this->Settings.totalSeconds - total);
    if (left <= 0.0)
      throw std::runtime_error(
        this->Settings.program.name + " hangs" + this->At() + ": no end after " +
        Text(std::round(10.0 * std::max(silent, total)) / 10.0) + " s, so it was stopped. " +
        this->Settings.remedy + ", or raise the decoder's time limit for a slow disk");
    pollfd wait{ this->Output, POLLIN, 0 };
    const int ready = poll(&wait, 1, static_cast<int>(std::min(500.0, 1000.0 * left)) + 1);
    if (ready <= 0)
      continue;
    const ssize_t got = read(this->Output, into, size);
    if (got >= 0)
      return static_cast<std::size_t>(got);
    if (errno != EINTR)
      throw std::runtime_error(
        this->Settings.program.name + " cannot be read from: " + strerror(errno));
  }
}

void ChildProcess::Read(void* into, std::size_t size, const Beat& beat)
{
  auto* bytes = static_cast<char*>(into);
  while (size > 0)
  {
    const std::size_t got = this->ReadSome(bytes, size, beat);
    if (got == 0)
      this->ThrowEnded();
    bytes += got;
    size -= got;
  }
}

void ChildProcess::ThrowEnded()
{
  const std::string& name = this->Settings.program.name;
  const std::string at = this->At(), remedy = ". " + this->Settings.remedy;
  // Its output is closed a little before its exit code is there; one that stays is ended.
  AwaitEnd(this->Child, 1000);
  kill(this->Child, SIGKILL);
  const int status = this->Reap();
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGSYS)
    throw std::runtime_error(name + " tried what it may not do" + at +
                             " (a forbidden system call) and was stopped before it was done; the "
                             "file may be made to attack" +
                             remedy);
  if (!WIFEXITED(status))
    throw std::runtime_error(
      name + " crashed" + at + " (" + (signal != 0 ? strsignal(signal) : "unknown") + ")" + remedy);
  const int code = WEXITSTATUS(status);
  if (code == 3)
    throw std::runtime_error(name + " needs more memory than the " +
                             Text(std::round(double(this->Settings.memoryBytes) / (1 << 20))) +
                             " MiB it was given" + at + this->Settings.memoryRemedy);
  if (code == 4)
    throw std::runtime_error(name + " cannot limit itself on this system (is /proc there, and may "
                                    "limits be set?); without limits it reads nothing");
  if (const auto ending = this->Settings.endings.find(code); ending != this->Settings.endings.end())
    throw std::runtime_error(ending->second);
  throw std::runtime_error(name + " gave up with code " + std::to_string(code) + at + remedy);
}

void ChildProcess::ThrowGarbage(const std::string& what) const
{
  const ChildProgram& program = this->Settings.program;
  throw std::runtime_error(program.name + " sent no valid answer" + this->At() + " (" + what +
                           "); is " + program.variable + " the " + program.file +
                           " of this build?");
}

void ChildProcess::Finish(const Beat& beat)
{
  char more = 0;
  if (this->ReadSome(&more, 1, beat) != 0)
    this->ThrowGarbage("more than was asked for");
  // All answers have come and were checked; how it ends no longer matters, that it ends does.
  kill(this->Child, SIGKILL);
  this->Reap();
}

} // namespace hasp
