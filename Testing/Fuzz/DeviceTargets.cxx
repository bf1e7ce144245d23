#include "Devices/HeadPath.h"
#include "Devices/OpentrackInbox.h"
#include "Devices/SimulatedHeadPath.h"
#include "Devices/TrackerCalibration.h"
#include "Targets.h"

#include <cstdlib>
#include <fstream>
#include <iterator>
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
    { "opentrack", "input.packet", MakePacketSeeds, ReadPacket } };
#if HASP_WITH_JSON
  targets.push_back({ "tracker.json", "input.json", MakeCalibrationSeeds, ReadCalibration });
#endif
  return targets;
}

} // namespace hasp
