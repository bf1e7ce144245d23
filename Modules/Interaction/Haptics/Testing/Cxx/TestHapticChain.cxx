#include "TouchScene.h"

#include "Devices/InputHapticDevice.h"
#include "Devices/ReplayHapticDevice.h"
#include "Grid/Testing/CountNew.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace
{

using namespace hasp;
using namespace hasp::testing;

TEST(HapticChain, NoDeviceAndBadSettingsAreRefused)
{
  EXPECT_THROW(HapticChain(nullptr), std::invalid_argument);
  HapticChainSettings settings;
  settings.workspace.scale = -1.0;
  EXPECT_THROW(HapticChain(HandAt({}), settings), std::invalid_argument);
  settings = {};
  settings.step.tickS = 0.0;
  EXPECT_THROW(HapticChain(HandAt({}), settings), std::invalid_argument);
}

TEST(HapticChain, CouplingIsWhatTheDeviceStands)
{
  const CouplingSpring wanted{ 5.0, 300.0, 50.0, 500.0 };
  const DeviceProfile premium = PremiumProfile();
  const double stable = StableStiffness(premium.dampingNsPerMm, 0.001, 0.0);
  const CouplingSpring at1 = SpringFor(premium, wanted, 1.0, 1.0, 0.001);
  EXPECT_DOUBLE_EQ(at1.stiffness, stable);
  EXPECT_DOUBLE_EQ(at1.turnStiffness, 300.0);
  EXPECT_DOUBLE_EQ(at1.forceLimit, premium.peakForceN);
  EXPECT_DOUBLE_EQ(at1.torqueLimit, premium.peakTorqueNmm);
  // World twice as large: the hand feels moves twice as stiff, turns half.
  const CouplingSpring at2 = SpringFor(premium, wanted, 2.0, 1.0, 0.001);
  EXPECT_DOUBLE_EQ(2.0 * at2.stiffness, stable);
  EXPECT_DOUBLE_EQ(at2.turnStiffness, 300.0);
  const CouplingSpring half = SpringFor(premium, wanted, 0.5, 1.0, 0.001);
  EXPECT_DOUBLE_EQ(half.turnStiffness, 150.0);
  // A soft one is let be, and nobody asks a mouse.
  EXPECT_DOUBLE_EQ(SpringFor(premium, { .stiffness = 0.01 }, 1.0, 1.0, 0.001).stiffness, 0.01);
  EXPECT_DOUBLE_EQ(SpringFor(InputHapticDevice().Profile(), wanted, 1, 1, 0.001).stiffness, 5.0);
}

TEST(HapticChain, WithoutASceneTheToolIsTheDevice)
{
  HapticChain chain(HandAt(At(3, 4, 5)), Settings());
  EXPECT_EQ(chain.Latest(), nullptr);
  std::int64_t now = 0;
  const HapticSnapshot& seen = Ticks(chain, 20, now);
  EXPECT_EQ(seen.ticks, 20u);
  EXPECT_EQ(seen.scene, 0u);
  EXPECT_LT(glm::length(seen.tool.position - glm::dvec3(3, 4, 5)), 1e-2);
  EXPECT_LT(glm::length(seen.onDevice.force), 1e-9);
}

// Hand, coupling and contact are springs in series, through guard, mapping, grid and kernels.
TEST(HapticChain, APressedBallPushesBackAsThreeSpringsInSeries)
{
  auto hand = HandAt(At(0, 0, 20), { MinimumJerkMotion{ At(0, 0, BallRadius - 5), 0.3 } });
  const SimulatedHapticDevice& truth = *hand;
  HapticChain chain(std::move(hand), Settings());
  chain.OfferScene(Scene(7));
  std::int64_t now = 0;
  const HapticSnapshot& seen = Ticks(chain, 2000, now);
  const HapticChainSettings settings = Settings();
  const CouplingSpring spring =
    SpringFor(chain.Profile(), settings.step.coupling.spring, 1.0, 1.0, 0.001);
  const Pressed expected = PressedBall(5.0, spring, settings.step.contact.stiffness);
  EXPECT_EQ(seen.scene, 7u);
  EXPECT_EQ(seen.contacts, 1u);
  // The distance is interpolated between samples 0.5 mm apart on a ball of 15 mm: h^2 / (8 R) and
  // an int16 step are 0.002 mm together; the encoder's count 0.001 mm at 0.1 N/mm is nothing.
  EXPECT_NEAR(seen.onDevice.force.z, expected.forceN, 0.01 * expected.forceN);
  EXPECT_NEAR(-seen.deepestMm, expected.depthMm, 0.02 * expected.depthMm);
  EXPECT_NEAR(BallRadius - seen.tool.position.z, expected.depthMm, 0.004);
  EXPECT_NEAR(truth.Applied().force.z, seen.onDevice.force.z, 1e-12);
}

// The hand is below the plate: where the tool is taken decides on which side it is held.
TEST(HapticChain, AStartThatNoTickHasTakenGoesOnToTheNextScene)
{
  HapticChain chain(HandAt(At(0, 0, -8)), Firm());
  auto first = Scene(1, Plate());
  first->start = At(0, 0, 8);
  chain.OfferScene(std::move(first));
  chain.OfferScene(Scene(2, Plate()));
  std::int64_t now = 0;
  const HapticSnapshot& seen = Ticks(chain, 200, now);
  EXPECT_EQ(seen.scene, 2u);
  EXPECT_EQ(seen.contacts, 1u);
  EXPECT_NEAR(seen.tool.position.z, PlateTop, 1.0);
}

/// Three times the world, and the world's x is the device's y: what a camera on its side gives.
TEST(HapticChain, AxesScaleAndPlaceAreTaken)
{
  HapticChain chain(HandAt(At(2, 0, 0), { MinimumJerkMotion{ At(2, 4, 0), 0.1 } }), Settings());
  std::int64_t now = 0;
  HapticControl control;
  control.placed = 1;
  control.place = At(100, 0, 0);
  chain.Control(control);
  EXPECT_NEAR(Ticks(chain, 5, now).device.position.x, 102.0, 0.01);
  control.axes = TurnBy({ 0, 0, -0.5 * std::numbers::pi }); // y to x
  control.scale = 3.0;
  chain.Control(control);
  // It stands while it is turned and scaled, and then 4 mm along y are 12 along x.
  const HapticSnapshot& seen = Ticks(chain, 1000, now);
  EXPECT_NEAR(seen.raw.position.y, 4.0, 0.01);
  EXPECT_NEAR(seen.device.position.x, 102.0 + 12.0, 0.02);
  EXPECT_NEAR(seen.device.position.y, 0.0, 0.02);
  // What is none changes nothing.
  control.axes = { 0, 0, 0, 0 };
  control.scale = std::nan("");
  chain.Control(control);
  EXPECT_NEAR(Ticks(chain, 1, now).device.position.x, 114.0, 0.02);
}

TEST(HapticChain, WhereADeviceStandsItStaysWhateverElseIsSaid)
{
  HapticChain chain(HandAt(At(0, 0, 0), { MinimumJerkMotion{ At(0, 4, 0), 0.1 } }), Settings());
  std::int64_t now = 0;
  HapticControl control;
  control.placed = 1;
  control.place = { { 100, 0, 0 }, TurnBy({ 0, 0, -0.5 * std::numbers::pi }) }; // y to x
  chain.Control(control);
  Ticks(chain, 5, now);
  control.attract = true;
  chain.Control(control);
  EXPECT_NEAR(Ticks(chain, 1000, now).device.position.x, 104.0, 0.02);
  EXPECT_NEAR(chain.Latest()->device.position.y, 0.0, 0.02);
}

TEST(HapticChain, AViewThatJumpsIsNoKnock)
{
  for (const bool turns : { true, false })
  {
    HapticChainSettings settings = Settings();
    settings.step.limits.rampInS = 0.5;
    HapticChain chain(HandAt(At(0, 0, BallRadius - 5)), settings);
    chain.OfferScene(Scene());
    std::int64_t now = 0;
    const double held = Ticks(chain, 1000, now).onDevice.force.z;
    EXPECT_GT(held, 0.1);
    HapticControl control;
    control.axes = TurnBy({ turns ? 0.05 : 0.0, 0, 0 });
    control.scale = turns ? 1.0 : 1.1;
    chain.Control(control); // a little: as a camera that moves
    EXPECT_GT(Ticks(chain, 1, now).onDevice.force.z, 0.9 * held);
    control.axes = TurnBy({ turns ? 1.5 : 0.0, 0, 0 });
    control.scale = turns ? 1.0 : 0.2;
    chain.Control(control);
    EXPECT_LE(
      glm::length(Ticks(chain, 1, now).onDevice.force), 1.001 / 500.0 * settings.step.limits.force);
  }
}

TEST(HapticChain, WhatNoTickCanCountWithStaysAsItWas)
{
  HapticChain chain(HandAt(At(0, 0, BallRadius - 5)), Settings());
  chain.OfferScene(Scene());
  std::int64_t now = 0;
  const double held = Ticks(chain, 1000, now).onDevice.force.z;
  EXPECT_GT(held, 0.1);
  const float nan = std::nanf("");
  HapticControl control;
  const auto refused = [&](auto& value, auto bad)
  {
    const auto good = std::exchange(value, bad);
    EXPECT_NE(WrongIn(control), nullptr);
    chain.Control(control);
    Ticks(chain, 50, now);
    value = good;
    EXPECT_EQ(WrongIn(control), nullptr);
    chain.Control(control);
    EXPECT_NEAR(Ticks(chain, 50, now).onDevice.force.z, held, 0.05 * held);
  };
  refused(control.contact.stiffness, nan);
  refused(control.contact.stiffness, -1.0F);
  refused(control.contact.attraction, nan);
  refused(control.contact.captureMm, 0.0F);
  refused(control.spring.stiffness, double(nan));
  refused(control.spring.turnStiffness, 0.0);
  refused(control.spring.forceLimit, double(nan));
  refused(control.spring.torqueLimit, -1.0);
}

TEST(HapticChain, TheClutchHoldsTheToolAndTakesTheForceAway)
{
  SimulatedDeviceSettings hand = HandSettings();
  hand.buttons = { { 1.0, 2 }, { 2.0, 0 } };
  HapticChain chain(std::make_unique<SimulatedHapticDevice>(
                      hand, HandIntention(At(0, 0, BallRadius - 3),
                              { HoldMotion{ 1.2 }, MinimumJerkMotion{ At(30, 0, 30), 0.5 } })),
    Settings());
  chain.OfferScene(Scene());
  HapticControl control;
  control.clutch = 2;
  chain.Control(control);
  std::int64_t now = 0;
  const HapticSnapshot before = Ticks(chain, 990, now);
  EXPECT_GT(before.onDevice.force.z, 0.1);
  const HapticSnapshot held = Ticks(chain, 1000, now);
  EXPECT_GT(held.raw.position.x, 20.0) << "the hand has moved on";
  EXPECT_LT(glm::length(held.device.position - before.device.position), 0.5);
  EXPECT_EQ(held.onDevice.force, glm::dvec3(0.0));
}

TEST(HapticChain, ATickTakesNoMemory)
{
  HapticChain chain(HandAt(At(0, 0, BallRadius - 2)), Settings());
  std::int64_t now = 0;
  std::vector<std::unique_ptr<HapticSceneOffer>> offers;
  for (std::uint64_t n = 1; n <= 3; ++n)
    offers.push_back(Scene(n));
  Ticks(chain, 10, now);
  for (auto& offer : offers)
  {
    chain.OfferScene(std::move(offer));
    auto request = std::make_unique<HapticDiscRequest>();
    request->room.resize(100);
    chain.Discs().Offer(std::move(request));
    HapticControl control;
    control.attract = true;
    control.contact.attraction = 0.01F;
    chain.Control(control);
    const std::size_t before = hasp::test::NewCount();
    Ticks(chain, 100, now);
    EXPECT_EQ(hasp::test::NewCount(), before);
    EXPECT_NE(chain.Discs().Collect(), nullptr);
    chain.Collect();
  }
  EXPECT_EQ(chain.Latest()->scene, 3u);
}

TEST(HapticChain, ScenesComeBackToBeFreedByRender)
{
  const auto map = BallMap();
  HapticChain chain(HandAt(At(0, 0, 20)), Settings());
  std::int64_t now = 0;
  const long before = map.use_count();
  for (std::uint64_t n = 1; n <= 5; ++n)
  {
    chain.OfferScene(Scene(n));
    EXPECT_EQ(Ticks(chain, 1, now).scene, n);
    EXPECT_EQ(map.use_count(), before + (n > 1 ? 4 : 2)) << "the tick has freed none";
    chain.Collect();
    EXPECT_EQ(map.use_count(), before + 2) << "in the body and its coarse phase, once";
  }
  auto nothing = std::make_unique<HapticSceneOffer>();
  chain.OfferScene(std::move(nothing));
  EXPECT_EQ(Ticks(chain, 1, now).scene, 5u) << "a null scene is none";
}

TEST(HapticChain, ATakenToolStartsWhereItIsTaken)
{
  HapticChain chain(HandAt(At(0, 0, 30)), Settings());
  std::int64_t now = 0;
  Ticks(chain, 10, now);
  auto offer = Scene();
  offer->start = At(1, 2, 30);
  chain.OfferScene(std::move(offer));
  // In free space the coupling goes all the way in a step; travel bounds nothing far from surfaces.
  const HapticSnapshot& seen = Ticks(chain, 1, now);
  EXPECT_LT(glm::length(seen.tool.position - glm::dvec3(0, 0, 30)), 2.3);
  EXPECT_LT(glm::length(seen.onDevice.force), 0.05) << "and grows from zero";
}

TEST(HapticChain, PollingGivesNoForceAndTheToolGoesAlong)
{
  HapticChain chain(HandAt(At(0, 0, BallRadius - 5)), Settings());
  const auto& truth = static_cast<SimulatedHapticDevice&>(chain.Guarded());
  chain.OfferScene(Scene());
  std::int64_t now = 0;
  Ticks(chain, 500, now);
  EXPECT_GT(truth.Applied().force.z, 0.1);
  for (int frame = 0; frame < 20; ++frame)
    chain.Poll(now += 16'000'000);
  const HapticSnapshot& seen = *chain.Latest();
  EXPECT_EQ(truth.Applied().force, glm::dvec3(0.0));
  EXPECT_EQ(seen.tool.position, seen.device.position);
  EXPECT_NEAR(seen.tool.position.z, BallRadius - 5, 0.05);
  Ticks(chain, 1, now);
  chain.Rest();
  EXPECT_EQ(truth.Applied().force, glm::dvec3(0.0));
}

TEST(HapticChain, WhatItRecordedIsReplayedToTheLastBit)
{
  HapticChainSettings settings = Settings();
  settings.step.coupling.spring.stiffness = 0.05; // less than either device's share: both feel it
  const std::string file =
    (std::filesystem::temp_directory_path() / ("hasp-chain-" + std::to_string(getpid()))).string();
  {
    HapticRecorder recorder(file, {});
    HapticChain chain(HandAt(At(0, 0, 20), { MinimumJerkMotion{ At(1, 0, 11), 0.2 } }), settings);
    chain.OfferScene(Scene());
    chain.Record(&recorder);
    std::int64_t now = 0;
    Ticks(chain, 400, now);
    recorder.Finish();
  }
  const auto recording = std::make_shared<HapticRecording>(ReadHapticRecording(file));
  std::filesystem::remove(file);
  ASSERT_EQ(recording->records.size(), 400u);
  auto made = std::make_unique<ReplayHapticDevice>(recording);
  const ReplayHapticDevice& replay = *made;
  HapticChain again(std::move(made), settings);
  again.OfferScene(Scene());
  std::uint64_t pushed = 0, different = 0;
  for (std::size_t n = 0; n < recording->records.size(); ++n)
  {
    again.Tick(n, *replay.NextNs());
    const HapticRecord& was = recording->records[n];
    const Wrench& is = again.Latest()->onDevice;
    different += is.force != was.wrench.force || is.torque != was.wrench.torque;
    pushed += was.contacts > 0;
  }
  EXPECT_GT(pushed, 100u);
  EXPECT_EQ(different, 0u);
}

} // namespace
