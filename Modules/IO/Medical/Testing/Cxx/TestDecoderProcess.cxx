#include "Dicom/DicomWire.h"
#include "DicomFixture.h"

#include "vtkHaspFileNames.h"

#include <sys/wait.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>

namespace
{

/// The parent against decoders that misbehave: shell scripts put in the real one's place.
class DecoderProcess : public DicomFixture
{
protected:
  ~DecoderProcess() override { unsetenv("HASP_DICOM_DECODER"); }

  void Pretend(const std::string& script) const
  {
    const auto file = this->Folder / "decoder";
    WriteBytes(file, "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    setenv("HASP_DICOM_DECODER", file.c_str(), 1);
  }
  /// A decoder that answers each call with these records.
  void Answer(const std::vector<hasp::SliceRecord>& records) const
  {
    std::string bytes;
    AppendBytes(bytes, records.data(), records.size());
    WriteBytes(this->Folder / "answer", bytes);
    this->Pretend("exec cat '" + (this->Folder / "answer").string() + "'");
  }
  std::filesystem::path TwoFiles() const
  {
    const auto folder = this->Folder / "two";
    std::filesystem::create_directories(folder);
    WriteBytes(folder / "a.dcm", "a");
    WriteBytes(folder / "b.dcm", "b");
    return folder;
  }
  /// A record without fault, of the file with this number.
  static hasp::SliceRecord Sound(std::uint32_t index)
  {
    hasp::SliceRecord r{};
    r.magic = hasp::SliceRecord::Magic;
    r.index = index;
    r.flags = hasp::HasSpacing | hasp::HasPosition | hasp::HasOrientation | hasp::Packed |
              hasp::Monochrome2;
    r.rows = r.columns = 16;
    r.frames = r.samplesPerPixel = 1;
    r.bitsAllocated = r.bitsStored = 16;
    r.highBit = 15;
    r.spacing[0] = r.spacing[1] = 1.0;
    r.position[2] = index;
    r.orientation[0] = r.orientation[4] = 1.0;
    r.slope = 1.0;
    return r;
  }
};

TEST_F(DecoderProcess, MissingDecoderSaysWhatToSet)
{
  setenv("HASP_DICOM_DECODER", "/nonexistent/decoder", 1);
  this->ExpectRefused(this->TwoFiles(), { "HASP_DICOM_DECODER" });
}

TEST_F(DecoderProcess, HangingChildIsEndedAndLeavesNothingBehind)
{
  this->Pretend("exec sleep 60");
  hasp::VolumeReadSettings settings;
  settings.decoderSilenceSeconds = 0.2;
  const auto start = std::chrono::steady_clock::now();
  this->ExpectRefused(this->TwoFiles(), { "hangs at a.dcm" }, settings);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

TEST_F(DecoderProcess, ChildThatDripsMeetsTheTotalLimit)
{
  this->Pretend("while printf x; do sleep 0.05; done");
  hasp::VolumeReadSettings settings;
  settings.decoderSilenceSeconds = 5.0;
  settings.decoderTotalSeconds = 0.4;
  this->ExpectRefused(this->TwoFiles(), { "hangs" }, settings);
}

TEST_F(DecoderProcess, CrashIsAnError)
{
  this->Pretend("kill -SEGV $$");
  this->ExpectRefused(this->TwoFiles(), { "crashed at a.dcm", "Segmentation fault" });
}

TEST_F(DecoderProcess, GivingUpIsAnError)
{
  this->Pretend("exit 3");
  this->ExpectRefused(this->TwoFiles(), { "more memory", "a.dcm" });
  this->Pretend("exit 7");
  this->ExpectRefused(this->TwoFiles(), { "code 7" });
}

TEST_F(DecoderProcess, GarbageIsAnError)
{
  this->Pretend("head -c 100000 /dev/urandom");
  this->ExpectRefused(this->TwoFiles(), { "no valid answer", "HASP_DICOM_DECODER" });
  this->Pretend("echo usage");
  this->ExpectRefused(this->TwoFiles(), { "a.dcm" });
}

TEST_F(DecoderProcess, EveryFieldOfTheHeaderIsChecked)
{
  const auto refused = [&](const char* what, const auto& spoil)
  {
    SCOPED_TRACE(what);
    auto second = Sound(1);
    spoil(second);
    this->Answer({ Sound(0), second });
    this->ExpectRefused(this->TwoFiles(), { "no valid answer at b.dcm", what });
  };
  refused("out of order", [](auto& r) { r.index = 0; });
  refused("status", [](auto& r) { r.status = 77; });
  refused("status", [](auto& r) { r.flags |= 0x80000000; });
  refused("size", [](auto& r) { r.rows = 70000; });
  refused("text", [](auto& r) { std::memset(r.series, 'x', sizeof(r.series)); });
  // Only texts of our own lists pass, so that no patient's can, whoever speaks for the decoder.
  refused("text", [](auto& r) { std::strcpy(r.modality, "Canary"); });
  refused("text", [](auto& r) { std::strcpy(r.photometric, "Canary"); });
  refused("text", [](auto& r) { std::strcpy(r.transferSyntax, "Canary"); });
  refused("text", [](auto& r) { std::strcpy(r.patientPosition, "Canary"); });
  refused("number of pixels", [](auto& r) { r.pixelBytes = 512; }); // in a scan there are none
  this->Answer({ Sound(0), Sound(1), Sound(2) });
  this->ExpectRefused(this->TwoFiles(), { "more than was asked for" });
}

TEST_F(DecoderProcess, HugeClaimIsRefusedBeforeMemoryIsTaken)
{
  auto a = Sound(0), b = Sound(1);
  a.rows = a.columns = b.rows = b.columns = 60000;
  this->Answer({ a, b });
  this->ExpectRefused(this->TwoFiles(), { "60000 x 60000 x 2", "memory limit" });
}

TEST_F(DecoderProcess, FewerPixelsThanPromisedAreAnError)
{
  this->Answer({ Sound(0), Sound(1) });
  const auto opened = hasp::OpenVolume(this->TwoFiles().string());
  auto promising = Sound(0);
  promising.pixelBytes = 512;
  this->Answer({ promising }); // and no pixels after it
  EXPECT_THROW(hasp::LoadVolume(opened), std::runtime_error);
  promising.pixelBytes = 1U << 30;
  this->Answer({ promising });
  EXPECT_THROW(hasp::LoadVolume(opened), std::runtime_error);
  promising.rows = 17; // another size than when the volume was laid out
  promising.pixelBytes = 17 * 16 * 2;
  this->Answer({ promising });
  EXPECT_THROW(hasp::LoadVolume(opened), std::runtime_error);
}

TEST_F(DecoderProcess, LittleMemoryEndsTheChildAlone)
{
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "AddressSanitizer needs the addresses that the limit takes away";
#endif
  auto g = this->Truth();
  g.dims = { 2000, 1500, 2 };
  const std::vector<std::int16_t> samples(g.Size(), 40);
  const auto folder = this->Folder / "large";
  this->WriteSeries(folder, g, samples);
  hasp::VolumeReadSettings settings;
  settings.decoderMemoryBytes = 1 << 20; // less than the program itself: no allocation succeeds
  this->ExpectRefused(folder, { "decoder" }, settings);
}

TEST_F(DecoderProcess, SlowChildThatAnswersIsLetBe)
{
  for (const char* name : { "answer0", "answer1", "answer2" })
  {
    std::string bytes;
    const auto record = Sound(static_cast<std::uint32_t>(name[6] - '0'));
    AppendBytes(bytes, &record, 1);
    WriteBytes(this->Folder / name, bytes);
  }
  const std::string folder = this->Folder.string();
  this->Pretend("for n in 0 1 2; do sleep 0.4; cat '" + folder + "'/answer$n; done");
  const auto files = this->TwoFiles();
  WriteBytes(files / "c.dcm", "c");
  hasp::VolumeReadSettings settings;
  settings.decoderSilenceSeconds = 1.0; // less than the three take together
  EXPECT_NO_THROW(hasp::OpenVolume(files.string(), settings));
}

TEST_F(DecoderProcess, LargeSliceHasMoreTimeToBeDecoded)
{
  const auto refusedAfter = [&](std::uint32_t size, std::size_t fileBytes)
  {
    auto a = Sound(0), b = Sound(1);
    a.rows = a.columns = b.rows = b.columns = size;
    this->Answer({ a, b });
    const auto files = this->TwoFiles();
    WriteBytes(files / "a.dcm", std::string(fileBytes, 'a'));
    hasp::VolumeReadSettings settings;
    settings.decoderSilenceSeconds = 0.1;
    const auto opened = hasp::OpenVolume(files.string(), settings);
    this->Pretend("exec sleep 60");
    const auto start = std::chrono::steady_clock::now();
    EXPECT_THROW(hasp::LoadVolume(opened), std::runtime_error);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  // 2048 x 2048 of 16 bits: 8 MiB, one second more. The same claimed by a tiny file gives it 64
  // times its bytes and no more.
  EXPECT_GE(refusedAfter(2048, 1 << 20), 1.1);
  EXPECT_LT(refusedAfter(2048, 16), 1.1);
}

TEST_F(DecoderProcess, SliceIsNamedByItsPlaceInTheFolderAndNotInTheStack)
{
  auto a = Sound(0), b = Sound(1);
  std::swap(a.position[2], b.position[2]); // b.dcm is the stack's first, and decoded first
  this->Answer({ a, b });
  const auto opened = hasp::OpenVolume(this->TwoFiles().string());
  this->Pretend("kill -SEGV $$");
  for (const bool shown : { true, false })
  {
    hasp::ShowFileNames(shown);
    try
    {
      hasp::LoadVolume(opened);
      ADD_FAILURE() << "was read";
    }
    catch (const std::runtime_error& error)
    {
      EXPECT_NE(std::string(error.what()).find(shown ? "at b.dcm" : "at file 2"), std::string::npos)
        << error.what();
    }
  }
}

TEST_F(DecoderProcess, CancelEndsTheChild)
{
  this->Pretend("exec sleep 60");
  EXPECT_THROW(
    hasp::OpenVolume(this->TwoFiles().string(), {}, [](double) { return false; }), hasp::Cancelled);
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
}

} // namespace
