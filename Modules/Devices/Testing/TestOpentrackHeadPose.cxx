#include "Devices/OpentrackHeadPose.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <thread>

namespace
{

/// A real socket that sends to a port of this machine.
class Sender
{
public:
  explicit Sender(std::uint16_t port) : Handle(socket(AF_INET, SOCK_DGRAM, 0))
  {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(port);
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(this->Handle, reinterpret_cast<sockaddr*>(&to), sizeof to), 0);
  }
  ~Sender() { close(this->Handle); }
  void Send(std::span<const std::byte> bytes) const
  {
    EXPECT_EQ(send(this->Handle, bytes.data(), bytes.size(), 0), ssize_t(bytes.size()));
  }
  /// To whoever may be gone by then: the system says so to the next one who sends.
  void SendInVain(std::span<const std::byte> bytes) const
  {
    [[maybe_unused]] const ssize_t sent = send(this->Handle, bytes.data(), bytes.size(), 0);
  }
  void SendAt(double xMm) const
  {
    this->Send(hasp::MakeOpentrackPacket({ { xMm, 0, 0 }, { 1, 0, 0, 0 } }));
  }

private:
  int Handle;
};

/// Asks until it is so, at most ten seconds: what is sent on loopback arrives, but not at once.
bool Until(const std::function<bool()>& so)
{
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (!so())
  {
    if (std::chrono::steady_clock::now() > end)
      return false;
    std::this_thread::yield();
  }
  return true;
}

bool Counted(hasp::OpentrackHeadPose& source, std::uint64_t packets)
{
  return Until(
    [&]
    {
      source.Latest(0.0);
      return source.Counts().packets >= packets;
    });
}

std::size_t Threads()
{
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& task : std::filesystem::directory_iterator("/proc/self/task"))
    ++count;
  return count;
}

const hasp::OpentrackSettings AnyPort{ .port = 0 };

TEST(OpentrackHeadPose, APortInUseIsSaidWithTheRemedy)
{
  const hasp::OpentrackHeadPose first(AnyPort);
  try
  {
    const hasp::OpentrackHeadPose second({ .port = first.Port() });
    ADD_FAILURE() << "both listen";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_EQ(std::string(error.what()),
      "opentrack: UDP port " + std::to_string(first.Port()) +
        " is in use by another program (or another Hasp); end that, or choose another port here and"
        " in the sender");
  }
}

TEST(OpentrackHeadPose, WrongSettingsAreRefused)
{
  EXPECT_THROW(
    hasp::OpentrackHeadPose({ .address = "localhost", .port = 0 }), std::invalid_argument);
  EXPECT_THROW(hasp::OpentrackHeadPose({ .address = "192.0.2.1", .port = 0 }), std::runtime_error);
  EXPECT_THROW(
    hasp::OpentrackHeadPose({ .port = 0, .origin = glm::dvec3(NAN) }), std::invalid_argument);
}

TEST(OpentrackHeadPose, ThreadAndSocketAreThereWithItAndGoWithIt)
{
  std::thread([] {}).join(); // sanitizers start a thread of theirs with the first
  const std::size_t before = Threads();
  std::uint16_t port = 0;
  {
    const hasp::OpentrackHeadPose source(AnyPort);
    port = source.Port();
    EXPECT_EQ(Threads(), before + 1);
  }
  EXPECT_TRUE(Until([&] { return Threads() == before; })); // joined; the kernel's list may lag
  EXPECT_NO_THROW(hasp::OpentrackHeadPose({ .port = port })) << "the port is free again";
}

/// Ends although packets come all the time, and although none ever came: no case may hang.
TEST(OpentrackHeadPose, EndsAtOnce)
{
  for (int n = 0; n < 50; ++n)
    const hasp::OpentrackHeadPose idle(AnyPort);
  for (int n = 0; n < 5; ++n)
  {
    auto source = std::make_unique<hasp::OpentrackHeadPose>(AnyPort);
    const Sender sender(source->Port());
    const std::jthread flood(
      [&](const std::stop_token& stop)
      {
        const auto packet = hasp::MakeOpentrackPacket({});
        while (!stop.stop_requested())
          sender.SendInVain(packet);
      });
    EXPECT_TRUE(Counted(*source, 100));
    source.reset();
  }
}

