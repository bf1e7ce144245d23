#include "FalconBench.h"

#include "Devices/Drivers/Falcon/FtdiLine.h"
#include "Grid/Progress.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>

using namespace hasp;

namespace
{
/// One start over a cable, in the model's time.
struct FalconBoot : testing::Test
{
  FalconBench bench;
  FalconBootSettings settings{ bench.settings.firmware };
  std::vector<std::string> said;
  DriverOpening how{ .says = [this](const std::string& what) { this->said.push_back(what); } };
  std::unique_ptr<UsbTransport> usb = PlugInto(bench.cable);

  void Start()
  {
    this->usb->Open();
    auto clock = this->bench.cable->Clock();
    clock.sleep = [this, sleep = clock.sleep](int ms)
    {
      EXPECT_FALSE(this->bench.cable->open) << "what is waited for is that it is closed";
      sleep(ms);
    };
    StartFalcon(*this->usb, clock, this->settings, this->how);
  }
  /// How it fails. Sentences name neither this machine's folders nor an error's number alone.
  std::string Failure(DeviceTrouble expected)
  {
    try
    {
      this->Start();
    }
    catch (const DeviceError& error)
    {
      EXPECT_EQ(error.trouble, expected) << error.what();
      EXPECT_FALSE(Says(error.what(), this->bench.folder.Path.string()));
      return error.what();
    }
    ADD_FAILURE() << "it started";
    return {};
  }
  double Seconds() const { return 1e-9 * static_cast<double>(this->bench.model->nowNs); }
};

/// The environment, put back.
class Variable
{
public:
  Variable(const char* name, const char* value) : Name(name)
  {
    if (const char* before = std::getenv(name))
      this->Before = before;
    this->Set(value);
  }
  ~Variable() { this->Set(this->Before ? this->Before->c_str() : nullptr); }

private:
  void Set(const char* value)
  {
    if (value)
      setenv(this->Name, value, 1);
    else
      unsetenv(this->Name);
  }
  const char* Name;
  std::optional<std::string> Before;
};

DeviceError ReadingFails(const std::filesystem::path& file)
{
  try
  {
    ReadFalconFirmware(file);
  }
  catch (const DeviceError& error)
  {
    EXPECT_EQ(error.trouble, DeviceTrouble::Firmware);
    EXPECT_FALSE(Says(error.what(), file.parent_path().string()));
    return error;
  }
  ADD_FAILURE() << "it was read";
  return { DeviceTrouble::Absent, "" };
}
} // namespace

TEST(FalconFirmware, IsLookedForInItsPlaces)
{
  const Variable file("HASP_FALCON_FIRMWARE", "/from/environment.bin");
  const Variable data("XDG_DATA_HOME", "/data");
  EXPECT_EQ(FalconFirmwareFile("/from/settings.bin"), "/from/settings.bin");
  EXPECT_EQ(FalconFirmwareFile(""), "/from/environment.bin");
  {
    const Variable none("HASP_FALCON_FIRMWARE", nullptr);
    EXPECT_EQ(FalconFirmwareFile(""), "/data/hasp/falcon-firmware.bin");
    const Variable noData("XDG_DATA_HOME", "");
    const Variable home("HOME", "/somebody");
    EXPECT_EQ(FalconFirmwareFile(""), "/somebody/.local/share/hasp/falcon-firmware.bin");
    const Variable noHome("HOME", nullptr);
    EXPECT_TRUE(FalconFirmwareFile("").empty());
  }
}

