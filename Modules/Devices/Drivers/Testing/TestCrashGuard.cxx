#include "Devices/Drivers/CrashGuard.h"
#include "Devices/Drivers/Plugin/PluginDriver.h"
#include "Devices/Testing/TemporaryFile.h"
#include "Grid/Progress.h"
#include "Realtime/LoopThread.h"
#include "ScriptedDriver.h"

#include <gtest/gtest.h>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <utility>

namespace
{

using namespace hasp;
using hasp::test::ScriptedDevice;
using hasp::test::ScriptedDriver;

/// Of this process; 0: none.
pid_t OnlyChild()
{
  for (const auto& entry : std::filesystem::directory_iterator("/proc"))
  {
    std::ifstream stream(entry.path() / "stat"); // "12 (name) S 11 …": the last is the parent
    std::string text;
    std::getline(stream, text);
    const std::size_t name = text.rfind(')');
    if (name != std::string::npos && std::atoi(text.c_str() + name + 4) == ::getpid())
      return std::atoi(text.c_str());
  }
  return 0;
}

/// What a guard does after these words and the pipe's end.
int Guarded(ScriptedDevice& device, const std::string& words, double patienceS = 0.05)
{
  int ends[2];
  EXPECT_EQ(::pipe(ends), 0);
  EXPECT_EQ(::write(ends[1], words.data(), words.size()), ssize_t(words.size()));
  ::close(ends[1]);
  ScriptedDriver driver(device);
  const int code = GuardDevice(ends[0], driver, patienceS);
  ::close(ends[0]);
  return code;
}

TEST(DeviceGuard, ActsOnlyWhereTheDeviceWasOpen)
{
  for (const auto& [words, closes] :
    { std::pair<const char*, int>{ "", 0 }, { "oc", 0 }, { "ococ", 0 }, { "o", 1 }, { "oco", 1 } })
  {
    ScriptedDevice device;
    EXPECT_EQ(Guarded(device, words), 0) << words;
    EXPECT_EQ(device.closes, closes) << words;
  }
}

TEST(DeviceGuard, TriesForAsLongAsTheOneThatDiedHoldsIt)
{
  ScriptedDevice device;
  device.there = false;
  device.trouble = DeviceTrouble::Busy;
  device.opening = [&](const DriverOpening& how)
  {
    EXPECT_FALSE(how.setUp);
    device.there = device.opens == 3;
  };
  EXPECT_EQ(Guarded(device, "o", 10.0), 0);
  EXPECT_EQ(device.opens, 3);
  EXPECT_EQ(device.closes, 1);

  ScriptedDevice kept;
  kept.there = false;
  kept.trouble = DeviceTrouble::Busy;
  EXPECT_EQ(Guarded(kept, "o"), 1);

  ScriptedDevice gone;
  gone.there = false;
  EXPECT_EQ(Guarded(gone, "o"), 0) << "without power there is no force";

  ScriptedDevice reset;
  reset.opening = [](const DriverOpening&) { throw Cancelled(); };
  EXPECT_EQ(Guarded(reset, "o"), 0) << "it would have to be set up first";
}

TEST(DeviceGuard, HearsSettingsFirst)
{
  for (const auto& [sent, settings] :
    { std::pair<std::string, std::optional<std::string>>{ {}, {} }, { "{ half", {} },
      { std::string("\0o", 2), "" }, { std::string("{}\0oc", 5), "{}" } })
  {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    ASSERT_EQ(::write(ends[1], sent.data(), sent.size()), ssize_t(sent.size()));
    ::close(ends[1]);
    EXPECT_EQ(ReadGuardedSettings(ends[0]), settings);
    ::close(ends[0]);
  }
}

TEST(CrashGuard, WithoutItsProgramTheDeviceIsUsedAndItIsSaid)
{
  ScriptedDevice device;
  CrashGuard guard(std::make_unique<ScriptedDriver>(device), "/nonexistent/guard", "falcon");
  std::string said;
  guard.Open({ .warns = [&](const std::string& what) { said = what; } });
  EXPECT_NE(said.find("hasp-device-guard"), std::string::npos);
  guard.Exchange({ { 0, 0, 1 }, {} }, 0);
  EXPECT_TRUE(device.open);
  guard.Close();
  EXPECT_FALSE(device.open);
}

TEST(CrashGuard, ADeviceWithoutMotorsHasNone)
{
  ScriptedDevice device;
  device.profile.forceAxes = 0;
  CrashGuard guard(std::make_unique<ScriptedDriver>(device), "/nonexistent/guard", "spacenav");
  std::string said;
  guard.Open({ .warns = [&](const std::string& what) { said = what; } });
  EXPECT_EQ(said, "");
}

class CrashGuardProgram : public ::testing::Test
{
protected:
  std::string Force() const
  {
    std::ifstream stream(this->file.Path);
    std::string text;
    std::getline(stream, text);
    return text;
  }
  /// However slow the machine is; ctest ends what never comes.
  void UntilForceIs(const std::string& newton) const
  {
    MonotonicClock clock;
    while (this->Force() != newton)
      clock.SleepUntil(clock.NowNs() + 1'000'000);
  }
  std::unique_ptr<HapticDriver> Driver() const
  {
    return std::make_unique<CrashGuard>(
      std::make_unique<PluginDriver>(HASP_FORCE_IN_FILE, this->file.Path), HASP_DEVICE_GUARD,
      std::string("plugin:") + HASP_FORCE_IN_FILE + ":" + this->file.Path);
  }
  /// A process that pushes, and then ends by that signal.
  void PushAndDie(int signal) const
  {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0)
    {
      const auto driver = this->Driver();
      driver->Open({});
      driver->Exchange({ { 0, 0, 2 }, {} }, 0);
      ::signal(signal, SIG_DFL); // a sanitizer's handler would exit
      ::raise(signal);
      ::_exit(0);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status));
  }
  const TemporaryFile file;
};

