// What haptic devices without hardware cost a tick: nanoseconds, the least and the worst mean of 30
// batches. bin/BenchHapticDevices
#include "Devices/GuardedHapticDevice.h"
#include "Devices/HapticRecorder.h"
#include "Devices/InputHapticDevice.h"
#include "Devices/SimulatedHapticDevice.h"
#include "Devices/WorkspaceMapping.h"
#include "Realtime/RateMonitor.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>

namespace
{

using namespace hasp;

constexpr std::int64_t Ms = 1'000'000;

template <class Body>
void Print(const char* what, int calls, const Body& body)
{
  double least = 1e300, most = 0.0;
  for (int batch = 0; batch < 30; ++batch)
  {
    const auto start = std::chrono::steady_clock::now();
    for (int call = 0; call < calls; ++call)
      body();
    const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - start;
    least = std::min(least, spent.count() / calls);
    most = std::max(most, spent.count() / calls);
  }
  std::printf("%-46s %10.1f %10.1f\n", what, least, most);
}

/// A device that costs nothing itself.
class Nothing : public HapticDevice
{
public:
  const DeviceProfile& Profile() const noexcept override { return this->Is; }
  DeviceStatus Read(std::int64_t nowNs, DeviceSample& sample) noexcept override
  {
    sample.timeNs = nowNs;
    return DeviceStatus::Ok;
  }
  DeviceStatus Write(const Wrench& wrench) noexcept override
  {
    this->Felt = wrench;
    return DeviceStatus::Ok;
  }

private:
  DeviceProfile Is;
  Wrench Felt;
};

template <class Device>
void PrintTick(const char* what, int calls, Device& device)
{
  DeviceSample sample;
  std::int64_t now = 0;
  Print(what, calls,
    [&]
    {
      device.Read(now += Ms, sample);
      device.Write({ -0.1 * sample.pose.position });
    });
}

} // namespace

int main()
{
  std::printf("%-46s %10s %10s\n", "ns", "least", "worst");
  RateMonitor monitor;
  std::int64_t n = 0;
  Print("RateMonitor::Add", 100'000, [&] { monitor.Add({ Ms + n % 977, n++ % 877, 1000 }); });
  Print("RateMonitor::Read", 2'000, [&] { n += static_cast<std::int64_t>(monitor.Read().ticks); });

  GuardedHapticDevice guarded(std::make_unique<Nothing>());
  PrintTick("guarded device: Read and Write", 100'000, guarded);
  InputHapticDevice input;
  input.SetRates({ 1, 1, 1 }, { 1, 1, 1 }, 0);
  PrintTick("input device: Read and Write", 100'000, input);

  WorkspaceMapping mapping;
  RigidPose pose;
  Print("workspace mapping: Update and ToDevice", 100'000,
    [&]
    {
      pose.position.x += 1e-6;
      pose.position.y = mapping.Update(pose, false, 0.001).position.x;
      pose.position.z = mapping.ToDevice({ pose.position }).force.x;
    });
  {
    HapticRecorder recorder("/dev/null", {}, 1'000'000);
    HapticRecord record;
    Print("recorder: Push", 30'000,
      [&]
      {
        ++record.number;
        recorder.Push(record);
      });
  }
  const HandMotion chirp = ChirpMotion{ { 5, 5, 5 }, { 0.1, 0, 0 }, 0.5, 5.0, 1e5 };
  SimulatedHapticDevice still({}, HandIntention());
  PrintTick("simulated device: a tick of 1 ms, holding", 500, still);
  SimulatedHapticDevice moving({}, HandIntention({}, { chirp }));
  PrintTick("simulated device: moving", 500, moving);
  SimulatedHapticDevice trembling({}, HandIntention({}, { chirp }, { .reachMm = 0.1 }));
  PrintTick("simulated device: moving, with tremor", 500, trembling);
  if (n == 1) // keeps what was read
    std::printf("\n");
}
