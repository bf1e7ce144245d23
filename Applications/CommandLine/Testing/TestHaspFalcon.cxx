// bin/hasp devices with a Falcon behind the system's own libusb: a model of one on umockdev, and a
// hand that homes it and holds its first button.
#include "FalconTestbed.h"
#include "HaspProcess.h"

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace
{

using namespace hasp;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

constexpr double UsualCountsPerNm = 5'000.0;

class HaspFalcon : public HaspTest
{
protected:
  HaspFalcon()
  {
    ::setenv("XDG_CONFIG_HOME", this->Path("config").c_str(), 1); // not the user's own settings
    const std::vector<std::uint8_t> image = InventedFirmware();
    std::ofstream(this->Path("image.bin"), std::ios::binary)
      .write(reinterpret_cast<const char*>(image.data()), std::streamsize(image.size()));
  }
  ~HaspFalcon() override
  {
    this->stopping = true;
    if (this->hand.joinable())
      this->hand.join();
    ::unsetenv("XDG_CONFIG_HOME");
  }
  /// Somebody takes the grip: homes it, and when it was seen without a button holds the first one.
  void TakeTheGrip()
  {
    this->hand = std::thread(
      [this]
      {
        constexpr std::uint64_t seenUp = 30;
        for (; !this->stopping; std::this_thread::sleep_for(std::chrono::milliseconds(2)))
          this->bed.With(
            [&](FalconModel& model)
            {
              if (!model.Runs())
                return;
              model.PullOutAndPushIn();
              if (model.Packets() > seenUp)
                model.Press(1);
              if (!model.PushesNobody())
                this->pushed = true;
            });
      });
  }
  Words WithImage(Words words) const
  {
    words.insert(words.begin(), "devices");
    words.insert(words.end(), { "--device", "falcon", "--firmware", this->Path("image.bin") });
    return words;
  }
  bool IsAtRest()
  {
    bool rests = false;
    this->bed.With([&](FalconModel& model) { rests = model.PushesNobody(); });
    return rests;
  }

  FalconTestbed bed;
  std::atomic<bool> stopping{ false }, pushed{ false };
  std::thread hand;
};

TEST_F(HaspFalcon, IsListed)
{
  const Json found = Json::parse(OutputOfHasp({ "devices", "--json" })).at("devices");
  ASSERT_EQ(found.size(), 1U) << found;
  EXPECT_EQ(found[0].at("address"), "falcon:1-1");
  EXPECT_TRUE(found[0].at("may_open").get<bool>());
  EXPECT_TRUE(found[0].at("force").get<bool>());
  this->bed.Unplug();
  EXPECT_TRUE(Json::parse(OutputOfHasp({ "devices", "--json" })).at("devices").empty());
  for (const char* more : { "--test-force", "--calibrate" })
    EXPECT_NE(OutputOfHasp({ "devices", more }).find("works with the mouse"), std::string::npos)
      << "where there is none that is said, and no failure";
}

TEST_F(HaspFalcon, IsBootedHomedAndPushes)
{
  this->TakeTheGrip();
  const HaspRun run = RunHasp(this->WithImage({ "--test-force", "--watch", "5" }));
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_NE(run.out.find("firmware"), std::string::npos) << run.out;
  EXPECT_TRUE(this->pushed);
  EXPECT_TRUE(this->IsAtRest());
}

TEST_F(HaspFalcon, IsCalibratedAndThatIsKept)
{
  this->TakeTheGrip();
  this->WriteText("typed", "0.5\n1\n1.5\n"); // half of what is asked for
  const int before = ::dup(STDIN_FILENO), file = ::open(this->Path("typed").c_str(), O_RDONLY);
  ::dup2(file, STDIN_FILENO);
  ::close(file);
  const HaspRun run = RunHasp(this->WithImage({ "--calibrate", "--json" }));
  ::dup2(before, STDIN_FILENO);
  ::close(before);
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_NEAR(Json::parse(run.out).at("share").get<double>(), 0.5, 1e-12);
  const Json kept = Json::parse(ReadBytes(this->Path("config/hasp/devices.json")));
  EXPECT_NEAR(kept.at("falcon").at("countsPerNm").get<double>(), 2.0 * UsualCountsPerNm, 1e-6);
  EXPECT_EQ(kept.at("falcon").at("firmware"), "") << "that was for one run";
  EXPECT_TRUE(this->IsAtRest());
}

// The whole way: the program is killed while it pushes, and its guard takes the force away.
TEST_F(HaspFalcon, IsLeftWithoutForceByAProgramThatIsKilled)
{
  this->TakeTheGrip();
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const pid_t child = StartHasp(this->WithImage({ "--test-force", "--watch", "600" }), ends[1]);
  while (!this->pushed && ::waitpid(child, nullptr, WNOHANG) == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  ASSERT_TRUE(this->pushed);
  ::kill(child, SIGKILL);
  ASSERT_EQ(::waitpid(child, nullptr, 0), child);
  // Its guard has the pipe's other end, too: that it has gone is the pipe's end.
  ::close(ends[1]);
  char said[256];
  while (::read(ends[0], said, sizeof said) > 0) // ctest ends what never comes
  {
  }
  ::close(ends[0]);
  EXPECT_TRUE(this->IsAtRest());
}

} // namespace
