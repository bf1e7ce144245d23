#pragma once
#include "Devices/Drivers/SpaceMouse/HidTransport.h"

#include <algorithm>
#include <deque>
#include <memory>
#include <string_view>

namespace hasp::test
{

using Bytes = std::vector<std::byte>;

inline Bytes FromHex(std::string_view hex)
{
  Bytes bytes;
  for (std::size_t n = 0; n + 1 < hex.size(); n += 2)
    bytes.push_back(static_cast<std::byte>(std::stoi(std::string(hex.substr(n, 2)), nullptr, 16)));
  return bytes;
}

/// Of a SpaceNavigator: X Y Z in report 1, Rx Ry Rz in report 2, 2 buttons in 3, a light in 4.
inline const Bytes HalvesDescriptor =
  FromHex("05010908a101a100850116a2fe265e013688fa467805550c6511093009310932751095038106c0a1008502"
          "0933093409357510950381"
          "06c0a102850305010509190129021500250135004501750195028102950e8103c0a10285040508094b1500"
          "2501750195019102950175079103c0c0");
/// All six axes in report 1, as the wireless ones have it.
inline const Bytes WholeDescriptor =
  FromHex("05010908a101a100850116a2fe265e01093009310932093309340935751095068102c0c0");

/// What a report says: id, then numbers of 16 bits.
inline Bytes Report(int id, std::initializer_list<int> numbers)
{
  Bytes bytes{ static_cast<std::byte>(id) };
  for (const int number : numbers)
  {
    bytes.push_back(static_cast<std::byte>(number & 0xff));
    bytes.push_back(static_cast<std::byte>(number >> 8 & 0xff));
  }
  return bytes;
}
inline Bytes ButtonReport(std::uint64_t bits, std::size_t size)
{
  Bytes bytes{ std::byte{ 3 } };
  for (std::size_t n = 1; n < size; ++n)
    bytes.push_back(static_cast<std::byte>(bits >> 8 * (n - 1) & 0xff));
  return bytes;
}

/// A device that is not there; a test holds its strings.
struct FakeHid
{
  HidCollection is{ "fake", 0x256f, 0xc635, 1, 8, "SpaceMouse Compact" };
  Bytes descriptor = HalvesDescriptor;
  std::deque<Bytes> reports;
  std::vector<Bytes> written;
  bool there = true, open = false, takesLight = true;
  int callsUntilUnplug = -1; ///< of this many calls from now on the last finds it gone; -1: none
  int opened = 0, closed = 0;

  /// Whether it is there still, a call later.
  bool Step()
  {
    if (this->callsUntilUnplug > 0 && --this->callsUntilUnplug == 0)
      this->there = false;
    return this->there;
  }
};

class FakeHidTransport : public HidTransport
{
public:
  explicit FakeHidTransport(std::shared_ptr<FakeHid> device) : Device(std::move(device)) {}

  HidCollection Open() override
  {
    if (!this->Device->Step())
      throw DeviceError(DeviceTrouble::Absent, "no SpaceMouse is there: plug it in");
    this->Device->open = true;
    ++this->Device->opened;
    return this->Device->is;
  }
  std::size_t Read(std::span<std::byte> report, int) override
  {
    this->MustBeThere();
    if (this->Device->reports.empty())
      return 0;
    const Bytes next = this->Device->reports.front();
    this->Device->reports.pop_front();
    const std::size_t size = std::min(next.size(), report.size());
    std::copy_n(next.begin(), size, report.begin());
    return size;
  }
  void Write(std::span<const std::byte> report) override
  {
    this->MustBeThere();
    if (!this->Device->takesLight)
      throw DeviceError(DeviceTrouble::Gone, "the SpaceMouse is gone: plug it in again");
    this->Device->written.emplace_back(report.begin(), report.end());
  }
  std::vector<std::byte> ReportDescriptor() override
  {
    return this->Device->Step() ? this->Device->descriptor : Bytes{};
  }
  void Close() noexcept override
  {
    if (this->Device->open)
      ++this->Device->closed;
    this->Device->open = false;
  }

private:
  void MustBeThere()
  {
    if (!this->Device->Step())
      throw DeviceError(DeviceTrouble::Gone, "the SpaceMouse is gone: plug it in again");
  }
  std::shared_ptr<FakeHid> Device;
};

} // namespace hasp::test
