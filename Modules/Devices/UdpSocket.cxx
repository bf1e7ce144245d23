#include "Devices/UdpSocket.h"

#include "Devices/HeadPose.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
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

/// How long ago the kernel took a datagram in, by the wall clock it stamps with; 0 if it did not.
double AgeS(msghdr& message)
{
  for (cmsghdr* part = CMSG_FIRSTHDR(&message); part; part = CMSG_NXTHDR(&message, part))
    if (part->cmsg_level == SOL_SOCKET && part->cmsg_type == SCM_TIMESTAMPNS)
    {
      timespec came{}, now{};
      std::memcpy(&came, CMSG_DATA(part), sizeof came);
      clock_gettime(CLOCK_REALTIME, &now);
      return static_cast<double>(now.tv_sec - came.tv_sec) +
             1e-9 * static_cast<double>(now.tv_nsec - came.tv_nsec);
    }
  return 0.0;
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
  const int on = 1; // where it cannot be, a datagram came when it is read
  setsockopt(this->Handle, SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof on);
  this->Bound = ntohs(where.sin_port);
  this->LastS = SteadySeconds();
}

UdpSocket::~UdpSocket()
{
  close(this->Handle);
}

std::optional<Datagram> UdpSocket::Receive(std::span<std::byte> buffer)
{
  for (;;)
  {
    iovec where{ buffer.data(), buffer.size() };
    alignas(cmsghdr) std::array<std::byte, CMSG_SPACE(sizeof(timespec))> stamp{};
    msghdr message{};
    message.msg_iov = &where;
    message.msg_iovlen = 1;
    message.msg_control = stamp.data();
    message.msg_controllen = stamp.size();
    const ssize_t bytes = recvmsg(this->Handle, &message, MSG_TRUNC);
    if (bytes >= 0)
    {
      const double age = AgeS(message), now = SteadySeconds();
      this->LastS = std::clamp(now - age, this->LastS, now);
      return Datagram{ static_cast<std::size_t>(bytes), this->LastS };
    }
    if (errno == EAGAIN || errno == EWOULDBLOCK)
      return std::nullopt;
    if (errno != EINTR)
      throw std::system_error(errno, std::generic_category(), "the socket is broken");
  }
}

} // namespace hasp
