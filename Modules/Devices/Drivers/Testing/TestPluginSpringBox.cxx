#include "Devices/Drivers/Plugin/PluginDriver.h"

#include <gtest/gtest.h>

#include <dlfcn.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace
{

const std::string File = HASP_TEST_PLUGINS "/DevicePluginSpringBox.so";

/// The sample, and a look at its motors that outlives its sessions.
class SpringBox : public ::testing::Test
{
protected:
  SpringBox() : Handle(dlopen(File.c_str(), RTLD_NOW | RTLD_LOCAL))
  {
    if (this->Handle)
      this->Motors = static_cast<const double*>(dlsym(this->Handle, "SpringBoxMotorsN"));
  }
  ~SpringBox() override
  {
    if (this->Handle)
      dlclose(this->Handle);
  }
  void SetUp() override { ASSERT_TRUE(this->Motors); }
  bool MotorsRest() const
  {
    return std::all_of(this->Motors, this->Motors + 3, [](double n) { return n == 0.0; });
  }

  void* Handle;
  const double* Motors = nullptr;
};

TEST_F(SpringBox, RestsWhereTheSpringBalancesTheForce)
{
  hasp::PluginDriver driver(File);
  driver.Open({});
  const hasp::Wrench wrench{ { 1.0, -0.5, 0.25 }, {} };
  hasp::DriverSample sample;
  double farthest = 0.0;
  for (int tick = 0; tick < 2000; ++tick)
  {
    sample = driver.Exchange(wrench, tick * 1'000'000LL);
    ASSERT_TRUE(sample.fresh && sample.homed);
    farthest = std::max(farthest, sample.pose.position.x);
  }
  // F = k x with 0.1 N/mm. Its slowest mode falls by e in 2 m/c = 20 ms: nothing is left in 2 s.
  EXPECT_NEAR(sample.pose.position.x, 10.0, 1e-9);
  EXPECT_NEAR(sample.pose.position.y, -5.0, 1e-9);
  EXPECT_NEAR(sample.pose.position.z, 2.5, 1e-9);
  EXPECT_GT(farthest, 10.0) << "it rings a little: c is below 2 sqrt(k m)";
  EXPECT_EQ(this->Motors[0], 1.0);
  for (int tick = 0; tick < 2000; ++tick)
    sample = driver.Exchange({}, tick);
  EXPECT_NEAR(sample.pose.position.x, 0.0, 1e-9);
}

/// Ten times what it can, and the wall all the same.
TEST_F(SpringBox, FeelsNoMoreThanItsProfileSays)
{
  hasp::PluginDriver driver(File);
  driver.Open({});
  for (int tick = 0; tick < 500; ++tick)
  {
    driver.Exchange({ { 30.0, 0, 0 }, { 5, 5, 5 } }, tick);
    EXPECT_DOUBLE_EQ(this->Motors[0], 3.0);
  }
  EXPECT_LE(driver.Exchange({}, 0).pose.position.x, 40.0);
}

TEST_F(SpringBox, PullsNoMoreWhenItIsClosed)
{
  hasp::PluginDriver driver(File);
  driver.Open({});
  driver.Exchange({ { 1, 1, 1 }, {} }, 0);
  EXPECT_FALSE(this->MotorsRest());
  driver.Close();
  EXPECT_TRUE(this->MotorsRest());

  auto another = std::make_unique<hasp::PluginDriver>(File);
  another->Open({});
  another->Exchange({ { 1, 1, 1 }, {} }, 0);
  another.reset(); // without Close
  EXPECT_TRUE(this->MotorsRest());
}

TEST_F(SpringBox, ItsSettingsHoldItsButton)
{
  for (const auto& [settings, buttons] : { std::pair{ "", 0u }, std::pair{ "held", 1u } })
  {
    hasp::PluginDriver driver(File, settings);
    driver.Open({});
    EXPECT_EQ(driver.Exchange({}, 0).buttons, buttons);
  }
  EXPECT_THROW(hasp::PluginDriver(File, "helt"), hasp::DeviceError);
}

TEST_F(SpringBox, OneAtATimeHasIt)
{
  hasp::PluginDriver a(File), b(File);
  a.Open({});
  try
  {
    b.Open({});
    ADD_FAILURE();
  }
  catch (const hasp::DeviceError& error)
  {
    EXPECT_EQ(error.trouble, hasp::DeviceTrouble::Busy);
  }
  a.Close();
  b.Open({});
  EXPECT_TRUE(b.Exchange({}, 0).fresh);
}

TEST_F(SpringBox, AThousandSessionsLeaveNothingBehind)
{
  hasp::PluginDriver driver(File);
  for (int n = 0; n < 1000; ++n)
  {
    driver.Open({});
    EXPECT_EQ(std::abs(driver.Exchange({}, 0).pose.position.x), 0.0) << "begins anew";
    driver.Exchange({ { 1, 2, 0 }, {} }, 1);
    if (n % 2 == 0)
      driver.Close(); // else Open has to
    EXPECT_EQ(this->MotorsRest(), n % 2 == 0);
  }
  for (int n = 0; n < 1000; ++n) // and so with the library itself
  {
    hasp::PluginDriver one(File);
    if (n == 0)
      driver.Close();
    one.Open({});
    one.Exchange({ { 1, 2, 0 }, {} }, 1);
  }
  EXPECT_TRUE(this->MotorsRest());
}

} // namespace
