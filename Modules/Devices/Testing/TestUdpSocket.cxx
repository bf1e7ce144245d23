#include "Devices/HeadPose.h"
#include "Devices/OpentrackInbox.h"
#include "Devices/UdpSocket.h"

#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <thread>

namespace
{

class UdpSocketTest : public ::testing::Test
{
protected:
  UdpSocketTest() : Receiver("127.0.0.1", 0), Sender(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0))
  {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(this->Receiver.Port());
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(this->Sender, reinterpret_cast<sockaddr*>(&to), sizeof to), 0);
  }
  ~UdpSocketTest() override { close(this->Sender); }

  void Send(std::span<const std::byte> bytes) const
  {
    EXPECT_EQ(send(this->Sender, bytes.data(), bytes.size(), 0), ssize_t(bytes.size()));
  }
  hasp::Datagram Receive()
  {
    for (const double end = hasp::SteadySeconds() + 10.0; hasp::SteadySeconds() < end;)
      if (const auto came = this->Receiver.Receive(this->Buffer))
        return *came;
    ADD_FAILURE() << "nothing came";
    return {};
  }
  static void LetPass(double seconds)
  {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  }
  /// The kernel begins to stamp a while after it is first asked to.
  void UntilStamped()
  {
    for (int n = 0; n < 1000; ++n)
    {
      this->Send(this->Packet);
      LetPass(0.002);
      const hasp::Datagram came = this->Receive();
      if (hasp::SteadySeconds() - came.timeS > 0.001)
        return;
    }
    ADD_FAILURE() << "never stamped";
  }

  hasp::UdpSocket Receiver;
  std::array<std::byte, 64> Buffer{};
  const std::array<std::byte, hasp::OpentrackPacketBytes> Packet = hasp::MakeOpentrackPacket({});

private:
  int Sender;
};

/// A program that stalls finds several packets at once: each came when it came, and one that is the
/// same as the one before is a head that keeps still.
TEST_F(UdpSocketTest, PacketsThatWaitedCameWhenTheyCame)
{
  this->UntilStamped();
  hasp::OpentrackInbox inbox({ 0, 0, 600 });
  double before[3], after[3];
  for (int n = 0; n < 3; ++n)
  {
    before[n] = hasp::SteadySeconds();
    this->Send(this->Packet);
    after[n] = hasp::SteadySeconds();
    LetPass(0.004);
  }
  LetPass(0.1); // the stall
  for (int n = 0; n < 3; ++n)
  {
    const hasp::Datagram came = this->Receive();
    EXPECT_EQ(came.bytes, this->Packet.size());
    // Two clocks are read one after the other: as far apart as a thread may be put off in between.
    EXPECT_GE(came.timeS, before[n] - 1e-5) << n;
    EXPECT_LE(came.timeS, after[n] + 0.05) << n;
    EXPECT_TRUE(inbox.Take(this->Packet, came.timeS)) << n;
  }
  EXPECT_EQ(inbox.Counts().duplicated, 0u);
  EXPECT_EQ(inbox.Counts().good, 3u);
}

TEST_F(UdpSocketTest, TimesDoNotGoBackAndAreNotToCome)
{
  double last = hasp::SteadySeconds() - 1.0;
  for (int n = 0; n < 1000; ++n)
  {
    this->Send(this->Packet);
    const hasp::Datagram came = this->Receive();
    EXPECT_GE(came.timeS, last);
    EXPECT_LE(came.timeS, hasp::SteadySeconds());
    last = came.timeS;
  }
}

TEST_F(UdpSocketTest, WhatDoesNotFitIsCutOffAndItsSizeTold)
{
  EXPECT_FALSE(this->Receiver.Receive(this->Buffer));
  const std::vector<std::byte> large(500);
  this->Send(large);
  EXPECT_EQ(this->Receive().bytes, 500u);
  this->Send({});
  EXPECT_EQ(this->Receive().bytes, 0u);
  EXPECT_FALSE(this->Receiver.Receive(this->Buffer));
}

} // namespace
