#include "FalconModel.h"

#include "Devices/Drivers/DeviceError.h"
#include "Devices/Drivers/Falcon/FalconKinematics.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hasp
{

FalconModel::FalconModel(std::vector<std::uint8_t> image) : Image(std::move(image))
{
  this->MoveTo(glm::dvec3(0.0));
}

void FalconModel::MoveTo(const glm::dvec3& positionMm)
{
  const auto angles = FalconAnglesAt(positionMm).value();
  this->PositionMm = positionMm;
  for (int i = 0; i < 3; ++i)
    this->Counts[i] = static_cast<int>(std::lround(FalconCountOfAngle(angles[i])));
}

void FalconModel::PullOutAndPushIn()
{
  if (this->Runs() && this->Last.homing)
    this->Homed = 7;
}

void FalconModel::SwitchOffAndOn()
{
  this->State = this->Dtr ? Mode::Asked : Mode::Off;
  this->Loaded = 0;
  this->Heard.clear();
  this->Outbox.clear();
  this->Command.clear();
  this->Last = {};
  this->Homed = 0;
}

void FalconModel::StartRunning()
{
  this->State = Mode::Running;
}

glm::dvec3 FalconModel::ForceN(double countsPerNm) const
{
  const auto angles = FalconAnglesAt(this->PositionMm).value();
  const auto jacobian = FalconJacobian(this->PositionMm, angles).value();
  const glm::dvec3 torquesNmm =
    glm::dvec3(this->Last.motors[0], this->Last.motors[1], this->Last.motors[2]) *
    (-1000.0 / countsPerNm);
  return glm::inverse(glm::transpose(jacobian)) * torquesNmm;
}

bool FalconModel::Control(std::uint8_t request, std::uint16_t value)
{
  switch (request)
  {
    case 0:
      if (value == 1)
        this->Outbox.clear();
      return value <= 2;
    case 1:
      if (this->faults.noModemLines)
        return false;
      if (value & 0x0100)
      {
        const bool high = value & 1;
        if (high && !this->Dtr && !this->Runs())
        {
          this->SwitchOffAndOn(); // the controller begins anew
          this->State = Mode::Asked;
        }
        this->Dtr = high;
      }
      return true;
    case 2:
    case 4:
    case 6:
      return true;
    case 3:
      this->Baud = value;
      return true;
    case 9:
      this->Latency = value;
      return value >= 1 && value <= 255;
    default:
      return false;
  }
}

void FalconModel::Receive(std::span<const std::uint8_t> bytes)
{
  for (const std::uint8_t byte : bytes)
    if (!this->Runs())
      this->TakeBootByte(byte);
    else if (this->Baud == 2) // at any other it is noise that the firmware does not understand
      this->TakePacketByte(byte);
}

void FalconModel::TakePacketByte(std::uint8_t byte)
{
  // How the true firmware finds its way back is not known, so this one is as dull as can be: what
  // begins like a packet and is none is thrown away whole.
  if (this->Command.empty() && byte != '<')
    return;
  this->Command.push_back(byte);
  FalconPacket packet{};
  if (this->Command.size() < packet.size())
    return;
  std::copy(this->Command.begin(), this->Command.end(), packet.begin());
  this->Command.clear();
  if (const auto command = DecodeCommand(packet))
    this->Obey(*command);
}

void FalconModel::TakeBootByte(std::uint8_t byte)
{
  if (this->State == Mode::Asked && this->Baud == 0x4138)
  {
    this->Heard.push_back(byte);
    constexpr std::uint8_t question[] = { 0x0a, 0x43, 0x0d };
    if (this->Heard.size() >= 3 &&
        std::equal(std::rbegin(question), std::rend(question), this->Heard.rbegin()))
      for (const std::uint8_t answer : { 0x0a, 0x44, 0x2c, 0x0d })
        this->Queue(answer, this->nowNs);
  }
  else if (this->State == Mode::Asked && this->Baud == 0x15 && !this->Dtr && byte == 'A')
  {
    this->Queue(byte, this->nowNs);
    this->State = Mode::Loading;
  }
  else if (this->State == Mode::Loading)
  {
    const bool wrong =
      static_cast<int>(this->Loaded) == this->faults.wrongEchoAt && this->faults.wrongEchoes > 0;
    this->faults.wrongEchoes -= wrong ? 1 : 0;
    this->Queue(static_cast<std::uint8_t>(wrong ? byte ^ 0x20 : byte), this->nowNs);
    const bool asImage = byte == this->Image[this->Loaded];
    if (++this->Loaded == this->Image.size())
      this->State = this->faults.deadFirmware ? Mode::Dead : Mode::Running;
    else if (!asImage)
      this->State = Mode::Dead;
  }
}

void FalconModel::Obey(const FalconCommand& command)
{
  this->Last = command;
  ++this->PacketNumber;
  FalconAnswer answer{ this->Counts, this->Buttons, this->Homed };
  if (!answer.AllHomed())
    for (int i = 0; i < 3; ++i)
      answer.counts[i] += this->ZeroOffset[i];
  if (this->Happens(this->faults.lost))
    return;
  // One after the other: also behind a late one each takes its time on the wire.
  constexpr std::int64_t apartNs = 300'000;
  const std::int64_t dueNs =
    std::max(this->nowNs + this->faults.delayNs, this->LastAnswerNs + apartNs);
  this->LastAnswerNs = dueNs;
  const auto bytes = Encode(answer);
  if (this->Happens(this->faults.noise))
    for (int i = this->Random() % 40; i >= 0; --i)
      this->Queue(static_cast<std::uint8_t>(this->Random()), dueNs);
  const std::size_t from = this->Happens(this->faults.shifted) ? this->Random() % bytes.size() : 0;
  const std::size_t length =
    this->Happens(this->faults.cut) ? this->Random() % bytes.size() : bytes.size();
  const bool repeated = this->Happens(this->faults.repeated);
  for (int copy = 0; copy < (repeated ? 3 : 1); ++copy)
    for (std::size_t i = from; i < length; ++i)
      this->Queue(bytes[i], copy == 2 ? dueNs + apartNs : dueNs);
}

void FalconModel::Queue(std::uint8_t byte, std::int64_t dueNs)
{
  if (!this->faults.silent)
    this->Outbox.push_back({ byte, dueNs });
}

bool FalconModel::Happens(double share)
{
  return share > 0.0 && std::uniform_real_distribution(0.0, 1.0)(this->Random) < share;
}

bool FalconModel::HasAnswer() const
{
  return !this->Outbox.empty() && this->Outbox.front().dueNs <= this->nowNs;
}

std::size_t FalconModel::Send(std::span<std::uint8_t> bytes)
{
  std::size_t size = 0;
  // Packets of 64 bytes, as many as fit; one that is not full ends the transfer.
  do
  {
    const std::size_t end = std::min(bytes.size(), size + 64);
    bytes[size++] = 0x01;
    bytes[size++] = 0x60;
    for (; size < end && this->HasAnswer(); ++size)
    {
      bytes[size] = this->Outbox.front().value;
      this->Outbox.pop_front();
    }
  } while (size % 64 == 0 && size < bytes.size());
  return size;
}

namespace
{
class CableTransport : public UsbTransport
{
public:
  explicit CableTransport(std::shared_ptr<FalconCable> cable) : Cable(std::move(cable)) {}
  ~CableTransport() override { CableTransport::Close(); }

  void Open() override
  {
    this->Close();
    this->CountCall();
    if (this->Cable->refuses)
      throw DeviceError(*this->Cable->refuses, "the cable refuses");
    if (!this->Cable->plugged)
      throw DeviceError(DeviceTrouble::Absent, "none is plugged in");
    if (this->Cable->open)
      throw DeviceError(DeviceTrouble::Busy, "it is open twice");
    this->Cable->open = this->Mine = true;
  }
  void Close() noexcept override
  {
    if (std::exchange(this->Mine, false))
      this->Cable->open = false;
  }
  void Control(std::uint8_t request, std::uint16_t value) override
  {
    this->MustBeThere();
    this->Model().nowNs += 200'000;
    if (!this->Model().Control(request, value))
      throw DeviceError(DeviceTrouble::Protocol, "it refuses a request");
  }
  std::size_t Read(std::span<std::uint8_t> bytes, int timeoutMs) override
  {
    this->MustBeThere();
    auto& model = this->Model();
    model.nowNs += 100'000;
    // The chip keeps the host waiting until there is something, or its timer ends.
    const std::int64_t timerNs = model.nowNs + model.LatencyMs() * 1'000'000LL;
    const std::int64_t timeoutNs = model.nowNs + timeoutMs * 1'000'000LL;
    while (!model.HasAnswer() && model.nowNs < std::min(timerNs, timeoutNs))
      model.nowNs += 100'000;
    return model.HasAnswer() || timerNs <= timeoutNs ? model.Send(bytes) : 0;
  }
  std::size_t Write(std::span<const std::uint8_t> bytes, int) override
  {
    this->MustBeThere();
    this->Model().nowNs += 100'000;
    this->Model().Receive(bytes);
    return bytes.size();
  }

private:
  FalconModel& Model() { return *this->Cable->model; }
  void CountCall()
  {
    if (this->Cable->calls++ == this->Cable->unplugAt)
      this->Cable->plugged = false;
  }
  void MustBeThere()
  {
    this->CountCall();
    if (!this->Mine || !this->Cable->plugged)
      throw DeviceError(DeviceTrouble::Gone, "it was unplugged");
  }

  std::shared_ptr<FalconCable> Cable;
  bool Mine = false;
};
} // namespace

DeviceClock FalconCable::Clock()
{
  return { [model = this->model] { return model->nowNs; },
    [model = this->model](int ms) { model->nowNs += ms * 1'000'000LL; } };
}

std::unique_ptr<UsbTransport> PlugInto(std::shared_ptr<FalconCable> cable)
{
  return std::make_unique<CableTransport>(std::move(cable));
}

std::vector<std::uint8_t> InventedFirmware(std::size_t size)
{
  std::vector<std::uint8_t> image(size);
  for (std::size_t i = 0; i < size; ++i)
    image[i] = static_cast<std::uint8_t>(i * 37 + (i >> 6) * 11 + 5);
  image[0] = 0xaa;
  image[1] = 0x08;
  return image;
}

} // namespace hasp
