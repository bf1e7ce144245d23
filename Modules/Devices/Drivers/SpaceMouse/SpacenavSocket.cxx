#include "Devices/Drivers/SpaceMouse/SpacenavSocket.h"

#include "Devices/Drivers/SpaceMouse/SixDofAxes.h"
#include "Grid/Progress.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace hasp
{

namespace
{
constexpr AxisRanges Promised{ { { -500, 500 }, { -500, 500 }, { -500, 500 }, { -500, 500 },
  { -500, 500 }, { -500, 500 } } };
constexpr int MostWrongInARow = 64;
constexpr std::int32_t MostButtons = 256; // that any device has; a larger number is none
constexpr int MostReceives = 16;          // of one read: a daemon that floods does not keep us

DeviceError WhyNotOpen(int error)
{
  switch (error)
  {
    case ENOENT:
    case ECONNREFUSED:
    case ENOTSOCK:
    case EPROTOTYPE:
      return { DeviceTrouble::Absent,
        "spacenavd does not run: install and start it, or plug the SpaceMouse in here" };
    case EACCES:
    case EPERM:
      return { DeviceTrouble::Permission,
        "spacenavd runs, and this user may not talk to it: change who may use its socket" };
    case EAGAIN:
      return { DeviceTrouble::Busy,
        "spacenavd takes no more programs now: end one that uses it, or try again" };
    default:
      return { DeviceTrouble::Absent, "spacenavd cannot be reached (" +
                                        std::generic_category().message(error) +
                                        "): start it anew" };
  }
}

DeviceError WhyGone()
{
  return { DeviceTrouble::Gone,
    "spacenavd has ended: start it again, and the SpaceMouse goes on by itself" };
}
} // namespace

SpacenavSocket::SpacenavSocket(std::string path) : Path(std::move(path)) {}

SpacenavSocket::~SpacenavSocket()
{
  this->Close();
}

void SpacenavSocket::Open(const DriverOpening& how)
{
  this->Close();
  if (how.cancelled())
    throw Cancelled();
  how.says("asking spacenavd");
  sockaddr_un where{};
  where.sun_family = AF_UNIX;
  if (this->Path.empty() || this->Path.size() >= sizeof where.sun_path)
    throw DeviceError(DeviceTrouble::Address, "the path of spacenavd's socket must have 1 to " +
                                                std::to_string(sizeof where.sun_path - 1) +
                                                " characters: as a rule it is " + StandardPath);
  std::memcpy(where.sun_path, this->Path.c_str(), this->Path.size() + 1);

  this->Handle = socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (this->Handle < 0)
    throw WhyNotOpen(errno);
  if (connect(this->Handle, reinterpret_cast<const sockaddr*>(&where), sizeof where) != 0)
  {
    const int error = errno;
    this->Close();
    throw WhyNotOpen(error);
  }
  this->Wrong = 0;
}

SixDofNews SpacenavSocket::Read(SixDofState& state, int waitMs)
{
  SixDofNews news;
  pollfd ready{ this->Handle, POLLIN, 0 };
  if (poll(&ready, 1, waitMs) < 0 && errno != EINTR) // a signal ends the wait, and no more
    throw WhyGone();
  for (int n = 0; n < MostReceives; ++n)
  {
    const std::size_t came = this->Receive();
    if (came == 0)
      break;
    this->Held += came;
    std::size_t taken = 0;
    for (; this->Held - taken >= sizeof(Event); taken += sizeof(Event))
    {
      Event event;
      std::memcpy(event.data(), this->Buffer.data() + taken, sizeof event);
      const SixDofNews more = this->Take(event, state);
      news = { news.push || more.push, news.turn || more.turn };
    }
    this->Held -= taken;
    std::memmove(this->Buffer.data(), this->Buffer.data() + taken, this->Held);
  }
  return news;
}

/// Bytes that came now, 0 if none are there. What is held is less than an event, so there is room.
std::size_t SpacenavSocket::Receive()
{
  const ssize_t bytes =
    recv(this->Handle, this->Buffer.data() + this->Held, this->Buffer.size() - this->Held, 0);
  if (bytes > 0)
    return static_cast<std::size_t>(bytes);
  if (bytes < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR))
    return 0;
  throw WhyGone();
}

SixDofNews SpacenavSocket::Take(const Event& event, SixDofState& state)
{
  const std::span<const std::int32_t, 6> numbers(event.data() + 1, 6);
  const std::int32_t button = event[1];
  const bool heard = button >= 0 && button < 32;
  const std::uint32_t bit = heard ? 1u << button : 0u;
  switch (event[0])
  {
    case 0:
      this->WrongInARow = 0;
      state.push = DeviceDeflections(numbers, Promised, SpacenavAxes, 0);
      state.turn = DeviceDeflections(numbers, Promised, SpacenavAxes, 3);
      return { true, true };
    case 1:
    case 2:
      if (button >= 32 && button < MostButtons)
        return {}; // one that is not heard
      if (!heard)
        break;
      this->WrongInARow = 0;
      state.buttons = event[0] == 1 ? state.buttons | bit : state.buttons & ~bit;
      return {};
    default:
      break;
  }
  ++this->Wrong;
  if (++this->WrongInARow >= MostWrongInARow)
    throw DeviceError(DeviceTrouble::Protocol,
      "spacenavd says what cannot be: start it anew, or read the SpaceMouse without it");
  return {};
}

void SpacenavSocket::Close() noexcept
{
  if (this->Handle >= 0)
    close(this->Handle);
  this->Handle = -1;
  this->Held = 0;
  this->WrongInARow = 0;
}

} // namespace hasp
