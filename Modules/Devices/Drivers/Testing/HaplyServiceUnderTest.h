#pragma once
#include <glm/vec3.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// What a service says of one Inverse3 at that place, metres and its own axes, and of a grip.
std::string InverseMessage(const glm::dvec3& positionM, const std::string& more = {});

/// What the service does with a connection.
struct HaplyScript
{
  enum class End
  {
    Never,        ///< serves until the other side leaves
    AtOnce,       ///< accepts and cuts
    InHandshake,  ///< cuts in its answer to the handshake
    BeforeAll,    ///< shakes hands and cuts
    InMessage,    ///< cuts in the middle of message `last`
    AfterMessage, ///< cuts after message `last`
    Silent,       ///< accepts and never says anything
    Drip,         ///< answers the handshake a byte now and a byte then
    EndlessHeader,
    NotFound,    ///< is a web server
    NotSpeaking, ///< answers something that is no HTTP
    HalfHeld     ///< keeps the second half of message `last` back until it is asked once more
  };
  End end = End::Never;
  int last = 0;
  bool reset = false; ///< cuts with a TCP reset instead of an end

  /// What it says: 0 when the connection is there, n after the n-th command; nothing: silence.
  std::function<std::optional<std::string>(int n)> message = [](int n) {
    return std::optional(InverseMessage({ 0.001 * n, -0.12, 0.15 }));
  };
  int repeats = 1; ///< how often it says each; `message` is asked for each
};

/// A Haply Inverse Service without a device, on a free port of this machine: one connection at a
/// time, on a thread of its own.
class HaplyServiceUnderTest
{
public:
  explicit HaplyServiceUnderTest(const HaplyScript& script = {});
  ~HaplyServiceUnderTest();

  std::uint16_t Port() const;
  std::string Address() const { return "ws://127.0.0.1:" + std::to_string(this->Port()); }

  void Play(const HaplyScript& script); ///< for the connections after this

  /// Waits until that many connections have come and gone.
  void AwaitEnds(int connections) const;

  // What was heard so far, in all connections.
  std::vector<glm::dvec3> Forces() const; ///< N, the service's axes
  std::vector<std::string> Ids() const;   ///< whom each was for
  int Goodbyes() const;                   ///< connections that were closed as they should be
  int Strange() const;                    ///< messages that are no such command

private:
  class Impl;
  std::unique_ptr<Impl> Self;
};

/// A port of this machine where nobody listens, nor can while this is there.
class DeafPort
{
public:
  DeafPort();
  ~DeafPort();
  DeafPort(const DeafPort&) = delete;
  DeafPort& operator=(const DeafPort&) = delete;
  std::string Address() const { return "ws://127.0.0.1:" + std::to_string(this->Port); }

private:
  int Handle;
  std::uint16_t Port = 0;
};
