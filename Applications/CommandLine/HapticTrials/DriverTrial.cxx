#include "Devices/Drivers/DeviceSession.h"
#include "Devices/Drivers/Falcon/FalconDriver.h"
#include "Devices/Drivers/Trials/FalconModel.h"
#include "HapticTrials.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

namespace hasp
{
namespace
{

constexpr std::int64_t TickNs = 1'000'000;
constexpr double CountsPerNm = 5'000.0;
constexpr int Batch = 100; // a tick is shorter than a look at the clock

/// A Falcon in one process, homed and pushed long enough that its force is no longer ramped in.
class FalconDesk
{
public:
  FalconDesk()
  {
    this->Cable->model = this->Model;
    this->Model->StartRunning();
    this->Model->MoveTo({ 5, -3, 8 });
  }
  std::unique_ptr<HapticDriver> Driver()
  {
    return std::make_unique<FalconDriver>(
      PlugInto(this->Cable), FalconSettings{ .countsPerNm = CountsPerNm }, this->Cable->Clock());
  }
  void Home(const std::function<void()>& exchange)
  {
    exchange();
    this->Model->PullOutAndPushIn();
    for (int n = 0; n < 700; ++n)
      exchange();
  }
  FalconModel& Device() { return *this->Model; }

private:
  std::shared_ptr<FalconModel> Model = std::make_shared<FalconModel>(InventedFirmware());
  std::shared_ptr<FalconCable> Cable = std::make_shared<FalconCable>();
};

const Wrench Push{ { 0.3, -0.4, 0.8 }, {} };

/// The session and HAPTIC, taking turns: `driverFirst` or not in each millisecond.
struct SessionBench
{
  explicit SessionBench(bool driverFirst) : first(driverFirst)
  {
    this->desk.Home([this] { this->Tick(Push); });
  }
  void Tick(const Wrench& wrench)
  {
    this->nowNs += TickNs;
    if (this->first)
      this->session.Step(this->nowNs);
    this->session.Read(this->sample);
    this->session.Write(wrench);
    if (!this->first)
      this->session.Step(this->nowNs);
  }
  FalconDesk desk;
  DeviceSession session{ this->desk.Driver() };
  DeviceSample sample;
  std::int64_t nowNs = 0;
  bool first;
};

/// Ticks from a move of the grip until HAPTIC reads it, and from a force that HAPTIC writes until
/// the motors do it. The worse of both orders within a millisecond.
struct Delays
{
  int in = 0, out = 0;
  double poseErrorMm = 0.0, forceErrorShare = 0.0;
};

Delays MeasureDelays()
{
  constexpr int most = 50;
  constexpr double nearMm = 0.1, nearN = 0.1;
  Delays delays;
  for (const bool first : { true, false })
  {
    SessionBench bench(first);
    const glm::dvec3 to{ -6, 4, 2 };
    bench.desk.Device().MoveTo(to);
    int in = 0, out = 0;
    for (; in < most && glm::distance(bench.sample.pose.position, to) > nearMm; ++in)
      bench.Tick(Push);
    for (int n = 0; n < most; ++n)
      bench.Tick(Push);
    delays.poseErrorMm =
      std::max(delays.poseErrorMm, glm::distance(bench.sample.pose.position, to));
    const auto felt = [&] { return bench.desk.Device().ForceN(CountsPerNm); };
    delays.forceErrorShare =
      std::max(delays.forceErrorShare, glm::distance(felt(), Push.force) / glm::length(Push.force));
    const Wrench other{ -Push.force, {} };
    for (; out < most && glm::distance(felt(), other.force) > nearN; ++out)
      bench.Tick(other);
    delays.in = std::max(delays.in, in);
    delays.out = std::max(delays.out, out);
  }
  return delays;
}

} // namespace

void TryDriver(ReportContext& context)
{
  const int ticks = context.settings.quick ? 2'000 : 20'000;
  const Delays delays = MeasureDelays();
  const MeasuredError pose{ delays.poseErrorMm, "mm" };

  SessionBench bench(true);
  FalconDesk alone;
  const auto driver = alone.Driver();
  driver->Open({});
  std::int64_t nowNs = 0;
  const auto exchange = [&] { driver->Exchange(Push, nowNs += TickNs); };
  alone.Home(exchange);
  const auto tick = [&]
  {
    bench.session.Read(bench.sample);
    bench.session.Write(Push);
  };
  const auto many = [](const auto& work)
  {
    return [work]
    {
      return ThreadTimeOf(
        [&]
        {
          for (int n = 0; n < Batch; ++n)
            work();
        });
    };
  };
  const PairedTimes times =
    ComparePairs(many(tick), many(exchange), { .warmUps = 2, .pairs = ticks / Batch });
  context.report.rows.push_back(CpuRatio("haptics.falcon.tick", times,
    "the driver called by the tick itself, which would wait 1 to 2 ms for the bus besides", pose,
    "what HAPTIC spends on a Falcon, in-process model, batches of 100 ticks"));
  context.report.rows.push_back(FixedFigure("haptics.falcon.delay.in", delays.in,
    "ticks from a move of the grip to the tick that reads it",
    "1: the driver called by the tick itself", pose, times,
    "worse of both orders of exchange and tick within a millisecond; the bus comes on top"));
  context.report.rows.push_back(FixedFigure("haptics.falcon.delay.out", delays.out,
    "ticks from a force written to the motors, a force that turns round",
    "1: the driver called by the tick itself", { delays.forceErrorShare, "of the force" }, times,
    "within the slew of 2 N a tick; the same"));
}

} // namespace hasp
