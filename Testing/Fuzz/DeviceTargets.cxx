#include "Devices/HapticRecording.h"
#include "Devices/HeadPath.h"
#include "Devices/OpentrackInbox.h"
#include "Devices/ReplayHapticDevice.h"
#include "Devices/SimulatedHeadPath.h"
#include "Devices/TrackerCalibration.h"
#include "Targets.h"

#include "vtk_zlib.h"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <span>
#include <stdexcept>

namespace hasp
{
namespace
{

using Path = std::filesystem::path;

void MakeHeadPathSeeds(const Path& folder)
{
  for (int n = 1; n <= 3; ++n)
    WriteHeadPath((folder / ("path" + std::to_string(n))).string(),
      SimulatedHeadPath({ .noiseMm = 0.1 * n }).Record(0.0, n, 10.0));
}

/// What is read is a path, whatever the file says.
void ReadPath(const Path& file, const Path&)
{
  const HeadPath path = ReadHeadPath(file.string());
  ValidateHeadPath(path);
  for (const TimedHeadPose& pose : path)
    if (FaultOf(HeadPoseAt(path, pose.timeS + 1e-3)) != HeadPoseFault::None)
      std::abort();
}

void MakePacketSeeds(const Path& folder)
{
  const SimulatedHeadPath path({ .center = glm::dvec3(0.0) });
  for (int n = 0; n < 4; ++n)
  {
    const auto packet = MakeOpentrackPacket(path.At(n));
    std::ofstream(folder / ("packet" + std::to_string(n)), std::ios::binary)
      .write(reinterpret_cast<const char*>(packet.data()), std::streamsize(packet.size()));
  }
}

/// The file is a packet.
void ReadPacket(const Path& file, const Path&)
{
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{ std::istreambuf_iterator<char>(stream),
    std::istreambuf_iterator<char>() };
  OpentrackInbox inbox({ 0, 0, 600 });
  const auto pose = inbox.Take(std::as_bytes(std::span(bytes)), 1.0);
  if (!pose)
    throw std::runtime_error("no pose");
  if (FaultOf(pose->pose) != HeadPoseFault::None)
    std::abort();
}

void MakeTickSeeds(const Path& folder)
{
  for (std::size_t ticks : { 0, 1, 20 })
  {
    std::string bytes(HapticHeaderBytes + ticks * HapticRecordBytes, '\0');
    const auto all = std::as_writable_bytes(std::span(bytes));
    PackHapticHeader({}, all.first<HapticHeaderBytes>());
    HapticRecord record;
    for (std::size_t n = 0; n < ticks; ++n)
    {
      record.nowNs = record.sample.timeNs = static_cast<std::int64_t>(++record.number) * 1'000'000;
      record.sample.pose.position.x = 0.1 * static_cast<double>(n);
      PackHapticRecord(
        record, all.subspan(HapticHeaderBytes + n * HapticRecordBytes).first<HapticRecordBytes>());
    }
    std::ofstream(folder / ("ticks" + std::to_string(ticks)), std::ios::binary) << bytes;
  }
}

/// What is read can be replayed to its end.
void ReadTicks(const Path& file, const Path&)
{
  const auto recording = std::make_shared<HapticRecording>(ReadHapticRecording(file.string()));
  ReplayHapticDevice device(recording);
  DeviceSample sample;
  std::size_t ticks = 0;
  for (; const auto nowNs = device.NextNs(); ++ticks)
  {
    device.Read(*nowNs, sample);
    device.Write({});
  }
  if (ticks != recording->records.size() || ticks > MostHapticRecords)
    std::abort();
}

/// Each checksum as it should be, so that what stands behind them is met.
std::string SealTicks(const std::string& bytes)
{
  std::string sealed = bytes;
  const auto seal = [&](std::size_t begin, std::size_t count)
  {
    const auto sum = static_cast<std::uint32_t>(crc32(
      0, reinterpret_cast<const Bytef*>(sealed.data() + begin), static_cast<uInt>(count - 4)));
    for (std::size_t b = 0; b < 4; ++b)
      sealed[begin + count - 4 + b] = static_cast<char>(sum >> (8 * b) & 255);
  };
  if (sealed.size() >= HapticHeaderBytes)
    seal(0, HapticHeaderBytes);
  for (std::size_t at = HapticHeaderBytes; at + HapticRecordBytes <= sealed.size();
       at += HapticRecordBytes)
    seal(at, HapticRecordBytes);
  return sealed;
}

#if HASP_WITH_JSON
void MakeCalibrationSeeds(const Path& folder)
{
  WriteTrackerCalibration((folder / "plain").string(), {});
  WriteTrackerCalibration((folder / "turned").string(),
    { HeadOrientation(0.3, 0.2, 0.1), { 10, 300, -50 }, { 0, -80, 20 }, { 0, 1, 0, 0 } });
}

void ReadCalibration(const Path& file, const Path&)
{
  ValidateTrackerCalibration(ReadTrackerCalibration(file.string()));
}
#endif

} // namespace

std::vector<Target> DeviceTargets()
{
  std::vector<Target> targets{ { "head.csv", "input.csv", MakeHeadPathSeeds, ReadPath },
    { "opentrack", "input.packet", MakePacketSeeds, ReadPacket },
    { "ticks", "input.ticks", MakeTickSeeds, ReadTicks },
    { "in.ticks", "input.ticks", MakeTickSeeds, ReadTicks, SealTicks } };
#if HASP_WITH_JSON
  targets.push_back({ "tracker.json", "input.json", MakeCalibrationSeeds, ReadCalibration });
#endif
  return targets;
}

} // namespace hasp
