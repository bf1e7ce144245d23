// What a frame pays for the head: microseconds of HeadTracker::At with trackers of several rates,
// and how long a pose of opentrack takes through a real socket and the thread that receives it.
#include "Devices/HeadTracker.h"
#include "Devices/OpentrackHeadPose.h"
#include "Devices/RecordedHeadPose.h"
#include "Devices/SimulatedHeadPath.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <vector>

namespace
{

void Print(const char* what, std::vector<double> microseconds)
{
  std::sort(microseconds.begin(), microseconds.end());
  const std::size_t n = microseconds.size();
  std::printf("%-34s %8.1f %8.1f %8.1f\n", what, microseconds[n / 2], microseconds[n * 99 / 100],
    microseconds.back());
}

void MeasureTracker(double hz, double frameHz)
{
  hasp::HeadTracker tracker(std::make_unique<hasp::RecordedHeadPose>(
    hasp::SimulatedHeadPath({ .noiseMm = 0.2 }).Record(0.0, 60.0, hz),
    hasp::PlaybackSettings{ .interpolate = false }));
  std::vector<double> spent;
  for (double now = 1.0; now < 59.0; now += 1.0 / frameHz)
  {
    const double before = hasp::SteadySeconds();
    tracker.At(now);
    spent.push_back(1e6 * (hasp::SteadySeconds() - before));
  }
  char what[64];
  std::snprintf(what, sizeof what, "At, tracker %.0f Hz, asked %.0f Hz", hz, frameHz);
  Print(what, std::move(spent));
}

void MeasureSocket()
{
  hasp::OpentrackHeadPose source({ .port = 0 });
  const int handle = socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(source.Port());
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  std::vector<double> spent;
  for (int n = 1; n <= 2000; ++n)
  {
    const auto packet = hasp::MakeOpentrackPacket({ { 0.01 * n, 0, 0 }, { 1, 0, 0, 0 } });
    const double before = hasp::SteadySeconds();
    sendto(handle, packet.data(), packet.size(), 0, reinterpret_cast<sockaddr*>(&to), sizeof to);
    do
      source.Latest(0.0);
    while (source.Counts().packets < static_cast<std::uint64_t>(n));
    spent.push_back(1e6 * (hasp::SteadySeconds() - before));
  }
  close(handle);
  Print("opentrack, from send to Latest", std::move(spent));
}

} // namespace

int main()
{
  std::printf("%-34s %8s %8s %8s\n", "us", "median", "p99", "most");
  MeasureTracker(60, 60);
  MeasureTracker(250, 60);
  MeasureTracker(1000, 1000);
  MeasureSocket();
}
