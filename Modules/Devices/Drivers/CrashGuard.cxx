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
constexpr char IsOpen = 'o', IsClosed = 'c';
constexpr std::int64_t TryAgainNs = 10'000'000;

ssize_t ReadByte(int pipe, char& byte)
{
  ssize_t got;
  do
    got = ::read(pipe, &byte, 1);
  while (got < 0 && errno == EINTR);
  return got;
}

} // namespace

CrashGuard::CrashGuard(
  std::unique_ptr<HapticDriver> driver, std::filesystem::path program, const std::string& address)
  : Driver(std::move(driver)),
    Program(std::move(program)),
    Address(address)
{
}

CrashGuard::~CrashGuard()
{
  this->Close();
  if (this->Pipe < 0)
    return;
  ::close(this->Pipe);
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
  if (error == 0)
    this->Pipe = ends[0];
  else
    ::close(ends[0]);
  return error == 0;
}

void CrashGuard::Tell(char word) noexcept
{
  // Where the guard has gone there is nobody to tell, and no reason to end this program.
  while (::send(this->Pipe, &word, 1, MSG_NOSIGNAL) < 0 && errno == EINTR)
  {
  }
}

void CrashGuard::Open(const DriverOpening& how)
{
  this->Driver->Open(how);
  if (this->Driver->Profile().forceAxes == 0)
    return;
  if (this->Pipe < 0 && !this->Start())
    how.says("the program that takes the force away after a crash, hasp-device-guard, cannot be"
             " started; the device is used without it");
  if (this->Pipe >= 0)
    this->Tell(IsOpen);
}

void CrashGuard::Close() noexcept
{
  this->Driver->Close();
  if (this->Pipe >= 0)
    this->Tell(IsClosed);
}

int GuardDevice(int pipe, HapticDriver& driver, double patienceS)
{
  char word = IsClosed, last = IsClosed;
  while (ReadByte(pipe, word) == 1)
    last = word;
  if (last != IsOpen)
    return 0;
  MonotonicClock clock;
  const std::int64_t untilNs = clock.NowNs() + static_cast<std::int64_t>(patienceS * 1e9);
  for (;;)
  {
    try
    {
      // A device that has to be set up first has no force.
      driver.Open({ .setUp = false });
      driver.Close();
      return 0;
    }
    catch (const Cancelled&)
    {
      return 0;
    }
    catch (const DeviceError& error)
    {
      if (error.trouble == DeviceTrouble::Absent)
        return 0; // without power there is no force
      if (clock.NowNs() > untilNs)
        return 1;
    }
    clock.SleepUntil(clock.NowNs() + TryAgainNs);
  }
}

} // namespace hasp
