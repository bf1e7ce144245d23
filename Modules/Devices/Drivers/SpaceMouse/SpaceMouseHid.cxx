#include "Devices/Drivers/SpaceMouse/SpaceMouseHid.h"

#include "Grid/Progress.h"

#include <array>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr std::size_t LongestReport = 64; // theirs are of 13 bytes
constexpr int MostReports = 128; // of one read; the kernel keeps 64, and what comes meanwhile
} // namespace

SpaceMouseHid::SpaceMouseHid(std::unique_ptr<HidTransport> transport)
  : Transport(std::move(transport))
{
  if (!this->Transport)
    throw std::invalid_argument("a SpaceMouse needs a transport");
}

SpaceMouseHid::~SpaceMouseHid()
{
  this->Close();
}

void SpaceMouseHid::Open(const DriverOpening& how)
{
  this->Close();
  if (how.cancelled())
    throw Cancelled();
  how.says("looking for a SpaceMouse");
  const HidCollection found = this->Transport->Open();
  this->Is = SpaceMouseOf(found);
  if (!this->Is)
  {
    this->Transport->Close();
    throw DeviceError(DeviceTrouble::Protocol,
      "what was opened is no SpaceMouse: take it off, or choose another device");
  }
  try
  {
    how.says(std::string("opening the ") + this->Is->name);
    this->Promised = ReadHidAxes(this->Transport->ReportDescriptor());
  }
  catch (...)
  {
    this->Close();
    throw;
  }
  this->SetLight(true);
}

SixDofNews SpaceMouseHid::Read(SixDofState& state, int waitMs)
{
  SixDofNews news;
  std::array<std::byte, LongestReport> report;
  for (int n = 0; n < MostReports; ++n)
  {
    const std::size_t bytes = this->Transport->Read(report, n == 0 ? waitMs : 0);
    if (bytes == 0)
      break;
    const SpaceMouseReport said = this->Reports.Take(std::span(report).first(bytes));
    const bool both = said == SpaceMouseReport::PushAndTurn;
    news.push = news.push || both || said == SpaceMouseReport::Push;
    news.turn = news.turn || both || said == SpaceMouseReport::Turn;
  }
  const std::span<const std::int16_t, 6> counts(this->Reports.axes);
  if (news.push)
    state.push = DeviceDeflections(counts, this->Promised.ranges, SpaceMouseAxes, 0);
  if (news.turn)
    state.turn = DeviceDeflections(counts, this->Promised.ranges, SpaceMouseAxes, 3);
  state.buttons = this->Is ? SpaceMouseButtons(*this->Is, this->Reports.buttonBits) : 0;
  return news;
}

void SpaceMouseHid::Close() noexcept
{
  if (!this->Is)
    return;
  this->SetLight(false);
  this->Transport->Close();
  this->Is = nullptr;
  this->Promised = {};
  this->Reports = {};
}

void SpaceMouseHid::SetLight(bool on) noexcept
{
  try
  {
    this->Transport->Write(SpaceMouseLight(on));
  }
  catch (const DeviceError&) // some have no light; one that is gone says so when it is read
  {
  }
}

} // namespace hasp
