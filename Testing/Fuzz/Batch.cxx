#include "Batch.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <system_error>

namespace hasp
{
namespace
{

/// What a forked process tells while it runs, in memory it shares with us.
struct Tally
{
  std::atomic<std::uint64_t> current; ///< the input being run
  std::atomic<std::uint64_t> opened, refused;
  std::atomic<bool> done;
};
static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

[[noreturn]] void ThrowSystem(const char* what)
{
  throw std::system_error(errno, std::generic_category(), what);
}

Tally* SharedTally()
{
  void* memory =
    mmap(nullptr, sizeof(Tally), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED)
    ThrowSystem("shared memory");
  return new (memory) Tally{};
}

using Input = std::function<Outcome(std::uint64_t, const std::filesystem::path&)>;

/// The forked process: never returns, and an exception ends it here.
[[noreturn]] void RunInputs(std::uint64_t first, std::uint64_t last, const BatchSettings& settings,
  int printed, const Input& input, Tally& tally) noexcept
{
#if !defined(__SANITIZE_ADDRESS__) // which reserves terabytes of addresses for itself
  const rlimit memory{ settings.memoryBytes, settings.memoryBytes };
  setrlimit(RLIMIT_AS, &memory);
#endif
  const rlimit noCore{ 0, 0 };
  setrlimit(RLIMIT_CORE, &noCore);
  dup2(printed, STDOUT_FILENO);
  dup2(printed, STDERR_FILENO);
  for (std::uint64_t number = first; number < last; ++number)
  {
    tally.current = number;
    (input(number, settings.folder) == Outcome::Opened ? tally.opened : tally.refused) += 1;
  }
  tally.done = true;
  _exit(0); // no exit handlers: they are the parent's
}

/// Waits for the child's end. False: one input took too long, and the child was killed.
bool WaitForEnd(pid_t child, double hangSeconds, const Tally& tally)
{
  const int end = static_cast<int>(syscall(SYS_pidfd_open, child, 0));
  if (end < 0)
    ThrowSystem("pidfd_open");
  bool ended = false, hangs = false;
  while (!ended && !hangs)
  {
    const std::uint64_t before = tally.current;
    pollfd waiting{ end, POLLIN, 0 };
    ended = poll(&waiting, 1, static_cast<int>(1000.0 * hangSeconds)) > 0;
    hangs = !ended && tally.current == before;
  }
  if (hangs)
    kill(child, SIGKILL);
  close(end);
  return ended;
}

std::uint64_t FilesIn(const std::filesystem::path& folder)
{
  std::uint64_t count = 0;
  for ([[maybe_unused]] const auto& any : std::filesystem::recursive_directory_iterator(folder))
    ++count;
  return count;
}

/// Removes what a killed process left of its inputs; they do not count as written.
void Empty(const std::filesystem::path& folder)
{
  for (const auto& any : std::filesystem::directory_iterator(folder))
    std::filesystem::remove_all(any.path());
}

/// One forked process. The number to go on with.
std::uint64_t RunFork(std::uint64_t first, std::uint64_t last, const BatchSettings& settings,
  int printed, const Input& input, Tally& tally, BatchResult& result)
{
  tally.done = false;
  tally.current = first;
  const pid_t child = fork();
  if (child < 0)
    ThrowSystem("fork");
  if (child == 0)
    RunInputs(first, last, settings, printed, input, tally);
  const bool ended = WaitForEnd(child, settings.hangSeconds, tally);
  int status = 0;
  rusage used{};
  while (wait4(child, &status, 0, &used) < 0 && errno == EINTR)
    ;
  result.peakBytes = std::max(result.peakBytes, std::uint64_t(used.ru_maxrss) * 1024);
  if (ended && tally.done)
  {
    result.filesLeft += FilesIn(settings.folder);
    Empty(settings.folder);
    return last;
  }
  (ended ? result.crashes : result.hangs).push_back(tally.current);
  Empty(settings.folder);
  return tally.current + 1;
}

} // namespace

bool BatchResult::Good() const
{
  return this->crashes.empty() && this->hangs.empty() && this->filesLeft == 0 &&
         this->bytesPrinted == 0;
}

BatchResult RunBatch(const BatchSettings& settings, const Input& input)
{
  BatchResult result;
  Tally* tally = SharedTally();
  const int printed = memfd_create("printed", MFD_CLOEXEC);
  if (printed < 0)
    ThrowSystem("memfd_create");
  const auto start = std::chrono::steady_clock::now();
  const std::uint64_t end = settings.first + settings.count;
  for (std::uint64_t at = settings.first; at < end;)
    at =
      RunFork(at, std::min(end, at + settings.perFork), settings, printed, input, *tally, result);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  result.seconds = spent.count();
  result.opened = tally->opened;
  result.refused = tally->refused;
  result.run = result.opened + result.refused + result.crashes.size() + result.hangs.size();
  result.bytesPrinted = static_cast<std::uint64_t>(lseek(printed, 0, SEEK_END));
  close(printed);
  munmap(tally, sizeof(Tally));
  return result;
}

} // namespace hasp
