#include "Devices/Drivers/Testing/FakeSpacenavd.h"

#include "Devices/Drivers/SpaceMouse/SpacenavSocket.h"
#include "Grid/Progress.h"

#include <sys/time.h>
#include <sys/wait.h>

#include <csignal>
#include <filesystem>
#include <random>
#include <vector>

namespace
{

using namespace hasp;
using hasp::test::FakeSpacenavd;

/// The trouble that opening or reading ends in; its sentence says something and shows no path.
template <class Does>
DeviceTrouble TroubleOf(Does&& does)
{
  try
  {
    does();
  }
  catch (const DeviceError& error)
  {
    const std::string sentence = error.what();
    EXPECT_NE(sentence.find("spacenavd"), sentence.npos) << sentence;
    EXPECT_NE(sentence.find(": "), sentence.npos) << sentence; // what to do
    EXPECT_EQ(sentence.find("/tmp"), sentence.npos) << sentence;
    return error.trouble;
  }
  ADD_FAILURE() << "no trouble";
  return DeviceTrouble::NotBuilt;
}

class SpacenavSocketTest : public ::testing::Test
{
protected:
  SpacenavSocketTest() : Source(this->Daemon.Path()) {}
  void Connect()
  {
    this->Daemon.Begin();
    this->Source.Open({});
    this->Daemon.Accept();
  }
  SixDofNews Read() { return this->Source.Read(this->State, 0); }

