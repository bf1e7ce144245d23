#include "Devices/Drivers/Falcon/FalconDriver.h"

#include "Devices/Drivers/Falcon/FalconKinematics.h"
#include "Devices/Drivers/Falcon/FtdiLine.h"
#include "Devices/SettingsCheck.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace hasp
{

namespace
{
constexpr double NmPerNmm = 1e-3;
// The chip hands out what it has at each read, and says "nothing" after its latency of 1 ms: with
// these and an answer's 10 ms an exchange takes 20 ms at worst.
constexpr int MostDrainReads = 3, DrainMs = 2, WriteMs = 4;
} // namespace

struct FalconDriver::Line
{
  Line(UsbTransport& usb, const DeviceClock& clock) : ftdi(usb, clock) {}
  FtdiLine ftdi;
  FalconFraming framing;
  std::uint64_t resyncs = 0, dropped = 0; ///< of the framing, as far as they are counted
  int owed = 0;                           ///< answers to commands that were sent
  int silent = 0;                         ///< exchanges without an answer, until now
  bool odd = true;                        ///< empty the line first: the boot may have left answers
};

FalconDriver::FalconDriver(
  std::unique_ptr<UsbTransport> usb, const FalconSettings& settings, DeviceClock clock)
  : Usb(std::move(usb)),
    Settings(settings),
    Clock(std::move(clock)),
    Shape(FalconProfile())
{
  constexpr const char* what = "Falcon";
  if (!this->Usb)
    throw std::invalid_argument("Falcon: there is no transport");
  CheckRange(what, "countsPerNm", settings.countsPerNm, 1e-3, 100'000.0);
  CheckRange(what, "answerMs", settings.answerMs, 1, 18);
  CheckRange(what, "mostSilence", settings.mostSilence, 1, 1'000'000);
  CheckRange(what, "bootTries", settings.bootTries, 1, 1000);
  CheckRange(what, "bootTimeBoxS", settings.bootTimeBoxS, 1e-3, 600.0);
}

FalconDriver::~FalconDriver()
{
  this->Close();
}

void FalconDriver::Open(const DriverOpening& how)
{
  this->Close();
  this->Sample = {};
  this->Sample.homed = false;
  try
  {
    this->Usb->Open();
    StartFalcon(*this->Usb, this->Clock,
      { this->Settings.firmware, this->Settings.bootTries, this->Settings.bootTimeBoxS,
        this->Settings.eventCharacter },
      how);
  }
  catch (...)
  {
    this->Usb->Close();
    throw;
  }
  this->Opened = std::make_unique<Line>(*this->Usb, this->Clock);
}

void FalconDriver::Close() noexcept
{
  this->Jacobian.reset();
  if (!this->Opened)
    return;
  this->Opened.reset();
  const auto quiet = Encode(FalconCommand{});
  try
  {
    // Twice: half a packet may lie before the first, and swallow it.
    for (int i = 0; i < 2; ++i)
      this->Usb->Write(quiet, 40);
  }
  catch (const std::exception&)
  {
    // It is gone, and its motors with it.
  }
  this->Usb->Close();
}

std::string FalconDriver::Advice() const
{
  if (!this->Opened || this->Sample.homed)
    return {};
  return "Pull the Falcon's grip all the way out, then push it all the way in.";
}

FalconCommand FalconDriver::CommandFor(const glm::dvec3& forceN) const noexcept
{
  FalconCommand command;
  const bool homed = this->Sample.homed;
  if (homed && this->Jacobian)
    command.motors =
      ToMotors(-this->Settings.countsPerNm * NmPerNmm * FalconTorques(*this->Jacobian, forceN));
  if (this->Settings.lights)
    command.lights = !homed ? FalconCommand::Red
                     : command.motors == std::array<int, 3>{}
                       ? FalconCommand::Green
                       : FalconCommand::Green | FalconCommand::Blue;
  return command;
}

DriverSample FalconDriver::Exchange(const Wrench& wrench, std::int64_t)
{
  if (!this->Opened)
    throw DeviceError(DeviceTrouble::Gone, "Falcon: it is not open");
  const auto answer = this->Ask(this->CommandFor(wrench.force));
  this->Sample.fresh = answer.has_value();
  if (answer)
  {
    this->Opened->silent = 0;
    this->UpdatePose(*answer);
    return this->Sample;
  }
  this->Add(Silences);
  if (++this->Opened->silent >= this->Settings.mostSilence)
    throw DeviceError(DeviceTrouble::Protocol,
      "Falcon: it has not answered " + std::to_string(this->Opened->silent) +
        " times, one after the other; is its power supply plugged in? If so, switch it off and on");
  return this->Sample;
}

std::optional<FalconAnswer> FalconDriver::Ask(const FalconCommand& command)
{
  Line& line = *this->Opened;
  std::optional<FalconAnswer> newest;
  if (line.odd)
  {
    // Until there is nothing more in the chip. Late answers are owed no longer.
    line.odd = false;
    bool more = true;
    for (int i = 0; i < MostDrainReads && more; ++i)
      more = this->Hear(line.ftdi.Read(DrainMs), newest);
    newest.reset(); // as old as the command before
    line.owed = std::max(line.owed, 0);
  }
  const auto packet = Encode(command);
  if (this->Usb->Write(packet, WriteMs) != packet.size())
  {
    line.odd = true;
    return newest;
  }
  this->Add(Commands);
  const bool others = line.owed > 0;
  ++line.owed;
  line.ftdi.ReadUntil(this->Settings.answerMs,
    [&](std::span<std::uint8_t> payload)
    {
      this->Hear(payload, newest);
      return line.owed <= 0;
    });
  // Where others were waited for, what came may be repetitions: look once more before the next.
  if (others || line.owed != 0)
    line.odd = true;
  if (newest && line.owed > 0)
    newest.reset(); // it may be the answer to one before, and this one's on its way
  else if (!newest)
    return newest; // all may come late
  line.owed = 0;   // what did not come by now is looked for by the next, and then given up
  return newest;
}

bool FalconDriver::Hear(std::span<std::uint8_t> payload, std::optional<FalconAnswer>& newest)
{
  Line& line = *this->Opened;
  for (const std::uint8_t byte : payload)
    if (const auto packet = line.framing.Take(byte))
    {
      newest = DecodeAnswer(*packet);
      this->Add(Answers);
      if (--line.owed < 0)
        this->Add(Surplus);
    }
  if (line.framing.Dropped() != line.dropped)
    line.odd = true;
  this->Add(Resyncs, line.framing.Resyncs() - std::exchange(line.resyncs, line.framing.Resyncs()));
  this->Add(Dropped, line.framing.Dropped() - std::exchange(line.dropped, line.framing.Dropped()));
  return !payload.empty();
}

void FalconDriver::UpdatePose(const FalconAnswer& answer)
{
  this->Sample.buttons = answer.buttons;
  this->Sample.homed = answer.AllHomed();
  const glm::dvec3 near = this->Jacobian ? this->Sample.pose.position : glm::dvec3(0.0);
  this->Jacobian.reset();
  this->Sample.sane = true;
  if (!this->Sample.homed)
    return; // counts from an unknown zero are no place
  const glm::dvec3 angles(FalconAngleOfCount(answer.counts[0]),
    FalconAngleOfCount(answer.counts[1]), FalconAngleOfCount(answer.counts[2]));
  const auto found = FalconPositionAt(angles, near);
  if (found)
  {
    this->Sample.pose.position = found->positionMm;
    this->Jacobian = FalconJacobian(found->positionMm, angles);
  }
  else
  {
    // Without a pose there is no force: whoever gates it has to know, or it came back at once.
    this->Sample.fresh = this->Sample.sane = false;
    this->Add(Refused);
  }
}

void FalconDriver::Add(Count which, std::uint64_t more) noexcept
{
  this->Counted[which].fetch_add(more, std::memory_order_relaxed);
}

FalconCounts FalconDriver::Counts() const noexcept
{
  const auto count = [this](Count which)
  { return this->Counted[which].load(std::memory_order_relaxed); };
  return { count(Commands), count(Answers), count(Silences), count(Surplus), count(Resyncs),
    count(Dropped), count(Refused) };
}

} // namespace hasp
