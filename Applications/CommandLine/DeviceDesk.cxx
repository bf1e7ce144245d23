#include "DeviceDesk.h"

#include "Devices/Drivers/DeviceList.h"
#include "Failure.h"

#include <glm/geometric.hpp>

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
constexpr std::int64_t LookNs = 100'000'000;
constexpr double ScaleForcesN[] = { 1.0, 2.0, 3.0 };

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
    if (words >> number && (words >> std::ws).eof() && std::isfinite(number) && number > 0.0)
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
  const glm::dvec3& at = seen.sample.pose.position;
  char text[160];
  std::snprintf(text, sizeof text, "x %.1f y %.1f z %.1f mm, buttons %s, force %.1f N", at.x, at.y,
    at.z, ButtonsText(seen.sample.buttons).c_str(), glm::length(seen.asked.force));
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
      return;
    }
    if (!words.empty() && words != said)
      this->Says(said = words);
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
  this->Trial->Ask({});
}

ScaleFit DeviceDesk::MeasureScale(std::istream& in, std::ostream& out)
{
  out << "Hang a spring scale between the grip and the table so that it is pulled when the grip"
         " moves towards\nyou. Hold the device's first button for as long as you read the scale.\n";
  std::vector<ScaleReading> readings;
  for (const double newton : ScaleForcesN)
  {
    this->Trial->Ask({ .kind = ForceTrial::Kind::Steady, .newton = newton });
    out << "  " << newton << " N is asked for; the scale reads, in newton: " << std::flush;
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
