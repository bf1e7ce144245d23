#include "Devices/Drivers/Falcon/FalconBoot.h"

#include "Devices/Drivers/Falcon/FtdiLine.h"
#include "Grid/Progress.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <string_view>
#include <thread>

namespace hasp
{

DeviceClock SteadyDeviceClock()
{
  using namespace std::chrono;
  return { []
    { return duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count(); },
    [](int ms) { std::this_thread::sleep_for(milliseconds(ms)); } };
}

namespace
{
constexpr std::string_view Device = "Falcon: ";
constexpr std::size_t LeastImage = 7'000, MostImage = 9'000;
constexpr const char* WhereFrom =
  " It is the maker's, is on the disc or in the driver that came with the device, and may not be"
  " passed on, so Hasp has none: name the file in the settings or in HASP_FALCON_FIRMWARE, or put"
  " it as hasp/falcon-firmware.bin into the folder of your programs' data (XDG_DATA_HOME)";

std::string FromEnvironment(const char* name)
{
  const char* value = std::getenv(name);
  return value ? value : "";
}

[[noreturn]] void RefuseFile(const std::string& sentence)
{
  throw DeviceError(DeviceTrouble::Firmware, std::string(Device) + sentence);
}
} // namespace

std::filesystem::path FalconFirmwareFile(const std::string& fromSettings)
{
  if (!fromSettings.empty())
    return fromSettings;
  if (const auto file = FromEnvironment("HASP_FALCON_FIRMWARE"); !file.empty())
    return file;
  std::filesystem::path data = FromEnvironment("XDG_DATA_HOME");
  if (data.empty())
    if (const auto home = FromEnvironment("HOME"); !home.empty())
      data = std::filesystem::path(home) / ".local/share";
  return data.empty() ? data : data / "hasp" / "falcon-firmware.bin";
}

std::vector<std::uint8_t> ReadFalconFirmware(const std::filesystem::path& file)
{
  std::error_code error;
  if (file.empty() || !std::filesystem::exists(file, error))
    RefuseFile(
      "its firmware is not loaded, and there is no file to load it from." + std::string(WhereFrom));
  const std::string name = "the file of firmware \"" + file.filename().string() + "\" ";
  if (!std::filesystem::is_regular_file(file, error))
    RefuseFile(name + "is no file of bytes; name the file itself");
  std::ifstream stream(file, std::ios::binary);
  // One more than is legal tells too long from long; a file of gigabytes is not read.
  std::vector<std::uint8_t> image(MostImage + 1);
  if (!stream.read(reinterpret_cast<char*>(image.data()), image.size()) && !stream.eof())
    RefuseFile(name + "cannot be read; is it yours to read?");
  image.resize(static_cast<std::size_t>(stream.gcount()));
  if (image.size() < LeastImage || image.size() > MostImage)
    RefuseFile(name + "has " +
               (image.size() > MostImage ? "more than 9000" : std::to_string(image.size())) +
               " bytes, and a Falcon's has 7000 to 9000: it is another file");
  if (image[0] != 0xaa || image[1] != 0x08)
    RefuseFile(name + "does not begin with AA 08, the key of the device's boot loader: it is"
                      " another file, or it is packed");
  return image;
}

namespace
{
/// One start of one device.
class FalconStart
{
public:
  FalconStart(UsbTransport& usb, const DeviceClock& clock, const FalconBootSettings& settings,
    const DriverOpening& how)
    : Usb(usb),
      Clock(clock),
      Settings(settings),
      How(how),
      Line(usb, clock),
      DeadlineNs(clock.nowNs() + static_cast<std::int64_t>(1e9 * settings.timeBoxS))
  {
  }

  void Run()
  {
    this->How.says("asking whether its firmware runs");
    if (this->RunsAlready())
      return;
    if (!this->How.setUp)
      throw Cancelled();
    const auto image = ReadFalconFirmware(FalconFirmwareFile(this->Settings.firmware));
    std::string failure;
    int tried = 0;
    do
    {
      if (tried > 0)
        this->OpenAnew();
      ++tried;
      this->How.says("loading the firmware, try " + std::to_string(tried) + " of " +
                     std::to_string(this->Settings.tries));
      failure = this->Try(image);
      if (failure.empty())
        return;
    } while (tried < this->Settings.tries && this->Clock.nowNs() < this->DeadlineNs);
    throw DeviceError(DeviceTrouble::Boot,
      std::string(Device) + "its firmware could not be loaded in " + std::to_string(tried) +
        " tries; the last one stopped at " + failure +
        ". Switch the device off and on, plug it into another socket, with a powered hub or without"
        " one, and try again");
  }

private:
  bool RunsAlready()
  {
    try
    {
      return this->Answers(4);
    }
    catch (const DeviceError& error)
    {
      if (error.trouble == DeviceTrouble::Gone)
        throw;
      return false; // it refuses a request that loading may bring it to take
    }
    catch (const Silence&)
    {
      return false;
    }
  }

  /// Empty, or where it stopped.
  std::string Try(const std::vector<std::uint8_t>& image)
  {
    try
    {
      this->Step = "the modem lines";
      this->SetBootLine();
      this->Step = "the question whether its boot loader listens";
      this->Probe();
      this->Step = "the finding of the baud rate";
      this->FindBaudRate();
      this->SendImage(image);
      this->Step = "the first packet: all bytes were echoed, yet the firmware does not answer; is "
                   "the file a Falcon's?";
      return this->Answers(20) ? "" : this->Step;
    }
    catch (const DeviceError& error)
    {
      // The transport's sentence names the device too.
      const std::string_view why = error.what();
      return this->Step + ", " +
             std::string(why.substr(why.starts_with(Device) ? Device.size() : 0));
    }
    catch (const Silence&)
    {
      return this->Step;
    }
  }

