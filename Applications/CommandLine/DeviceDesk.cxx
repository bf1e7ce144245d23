#include "DeviceDesk.h"

#include "Devices/Drivers/DeviceList.h"
#include "Failure.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <optional>
#include <sstream>
#include <vector>

namespace hasp
{

namespace
{
constexpr std::int64_t LookNs = 100'000'000, LongestWaitNs = 120'000'000'000;
constexpr double ScaleForcesN[] = { 1.0, 2.0, 3.0 };
constexpr double MostReadN = 1000.0; // no spring scale of a table reads more

std::string ButtonsText(std::uint32_t buttons)
{
  std::string text;
  for (int button = 0; button < 32; ++button)
    if ((buttons >> button & 1U) != 0)
      text += (text.empty() ? "" : ",") + std::to_string(button);
  return text.empty() ? "none" : text;
}

const char* StatusText(DeviceStatus status)
{
  if (Has(status, DeviceStatus::Unplugged))
    return "not there";
  if (Has(status, DeviceStatus::Fault))
    return "says what cannot be";
  if (Has(status, DeviceStatus::NotHomed))
    return "not homed";
  return nullptr;
}

/// A number, or nothing for an empty line. Throws Failure at the end of what there is to read.
std::optional<double> ReadNumber(std::istream& in, std::ostream& out)
{
  for (std::string line; std::getline(in, line);)
  {
    if (line.find_first_not_of(" \t\r") == std::string::npos)
      return {};
    std::istringstream words(line);
    double number = 0.0;
    if (words >> number && (words >> std::ws).eof() && number > 0.0 && number < MostReadN)
      return number;
    out << "  a number of newtons above 0, or nothing to leave this one out: " << std::flush;
  }
  throw Failure(ExitCode::WrongUse, "the readings ended before all were there; nothing was kept");
}
} // namespace

std::string SightLine(const DeviceSight& seen)
{
  if (const char* wrong = StatusText(seen.status))
    return wrong;
  const auto rounded = [](const glm::dvec3& v)
  { return glm::round(10.0 * v) / 10.0 + 0.0; }; // no "-0.0"
  const glm::dvec3 at = rounded(seen.sample.pose.position), push = rounded(seen.asked.force);
  char text[200];
  std::snprintf(text, sizeof text,
    "x %.1f y %.1f z %.1f mm, buttons %s, force x %.1f y %.1f z %.1f N", at.x, at.y, at.z,
    ButtonsText(seen.sample.buttons).c_str(), push.x, push.y, push.z);
  return text;
}

DeviceDesk::DeviceDesk(const std::string& address, const DeviceSettings& settings,
  std::function<void(const std::string&)> says)
  : Says(std::move(says))
{
  try
  {
    this->Device =
      std::make_unique<DrivenHapticDevice>(MakeGuardedDriver(address, settings, BesideProgram()));
    this->Trial = std::make_unique<DeviceTrial>(*this->Device);
  }
  catch (const DeviceError& error)
  {
    throw Failure(error.trouble == DeviceTrouble::Address ? ExitCode::WrongUse : ExitCode::BadInput,
      error.what());
  }
}

DeviceDesk::~DeviceDesk() = default;

void DeviceDesk::UntilReady(bool homed)
{
  MonotonicClock clock;
  const std::int64_t untilNs = clock.NowNs() + LongestWaitNs;
  std::string said;
  for (;;)
  {
    const DeviceNews news = this->Device->News();
    const std::string& words = news.advice.empty() ? news.says : news.advice;
    if (news.phase == DevicePhase::Searching && !news.says.empty())
      throw Failure(ExitCode::BadInput, news.says);
    if (news.phase == DevicePhase::Running || (news.phase == DevicePhase::Homing && !homed))
    {
      if (!news.warning.empty())
        this->Says(news.warning);
      while (this->Trial->Look().status == DeviceStatus::Unplugged && clock.NowNs() < untilNs)
        clock.SleepUntil(clock.NowNs() + LookNs / 10); // until the loop has seen it, too
      return;
    }
    if (!words.empty() && words != said)
      this->Says(said = words);
    if (clock.NowNs() > untilNs)
      throw Failure(
        ExitCode::BadInput, "two minutes are over, and the device does not run: " + words);
    clock.SleepUntil(clock.NowNs() + LookNs / 10);
  }
}

void DeviceDesk::Watch(double seconds, const ForceTrial& trial)
{
  this->Trial->Ask(trial);
  MonotonicClock clock;
  const std::int64_t untilNs = clock.NowNs() + static_cast<std::int64_t>(1e9 * seconds);
  std::string said, advice;
  for (std::int64_t nowNs = clock.NowNs(); nowNs < untilNs; nowNs = clock.NowNs())
  {
    const DeviceNews news = this->Device->News();
    const std::string& words = news.phase == DevicePhase::Searching ? news.says : news.advice;
    if (words != advice && !words.empty())
      this->Says(words);
    advice = words;
    if (const std::string line = SightLine(this->Trial->Look()); line != said)
      this->Says(said = line);
    clock.SleepUntil(std::min(nowNs + LookNs, untilNs));
  }
  if (const DeviceNews news = this->Device->News(); news.phase == DevicePhase::Searching)
    throw Failure(ExitCode::BadInput, news.says);
  if (trial.kind != ForceTrial::Kind::None && this->Trial->Look().givenN == 0.0)
    throw Failure(ExitCode::FailedCheck,
      "no force was given: the device's first button was not held,"
      " or it was down from the beginning; let go of it first");
  this->Trial->Ask({});
}

/// Until the button is held and all of the force is there.
void DeviceDesk::UntilGiven(double newton)
{
  MonotonicClock clock;
  const std::int64_t untilNs = clock.NowNs() + LongestWaitNs;
  while (this->Trial->Look().givenN < newton - 1e-9)
  {
    if (clock.NowNs() > untilNs)
      throw Failure(ExitCode::WrongUse, "the device's first button was not held within two minutes;"
                                        " nothing was kept");
    clock.SleepUntil(clock.NowNs() + LookNs / 10);
  }
}

ScaleFit DeviceDesk::MeasureScale(std::istream& in, std::ostream& out)
{
  out << "Hang a spring scale between the grip and the table so that it is pulled when the grip"
         " moves towards\nyou. Hold the device's first button for as long as you read the scale.\n";
  std::vector<ScaleReading> readings;
  for (const double newton : ScaleForcesN)
  {
    this->Trial->Ask({ .kind = ForceTrial::Kind::Steady, .newton = newton });
    out << "  Hold the button: " << newton << " N … " << std::flush;
    this->UntilGiven(newton);
    out << "the scale reads, in newton: " << std::flush;
    if (const auto read = ReadNumber(in, out))
      readings.push_back({ newton, *read });
  }
  this->Trial->Ask({});
  try
  {
    return FitScale(readings);
  }
  catch (const std::invalid_argument& error)
  {
    throw Failure(ExitCode::BadInput, error.what());
  }
}

} // namespace hasp
