#include "Devices/Drivers/Testing/SpaceMouseBench.h"

#include <limits>
#include <random>

namespace
{

using namespace hasp;
using namespace hasp::test;

class SpaceMouseFaults : public SpaceMouseBench
{
};

/// A thousand times it is unplugged at any call, and opened again until it is there.
TEST_F(SpaceMouseFaults, IsUnpluggedAtAnyMomentAndComesBack)
{
  std::mt19937 random(6);
  const auto oneOf = [&](int count) { return static_cast<int>(random() % unsigned(count)); };
  std::int64_t ms = 0;
  int unplugs = 0, absent = 0, gone = 0;
  while (unplugs < 1000)
  {
    this->Device->there = true;
    this->Device->reports.clear();
    this->Device->callsUntilUnplug = 1 + oneOf(40);
    try
    {
      this->Driver.Open({});
      for (;;)
      {
        this->Says(oneOf(2) ? Report(1, { oneOf(700) - 350, oneOf(700) - 350, 0, 0, 0, 350 })
                            : ButtonReport(random(), 3));
        ExpectFinite(this->At(ms += 1 + oneOf(50)));
      }
    }
    catch (const DeviceError& error)
    {
      ++unplugs;
      absent += error.trouble == DeviceTrouble::Absent;
      gone += error.trouble == DeviceTrouble::Gone;
      const std::string sentence = error.what();
      EXPECT_NE(sentence.find("plug it in"), sentence.npos) << sentence;
    }
    this->Driver.Close();
    EXPECT_FALSE(this->Device->open);
  }
  EXPECT_EQ(absent + gone, 1000);
  EXPECT_GT(absent, 0);
  EXPECT_GT(gone, 900);
  EXPECT_EQ(this->Device->opened, this->Device->closed);
  this->Device->there = true;
  this->Device->callsUntilUnplug = -1;
  this->Device->reports.clear();
  this->Driver.Open({});
  this->Says(ButtonReport(1, 3));
  EXPECT_EQ(this->At(ms + 10).buttons, 1u);
}

TEST_F(SpaceMouseFaults, RandomReportsGiveSanePoses)
{
  this->Driver.Open({});
  std::mt19937 random(7);
  for (int n = 0; n < 100'000; ++n)
  {
    Bytes report(random() % 16);
    for (std::byte& byte : report)
      byte = static_cast<std::byte>(random());
    if (!report.empty() && n % 2)
      report[0] = static_cast<std::byte>(1 + random() % 3);
    if (n % 4 == 1)
      report.resize(13);
    if (report.empty())
      continue; // a transport says by it that none came
    this->Says(report);
    ExpectFinite(this->Driver.Exchange({}, n * Ms));
  }
}

TEST_F(SpaceMouseFaults, AnyTimeIsSafe)
{
  using Limits = std::numeric_limits<std::int64_t>;
  this->Driver.Open({});
  for (const std::int64_t now :
    { Limits::min(), Limits::max(), std::int64_t{ 0 }, Limits::max() - 1, Limits::min() + 1 })
  {
    this->Says(Report(1, { 350, 350, 350, 350, 350, 350 }));
    ExpectFinite(this->Driver.Exchange({}, now));
  }
}

} // namespace
