// What a hostile network does to a picture that follows opentrack: nothing.
#include "Devices/OpentrackHeadPose.h"
#include "Devices/OpentrackPacket.h"
#include "StereoDesk.h"

#include <glm/geometric.hpp>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <vector>

namespace
{

using namespace hasp;
using hasp::testing::StereoDesk;

/// Sends to a port of this machine.
class Sender
{
public:
  explicit Sender(std::uint16_t port) : Socket(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0))
  {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(port);
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(this->Socket, reinterpret_cast<sockaddr*>(&to), sizeof to), 0);
  }
  ~Sender() { close(this->Socket); }
  void Send(const void* bytes, std::size_t size) const
  {
    EXPECT_EQ(send(this->Socket, bytes, size, 0), ssize_t(size));
  }
  void Send(const std::array<double, 6>& numbers) const { this->Send(numbers.data(), 48); }

private:
  int Socket;
};

class StereoViewOpentrack : public ::testing::Test
{
protected:
  StereoViewOpentrack()
  {
    OpentrackSettings settings;
    settings.port = 0; // a free one
    auto source = std::make_unique<OpentrackHeadPose>(settings);
    this->Port = source->Port();
    this->Desk = std::make_unique<StereoDesk>("mono", std::move(source));
  }
  glm::dvec3 Eye() const
  {
    const auto ray = this->Desk->eyes->RayOf(100, 75);
    return ray ? this->Desk->InRoom(ray->first) : glm::dvec3(0.0);
  }
  /// Frames until something holds; ten seconds are many times what it takes.
  template <typename Condition>
  void FireUntil(const Condition& holds) const
  {
    for (const double start = SteadySeconds(); !holds() && SteadySeconds() - start < 10.0;)
      ASSERT_TRUE(this->Desk->Fire());
    EXPECT_TRUE(holds());
  }
  int Said(const std::string& words) const
  {
    return int(std::count_if(this->Desk->said.begin(), this->Desk->said.end(),
      [&](const std::string& text) { return text.find(words) != text.npos; }));
  }

  std::uint16_t Port = 0;
  std::unique_ptr<StereoDesk> Desk;
};

TEST_F(StereoViewOpentrack, WhatIsNoPoseLeavesTheViewAndIsSaidOnce)
{
  const Sender sender(this->Port);
  const std::vector<std::byte> huge(20'000, std::byte(0x41));
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                   infinite = std::numeric_limits<double>::infinity();
  for (int times = 0; times < 3; ++times)
  {
    sender.Send(huge.data(), huge.size());
    sender.Send(huge.data(), 47);
    sender.Send(huge.data(), 0);
    sender.Send({ nan, 0, 0, 0, 0, 0 });
    sender.Send({ 0, 0, 0, 0, infinite, 0 });
    sender.Send({ 1e300, 0, 0, 0, 0, 0 });
    sender.Send({ 0, 0, 0, -1e9, 0, 0 });
  }
  const auto told = [&]
  {
    return this->Said("shorter than 48") && this->Said("longer than 48") &&
           this->Said("not finite") && this->Said("further than 10 m");
  };
  this->FireUntil(told);
  EXPECT_LT(glm::length(this->Eye() - glm::dvec3(0, 0, 600)), 1e-6);
  const auto texts = this->Desk->said.size();
  sender.Send({ nan, 0, 0, 0, 0, 0 });
  sender.Send(huge.data(), 47);
  // A good packet behind them: when it shows, those before it were looked at.
  HeadPose head;
  head.position = { 80.0, 30.0, -100.0 }; // from opentrack's centre
  const auto good = MakeOpentrackPacket(head);
  const auto there = [&]
  {
    sender.Send(good.data(), good.size());
    return glm::length(this->Eye() - glm::dvec3(80.0, 30.0, 500.0)) < 0.5;
  };
  this->FireUntil(there);
  EXPECT_EQ(this->Said("shorter than 48"), 1);
  EXPECT_EQ(this->Said("not finite"), 1);
  EXPECT_LE(this->Desk->said.size(), texts + 2) << "packets that came twice or late, at most";
}

TEST_F(StereoViewOpentrack, APoseThatStaysAwayLetsTheViewGoToRest)
{
  const Sender sender(this->Port);
  HeadPose head;
  head.position = { -120.0, 0.0, 0.0 };
  const auto pose = MakeOpentrackPacket(head);
  const auto there = [&]
  {
    sender.Send(pose.data(), pose.size());
    return glm::length(this->Eye() - glm::dvec3(-120.0, 0.0, 600.0)) < 0.5;
  };
  this->FireUntil(there);
  double largest = 0.0;
  glm::dvec3 last = this->Eye();
  const auto atRest = [&]
  {
    const glm::dvec3 eye = this->Eye();
    largest = std::max(largest, glm::length(eye - last));
    last = eye;
    return glm::length(eye - glm::dvec3(0, 0, 600)) < 0.5;
  };
  this->FireUntil(atRest);
  // A smooth step of 120 mm in 1.5 s goes 12 mm in 0.1 s, the most that a look at the tracker
  // counts; a frame takes two.
  EXPECT_LT(largest, 25.0) << "eased, not jumped";
  EXPECT_NE(this->Desk->view->Text().find("rest, no poses of opentrack"), std::string::npos)
    << this->Desk->view->Text();
}

} // namespace