TEST(FalconFirmware, FileIsChecked)
{
  const TemporaryFolder folder;
  const auto key = [](std::size_t size) { return InventedFirmware(size); };
  for (const std::size_t size : { 7'000, 7'324, 8'492, 9'000 })
    EXPECT_EQ(ReadFalconFirmware(folder.File("good", key(size))), key(size));
  for (const std::size_t size : { 2, 6'999, 9'001, 1'000'000 })
    EXPECT_TRUE(Says(ReadingFails(folder.File("size", key(size))).what(), "7000 to 9000"));
  EXPECT_TRUE(Says(ReadingFails(folder.File("empty", {})).what(), "has 0 bytes"));
  auto other = key(8'000);
  other[1] = 0x09;
  EXPECT_TRUE(Says(ReadingFails(folder.File("other", other)).what(), "AA 08"));
  EXPECT_TRUE(Says(ReadingFails(folder.Path / "no such").what(), "HASP_FALCON_FIRMWARE"));
  EXPECT_TRUE(Says(ReadingFails(folder.Path).what(), "no file of bytes"));
}

TEST_F(FalconBoot, LoadsAtTheFirstTry)
{
  this->Start();
  EXPECT_TRUE(this->bench.model->Runs());
  EXPECT_LT(this->Seconds(), 5.0);
  EXPECT_EQ(this->said.back(), "loading the firmware, try 1 of 12");
  EXPECT_TRUE(this->bench.model->PushesNobody());
}

TEST_F(FalconBoot, LeavesAloneWhatRuns)
{
  this->bench.model->StartRunning();
  this->settings.firmware = "/no such file"; // it is not needed
  this->Start();
  EXPECT_EQ(this->said.size(), 1u);
  EXPECT_LT(this->Seconds(), 0.1);
}

TEST_F(FalconBoot, NoFileIsSaidOnlyWhenItIsNeeded)
{
  this->settings.firmware = "/no such file";
  EXPECT_TRUE(Says(this->Failure(DeviceTrouble::Firmware), "no file to load it from"));
}

TEST_F(FalconBoot, WrongEchoIsTriedAnewAsOftenAsItTakes)
{
  for (const int times : { 1, 3, 11 })
  {
    this->bench.model->SwitchOffAndOn();
    this->bench.model->faults.wrongEchoAt = 4'321;
    this->bench.model->faults.wrongEchoes = times;
    this->said.clear();
    this->Start();
    EXPECT_TRUE(this->bench.model->Runs());
    EXPECT_EQ(
      this->said.back(), "loading the firmware, try " + std::to_string(times + 1) + " of 12");
  }
}

TEST_F(FalconBoot, EachWrongByteIsFound)
{
  this->settings.tries = 1;
  for (const int at : { 0, 1, 61, 62, 63, 3'000, 7'911, 7'912, 7'913 })
  {
    this->bench.model->SwitchOffAndOn();
    this->bench.model->faults.wrongEchoAt = at;
    this->bench.model->faults.wrongEchoes = 1;
    EXPECT_TRUE(Says(this->Failure(DeviceTrouble::Boot),
      "echo of byte " + std::to_string(at + 1) + " of 7914, which came back wrong"));
    this->bench.model->Control(1, 0x0100);
  }
}

TEST_F(FalconBoot, SilenceEndsWithTheTimeBox)
{
  this->bench.model->faults.silent = true;
  const auto failure = this->Failure(DeviceTrouble::Boot);
  EXPECT_TRUE(Says(failure, "whether its boot loader listens"));
  EXPECT_GE(this->Seconds(), 15.0);
  EXPECT_LE(this->Seconds(), 22.5);
  EXPECT_GE(this->said.size(), 11u); // ten tries at least
}

TEST_F(FalconBoot, RefusedModemLinesAreNamed)
{
  this->bench.model->faults.noModemLines = true;
  const auto failure = this->Failure(DeviceTrouble::Boot);
  EXPECT_TRUE(Says(failure, "in 12 tries"));
  EXPECT_TRUE(Says(failure, "the modem lines, it refuses a request"));
}

TEST_F(FalconBoot, FirmwareThatDoesNotRunIsNamed)
{
  this->bench.model->faults.deadFirmware = true;
  EXPECT_TRUE(Says(this->Failure(DeviceTrouble::Boot), "the firmware does not answer"));
}

// The cable comes off at each of the calls of a boot, one after the other.
TEST_F(FalconBoot, UnplugAtAnyCallIsGoneOrAbsent)
{
  this->Start();
  const int calls = this->bench.cable->calls;
  ASSERT_GT(calls, 250);
  for (int at = 0; at < calls; ++at)
  {
    this->bench.model->Control(1, 0x0100);
    FalconModel fresh(InventedFirmware());
    fresh.nowNs = this->bench.model->nowNs;
    *this->bench.model = fresh;
    this->bench.cable->calls = 0;
    this->bench.cable->unplugAt = at;
    this->bench.cable->plugged = true;
    try
    {
      this->Start();
      ADD_FAILURE() << "it started, unplugged at call " << at;
    }
    catch (const DeviceError& error)
    {
      EXPECT_TRUE(error.trouble == DeviceTrouble::Gone || error.trouble == DeviceTrouble::Absent)
        << at << ": " << error.what();
    }
    this->usb->Close();
  }
  this->bench.cable->unplugAt = -1;
  this->bench.cable->plugged = true;
  this->Start();
  EXPECT_TRUE(this->bench.model->Runs());
}

TEST_F(FalconBoot, IsLeftWhenAsked)
{
  // At each question of a whole boot, and of one that fails and waits.
  for (const bool silent : { false, true })
  {
    int asked = 0, leaveAt = 1 << 30;
    this->how.cancelled = [&] { return asked++ >= leaveAt; };
    const auto start = [&]
    {
      FalconModel fresh(InventedFirmware());
      fresh.faults.silent = silent;
      *this->bench.model = fresh;
      asked = 0;
      this->Start();
    };
    if (silent)
      EXPECT_THROW(start(), DeviceError);
    else
      start();
    const int questions = asked;
    EXPECT_GT(questions, 100);
    for (leaveAt = 0; leaveAt < questions; leaveAt += silent ? 17 : 1)
    {
      EXPECT_THROW(start(), Cancelled) << leaveAt;
      EXPECT_EQ(asked, leaveAt + 1); // and at once
      this->usb->Close();
    }
  }
}

TEST_F(FalconBoot, DoesNotLoadWhereItMayNot)
{
  this->how.setUp = false;
  EXPECT_THROW(this->Start(), Cancelled);
  EXPECT_FALSE(this->bench.model->Runs());
  this->bench.model->StartRunning();
  this->Start();
}

TEST_F(FalconBoot, EventCharacterIsSetOnlyIfAsked)
{
  struct Requests : UsbTransport
  {
    explicit Requests(UsbTransport& usb) : Usb(usb) {}
    void Open() override { this->Usb.Open(); }
    void Close() noexcept override { this->Usb.Close(); }
    void Control(std::uint8_t request, std::uint16_t value) override
    {
      if (request == FtdiEventCharacter)
        this->Event = value;
      this->Usb.Control(request, value);
    }
    std::size_t Read(std::span<std::uint8_t> bytes, int timeoutMs) override
    {
      return this->Usb.Read(bytes, timeoutMs);
    }
    std::size_t Write(std::span<const std::uint8_t> bytes, int timeoutMs) override
    {
      return this->Usb.Write(bytes, timeoutMs);
    }
    UsbTransport& Usb;
    int Event = -1;
  } requests(*this->usb);
  const auto clock = this->bench.cable->Clock();
  this->usb->Open();
  StartFalcon(requests, clock, this->settings, this->how);
  EXPECT_EQ(requests.Event, -1);
  this->settings.eventCharacter = true;
  StartFalcon(requests, clock, this->settings, this->how);
  EXPECT_EQ(requests.Event, 0x013e);
}
