#include "Devices/Drivers/Haply/HaplyDriver.h"

#include "Devices/SettingsCheck.h"
#include "Grid/Progress.h"

#include <algorithm>
#include <utility>

namespace hasp
{

namespace
{
using Clock = std::chrono::steady_clock;
using Milliseconds = WebSocketClient::Milliseconds;
constexpr const char* What = "Haply Inverse3";
constexpr Milliseconds Taken{ 20 }, Goodbye{ 80 }, AskEach{ 20 };

[[noreturn]] void Fail(DeviceTrouble trouble, const std::string& why)
{
  throw DeviceError(trouble, std::string(What) + ": " + why);
}

DeviceProfile Inverse3Profile(bool grip)
{
  return { .name = "Inverse3",
    .poseAxes = grip ? 6 : 3,
    .forceAxes = 3,
    .buttons = grip ? 3 : 0,
    .workspaceMm = { 100, 100, 100 },
    .peakForceN = 10.0,
    .continuousForceN = 3.0,
    .peakTorqueNmm = 0.0,
    .continuousTorqueNmm = 0.0,
    .stiffnessNPerMm = 0.8,
    .dampingNsPerMm = 0.001,
    .movingMassKg = 0.1,
    .positionQuantumMm = 0.05,
    .angleQuantumRad = 0.001,
    .delayTicks = 2 };
}

std::string Port(const WebSocketAddress& address)
{
  return "port " + std::to_string(address.port);
}
} // namespace

HaplyDriver::HaplyDriver(const HaplySettings& settings)
  : Settings(settings),
    Device(Inverse3Profile(settings.grip))
{
  try
  {
    this->Address = ParseWebSocketAddress(settings.address);
    CheckVector(What, "centreMm", settings.centreMm, 2000.0);
    CheckRange(What, "opening in ms", double(settings.opening.count()), 10.0, 60'000.0);
    CheckRange(What, "answer in ms", double(settings.answer.count()), 0.0, 20.0);
  }
  catch (const std::invalid_argument& error)
  {
    throw DeviceError(DeviceTrouble::Address, error.what());
  }
  if (!this->Address.loopback && !settings.allowRemote)
    Fail(DeviceTrouble::Address,
      "its address is another machine's, and what goes there is neither secret nor signed; use "
      "ws://localhost:10001, or allow remote services if nobody else is on that network");
}

HaplyDriver::~HaplyDriver()
{
  this->Close();
}

void HaplyDriver::Open(const DriverOpening& how)
{
  this->Close();
  how.says("connecting to the Haply Inverse Service");
  const auto end = Clock::now() + this->Settings.opening;
  std::optional<HaplyState> state;
  try
  {
    this->Service.Connect(this->Address, this->Settings.opening, how.cancelled);
    how.says("waiting for what the Haply Inverse Service has");
    // Once, when the connection is there, it says all that it has; after that it only answers.
    std::optional<std::string> text;
    while (!(text = this->Service.Receive(AskEach)))
    {
      if (how.cancelled())
        throw Cancelled();
      if (Clock::now() >= end)
        Fail(DeviceTrouble::Absent, "the service at " + Port(this->Address) +
                                      " says nothing; restart the Haply Inverse Service");
    }
    state = ReadHaplyState(*text, this->Settings.deviceId);
  }
  catch (const WebSocketError& error)
  {
    this->Close();
    if (error.answered)
      Fail(DeviceTrouble::Protocol,
        "what listens at " + Port(this->Address) +
          " is no Haply Inverse Service; give the address where that listens");
    Fail(DeviceTrouble::Absent, "the service at " + Port(this->Address) + " does not answer (" +
                                  error.what() + "); is the Haply Inverse Service running?");
  }
  catch (const std::invalid_argument& error)
  {
    this->Close();
    Fail(DeviceTrouble::Protocol, error.what());
  }
  catch (...)
  {
    this->Close();
    throw;
  }
  if (!state || state->turnedAxes)
  {
    this->Close();
    if (state)
      Fail(DeviceTrouble::Protocol,
        "the service turns its axes; set the basis back to XYZ (in the Haply Hub)");
    Fail(DeviceTrouble::Absent,
      "the service has no such device; is the Inverse3 plugged in and switched on?");
  }
  this->DeviceId = state->deviceId;
  this->Centred = state->centred;
  this->GripHeard = false;
  this->Last = { .homed = true };
  this->Wrong = 0;
  this->HeardNs.reset();
  this->Take(*state);
}

void HaplyDriver::Take(const HaplyState& state)
{
  DriverSample& last = this->Last;
  last.pose.position =
    this->Centred ? state.positionMm : state.positionMm - this->Settings.centreMm;
  this->GripHeard = state.orientation.has_value();
  if (this->Settings.grip)
  {
    last.pose.orientation = state.orientation.value_or(last.pose.orientation);
    last.buttons = state.buttons;
  }
  last.homed = state.calibrated.value_or(last.homed);
}

/// One message: what it says, or that it cannot be.
void HaplyDriver::Judge(const std::string& text, std::int64_t nowNs)
{
  this->HeardNs = nowNs;
  std::optional<HaplyState> state;
  try
  {
    state = ReadHaplyState(text, this->DeviceId);
  }
  catch (const std::invalid_argument& error)
  {
    if (++this->Wrong >= MostWrong)
      Fail(DeviceTrouble::Protocol,
        std::string(error.what()) + ", " + std::to_string(this->Wrong) + " times in a row");
    return;
  }
  if (!state)
    Fail(DeviceTrouble::Gone, "the service has it no more; was it unplugged?");
  this->Take(*state);
  this->Last.fresh = true;
  this->Wrong = 0;
}

DriverSample HaplyDriver::Exchange(const Wrench& wrench, std::int64_t nowNs)
{
  if (!this->Service.IsOpen())
    Fail(DeviceTrouble::Gone, "it is not open");
  if (!this->HeardNs)
    this->HeardNs = nowNs;
  this->Last.fresh = false;
  std::optional<std::string> text;
  try
  {
    const glm::dvec3 force = ClampToProfile(this->Device, wrench).force;
    text = this->Service.Receive(Milliseconds(0)); // late, and better than nothing
    this->Service.Send(WriteHaplyForce(this->DeviceId, force), Taken);
    if (auto answer = this->Service.Receive(this->Settings.answer))
      text = std::move(answer);
  }
  catch (const WebSocketError& error)
  {
    Fail(DeviceTrouble::Gone, std::string("the service went: ") + error.what());
  }
  if (text)
    this->Judge(*text, nowNs);
  if (NsBetween(*this->HeardNs, nowNs) > MostSilenceNs)
    Fail(
      DeviceTrouble::Gone, "the service says nothing any more; restart the Haply Inverse Service");
  return this->Last;
}

void HaplyDriver::Close() noexcept
{
  if (!this->Service.IsOpen())
    return;
  const auto end = Clock::now() + Goodbye;
  try
  {
    if (!this->DeviceId.empty())
      this->Service.Send(WriteHaplyForce(this->DeviceId, glm::dvec3(0.0)), Goodbye);
  }
  catch (...) // it hears no more
  {
  }
  // To cut at once might take the zero back, where the service is slow to read it.
  this->Service.Close(std::chrono::ceil<Milliseconds>(std::max(end - Clock::now(), {})));
  this->DeviceId.clear();
}

std::string HaplyDriver::Advice() const
{
  if (!this->Service.IsOpen())
    return {};
  if (!this->Last.homed)
    return "Put the grip into its holder on the Inverse3 until its light is steady.";
  if (this->Settings.grip && !this->GripHeard)
    return "Switch the VerseGrip on: its turn is not known.";
  return {};
}

} // namespace hasp