TEST(OpentrackHeadPose, PosesArriveInRoomCoordinatesWithTheTimeTheyCame)
{
  hasp::OpentrackHeadPose source(AnyPort);
  EXPECT_FALSE(source.Latest(0.0));
  EXPECT_TRUE(source.TakeWarnings().empty());
  const Sender sender(source.Port());
  const double before = hasp::SteadySeconds();
  const hasp::HeadPose sent{ { 12, -34, 56 }, hasp::HeadOrientation(0.2, -0.1, 0.05) };
  sender.Send(hasp::MakeOpentrackPacket(sent));
  ASSERT_TRUE(Counted(source, 1));
  const auto pose = source.Latest(0.0);
  ASSERT_TRUE(pose);
  EXPECT_LT(glm::length(pose->pose.position - glm::dvec3(12, -34, 656)), 1e-12);
  EXPECT_NEAR(std::abs(glm::dot(pose->pose.orientation, sent.orientation)), 1.0, 1e-14);
  EXPECT_GE(pose->timeS, before);
  EXPECT_LE(pose->timeS, hasp::SteadySeconds());
  EXPECT_EQ(source.Latest(1e9)->timeS, pose->timeS) << "nothing new: the same again";
  EXPECT_STREQ(source.Name(), "opentrack");
}

TEST(OpentrackHeadPose, TheNewestPoseWins)
{
  hasp::OpentrackHeadPose source(AnyPort);
  const Sender sender(source.Port());
  for (int x = 1; x <= 100; ++x)
  {
    sender.SendAt(x);
    ASSERT_TRUE(Counted(source, x)); // one by one: the kernel drops what it has no room for
  }
  EXPECT_NEAR(source.Latest(0.0)->pose.position.x, 100.0, 1e-9);
}

TEST(OpentrackHeadPose, FaultyPacketsLeaveTheViewAndWarnOnceAKind)
{
  hasp::OpentrackHeadPose source(AnyPort);
  const Sender sender(source.Port());
  sender.SendAt(5);
  ASSERT_TRUE(Counted(source, 1));
  const auto good = source.Latest(0.0);
  ASSERT_TRUE(good);

  std::vector<std::byte> bytes(60'000, std::byte{ 0x41 });
  auto nan = hasp::MakeOpentrackPacket({});
  std::fill(nan.begin(), nan.begin() + 8, std::byte{ 0xFF });
  auto huge = hasp::MakeOpentrackPacket({});
  huge[7] = std::byte{ 0x7E };
  std::uint64_t packets = 1;
  for (int round = 0; round < 3; ++round)
    for (const std::span<const std::byte> faulty :
      { std::span<const std::byte>(bytes).first(0), std::span<const std::byte>(bytes).first(47),
        std::span<const std::byte>(bytes).first(49), std::span<const std::byte>(bytes),
        std::span<const std::byte>(nan), std::span<const std::byte>(huge) })
    {
      sender.Send(faulty);
      ASSERT_TRUE(Counted(source, ++packets));
      EXPECT_EQ(source.Latest(0.0)->timeS, good->timeS);
      EXPECT_EQ(source.Latest(0.0)->pose.position, good->pose.position);
    }
  const hasp::OpentrackCounts counts = source.Counts();
  EXPECT_EQ(counts.good, 1u);
  EXPECT_EQ(counts.tooShort, 6u);
  EXPECT_EQ(counts.tooLong, 6u);
  EXPECT_EQ(counts.notFinite, 3u);
  EXPECT_EQ(counts.outOfRange, 3u);
  const std::vector<std::string> warnings = source.TakeWarnings();
  ASSERT_EQ(warnings.size(), 4u);
  EXPECT_EQ(warnings[0],
    "opentrack: 6 packets shorter than 48 bytes; is something else sending to this port?");
  EXPECT_TRUE(source.TakeWarnings().empty()) << "once";
  sender.Send(nan);
  ASSERT_TRUE(Counted(source, ++packets));
  EXPECT_TRUE(source.TakeWarnings().empty()) << "once in its life";
}

TEST(OpentrackHeadPose, AFloodIsSurvivedAndSaid)
{
  hasp::OpentrackHeadPose source(AnyPort);
  const Sender sender(source.Port());
  std::vector<std::string> warnings;
  ASSERT_TRUE(Until(
    [&]
    {
      for (int n = 0; n < 200; ++n)
        sender.SendAt(n);
      source.Latest(0.0);
      const auto more = source.TakeWarnings();
      warnings.insert(warnings.end(), more.begin(), more.end());
      return source.Counts().flooding > 0;
    }));
  const auto more = source.TakeWarnings();
  warnings.insert(warnings.end(), more.begin(), more.end());
  EXPECT_EQ(std::count_if(warnings.begin(), warnings.end(),
              [](const std::string& w) { return w.find("beyond 4000") != std::string::npos; }),
    1);
  EXPECT_TRUE(source.Latest(0.0));
}

TEST(OpentrackHeadPose, ListeningBeyondThisMachineIsSaid)
{
  hasp::OpentrackHeadPose source({ .address = "0.0.0.0", .port = 0 });
  const std::vector<std::string> warnings = source.TakeWarnings();
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("others may move the view"), std::string::npos);
}

} // namespace
