#pragma once
#include "Devices/Drivers/SpaceMouse/SixDofSource.h"

#include <array>
#include <cstddef>
#include <string>

namespace hasp
{

/// The daemon spacenavd as a source: it reads devices of all makers, also serial ones, and says
/// what they say on a Unix socket. Needs no library.
///
/// Protocol 0, which it speaks unless asked for another: events of eight int32 of this machine's
/// byte order,
///
///   0           | 1 - 6                                    | 7
///   0: motion   | x y z rx ry rz, in [-500, 500]           | ms since the one before, not read
///   1: press    | number of the button, the rest is 0      |
///   2: release  | …                                        |
///
/// (spacenavd, proto_unix.c and event.c). What is none of those is skipped and counted; after 64 of
/// them in a row the stream is out of step, and there is no going on. Events may come in pieces.
/// Buttons above 31 are not heard. The daemon's settings of the user (dead zone, sensitivity, axes
/// turned round) act before; more than 500 counts as 500. It says nothing of a battery, and of a
/// device that is unplugged no more than that it falls silent.
class SpacenavSocket : public SixDofSource
{
public:
  static constexpr const char* StandardPath = "/var/run/spnav.sock";

  explicit SpacenavSocket(std::string path = StandardPath);
  ~SpacenavSocket() override;

  const char* Name() const noexcept override { return "spacenavd"; }
  /// Throws DeviceError: Absent (no daemon), Permission, Busy (it takes no more programs), Address
  /// (a path that is none). Does not wait.
  void Open(const DriverOpening& how) override;
  /// Throws DeviceError: Gone, Protocol.
  SixDofNews Read(SixDofState& state, int waitMs) override;
  void Close() noexcept override;
  std::uint64_t WrongCount() const noexcept override { return this->Wrong; }

private:
  using Event = std::array<std::int32_t, 8>;
  std::size_t Receive();
  SixDofNews Take(const Event& event, SixDofState& state);

  std::string Path;
  int Handle = -1;
  std::array<std::byte, 64 * sizeof(Event)> Buffer{};
  std::size_t Held = 0; ///< bytes of Buffer that were not taken
  std::uint64_t Wrong = 0;
  int WrongInARow = 0;
};

} // namespace hasp
