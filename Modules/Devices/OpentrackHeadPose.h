#pragma once
#include "Devices/OpentrackInbox.h"

#include <memory>

namespace hasp
{

struct OpentrackSettings
{
  std::string address = "127.0.0.1"; ///< this machine alone; elsewhere anybody may move the view
  std::uint16_t port = 4242;         ///< opentrack's; 0: a free one, see Port
  /// The head in the room, mm, when opentrack is centred. {0, 0, 0} where a TrackerCalibration maps
  /// opentrack's own coordinates: when it is made, and when it is used.
  glm::dvec3 origin{ 0, 0, 600 };
};

/// opentrack (github.com/opentrack/opentrack) as a tracker: a webcam or a clip with lights, on this
/// machine or another. In opentrack choose the output "UDP over network", 127.0.0.1, port 4242.
///
/// The protocol has neither sender nor checksum: whatever has 48 bytes and numbers in range is
/// believed. Everything else leaves the view as it is, is counted, and gives a warning once a kind.
/// No memory is taken for what is received.
///
/// Threads: as HeadPoseSource. One WORKER thread of its own receives while this object lives, waits
/// in poll, and ends at once with it; it hands over through TripleBuffer. Poses are stamped with
/// SteadySeconds as they come.
/// Cost: a socket, a thread that sleeps, microseconds a packet (bin/BenchHeadTracker); in a flood
/// 64 packets every 2 ms are looked at and no more, so that it does not take a core.
class OpentrackHeadPose : public HeadPoseSource
{
public:
  /// Throws std::invalid_argument (settings) or std::runtime_error (port in use and the like), with
  /// the remedy.
  explicit OpentrackHeadPose(const OpentrackSettings& settings = {});
  ~OpentrackHeadPose() override;

  std::uint16_t Port() const noexcept;
  /// As of the last call of Latest.
  OpentrackCounts Counts() const;

  std::optional<TimedHeadPose> Latest(double nowS) override;
  const char* Name() const noexcept override { return "opentrack"; }
  std::vector<std::string> TakeWarnings() override;

private:
  class Receiver;
  std::unique_ptr<Receiver> Thread;
  std::vector<bool> Warned; ///< by kind
};

} // namespace hasp
