#include "Devices/Drivers/Haply/WebSocketClient.h"
#include "Grid/Progress.h"
#include "HaplyServiceUnderTest.h"

#include <gtest/gtest.h>

namespace
{

using hasp::ParseWebSocketAddress;
using hasp::WebSocketClient;
using hasp::WebSocketError;
using std::chrono::milliseconds;

constexpr milliseconds Long{ 60'000 }; // what must come comes far sooner, on any machine

TEST(WebSocketAddress, IsTakenApart)
{
  const auto plain = ParseWebSocketAddress("ws://localhost:10001");
  EXPECT_EQ(plain.host, "localhost");
  EXPECT_EQ(plain.port, 10001);
  EXPECT_EQ(plain.path, "/");
  EXPECT_TRUE(plain.loopback);
  const auto six = ParseWebSocketAddress("ws://[::1]:7/a/b?c:d");
  EXPECT_EQ(six.host, "::1");
  EXPECT_EQ(six.port, 7);
  EXPECT_EQ(six.path, "/a/b?c:d");
  EXPECT_TRUE(six.loopback);
  EXPECT_EQ(ParseWebSocketAddress("ws://[::1]").port, 80);
  EXPECT_TRUE(ParseWebSocketAddress("ws://127.9.9.9:1").loopback);
  for (const char* elsewhere : { "ws://192.168.1.7:10001", "ws://[2001:db8::1]:2", "ws://0.0.0.0:1",
         "ws://[::ffff:127.0.0.1]:3", "ws://128.0.0.1" })
    EXPECT_FALSE(ParseWebSocketAddress(elsewhere).loopback) << elsewhere;
}

TEST(WebSocketAddress, WhatIsNoneIsRefused)
{
  for (const char* text :
    { "", "localhost:10001", "wss://localhost", "http://localhost", "ws://", "ws://:1",
      "ws://localhost:", "ws://localhost:0", "ws://localhost:65536", "ws://localhost:1x",
      "ws://localhost:-1", "ws://example.org:10001", "ws://localhost.example.org", "ws://::1:80",
      "ws://[::1", "ws://[127.0.0.1]:1", "ws://[localhost]:1", "ws://127.0.0.1.:1", "ws://1.2.3",
      "ws://user@localhost:1", "ws://localhost:1/a b", "ws://localhost:1/\r\nX: y", "ws://[]:1" })
    EXPECT_THROW(ParseWebSocketAddress(text), std::invalid_argument) << text;
}

HaplyScript Texts(std::function<std::optional<std::string>(int)> message)
{
  HaplyScript script;
  script.message = std::move(message);
  return script;
}

TEST(WebSocketClient, WithoutAConnectionNothingGoes)
{
  WebSocketClient client;
  EXPECT_FALSE(client.IsOpen());
  EXPECT_THROW(client.Send("x", Long), WebSocketError);
  EXPECT_THROW(client.Receive(Long), WebSocketError);
  client.Close(Long); // nothing
}

TEST(WebSocketClient, MessagesGoBothWays)
{
  HaplyServiceUnderTest service(Texts([](int n) { return std::to_string(n); }));
  WebSocketClient client;
  client.Connect(ParseWebSocketAddress(service.Address()), Long);
  for (int n = 0; n < 1000; ++n)
  {
    EXPECT_EQ(client.Receive(Long), std::to_string(n));
    EXPECT_EQ(client.Receive(milliseconds(0)), std::nullopt) << "it answers once";
    client.Send("no command", Long);
  }
  client.Close(Long);
  service.AwaitEnds(1);
  EXPECT_EQ(service.Strange(), 1000);
  EXPECT_EQ(service.Goodbyes(), 1);
}

TEST(WebSocketClient, LocalhostIsThisMachine)
{
  HaplyServiceUnderTest service;
  WebSocketClient client;
  client.Connect(ParseWebSocketAddress("ws://localhost:" + std::to_string(service.Port())), Long);
  EXPECT_TRUE(client.Receive(Long));
}

TEST(WebSocketClient, TheNewestIsGivenAndThoseBeforeDropped)
{
  int said = 0;
  HaplyScript script = Texts([&said](int) { return std::to_string(said++); });
  script.repeats = 100;
  HaplyServiceUnderTest service(script);
  WebSocketClient client;
  client.Connect(ParseWebSocketAddress(service.Address()), Long);
  int last = -1, given = 0;
  while (last < 99)
  {
    const auto text = client.Receive(Long);
    ASSERT_TRUE(text);
    EXPECT_GT(std::stoi(*text), last);
    last = std::stoi(*text);
    ++given;
  }
  EXPECT_EQ(client.Receive(milliseconds(0)), std::nullopt);
  EXPECT_LE(given, 100);
}

TEST(WebSocketClient, WhatCameInPartIsKept)
{
  HaplyScript script = Texts([](int n) { return "message " + std::to_string(n); });
  script.end = HaplyScript::End::HalfHeld;
  script.last = 1;
  HaplyServiceUnderTest service(script);
  WebSocketClient client;
  client.Connect(ParseWebSocketAddress(service.Address()), Long);
  EXPECT_EQ(client.Receive(Long), "message 0");
  client.Send("a", Long);
  EXPECT_EQ(client.Receive(milliseconds(1)), std::nullopt);
  EXPECT_EQ(client.Receive(milliseconds(0)), std::nullopt);
  client.Send("b", Long);
  EXPECT_EQ(client.Receive(Long), "message 1");
}

TEST(WebSocketClient, AMessageOfAMebibyteComesAndALargerOneIsTheEnd)
{
  HaplyServiceUnderTest service(
    Texts([](int n) { return std::string(WebSocketClient::MostBytes + n, 'x'); }));
  WebSocketClient client;
  client.Connect(ParseWebSocketAddress(service.Address()), Long);
  EXPECT_EQ(client.Receive(Long)->size(), WebSocketClient::MostBytes);
  client.Send("more", Long);
  try
  {
    client.Receive(Long);
    ADD_FAILURE();
  }
  catch (const WebSocketError& error)
  {
    EXPECT_STREQ(error.what(), "a message is larger than 1 MiB");
  }
  EXPECT_FALSE(client.IsOpen());
}

/// Who does not read fills the system's buffers: to say more then takes until the time is up.
TEST(WebSocketClient, WhoDoesNotListenHoldsNobody)
{
  HaplyScript deaf = Texts([](int) { return std::string(60'000, 'x'); });
  deaf.repeats = 1 << 30; // too busy with what it has to say
  HaplyServiceUnderTest service(deaf);
  WebSocketClient client;
  client.Connect(ParseWebSocketAddress(service.Address()), Long);
  const std::string much(1 << 20, 'y');
  EXPECT_THROW(for (int n = 0; n < 1000; ++n) client.Send(much, milliseconds(50)), WebSocketError);
  EXPECT_FALSE(client.IsOpen());
}

TEST(WebSocketClient, WhoNeverShakesHandsHoldsNobody)
{
  for (const auto end : { HaplyScript::End::Silent, HaplyScript::End::Drip })
  {
    HaplyScript script;
    script.end = end;
    HaplyServiceUnderTest service(script);
    WebSocketClient client;
    const auto address = ParseWebSocketAddress(service.Address());
    EXPECT_THROW(client.Connect(address, milliseconds(100)), WebSocketError);
    EXPECT_FALSE(client.IsOpen());
    int asked = 0;
    EXPECT_THROW(client.Connect(address, Long, [&asked] { return ++asked > 3; }), hasp::Cancelled);
    EXPECT_FALSE(client.IsOpen());
  }
}

TEST(WebSocketClient, WhatIsNoSuchServiceIsToldFromWhatIsNone)
{
  const struct
  {
    HaplyScript::End end;
    bool answered;
  } cases[] = {
    { HaplyScript::End::NotFound, true },
    { HaplyScript::End::NotSpeaking, true },
    { HaplyScript::End::EndlessHeader, true },
    { HaplyScript::End::AtOnce, false },
    { HaplyScript::End::InHandshake, false },
  };
  for (const auto& c : cases)
  {
    HaplyScript script;
    script.end = c.end;
    HaplyServiceUnderTest service(script);
    WebSocketClient client;
    try
    {
      client.Connect(ParseWebSocketAddress(service.Address()), Long);
      ADD_FAILURE() << int(c.end);
    }
    catch (const WebSocketError& error)
    {
      EXPECT_EQ(error.answered, c.answered) << int(c.end) << " " << error.what();
    }
  }
  const DeafPort nobody;
  WebSocketClient client;
  EXPECT_THROW(client.Connect(ParseWebSocketAddress(nobody.Address()), Long), WebSocketError);
}

} // namespace
