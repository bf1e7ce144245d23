#include "Devices/OpentrackHeadPose.h"

#include "Devices/UdpSocket.h"
#include "Realtime/SignalsBlocked.h"
#include "Realtime/TripleBuffer.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <thread>

namespace hasp
{

namespace
{
constexpr int PacketsAWake = 64;
constexpr int RestMs = 2; ///< after so many at once, while it floods

/// Set from one thread, polled by another.
class StopEvent
{
public:
  StopEvent() : Handle(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK))
  {
    if (this->Handle < 0)
      throw std::system_error(errno, std::generic_category(), "opentrack: no event to stop by");
  }
  ~StopEvent() { close(this->Handle); }
  StopEvent(const StopEvent&) = delete;
  StopEvent& operator=(const StopEvent&) = delete;
  void Set() const { eventfd_write(this->Handle, 1); }
  int Descriptor() const { return this->Handle; }

private:
  int Handle;
};

/// All that RENDER hears of the thread.
struct Snapshot
{
  TimedHeadPose newest; ///< if counts.good > 0
  OpentrackCounts counts;
  int socketError = 0;
};
} // namespace

class OpentrackHeadPose::Receiver
{
public:
  explicit Receiver(const OpentrackSettings& settings)
    : Socket(settings.address, settings.port),
      Inbox(settings.origin)
  {
    const SignalsBlocked inherited;
    this->Thread = std::thread([this] { this->Run(); });
  }
  ~Receiver()
  {
    this->Stop.Set();
    this->Thread.join();
  }
  Receiver(const Receiver&) = delete;
  Receiver& operator=(const Receiver&) = delete;

  const UdpSocket& Bound() const { return this->Socket; }

  /// RENDER.
  void Update() { this->News.Update(); }
  const Snapshot& Latest() const
  {
    static const Snapshot nothing;
    const Snapshot* latest = this->News.Latest();
    return latest ? *latest : nothing;
  }

private:
  void Run() noexcept
  {
    Snapshot now;
    try
    {
      while (this->WaitForPackets())
      {
        const std::uint64_t before = now.counts.flooding;
        const bool more = this->TakeAll(now) == PacketsAWake;
        if (more && now.counts.flooding > before && this->WaitForStop(RestMs))
          return;
      }
    }
    catch (const std::system_error& error)
    {
      now.socketError = error.code().value();
      this->News.Write(now);
    }
  }

  /// False: to stop.
  bool WaitForPackets() const
  {
    pollfd both[] = { { this->Stop.Descriptor(), POLLIN, 0 },
      { this->Socket.Descriptor(), POLLIN, 0 } };
    while (poll(both, 2, -1) < 0)
      if (errno != EINTR)
        throw std::system_error(errno, std::generic_category());
    return both[0].revents == 0;
  }
  bool WaitForStop(int milliseconds) const
  {
    pollfd stop{ this->Stop.Descriptor(), POLLIN, 0 };
    return poll(&stop, 1, milliseconds) > 0;
  }

  /// Takes what is there and hands the newest over. Returns how many.
  int TakeAll(Snapshot& now)
  {
    std::array<std::byte, OpentrackPacketBytes> buffer{};
    int taken = 0;
    for (; taken < PacketsAWake; ++taken)
    {
      const auto came = this->Socket.Receive(buffer);
      if (!came)
        break;
      static constexpr std::array<std::byte, OpentrackPacketBytes + 1> TooLong{};
      const auto packet = came->bytes > buffer.size()
                            ? std::span<const std::byte>(TooLong)
                            : std::span<const std::byte>(buffer).first(came->bytes);
      if (const auto pose = this->Inbox.Take(packet, came->timeS))
        now.newest = *pose;
    }
    now.counts = this->Inbox.Counts();
    if (taken > 0)
      this->News.Write(now);
    return taken;
  }

  UdpSocket Socket;
  StopEvent Stop;
  OpentrackInbox Inbox; ///< the thread's alone
  TripleBuffer<Snapshot> News;
  std::thread Thread;
};

OpentrackHeadPose::OpentrackHeadPose(const OpentrackSettings& settings)
{
  ValidateHeadPose({ settings.origin, { 1, 0, 0, 0 } });
  try
  {
    this->Thread = std::make_unique<Receiver>(settings);
  }
  catch (const std::invalid_argument& error)
  {
    throw std::invalid_argument(std::string("opentrack: ") + error.what());
  }
  catch (const std::runtime_error& error)
  {
    throw std::runtime_error(std::string("opentrack: ") + error.what());
  }
}

OpentrackHeadPose::~OpentrackHeadPose() = default;

std::uint16_t OpentrackHeadPose::Port() const noexcept
{
  return this->Thread->Bound().Port();
}

OpentrackCounts OpentrackHeadPose::Counts() const
{
  return this->Thread->Latest().counts;
}

std::optional<TimedHeadPose> OpentrackHeadPose::Latest(double)
{
  this->Thread->Update();
  const Snapshot& latest = this->Thread->Latest();
  if (latest.counts.good == 0)
    return std::nullopt;
  return latest.newest;
}

std::vector<std::string> OpentrackHeadPose::TakeWarnings()
{
  const Snapshot& latest = this->Thread->Latest();
  const OpentrackCounts& c = latest.counts;
  const struct
  {
    std::uint64_t count;
    const char* what;
  } kinds[] = {
    { c.tooShort, "packets shorter than 48 bytes; is something else sending to this port?" },
    { c.tooLong, "packets longer than 48 bytes; is something else sending to this port?" },
    { c.notFinite, "packets with numbers that are not finite" },
    { c.outOfRange, "packets with a head further than 10 m or turned by more than 360 degrees" },
    { c.duplicated, "packets that came twice" },
    { c.late, "times no packet for a tenth of a second or longer" },
    { c.flooding, "packets beyond 4000 in a second; does more than one program send?" },
    { std::uint64_t(latest.socketError), "is the error of the socket (errno); it receives nothing"
                                         " more, begin anew" },
    { std::uint64_t(!this->Thread->Bound().LoopbackOnly()),
      "address beyond this machine is listened"
      " at: others may move the view" },
  };
  this->Warned.resize(std::size(kinds));
  std::vector<std::string> warnings;
  for (std::size_t k = 0; k < std::size(kinds); ++k)
    if (kinds[k].count > 0 && !this->Warned[k])
    {
      this->Warned[k] = true;
      warnings.push_back("opentrack: " + std::to_string(kinds[k].count) + " " + kinds[k].what);
    }
  return warnings;
}

} // namespace hasp
