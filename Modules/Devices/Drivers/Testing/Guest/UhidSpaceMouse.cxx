#include "UhidSpaceMouse.h"

#include <fcntl.h>
#include <linux/input.h>
#include <linux/uhid.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace hasp::test
{

namespace
{
/// All six axes in report 1, 2 buttons in 3, a light in 4, the battery in 17: the kernel throws
/// away what a descriptor does not promise.
const Bytes Descriptor =
  FromHex("05010908a101"
          "a100850116a2fe265e013688fa467805550c6511093009310932093309340935751095068102c0"
          "a102850305010509190129021500250135004501750195028102950e8103c0"
          "a10285040508094b15002501950175019102950175079103c0"
          "a10285170600ff09011500266400750895028102c0"
          "c0");

void Send(int node, const uhid_event& event)
{
  if (write(node, &event, sizeof event) != static_cast<ssize_t>(sizeof event))
    throw std::system_error(errno, std::generic_category(), "/dev/uhid");
}
} // namespace

UhidSpaceMouse::UhidSpaceMouse() : Node(open("/dev/uhid", O_RDWR | O_CLOEXEC))
{
  uhid_event event{};
  event.type = UHID_CREATE2;
  auto& is = event.u.create2;
  std::strcpy(reinterpret_cast<char*>(is.name), "3Dconnexion SpaceMouse Wireless");
  std::memcpy(is.rd_data, Descriptor.data(), Descriptor.size());
  is.rd_size = static_cast<std::uint16_t>(Descriptor.size());
  is.bus = BUS_USB;
  is.vendor = 0x256f;
  is.product = 0xc62e;
  Send(this->Node, event);
  this->Listener = std::jthread([this](const std::stop_token& stop) { this->Listen(stop); });
}

UhidSpaceMouse::~UhidSpaceMouse()
{
  this->Listener.request_stop();
  this->Listener.join();
  close(this->Node); // unplugs it
}

void UhidSpaceMouse::Say(const Bytes& report)
{
  uhid_event event{};
  event.type = UHID_INPUT2;
  std::memcpy(event.u.input2.data, report.data(), report.size());
  event.u.input2.size = static_cast<std::uint16_t>(report.size());
  Send(this->Node, event);
}

std::vector<Bytes> UhidSpaceMouse::Written()
{
  const std::lock_guard lock(this->Lock);
  return this->Outputs;
}

void UhidSpaceMouse::Listen(const std::stop_token& stop)
{
  while (!stop.stop_requested())
  {
    pollfd waits{ this->Node, POLLIN, 0 };
    uhid_event event{};
    if (poll(&waits, 1, /*ms, until it looks at stop*/ 20) <= 0 ||
        read(this->Node, &event, sizeof event) <= 0)
      continue;
    if (event.type != UHID_OUTPUT)
      continue;
    const auto* const bytes = reinterpret_cast<const std::byte*>(event.u.output.data);
    const std::lock_guard lock(this->Lock);
    this->Outputs.emplace_back(bytes, bytes + event.u.output.size);
  }
}

} // namespace hasp::test
