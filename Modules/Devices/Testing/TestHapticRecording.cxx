#include "Devices/HapticRecorder.h"
#include "Devices/HapticRecording.h"
#include "Devices/ReplayHapticDevice.h"

#include "Grid/Testing/CountNew.h"
#include "TemporaryFile.h"

#include <gtest/gtest.h>

#include <signal.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using namespace hasp;
using Bytes = std::vector<std::byte>;

std::string Refusal(const std::function<void()>& body)
{
  try
  {
    body();
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return {};
}

/// Any bits at all, NaN with payloads among them: what comes back is compared bit by bit.
HapticRecord AnyRecord(std::mt19937_64& random, std::uint64_t number)
{
  const auto any = [&random] { return std::bit_cast<double>(random()); };
  HapticRecord r;
  r.number = number;
  r.nowNs = static_cast<std::int64_t>(random());
  r.sample.timeNs = static_cast<std::int64_t>(random());
  r.sample.pose = { { any(), any(), any() }, { any(), any(), any(), any() } };
  r.sample.buttons = static_cast<std::uint32_t>(random());
  r.status = static_cast<DeviceStatus>(random() % 32);
  r.wrench = { { any(), any(), any() }, { any(), any(), any() } };
  r.costNs = static_cast<std::uint32_t>(random());
  r.contacts = static_cast<std::uint32_t>(random());
  return r;
}

std::array<std::byte, HapticRecordBytes> Packed(const HapticRecord& record)
{
  std::array<std::byte, HapticRecordBytes> bytes{};
  PackHapticRecord(record, bytes);
  return bytes;
}

Bytes FileOf(const std::vector<HapticRecord>& records, const HapticRecording& of = {})
{
  Bytes file(HapticHeaderBytes);
  PackHapticHeader(of, std::span<std::byte, HapticHeaderBytes>(file.data(), HapticHeaderBytes));
  for (const HapticRecord& record : records)
  {
    const auto bytes = Packed(record);
    file.insert(file.end(), bytes.begin(), bytes.end());
  }
  return file;
}

std::vector<HapticRecord> SomeRecords(std::size_t count)
{
  std::mt19937_64 random(5);
  std::vector<HapticRecord> records;
  for (std::size_t n = 0; n < count; ++n)
    records.push_back(AnyRecord(random, 10 * n + 1));
  return records;
}

TEST(HapticRecording, WhatIsNoRecordingIsRefusedAndNotQuoted)
{
  const auto why = [](Bytes bytes) { return Refusal([&] { ParseHapticRecording(bytes); }); };
  EXPECT_NE(why({}).find("there are 0 bytes"), std::string::npos);
  Bytes file = FileOf({});
  const auto changed = [&](std::size_t at, int to)
  {
    Bytes other = file;
    other[at] = static_cast<std::byte>(to);
    return why(other);
  };
  EXPECT_NE(changed(0, 'X').find("does not begin"), std::string::npos);
  EXPECT_NE(changed(8, 2).find("version 2"), std::string::npos);
  for (std::size_t at = 12; at < HapticHeaderBytes; ++at)
    EXPECT_NE(changed(at, 0x5A).find("header is damaged"), std::string::npos) << at;
  const auto headed = [&](const HapticRecording& of) { return why(FileOf({}, of)); };
  EXPECT_NE(headed({ .poseAxes = 5 }).find("axes"), std::string::npos);
  EXPECT_NE(headed({ .periodNs = 0 }).find("period"), std::string::npos);
  EXPECT_NE(headed({ .peakForceN = std::nan("") }).find("largest force"), std::string::npos);
}

TEST(HapticRecording, WholeRecordsThatCannotBeAreRefused)
{
  auto records = SomeRecords(3);
  records[2].number = records[1].number;
  EXPECT_NE(
    Refusal([&] { ParseHapticRecording(FileOf(records)); }).find("tick 3"), std::string::npos);
  records = SomeRecords(3);
  records[1].status = static_cast<DeviceStatus>(32);
  EXPECT_NE(
    Refusal([&] { ParseHapticRecording(FileOf(records)); }).find("tick 2"), std::string::npos);
}

/// Bytes written by hand from the table in the header, their CRC by another program (Python's
/// zlib).
TEST(HapticRecording, TheBytesAreThoseOfTheTable)
{
  HapticRecord r;
  r.number = 7;
  r.nowNs = 123456789;
  r.sample.timeNs = 123400000;
  r.sample.pose.position = { 1.5, -2.25, 3.0 };
  r.wrench = { { 0.5, -0.25, 0 }, { 10, 20, 30 } };
  r.sample.buttons = 2;
  r.status = DeviceStatus::Stale;
  r.costNs = 4321;
  r.contacts = 99;
  const auto bytes = Packed(r);
  const auto byte = [&](std::size_t at) { return std::to_integer<int>(bytes[at]); };
  EXPECT_EQ(byte(0), 7);
  EXPECT_EQ(byte(30), 0xF8); // 1.5 is 3FF8 0000 0000 0000
  EXPECT_EQ(byte(31), 0x3F);
  EXPECT_EQ(byte(136) + 256 * byte(137), 4321);
  std::uint32_t crc = 0;
  for (int b = 0; b < 4; ++b)
    crc |= static_cast<std::uint32_t>(byte(148 + b)) << 8 * b;
  EXPECT_EQ(crc, 0x1C31E8B6u);
  const Bytes header =
    FileOf({}, { .poseAxes = 3, .forceAxes = 3, .peakForceN = 8.9, .peakTorqueNmm = 0.0 });
  crc = 0;
  for (int b = 0; b < 4; ++b)
    crc |= std::to_integer<std::uint32_t>(header[60 + b]) << 8 * b;
  EXPECT_EQ(crc, 0xB44C2348u);
}

TEST(HapticRecording, AnythingComesBackToTheLastBit)
{
  const auto records = SomeRecords(200);
  const HapticRecording of{
    .periodNs = 250'000, .poseAxes = 3, .forceAxes = 0, .peakForceN = 22.0, .peakTorqueNmm = 188.0
  };
  const HapticRecording back = ParseHapticRecording(FileOf(records, of));
  EXPECT_EQ(back.periodNs, 250'000);
  EXPECT_EQ(back.poseAxes, 3);
  EXPECT_EQ(back.forceAxes, 0);
  EXPECT_EQ(back.peakForceN, 22.0);
  EXPECT_EQ(back.peakTorqueNmm, 188.0);
  EXPECT_EQ(back.bytesLost, 0u);
  ASSERT_EQ(back.records.size(), records.size());
  for (std::size_t n = 0; n < records.size(); ++n)
    EXPECT_EQ(Packed(back.records[n]), Packed(records[n]));
}

TEST(HapticRecording, SaysWhichKernelsRan)
{
  for (const char* name : { "", "AVX2", "scalar", "AVX3_DL", "12345678" })
  {
    const HapticRecording back = ParseHapticRecording(FileOf({}, { .kernels = name }));
    EXPECT_EQ(back.kernels, name);
    EXPECT_EQ(WhyBitsDiffer(back, name), "");
    EXPECT_EQ(WhyBitsDiffer(back, "SSE4").empty(), back.kernels.empty()) << name;
  }
  const HapticRecording longer =
    ParseHapticRecording(FileOf({}, { .kernels = "NEON_WITHOUT_AES" }));
  EXPECT_EQ(longer.kernels, "NEON_WIT");
  EXPECT_EQ(WhyBitsDiffer(longer, "NEON_WITHOUT_AES"), "");
  EXPECT_EQ(WhyBitsDiffer({ .kernels = "SECRET" }, "AVX2").find("SECRET"), std::string::npos);
  // What a file says is text of anybody's.
  for (const char* name : { "AVX 2", "<b>", "a\nb" })
    EXPECT_NE(
      Refusal([&] { ParseHapticRecording(FileOf({}, { .kernels = name })); }).find("name is none"),
      std::string::npos);
}

TEST(HapticRecording, AFileCutOffAnywhereIsGoodToTheLastWholeRecord)
{
  const auto records = SomeRecords(3);
  const Bytes whole = FileOf(records);
  for (std::size_t bytes = HapticHeaderBytes; bytes <= whole.size(); ++bytes)
  {
    const HapticRecording cut = ParseHapticRecording(std::span(whole).first(bytes));
    const std::size_t left = bytes - HapticHeaderBytes;
    ASSERT_EQ(cut.records.size(), left / HapticRecordBytes);
    ASSERT_EQ(cut.bytesLost, left % HapticRecordBytes);
  }
}

TEST(HapticRecording, ADamagedRecordEndsIt)
{
  const Bytes whole = FileOf(SomeRecords(3));
  for (std::size_t at = HapticHeaderBytes + HapticRecordBytes;
       at < HapticHeaderBytes + 2 * HapticRecordBytes; ++at)
  {
    Bytes damaged = whole;
    damaged[at] ^= std::byte(1u << at % 8);
    const HapticRecording read = ParseHapticRecording(damaged);
    ASSERT_EQ(read.records.size(), 1u) << at;
    ASSERT_EQ(read.bytesLost, 2 * HapticRecordBytes);
  }
}

TEST(HapticRecording, TooLargeIsRefusedBeforeMemoryIsTaken)
{
  const TemporaryFile file;
  std::ofstream(file.Path) << "HASPTICK";
  std::filesystem::resize_file(file.Path, std::uintmax_t(1) << 30); // a hole: no disk is used
  const std::string why = Refusal([&] { ReadHapticRecording(file.Path); });
  EXPECT_NE(why.find("at most"), std::string::npos) << why;
  EXPECT_EQ(why.find("hasp-ticks"), std::string::npos) << "no name in it";
  EXPECT_FALSE(Refusal([] { ReadHapticRecording("/nowhere/SECRET"); }).empty());
  EXPECT_EQ(
    Refusal([] { ReadHapticRecording("/nowhere/SECRET"); }).find("SECRET"), std::string::npos);
}

TEST(HapticRecorder, WhatCannotBeWrittenIsRefused)
{
  for (const char* file : { "/nowhere/SECRET", "/dev/full" })
  {
    const std::string why = Refusal([&] { HapticRecorder(file, {}); });
    EXPECT_NE(why.find("cannot be written"), std::string::npos) << why;
    EXPECT_EQ(why.find(file), std::string::npos) << why;
  }
  const TemporaryFile file;
  EXPECT_NE(
    Refusal([&] { HapticRecorder(file.Path, {}, 0); }).find("ringTicks"), std::string::npos);
}

TEST(HapticRecorder, EveryTickIsInTheFile)
{
  const TemporaryFile file;
  const auto records = SomeRecords(3000);
  HapticRecorder recorder(file.Path, { .peakForceN = 8.9 });
  const std::size_t before = test::NewCountOfAllThreads();
  for (const HapticRecord& record : records)
    recorder.Push(record);
  EXPECT_EQ(test::NewCountOfAllThreads(), before) << "neither the tick nor the writer takes memory";
  recorder.Finish();
  recorder.Finish();
  EXPECT_EQ(recorder.Counts().written, records.size());
  EXPECT_TRUE(recorder.Losses().empty());
  const HapticRecording read = ReadHapticRecording(file.Path);
  EXPECT_EQ(read.peakForceN, 8.9);
  ASSERT_EQ(read.records.size(), records.size());
  for (std::size_t n = 0; n < records.size(); ++n)
    ASSERT_EQ(Packed(read.records[n]), Packed(records[n]));
}

/// Whatever the two threads' pace: each tick is in the file or counted as lost, and the file says
/// which.
TEST(HapticRecorder, WhatFindsTheRingFullIsCounted)
{
  const TemporaryFile file;
  const auto records = SomeRecords(5000);
  HapticRecorder recorder(file.Path, {}, 64);
  for (const HapticRecord& record : records)
    recorder.Push(record);
  recorder.Finish();
  const HapticRecorderCounts counts = recorder.Counts();
  EXPECT_EQ(counts.written + counts.full, records.size());
  EXPECT_GE(counts.written, 64u);
  ASSERT_GT(counts.full, 0u) << "5000 ticks at once, and 64 places emptied every 20 ms";
  ASSERT_EQ(recorder.Losses().size(), 1u);
  const HapticRecording read = ReadHapticRecording(file.Path);
  ASSERT_EQ(read.records.size(), counts.written);
  for (const HapticRecord& record : read.records)
    EXPECT_EQ(Packed(record), Packed(records[(record.number - 1) / 10]));
}

TEST(HapticRecorder, ADiskThatIsFullLeavesAReadableFile)
{
  const TemporaryFile file;
  const auto records = SomeRecords(40);
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = HapticHeaderBytes + 10 * HapticRecordBytes + 50;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  HapticRecorder recorder(file.Path, {});
  for (const HapticRecord& record : records)
    recorder.Push(record);
  recorder.Finish();
  setrlimit(RLIMIT_FSIZE, &before);
  signal(SIGXFSZ, handler);
  EXPECT_EQ(recorder.Counts().written, 10u) << "as many as are in the file";
  EXPECT_EQ(recorder.Counts().failed, 30u);
  ASSERT_EQ(recorder.Losses().size(), 1u);
  EXPECT_NE(recorder.Losses()[0].find("disk"), std::string::npos);
  const HapticRecording read = ReadHapticRecording(file.Path);
  EXPECT_EQ(read.records.size(), 10u);
  EXPECT_EQ(read.bytesLost, 50u);
}

TEST(HapticRecorder, ARingThatIsTooLongIsRefusedBeforeMemoryIsTaken)
{
  const TemporaryFile file;
  const auto mostKiB = []
  {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
  };
  const long before = mostKiB();
  EXPECT_NE(Refusal([&] { HapticRecorder(file.Path, {}, 2'000'000); }).find("ringTicks"),
    std::string::npos);
  EXPECT_LT(mostKiB() - before, 100'000) << "2^21 ticks are 340 MB";
  EXPECT_FALSE(std::filesystem::exists(file.Path));
}

/// A session's ticks in a file that nobody can read are lost at the beginning, not at the end.
TEST(HapticRecorder, WhatItsReaderRefusesIsNotBegun)
{
  const TemporaryFile file;
  for (const HapticRecording& of :
    { HapticRecording{ .periodNs = 0 }, HapticRecording{ .poseAxes = 5 },
      HapticRecording{ .forceAxes = 1 }, HapticRecording{ .peakForceN = 2000.0 },
      HapticRecording{ .peakTorqueNmm = std::nan("") } })
  {
    EXPECT_NE(Refusal([&] { HapticRecorder(file.Path, of); }).find("must be"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(file.Path)) << "nor is a file emptied";
  }
}

/// A loop that was started again counts from 0 again.
TEST(HapticRecorder, TicksThatAreNotYoungerAreLostAloneAndCounted)
{
  const TemporaryFile file;
  auto records = SomeRecords(20);
  records[10].number = 0;
  records[11].number = records[9].number;
  HapticRecorder recorder(file.Path, {});
  for (const HapticRecord& record : records)
    recorder.Push(record);
  recorder.Finish();
  const HapticRecording read = ReadHapticRecording(file.Path);
  EXPECT_EQ(read.records.size(), 18u);
  EXPECT_EQ(recorder.Counts().written, 18u);
  EXPECT_EQ(recorder.Counts().disordered, 2u);
  ASSERT_EQ(recorder.Losses().size(), 1u);
  EXPECT_NE(recorder.Losses()[0].find("2 ticks"), std::string::npos);
}

} // namespace
