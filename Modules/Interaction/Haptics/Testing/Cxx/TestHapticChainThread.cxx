// The chain on a thread of a loop, with RENDER beside it that does all it may, and an input device
// that is fed from there. What is held here holds whatever the machine's clock does; the preset
// tsan looks for races.
#include "TouchScene.h"

#include "Devices/HapticRecorder.h"
#include "Devices/InputHapticDevice.h"
#include "Grid/Testing/CountNew.h"
#include "Haptics/Testing/GreyBodyOnFloor.h"
#include "Realtime/LoopThread.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <string>

namespace
{

using namespace hasp;
using namespace hasp::testing;

constexpr double DropRadius = 4.0;                              // mm
constexpr std::uint64_t LeastTicks = 10'000, LeastTurns = 1000; // beside each other

/// A grey drop of 4 mm about the tool's origin: points are drawn where it touches.
std::shared_ptr<const DynamicShellSource> Drop()
{
  static const auto made = []
  {
    auto source = std::make_shared<DynamicShellSource>();
    source->volume = GreyBody(hasp::testing::Ball({}, DropRadius), CubeGrid(13)).Volume;
    source->settings.points = 512;
    source->settings.pointsPerTick = 64;
    return source;
  }();
  return made;
}

/// A tip and the drop over the ball.
std::unique_ptr<HapticSceneOffer> DropScene(std::uint64_t number)
{
  auto offer = std::make_unique<HapticSceneOffer>();
  offer->scene = std::make_unique<HapticScene>(
    std::vector<HapticShell>{ { TipShell(), At(0, 0, -DropRadius) }, { nullptr, {}, Drop() } },
    hasp::testing::Ball());
  offer->number = number;
  return offer;
}

bool AreOfTheDrop(const HapticDiscRequest& discs)
{
  bool all = discs.count <= discs.room.size() && IsPose(discs.tool);
  for (std::uint32_t n = 0; all && n < discs.count; ++n)
    all = glm::length(discs.room[n].center) < 1.5 * DropRadius && discs.room[n].areaMm2 >= 0.0F &&
          std::abs(glm::length(discs.room[n].normal) - 1.0F) < 1e-3F;
  return all;
}

/// All that RENDER says and asks, in turns that depend on nothing but their number.
struct Render
{
  HapticChain& chain;
  InputHapticDevice& device;
  std::uint64_t turns = 0, scenes = 0, faults = 0, discs = 0;
  bool asked = false;
  HapticSnapshot before{};

  void Feed()
  {
    const double z = BallRadius + DropRadius - 0.1 * static_cast<double>(turns % 20);
    switch (turns % 5)
    {
      case 0:
        device.MoveTo(At(0, 0, z));
        break;
      case 1:
        device.MoveBy({ 0.01, 0, 0 });
        break;
      case 2:
        device.TurnBy({ 0, 0.001, 0 });
        break;
      case 3:
        device.SetRates({ 1, 0, 0 }, { 0, 0, 1 }, MonotonicClock().NowNs());
        break;
      default:
        device.SetButtons(turns % 7 == 0 ? 1 : 0);
    }
  }
  void Say()
  {
    HapticControl control;
    control.attract = turns % 2 == 0;
    control.contact.attraction = 0.01F;
    control.contact.stiffness = turns % 3 == 0 ? 0.01F : 0.02F;
    control.levels = 1 + static_cast<int>(turns % 4);
    control.clutch = 1;
    control.scale = turns % 50 < 25 ? 1.0 : 1.01;
    control.isovalues[1] = turns % 10 < 5 ? Isovalue : Isovalue + 50.0;
    chain.Control(control);
  }
  void Ask()
  {
    if (auto back = chain.Discs().Collect())
    {
      faults += !AreOfTheDrop(*back);
      ++discs;
      asked = false;
    }
    if (asked)
      return;
    auto request = std::make_unique<HapticDiscRequest>();
    request->room.resize(600);
    chain.Discs().Offer(std::move(request));
    asked = true;
  }
  void Look()
  {
    const HapticSnapshot* now = chain.Latest();
    if (!now)
      return;
    faults += now->ticks < before.ticks || now->nowNs < before.nowNs || now->scene < before.scene;
    faults += now->scene > scenes || !IsPose(now->tool) || !IsPose(now->device);
    faults += !IsFinite(now->onDevice) || now->contacts > now->points;
    before = *now;
  }
  void Turn()
  {
    Feed();
    Say();
    Ask();
    if (turns % 10 == 0)
      chain.OfferScene(DropScene(++scenes));
    chain.Collect();
    Look();
    ++turns;
  }
};

TEST(HapticChainThread, RenderAndHapticMeetInNothingTorn)
{
  const std::string file =
    (std::filesystem::temp_directory_path() / ("hasp-chain-" + std::to_string(getpid()))).string();
  const auto map = BallMap();
  const long mapUsers = map.use_count(), dropUsers = Drop().use_count();
  {
    HapticRecorder recorder(file, {});
    auto made = std::make_unique<InputHapticDevice>();
    InputHapticDevice& device = *made;
    HapticChain chain(std::move(made), Settings());
    chain.Record(&recorder);
    Render render{ chain, device };
    std::atomic<std::size_t> taken{ 0 };
    LoopThread loop;
    loop.Start({ .periodNs = 100'000 },
      [&](const LoopTick& tick) noexcept
      {
        const std::size_t count = hasp::test::NewCount(); // of this thread
        chain.Tick(tick.number, tick.nowNs);
        taken.fetch_add(hasp::test::NewCount() - count, std::memory_order_relaxed);
        return true;
      });
    while (render.turns < LeastTurns || render.before.ticks < LeastTicks)
      render.Turn();
    loop.Stop();
    EXPECT_EQ(taken, 0u);
    EXPECT_GT(render.discs, 0u);
    render.Look();
    const std::uint64_t ticks = render.before.ticks;

    // What was said last is what is felt, now that the owner ticks. Clutch and scale have moved the
    // tool away from the device: it is placed when they are settled.
    std::uint64_t number = ticks;
    std::int64_t nowNs = render.before.nowNs + 1'000'000'000;
    const auto go = [&](HapticControl control, std::uint32_t placed, int count)
    {
      control.placed = placed;
      chain.Control(control);
      for (int n = 0; n < count; ++n)
        chain.Tick(number++, nowNs += 1'000'000);
    };
    chain.Collect();
    chain.OfferScene(DropScene(++render.scenes));
    device.SetButtons(0);
    device.SetRates({}, {}, 0);
    device.MoveTo(At(0, 0, BallRadius + DropRadius - 1.0));
    go({}, 0, 500);
    go({}, 1, 500);
    render.Ask();
    go({}, 1, 1);
    render.Ask();
    render.Look();
    EXPECT_NEAR(glm::length(render.before.device.position - At(0, 0, 18).position), 0.0, 1e-3);
    EXPECT_EQ(render.faults, 0u);
    EXPECT_EQ(render.before.ticks, ticks + 1001);
    EXPECT_EQ(render.before.scene, render.scenes);
    EXPECT_GT(render.before.contacts, 0u);
    recorder.Finish();
    EXPECT_EQ(recorder.Counts().written + recorder.Counts().full, ticks + 1001);
  }
  EXPECT_EQ(map.use_count(), mapUsers) << "each scene is freed, wherever it was";
  EXPECT_EQ(Drop().use_count(), dropUsers);
  std::filesystem::remove(file);
}

} // namespace
