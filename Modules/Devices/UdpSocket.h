#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace hasp
{

/// A datagram that came: its real size, and when it reached this machine (SteadySeconds).
struct Datagram
{
  std::size_t bytes = 0;
  double timeS = 0.0;
};

/// A UDP socket that receives (IPv4), for one thread. Never blocks.
class UdpSocket
{
public:
  /// address  "127.0.0.1": this machine alone; "0.0.0.0": anybody who reaches it
  /// port     0: a free one, see Port
  /// Throws std::invalid_argument if that is no IPv4 address, std::runtime_error if the port is in
  /// use or not allowed, with what to do.
  UdpSocket(const std::string& address, std::uint16_t port);
  ~UdpSocket();
  UdpSocket(const UdpSocket&) = delete;
  UdpSocket& operator=(const UdpSocket&) = delete;

  int Descriptor() const noexcept { return this->Handle; } ///< to poll
  std::uint16_t Port() const noexcept { return this->Bound; }
  bool LoopbackOnly() const noexcept { return this->Loopback; }

  /// The next datagram's bytes; what does not fit is cut off, and the size is the real one. Its
  /// time is the kernel's, however long it waited here; never before that of the one before it, nor
  /// yet to come, whatever the wall clock does. Nothing if none is there. Throws std::system_error
  /// if the socket is broken.
  std::optional<Datagram> Receive(std::span<std::byte> buffer);

private:
  int Handle = -1;
  std::uint16_t Bound = 0;
  bool Loopback = true;
  double LastS = 0.0; ///< when the last datagram came, or the socket
};

} // namespace hasp