  FakeSpacenavd Daemon;
  SpacenavSocket Source;
  SixDofState State;
};

TEST_F(SpacenavSocketTest, SaysMotionInDeviceAxesAndClamps)
{
  this->Connect();
  EXPECT_FALSE(this->Read().push);
  this->Daemon.Motion(std::array{ 250, 500, 125, -250, 0, -500 });
  const SixDofNews news = this->Read();
  EXPECT_TRUE(news.push && news.turn);
  EXPECT_EQ(this->State.push, glm::dvec3(0.5, 1.0, -0.25));
  EXPECT_EQ(this->State.turn, glm::dvec3(-0.5, 0.0, 1.0));
  this->Daemon.Motion(std::array{ 2147483647, -2147483647 - 1, 501, -501, 0, 0 });
  this->Read();
  EXPECT_EQ(this->State.push, glm::dvec3(1.0, -1.0, -1.0));
  EXPECT_EQ(this->State.turn, glm::dvec3(-1.0, 0.0, 0.0));
  EXPECT_FALSE(this->Read().push); // said once
}

TEST_F(SpacenavSocketTest, HoldsButtons)
{
  this->Connect();
  this->Daemon.Send({ 1, 0 });
  this->Daemon.Send({ 1, 31 });
  const SixDofNews news = this->Read();
  EXPECT_FALSE(news.push || news.turn);
  EXPECT_EQ(this->State.buttons, 0x8000'0001u);
  this->Daemon.Send({ 2, 0 });
  this->Daemon.Send({ 2, 7 }); // was not held
  this->Read();
  EXPECT_EQ(this->State.buttons, 0x8000'0000u);
}

TEST_F(SpacenavSocketTest, EventsComeInPiecesOfAnySize)
{
  this->Connect();
  std::vector<std::int32_t> stream;
  for (int n = 1; n <= 500; ++n)
    for (const int number : { 0, n, 0, 0, 0, 0, 0, 16 })
      stream.push_back(number);
  const char* at = reinterpret_cast<const char*>(stream.data());
  std::size_t left = stream.size() * sizeof stream[0], sent = 0;
  std::mt19937 random(3);
  while (left > 0)
  {
    const std::size_t size = std::min<std::size_t>(1 + random() % 97, left);
    this->Daemon.SendBytes(at, size);
    at += size;
    left -= size;
    sent += size;
    this->Read();
    EXPECT_EQ(this->State.push.x, static_cast<double>(sent / 32) / 500.0);
  }
  EXPECT_EQ(this->Source.WrongCount(), 0u);
}

TEST_F(SpacenavSocketTest, WrongOnesAreSkippedAndCounted)
{
  this->Connect();
  const std::vector<FakeSpacenavd::Event> wrong{ { 3, 1, 2 }, { 4 }, { -1 }, { 2147483647 },
    { -2147483647 - 1 }, { 1, -1 }, { 1, 256 }, { 2, 1000000 }, { 2, -2147483647 - 1 } };
  for (const auto& event : wrong)
    this->Daemon.Send(event);
  this->Daemon.Motion(std::array{ 500, 0, 0, 0, 0, 0 });
  EXPECT_TRUE(this->Read().push);
  EXPECT_EQ(this->State.push, glm::dvec3(1, 0, 0));
  EXPECT_EQ(this->State.buttons, 0u);
  EXPECT_EQ(this->Source.WrongCount(), wrong.size());
}

/// A device with more buttons than are heard is no stream out of step.
TEST_F(SpacenavSocketTest, ButtonsThatAreNotHeardAreNoFault)
{
  this->Connect();
  for (int n = 0; n < 200; ++n)
    this->Daemon.Send({ 1 + n % 2, 40 });
  this->Read();
  EXPECT_EQ(this->State.buttons, 0u);
  EXPECT_EQ(this->Source.WrongCount(), 0u);
}

/// Wrong ones between good ones never add up; a stream that is out of step is left, and opened anew
/// it is in step.
TEST_F(SpacenavSocketTest, AStreamOutOfStepIsLeft)
{
  this->Connect();
  for (int n = 0; n < 1000; ++n)
  {
    this->Daemon.Send({ 77 });
    this->Daemon.Send({ 1, 5 });
    this->Read();
  }
  EXPECT_EQ(this->Source.WrongCount(), 1000u);
  for (int n = 0; n < 64; ++n)
    this->Daemon.Send({ 77 });
  EXPECT_EQ(TroubleOf([&] { this->Read(); }), DeviceTrouble::Protocol);
  this->Source.Close();
  this->Source.Open({});
  this->Daemon.Accept();
  this->Daemon.Motion(std::array{ 0, 500, 0, 0, 0, 0 });
  EXPECT_TRUE(this->Read().push);
  EXPECT_EQ(this->Source.WrongCount(), 0u);
}

TEST_F(SpacenavSocketTest, RandomEventsNeverGiveWhatIsNone)
{
  this->Connect();
  std::mt19937 random(5);
  for (int n = 0; n < 20'000; ++n)
  {
    FakeSpacenavd::Event event;
    for (std::int32_t& number : event)
      number = static_cast<std::int32_t>(random());
    event[0] = static_cast<std::int32_t>(random() % 4);
    this->Daemon.Send(event);
    this->Read();
    for (int axis = 0; axis < 3; ++axis)
    {
      ASSERT_LE(std::abs(this->State.push[axis]), 1.0); // NaN is not
      ASSERT_LE(std::abs(this->State.turn[axis]), 1.0);
    }
  }
}

TEST_F(SpacenavSocketTest, WithoutADaemonItIsAbsent)
{
  EXPECT_EQ(TroubleOf([&] { this->Source.Open({}); }), DeviceTrouble::Absent);
  this->Daemon.Begin();
  this->Daemon.End(); // its file is left
  EXPECT_EQ(TroubleOf([&] { this->Source.Open({}); }), DeviceTrouble::Absent);
  SpacenavSocket folder(std::filesystem::temp_directory_path().string());
  EXPECT_EQ(TroubleOf([&] { folder.Open({}); }), DeviceTrouble::Absent);
}

TEST_F(SpacenavSocketTest, APathThatIsNoneIsTold)
{
  for (const std::string& path : { std::string(), std::string(108, 'x') })
  {
    SpacenavSocket none(path);
    EXPECT_EQ(TroubleOf([&] { none.Open({}); }), DeviceTrouble::Address);
  }
}

TEST_F(SpacenavSocketTest, ADaemonThatTakesNoMoreIsBusy)
{
  this->Daemon.Begin(0);
  std::vector<std::unique_ptr<SpacenavSocket>> others;
  const auto one = [&]
  {
    others.push_back(std::make_unique<SpacenavSocket>(this->Daemon.Path()));
    others.back()->Open({});
  };
  EXPECT_EQ(TroubleOf(
              [&]
              {
                for (int n = 0; n < 100; ++n)
                  one();
              }),
    DeviceTrouble::Busy);
}

/// A wait that a signal ends is no news, and no trouble.
TEST_F(SpacenavSocketTest, ASignalIsNoTrouble)
{
  static volatile std::sig_atomic_t signals;
  signals = 0;
  struct sigaction handle = {}, before = {};
  handle.sa_handler = [](int) { signals = signals + 1; };
  ASSERT_EQ(sigaction(SIGALRM, &handle, &before), 0);
  this->Connect();
  const itimerval often{ { 0, 500 }, { 0, 500 } };
  ASSERT_EQ(setitimer(ITIMER_REAL, &often, nullptr), 0);
  while (signals < 20)
    EXPECT_FALSE(this->Source.Read(this->State, 20).push);
  const itimerval never{};
  setitimer(ITIMER_REAL, &never, nullptr);
  sigaction(SIGALRM, &before, nullptr);
  this->Daemon.Motion(std::array{ 500, 0, 0, 0, 0, 0 });
  EXPECT_TRUE(this->Read().push);
}

/// Root may do all: it is asked as somebody else.
TEST_F(SpacenavSocketTest, ASocketOfOthersIsForbidden)
{
  this->Daemon.Begin();
  ASSERT_EQ(chmod(this->Daemon.Path().c_str(), 0), 0);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0)
  {
    if (geteuid() == 0 && setresuid(65534, 65534, 65534) != 0)
      _exit(2);
    try
    {
      this->Source.Open({});
    }
    catch (const DeviceError& error)
    {
      _exit(error.trouble == DeviceTrouble::Permission ? 0 : 3);
    }
    _exit(4);
  }
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
}

TEST_F(SpacenavSocketTest, IsCancelledBeforeItOpens)
{
  this->Daemon.Begin();
  EXPECT_THROW(this->Source.Open({ .cancelled = [] { return true; } }), Cancelled);
}

/// A thousand times the daemon ends in the middle of an event and comes back; no handle is left.
TEST_F(SpacenavSocketTest, TheDaemonGoesAndComesBack)
{
  const auto handles = []
  {
    return std::distance(
      std::filesystem::directory_iterator("/proc/self/fd"), std::filesystem::directory_iterator{});
  };
  const auto before = handles();
  std::mt19937 random(1);
  for (int n = 0; n < 1000; ++n)
  {
    this->Connect();
    this->Daemon.Motion(std::array{ 500, 0, 0, 0, 0, 0 });
    const FakeSpacenavd::Event event{};
    this->Daemon.SendBytes(event.data(), random() % sizeof event);
    ASSERT_TRUE(this->Read().push);
    this->Daemon.End();
    ASSERT_EQ(TroubleOf([&] { this->Read(); }), DeviceTrouble::Gone);
    this->Source.Close();
    this->Source.Close(); // and nothing more
  }
  EXPECT_EQ(handles(), before);
}

/// What was said before it ended is heard first; nothing of a stream before reaches the next one.
TEST_F(SpacenavSocketTest, HalfAnEventIsForgotten)
{
  this->Connect();
  const FakeSpacenavd::Event event{ 1, 3 };
  this->Daemon.SendBytes(event.data(), 20);
  this->Read();
  this->Source.Close();
  this->Source.Open({});
  this->Daemon.Accept();
  this->Daemon.Send({ 1, 4 });
  this->Read();
  EXPECT_EQ(this->State.buttons, 1u << 4);
}

} // namespace