TEST_F(CrashGuardProgram, TakesTheForceAwayAfterEachWayToDie)
{
  for (const int signal : { SIGKILL, SIGSEGV, SIGABRT, SIGTERM, SIGINT })
  {
    this->PushAndDie(signal);
    this->UntilForceIs("0.000");
  }
}

// Whatever this program has open, the guard has not: what keeps a device would be kept by it.
TEST_F(CrashGuardProgram, InheritsNothing)
{
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0); // not to be closed by exec
  const auto driver = this->Driver();
  driver->Open({});
  ::close(ends[1]);
  char byte = 0;
  EXPECT_EQ(::read(ends[0], &byte, 1), 0) << "nobody else can write any more";
  ::close(ends[0]);
}

TEST_F(CrashGuardProgram, AGuardThatHasGoneIsStartedAgain)
{
  const auto driver = this->Driver();
  driver->Open({});
  driver->Close();
  const pid_t guard = OnlyChild();
  ASSERT_GT(guard, 0);
  ASSERT_EQ(::kill(guard, SIGKILL), 0);
  siginfo_t ended{};
  ASSERT_EQ(::waitid(P_PID, guard, &ended, WEXITED | WNOWAIT), 0) << "it is its driver's to bury";
  std::string said;
  driver->Open({ .warns = [&](const std::string& what) { said = what; } });
  EXPECT_EQ(said, "");
}

TEST_F(CrashGuardProgram, IsThereTheWholeTimeAndEndsWithItsProgram)
{
  {
    const auto driver = this->Driver();
    for (int n = 0; n < 5; ++n)
    {
      driver->Open({});
      driver->Exchange({ { 0, 0, 1.5 }, {} }, 0);
      EXPECT_EQ(this->Force(), "1.500") << "nobody takes it away while the program lives";
      driver->Close();
      EXPECT_EQ(this->Force(), "0.000");
    }
    driver->Open({});
  }
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1) << "no child is left";
}

} // namespace
