#include "FalconBench.h"

#include "Devices/Drivers/Falcon/FalconKinematics.h"
#include "Grid/FinitePose.h"
#include "Grid/Progress.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

using namespace hasp;

namespace
{
/// A bench whose driver is open; homed if wished.
struct OpenFalcon : FalconBench
{
  FalconDriver driver;

  explicit OpenFalcon(bool homed = true, const FalconSettings& with = {})
    : driver(PlugInto(this->cable), this->With(with), this->cable->Clock())
  {
    this->driver.Open(this->how);
    this->Say(glm::dvec3(0.0));
    if (homed)
      this->model->PullOutAndPushIn();
    this->Say(glm::dvec3(0.0));
  }
  DriverSample Say(const glm::dvec3& forceN)
  {
    return this->driver.Exchange({ forceN, glm::dvec3(0.0) }, this->model->nowNs);
  }

private:
  FalconSettings With(FalconSettings with)
  {
    with.firmware = this->settings.firmware;
    return with;
  }
};
/// A motor's number is whole: half of one, by the arm's 25 N mm a newton at the worst of poses.
constexpr double RoundingN = 0.02;
} // namespace

TEST(FalconDriver, PoseAndForceAreThoseOfTheModel)
{
  OpenFalcon falcon;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  double worstMm = 0.0, worstN = 0.0;
  for (int n = 0; n < 2'000; ++n)
  {
    const glm::dvec3 place{ 35 * unit(random), 35 * unit(random), 30 * unit(random) };
    falcon.model->MoveTo(place);
    falcon.Say(glm::dvec3(0.0)); // where it is now
    glm::dvec3 force{ unit(random), unit(random), unit(random) };
    force *= 4.0;
    const auto sample = falcon.Say(force);
    EXPECT_TRUE(sample.fresh);
    EXPECT_TRUE(sample.homed);
    worstMm = std::max(worstMm, glm::distance(sample.pose.position, place));
    worstN = std::max(worstN, glm::distance(falcon.model->ForceN(5'000.0), force));
  }
  std::printf("worst pose %.3f mm, worst force %.4f N\n", worstMm, worstN);
  EXPECT_LE(worstMm, 0.08); // half a count of each of three arms
  EXPECT_LE(worstN, RoundingN);
  const auto counts = falcon.driver.Counts();
  EXPECT_EQ(counts.silences, 0u);
  EXPECT_EQ(counts.surplus, 0u);
  EXPECT_EQ(counts.droppedBytes, 0u);
  EXPECT_EQ(counts.refused, 0u);
  EXPECT_EQ(counts.answers, counts.commands);
}

// Outwards is towards the user, and libnifalcon's positive numbers pull in.
TEST(FalconDriver, ForceHasTheRightSign)
{
  OpenFalcon falcon;
  falcon.Say({ 0, 0, 2 });
  for (const int motor : falcon.model->Told().motors)
    EXPECT_NEAR(motor, -2 * 126, 2);
}

TEST(FalconDriver, ButtonsAreTheGrips)
{
  OpenFalcon falcon;
  for (std::uint8_t buttons = 0; buttons < 16; ++buttons)
  {
    falcon.model->Press(buttons);
    EXPECT_EQ(falcon.Say(glm::dvec3(0.0)).buttons, buttons);
  }
}

TEST(FalconDriver, NothingPushesBeforeItIsHomed)
{
  OpenFalcon falcon(false);
  for (int n = 0; n < 50; ++n)
  {
    const auto sample = falcon.Say({ 8, -8, 8 });
    EXPECT_FALSE(sample.homed);
    EXPECT_EQ(sample.pose.position, glm::dvec3(0.0)); // counts are no place yet
    EXPECT_TRUE(falcon.model->PushesNobody());
    EXPECT_TRUE(falcon.model->Told().homing);
    EXPECT_EQ(falcon.model->Told().lights, FalconCommand::Red);
  }
  EXPECT_TRUE(Says(falcon.driver.Advice(), "Pull"));
  falcon.model->PullOutAndPushIn();
  falcon.Say({ 8, -8, 8 }); // only now does it learn of it
  EXPECT_TRUE(falcon.model->PushesNobody());
  EXPECT_TRUE(falcon.Say({ 8, -8, 8 }).homed);
  EXPECT_FALSE(falcon.model->PushesNobody());
  EXPECT_EQ(falcon.model->Told().lights, FalconCommand::Green | FalconCommand::Blue);
  EXPECT_TRUE(falcon.model->Told().homing);
  EXPECT_EQ(falcon.driver.Advice(), "");
  // It was switched off: the zeros are gone, and the force with them.
  falcon.model->SwitchOffAndOn();
  falcon.model->StartRunning();
  falcon.Say({ 8, -8, 8 });
  falcon.Say({ 8, -8, 8 });
  EXPECT_TRUE(falcon.model->PushesNobody());
  EXPECT_TRUE(Says(falcon.driver.Advice(), "push"));
}

TEST(FalconDriver, ExtremeWrenchesAreNoForceOrTheLargest)
{
  OpenFalcon falcon;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double inf = std::numeric_limits<double>::infinity();
  for (const double bad : { nan, inf, -inf, 1e308, 4e-324 })
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::dvec3 force(0.0);
      force[axis] = bad;
      falcon.Say(force);
      if (std::abs(bad) < 1e308 || !std::isfinite(bad))
      {
        EXPECT_TRUE(falcon.model->PushesNobody()) << bad;
      }
      falcon.driver.Exchange({ glm::dvec3(0.0), glm::dvec3(bad) }, 0);
      EXPECT_TRUE(falcon.model->PushesNobody()); // a torque is nothing to it
    }
  // Too much: as much as there is, in its direction.
  for (const glm::dvec3 direction :
    { glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1), glm::dvec3(0.6, 0, 0.8) })
    for (const double size : { 1e3, 1e100, 1e300 })
    {
      falcon.Say(size * direction);
      const auto felt = falcon.model->ForceN(5'000.0);
      EXPECT_GT(glm::length(felt), 5.0);
      EXPECT_LT(glm::distance(glm::normalize(felt), direction), 1e-3);
      for (const int motor : falcon.model->Told().motors)
        EXPECT_LE(std::abs(motor), 4095);
    }
}

TEST(FalconDriver, CountsThatNoPoseHasAreRefused)
{
  OpenFalcon falcon;
  falcon.model->MoveTo({ 10, 0, 0 });
  const auto good = falcon.Say(glm::dvec3(0.0));
  falcon.model->SetCounts({ 32767, -32768, 0 });
  for (int n = 0; n < 100; ++n)
  {
    const auto sample = falcon.Say({ 0, 0, 5 });
    EXPECT_FALSE(sample.fresh);
    EXPECT_FALSE(sample.sane);
    EXPECT_EQ(sample.pose.position, good.pose.position);
    if (n > 0)
    {
      EXPECT_TRUE(falcon.model->PushesNobody());
    }
  }
  EXPECT_EQ(falcon.driver.Counts().refused, 100u);
  falcon.model->MoveTo({ -20, 5, 10 });
  const auto back = falcon.Say({ 0, 0, 5 });
  EXPECT_TRUE(back.fresh && back.sane);
  falcon.Say({ 0, 0, 5 });
  EXPECT_NEAR(falcon.model->ForceN(5'000.0).z, 5.0, RoundingN);
}

// Each kind of damage to one answer in ten, and all at once. Poses are right or not fresh.
TEST(FalconDriver, DamagedAnswersAreNotBelieved)
{
  for (int kind = 0; kind < 6; ++kind)
  {
    OpenFalcon falcon;
    auto& faults = falcon.model->faults;
    for (auto* share :
      { &faults.lost, &faults.cut, &faults.repeated, &faults.shifted, &faults.noise })
      *share = kind == 5 ? 0.1 : 0.0;
    double* const shares[] = { &faults.lost, &faults.cut, &faults.repeated, &faults.shifted,
      &faults.noise };
    if (kind < 5)
      *shares[kind] = 0.1;
    int fresh = 0;
    for (int n = 0; n < 3'000; ++n)
    {
      const glm::dvec3 place{ 30 * std::sin(0.01 * n), 20 * std::cos(0.013 * n), 10 };
      falcon.model->MoveTo(place);
      const std::int64_t beforeNs = falcon.model->nowNs;
      const auto sample = falcon.Say({ 1, 0, 0 });
      EXPECT_LE(falcon.model->nowNs - beforeNs, 22'000'000);
      fresh += sample.fresh;
      if (sample.fresh)
      {
        // Of this very command: not one tick old, which would be 0.3 mm.
        ASSERT_LT(glm::distance(sample.pose.position, place), 0.1) << kind << " at " << n;
      }
    }
    // A lost answer costs two exchanges; a damaged one is lost, and with all five most are.
    EXPECT_GE(fresh, kind == 5 ? 1'200 : 2'300) << kind;
    faults = {};
    for (int n = 0; n < 5; ++n)
      falcon.Say(glm::dvec3(0.0));
    EXPECT_TRUE(falcon.Say(glm::dvec3(0.0)).fresh) << "well again after " << kind;
    const auto counts = falcon.driver.Counts();
    EXPECT_EQ(counts.droppedBytes > 0, kind == 1 || kind >= 3) << kind;
  }
}

// Answers that come after the time to wait is over are never taken for later ones.
TEST(FalconDriver, LateAnswersAreNotTakenForNewOnes)
{
  OpenFalcon falcon;
  int fresh = 0;
  for (int n = 0; n < 4'000; ++n)
  {
    // From just too late to later than the next command's answer ought to be.
    falcon.model->faults.delayNs = n % 40 == 17 ? 10'500'000 + n % 700 * 40'000 : 0;
    const glm::dvec3 place{ 20 * std::sin(0.1 * n), 20 * std::cos(0.13 * n), 10 };
    falcon.model->MoveTo(place);
    const auto sample = falcon.Say(glm::dvec3(0.0));
    fresh += sample.fresh;
    if (sample.fresh)
    {
      ASSERT_LT(glm::distance(sample.pose.position, place), 0.1) << n;
    }
  }
  EXPECT_GE(fresh, 3'600);
  EXPECT_GE(falcon.driver.Counts().silences, 100u);
}

// Its boot asks more than once where answers are slow, and leaves none of them behind.
TEST(FalconDriver, AnswersToTheBootAreNotTakenForLaterOnes)
{
  for (std::int64_t delayNs = 0; delayNs < 90'000'000; delayNs += 7'000'000)
  {
    FalconBench bench;
    bench.model->StartRunning();
    bench.model->faults.delayNs = delayNs;
    auto driver = bench.Driver();
    driver.Open(bench.how);
    bench.model->faults.delayNs = 0;
    bench.model->Press(9);
    const auto sample = driver.Exchange({}, 0);
    EXPECT_TRUE(sample.fresh) << delayNs;
    EXPECT_EQ(sample.buttons, 9u) << delayNs;
    EXPECT_EQ(driver.Counts().surplus, 0u);
  }
}

TEST(FalconDriver, SilenceEndsItAfterAWhile)
{
  OpenFalcon falcon;
  falcon.model->faults.silent = true;
  try
  {
    for (int n = 0; n < 50; ++n)
      EXPECT_FALSE(falcon.Say({ 1, 1, 1 }).fresh);
    FAIL() << "it went on";
  }
  catch (const DeviceError& error)
  {
    EXPECT_EQ(error.trouble, DeviceTrouble::Protocol);
    EXPECT_TRUE(Says(error.what(), "not answered 50 times"));
  }
  falcon.driver.Close();
  EXPECT_TRUE(falcon.model->PushesNobody()); // it may hear still
}

TEST(FalconDriver, CloseLeavesNoForce)
{
  for (const auto& leave :
    { +[](OpenFalcon& f) { f.driver.Close(); }, +[](OpenFalcon& f) { f.driver.Open(f.how); } })
  {
    OpenFalcon falcon;
    falcon.Say({ 5, 5, 5 });
    EXPECT_FALSE(falcon.model->PushesNobody());
    // Half a packet went out before: the zero is understood all the same.
    const auto half = Encode(FalconCommand{ { 1, 2, 3 } });
    falcon.model->Receive(std::span(half).first(9));
    leave(falcon);
    EXPECT_TRUE(falcon.model->PushesNobody());
  }
  FalconBench bench;
  {
    auto driver = bench.Driver();
    driver.Open(bench.how);
    driver.Exchange({}, 0);
    bench.model->PullOutAndPushIn();
    driver.Exchange({ { 5, 5, 5 }, {} }, 0);
    driver.Exchange({ { 5, 5, 5 }, {} }, 0);
    EXPECT_FALSE(bench.model->PushesNobody());
  }
  EXPECT_TRUE(bench.model->PushesNobody()); // nor does its end
  EXPECT_FALSE(bench.cable->open);
}

TEST(FalconDriver, ClosedItSaysSo)
{
  FalconBench bench;
  auto driver = bench.Driver();
  driver.Close();
  EXPECT_THROW(driver.Exchange({}, 0), DeviceError);
  EXPECT_EQ(driver.Advice(), "");
  for (const auto trouble :
    { DeviceTrouble::Absent, DeviceTrouble::Permission, DeviceTrouble::Busy })
  {
    bench.cable->refuses = trouble;
    try
    {
      driver.Open(bench.how);
      FAIL();
    }
    catch (const DeviceError& error)
    {
      EXPECT_EQ(error.trouble, trouble);
    }
    EXPECT_FALSE(bench.cable->open);
  }
  bench.cable->refuses.reset();
  bench.how.cancelled = [] { return true; };
  EXPECT_THROW(driver.Open(bench.how), Cancelled);
  EXPECT_FALSE(bench.cable->open);
  bench.how = {};
  driver.Open(bench.how);
  EXPECT_TRUE(driver.Exchange({}, 0).fresh);
}

TEST(FalconDriver, WrongFirmwareIsSaid)
{
  FalconBench bench;
  bench.settings.firmware = bench.folder.File("short.bin", InventedFirmware(100)).string();
  auto driver = bench.Driver();
  try
  {
    driver.Open(bench.how);
    FAIL();
  }
  catch (const DeviceError& error)
  {
    EXPECT_EQ(error.trouble, DeviceTrouble::Firmware);
    EXPECT_TRUE(Says(error.what(), "short.bin"));
  }
  EXPECT_FALSE(bench.cable->open);
}

TEST(FalconDriver, SettingsAreChecked)
{
  const auto with = [](auto change)
  {
    FalconBench bench;
    change(bench.settings);
    bench.Driver();
  };
  EXPECT_THROW(with([](auto& s) { s.countsPerNm = 0.0; }), std::invalid_argument);
  EXPECT_THROW(with([](auto& s) { s.countsPerNm = NAN; }), std::invalid_argument);
  EXPECT_THROW(with([](auto& s) { s.answerMs = 0; }), std::invalid_argument);
  EXPECT_THROW(with([](auto& s) { s.mostSilence = 0; }), std::invalid_argument);
  EXPECT_THROW(with([](auto& s) { s.bootTries = 0; }), std::invalid_argument);
  EXPECT_THROW(with([](auto& s) { s.bootTimeBoxS = 0.0; }), std::invalid_argument);
  EXPECT_THROW(FalconDriver(nullptr), std::invalid_argument);
  ValidateDeviceProfile(FalconBench().Driver().Profile());
}

// The cable comes off a thousand times, at any call: while it boots, is homed, pushes, closes.
TEST(FalconDriver, AThousandUnplugsEndWell)
{
  std::mt19937 random(11);
  FalconBench bench;
  auto driver = bench.Driver();
  int whileOpening = 0, whileRunning = 0;
  for (int n = 0; n < 1'000; ++n)
  {
    if (random() % 4 == 0)
      bench.model->SwitchOffAndOn();
    bench.cable->unplugAt =
      bench.cable->calls + static_cast<int>(random() % (bench.model->Runs() ? 150 : 500));
    bool opened = false;
    try
    {
      driver.Open(bench.how);
      opened = true;
      for (;;)
      {
        driver.Exchange({ { 3, -2, 4 }, {} }, 0);
        bench.model->PullOutAndPushIn();
      }
    }
    catch (const DeviceError& error)
    {
      ++(opened ? whileRunning : whileOpening);
      EXPECT_TRUE(error.trouble == DeviceTrouble::Gone || error.trouble == DeviceTrouble::Absent)
        << error.what();
      EXPECT_TRUE(Says(error.what(), "plugged"));
    }
    driver.Close();
    EXPECT_FALSE(bench.cable->open);
    EXPECT_TRUE(!bench.cable->plugged || bench.model->PushesNobody());

    bench.cable->unplugAt = -1;
    bench.cable->plugged = true;
    driver.Open(bench.how);
    ASSERT_TRUE(bench.model->PushesNobody()) << "asking whether it runs is without force";
    ASSERT_TRUE(driver.Exchange({}, 0).fresh);
    driver.Close();
  }
  EXPECT_GT(whileOpening, 100);
  EXPECT_GT(whileRunning, 100);
}
