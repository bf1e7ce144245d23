#pragma once
#include "Devices/Drivers/Falcon/FalconBoot.h"
#include "Devices/Drivers/Falcon/FalconPacket.h"
#include "Devices/Drivers/Falcon/UsbTransport.h"

namespace hasp
{

/// The vendor requests of an FTDI serial chip, as far as a Falcon needs them.
enum FtdiRequest : std::uint8_t
{
  FtdiReset = 0,
  FtdiModemLines = 1,
  FtdiFlowControl = 2,
  FtdiBaudRate = 3,
  FtdiLineFormat = 4,
  FtdiEventCharacter = 6,
  FtdiLatency = 9
};
constexpr std::uint16_t FtdiPurgeReceived = 1, FtdiPurgeSent = 2;
constexpr std::uint16_t FtdiDtrLow = 0x0100, FtdiDtrHigh = 0x0101, FtdiRtsLow = 0x0200;
constexpr std::uint16_t FtdiBaud9600 = 0x4138, FtdiBaud143k = 0x0015, FtdiBaud1500k = 0x0002;
constexpr std::uint16_t FtdiEventAtPacketEnd = 0x0100 | '>'; // on, and which

/// A serial line over an FTDI chip: payload without status bytes, and deadlines. Same thread as
/// the transport.
class FtdiLine
{
public:
  FtdiLine(UsbTransport& usb, const DeviceClock& clock) : Usb(usb), Clock(clock) {}

  void Purge()
  {
    this->Usb.Control(FtdiReset, FtdiPurgeReceived);
    this->Usb.Control(FtdiReset, FtdiPurgeSent);
  }

  /// The payload of one transfer; empty if there is none yet. Good until the next Read.
  std::span<std::uint8_t> Read(int timeoutMs)
  {
    const std::size_t size = this->Usb.Read(this->Transfer, timeoutMs);
    return FtdiPayload(std::span(this->Transfer).first(size));
  }

  /// Hands each payload to `take` until that returns true, or `waitMs` are over: false.
  template <typename Take>
  bool ReadUntil(int waitMs, Take&& take)
  {
    const std::int64_t deadlineNs = this->Clock.nowNs() + waitMs * 1'000'000LL;
    for (;;)
    {
      const std::int64_t leftNs = deadlineNs - this->Clock.nowNs();
      if (leftNs <= 0)
        return false;
      if (take(this->Read(static_cast<int>((leftNs + 999'999) / 1'000'000))))
        return true;
    }
  }

private:
  UsbTransport& Usb;
  const DeviceClock& Clock;
  std::array<std::uint8_t, 512> Transfer{};
};

} // namespace hasp