  /// The step got no answer, or a wrong one.
  struct Silence
  {
  };

  void Leave() const
  {
    if (this->How.cancelled())
      throw Cancelled();
  }

  void OpenAnew()
  {
    this->Usb.Close();
    for (int i = 0; i < 4; ++i)
    {
      this->Leave();
      this->Clock.sleep(50);
    }
    this->Usb.Open();
  }

  void Send(std::span<const std::uint8_t> bytes)
  {
    if (this->Usb.Write(bytes, 250) != bytes.size())
      throw Silence{};
  }

  void SetBootLine()
  {
    this->Leave();
    this->Line.Purge();
    this->Usb.Control(FtdiLatency, 16);
    this->Usb.Control(FtdiBaudRate, FtdiBaud9600);
    this->Usb.Control(FtdiLineFormat, 8);
    this->Usb.Control(FtdiFlowControl, 0);
    this->Usb.Control(FtdiModemLines, FtdiRtsLow);
    this->Usb.Control(FtdiModemLines, FtdiDtrLow);
    this->Usb.Control(FtdiModemLines, FtdiDtrHigh);
  }

  void Probe()
  {
    constexpr std::array<std::uint8_t, 3> question{ 0x0a, 0x43, 0x0d };
    constexpr std::array<std::uint8_t, 4> answer{ 0x0a, 0x44, 0x2c, 0x0d };
    const std::int64_t giveUpNs = this->Clock.nowNs() + 1'200'000'000;
    for (int i = 0; i < 100 && this->Clock.nowNs() < giveUpNs; ++i)
    {
      this->Leave();
      this->Send(question);
      std::vector<std::uint8_t> got;
      // Some systems put a 0 in front; what is behind it counts.
      if (this->Line.ReadUntil(40,
            [&](std::span<std::uint8_t> payload)
            {
              got.insert(got.end(), payload.begin(), payload.end());
              return got.size() >= answer.size() &&
                     std::equal(answer.rbegin(), answer.rend(), got.rbegin());
            }))
        return;
    }
    throw Silence{};
  }

  void FindBaudRate()
  {
    this->Leave();
    this->Usb.Control(FtdiModemLines, FtdiDtrLow);
    this->Usb.Control(FtdiBaudRate, FtdiBaud143k);
    this->Usb.Control(FtdiReset, FtdiPurgeReceived);
    constexpr std::array<std::uint8_t, 1> a{ 'A' };
    this->Send(a);
    this->Expect(a);
  }

  void SendImage(std::span<const std::uint8_t> image)
  {
    constexpr std::size_t Chunk = 62; // what a packet of the chip holds beside its status
    for (std::size_t at = 0; at < image.size(); at += Chunk)
    {
      this->Leave();
      const auto chunk = image.subspan(at, std::min(Chunk, image.size() - at));
      const auto name = [&](std::size_t i)
      {
        this->Step =
          "the echo of byte " + std::to_string(at + i + 1) + " of " + std::to_string(image.size());
      };
      name(0);
      this->Send(chunk);
      this->Expect(chunk, name);
    }
  }

  /// Waits for exactly these bytes; `name` is told which of them it was when it fails.
  template <typename Name>
  void Expect(std::span<const std::uint8_t> bytes, Name&& name)
  {
    std::size_t right = 0;
    bool wrong = false;
    const bool came = this->Line.ReadUntil(250,
      [&](std::span<std::uint8_t> payload)
      {
        for (const std::uint8_t byte : payload)
        {
          wrong = wrong || right == bytes.size() || byte != bytes[right];
          right += wrong ? 0 : 1;
        }
        return wrong || right == bytes.size();
      });
    name(right);
    if (wrong)
      this->Step += ", which came back wrong";
    if (wrong || !came)
      throw Silence{};
  }
  void Expect(std::span<const std::uint8_t> bytes)
  {
    this->Expect(bytes, [](std::size_t) {});
  }

  /// Sets the line for packets and sends some, without force.
  bool Answers(int packets)
  {
    this->Usb.Control(FtdiLatency, 1);
    this->Usb.Control(FtdiBaudRate, FtdiBaud1500k);
    if (this->Settings.eventCharacter)
      this->Usb.Control(FtdiEventCharacter, FtdiEventAtPacketEnd);
    this->Line.Purge();
    FalconFraming framing;
    int answers = 0;
    const auto hear = [&](std::span<std::uint8_t> payload)
    {
      for (const std::uint8_t byte : payload)
        answers += framing.Take(byte) ? 1 : 0;
      return answers > 0;
    };
    for (int sent = 1; sent <= packets; ++sent)
    {
      this->Leave();
      this->Send(Encode(FalconCommand{}));
      if (!this->Line.ReadUntil(25, hear))
        continue;
      // Late ones would be taken for answers to what is sent next.
      this->Line.ReadUntil(25 * sent,
        [&](std::span<std::uint8_t> payload)
        {
          hear(payload);
          return answers >= sent;
        });
      return true;
    }
    return false;
  }

  UsbTransport& Usb;
  const DeviceClock& Clock;
  const FalconBootSettings& Settings;
  const DriverOpening& How;
  FtdiLine Line;
  std::int64_t DeadlineNs;
  std::string Step; ///< what is being done, for people
};
} // namespace

void StartFalcon(UsbTransport& usb, const DeviceClock& clock, const FalconBootSettings& settings,
  const DriverOpening& how)
{
  FalconStart(usb, clock, settings, how).Run();
}

} // namespace hasp
