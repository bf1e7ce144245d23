#include "Devices/UdpSocket.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>

namespace hasp
{

namespace
{
std::string WhyNotBound(int error, std::uint16_t port)
{
  const std::string which = "UDP port " + std::to_string(port);
  switch (error)
  {
    case EADDRINUSE:
      return which + " is in use by another program (or another Hasp); end that, or choose another"
                     " port here and in the sender";
    case EACCES:
      return which + " may not be opened by this user; choose one above 1023";
    case EADDRNOTAVAIL:
      return "the address to listen at is none of this machine's; 127.0.0.1 always is";
    default:
      return which + " cannot be opened: " + std::generic_category().message(error);
  }
}
} // namespace

UdpSocket::UdpSocket(const std::string& address, std::uint16_t port)
{
  sockaddr_in where{};
  where.sin_family = AF_INET;
  where.sin_port = htons(port);
  if (inet_pton(AF_INET, address.c_str(), &where.sin_addr) != 1)
    throw std::invalid_argument(
      "the address to listen at must be IPv4 such as 127.0.0.1 (this machine alone)");
  this->Loopback = ntohl(where.sin_addr.s_addr) >> 24 == 127;

  this->Handle = socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (this->Handle < 0)
    throw std::runtime_error("no socket: " + std::generic_category().message(errno));
  socklen_t size = sizeof where;
  if (bind(this->Handle, reinterpret_cast<const sockaddr*>(&where), size) != 0 ||
      getsockname(this->Handle, reinterpret_cast<sockaddr*>(&where), &size) != 0)
  {
    const int error = errno;
    close(this->Handle);
    throw std::runtime_error(WhyNotBound(error, port));
  }
  this->Bound = ntohs(where.sin_port);
}

UdpSocket::~UdpSocket()
{
  close(this->Handle);
}

std::optional<std::size_t> UdpSocket::Receive(std::span<std::byte> buffer)
{
  for (;;)
  {
    const ssize_t bytes = recv(this->Handle, buffer.data(), buffer.size(), MSG_TRUNC);
    if (bytes >= 0)
      return static_cast<std::size_t>(bytes);
    if (errno == EAGAIN || errno == EWOULDBLOCK)
      return std::nullopt;
    if (errno != EINTR)
      throw std::system_error(errno, std::generic_category(), "the socket is broken");
  }
}

} // namespace hasp
