#include "Devices/Drivers/CrashGuard.h"

#include "Grid/Progress.h"
#include "Realtime/LoopThread.h"

#include <sched.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

extern char** environ;

namespace hasp
{

namespace
{
constexpr char IsOpen = 'o', IsClosed = 'c', EndOfSettings = '\0';
constexpr std::int64_t TryAgainNs = 10'000'000;

/// False: the pipe has ended.
bool ReadByte(int pipe, char& byte)
{
  ssize_t got;
  do
    got = ::read(pipe, &byte, 1);
  while (got < 0 && errno == EINTR);
  return got == 1;
}

} // namespace

CrashGuard::CrashGuard(std::unique_ptr<HapticDriver> driver, std::filesystem::path program,
  const std::string& address, const std::string& settings)
  : Driver(std::move(driver)),
    Program(std::move(program)),
    Address(address),
    Settings(settings)
{
}

CrashGuard::~CrashGuard()
{
  this->Close();
  this->Stop();
}

void CrashGuard::Stop() noexcept
{
  if (this->Pipe < 0)
    return;
  ::close(std::exchange(this->Pipe, -1));
  while (::waitpid(this->Child, nullptr, 0) < 0 && errno == EINTR)
  {
  }
}

bool CrashGuard::Start()
{
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    return false;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
  // What libraries have opened without a word of closing: the device itself, perhaps.
  posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
  // Not in this program's group: Ctrl+C in a terminal ends all of that. Nor as this thread is,
  // which hears no signals and may be a real-time one.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(
    &attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSCHEDULER);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setschedpolicy(&attributes, SCHED_OTHER);
  const std::string program = this->Program.string();
  char* words[] = { const_cast<char*>(program.c_str()), const_cast<char*>(this->Address.c_str()),
    nullptr };
  const int error =
    ::posix_spawn(&this->Child, program.c_str(), &actions, &attributes, words, environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  if (error != 0)
  {
    ::close(ends[0]);
    return false;
  }
  this->Pipe = ends[0];
  return this->Tell(this->Settings + EndOfSettings);
}

/// False: the guard has gone. That is no reason to end this program by SIGPIPE.
bool CrashGuard::Tell(const std::string& words) noexcept
{
  for (std::size_t sent = 0; sent < words.size();)
  {
    const ssize_t now = ::send(this->Pipe, words.data() + sent, words.size() - sent, MSG_NOSIGNAL);
    if (now < 0 && errno != EINTR)
      return false;
    sent += now > 0 ? static_cast<std::size_t>(now) : 0;
  }
  return true;
}

void CrashGuard::Open(const DriverOpening& how)
{
  this->Driver->Open(how);
  if (this->Driver->Profile().forceAxes == 0)
    return;
  if (this->Pipe >= 0 && this->Tell({ IsOpen }))
    return;
  this->Stop(); // it has gone
  if (!this->Start() || !this->Tell({ IsOpen }))
    how.warns("the program that takes the force away after a crash, hasp-device-guard, cannot be"
              " started; the device is used without it");
}

void CrashGuard::Close() noexcept
{
  this->Driver->Close();
  if (this->Pipe >= 0)
    this->Tell({ IsClosed });
}

std::optional<std::string> ReadGuardedSettings(int pipe)
{
  std::string settings;
  for (char byte = EndOfSettings; ReadByte(pipe, byte); settings += byte)
    if (byte == EndOfSettings)
      return settings;
  return {};
}

int GuardDevice(int pipe, HapticDriver& driver, double patienceS)
{
  char last = IsClosed;
  for (char word = IsClosed; ReadByte(pipe, word);)
    last = word;
  if (last != IsOpen)
    return 0;
  MonotonicClock clock;
  const std::int64_t untilNs = clock.NowNs() + static_cast<std::int64_t>(patienceS * 1e9);
  for (;;)
  {
    int code = 1;
    try
    {
      driver.Open({ .setUp = false });
      driver.Close();
      return 0;
    }
    catch (const Cancelled&)
    {
      code = 0; // one that has to be set up first has no force
    }
    catch (const DeviceError& error)
    {
      code = error.trouble == DeviceTrouble::Absent ? 0 : 1; // without power neither
    }
    // All of that may also be said of one that the dead program still holds.
    if (clock.NowNs() > untilNs)
      return code;
    clock.SleepUntil(clock.NowNs() + TryAgainNs);
  }
}

} // namespace hasp
