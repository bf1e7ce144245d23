#include "DeviceDesk.h"
#include "Devices/Drivers/DeviceAddress.h"
#include "Devices/Drivers/DeviceError.h"
#include "Devices/Drivers/DeviceSearch.h"
#include "Failure.h"
#include "Session.h"
#include "Verbs.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <vector>

namespace hasp
{
namespace
{

constexpr double MostRmsShare = 0.1; // of the largest force: readings that scatter more are none

struct Choices
{
  std::string device{}, settings{}, firmware{};
  double watchS = 0.0, newton = 1.0;
  bool udevRules = false, testForce = false, calibrate = false, settingsNamed = false;
  bool Pushes() const { return testForce || calibrate; }
  bool Opens() const { return watchS > 0.0 || testForce || calibrate || !device.empty(); }
};

DeviceSettings SettingsOf(const Choices& choices)
{
  try
  {
    if (choices.settingsNamed && !choices.calibrate && !std::filesystem::exists(choices.settings))
      throw Failure(ExitCode::BadInput, "--settings: there is no such file");
    DeviceSettings settings = ReadDeviceSettings(choices.settings);
    if (!choices.firmware.empty())
      settings.falcon.firmware = choices.firmware;
    return settings;
  }
  catch (const Failure&)
  {
    throw;
  }
  catch (const std::exception& error)
  {
    throw Failure(ExitCode::BadInput, error.what());
  }
}

void List(const std::vector<FoundDevice>& found, Session& session)
{
  auto& list = session.result["devices"] = nlohmann::ordered_json::array();
  for (const FoundDevice& device : found)
    list.push_back(
      { { "address", device.address }, { "name", device.name }, { "force", device.force },
        { "may_open", device.mayOpen }, { "driver", device.driver }, { "remedy", device.remedy } });
  if (session.json)
    return;
  for (const FoundDevice& device : found)
    std::cout << device.name << " (" << device.address << ", "
              << (device.force ? "pushes" : "input alone")
              << "): " << (device.remedy.empty() ? "can be used" : device.remedy) << "\n";
}

void SayNone(Session& session)
{
  if (!session.json)
    std::cout << "No haptic device and no 6-DOF mouse is plugged in. Hasp works with the mouse"
                 " alone.\nWhat is behind a service or a maker's SDK is named: --device inverse3,"
                 " --device plugin:FILE.so\n";
}

void Calibrate(DeviceDesk& desk, const std::string& address, DeviceSettings settings,
  const Choices& choices, Session& session)
{
  const ScaleFit fit = desk.MeasureScale(std::cin, session.json ? std::cerr : std::cout);
  session.result["share"] = fit.share;
  session.result["rms_newton"] = fit.rmsN;
  char text[200];
  std::snprintf(text, sizeof text,
    "%.3f of what is asked for is felt; readings scatter by %.2f N RMS, %.2f N at most\n",
    fit.share, fit.rmsN, fit.worstN);
  if (!session.json)
    std::cout << text;
  if (fit.rmsN > MostRmsShare * ForceTrial::mostN)
    throw Failure(ExitCode::FailedCheck, "the readings scatter by more than a tenth of the largest"
                                         " force; nothing was kept. Read the scale again, without"
                                         " friction and along the axis towards you");
  if (ParseDeviceAddress(address).driver != "falcon")
    return;
  settings.falcon.countsPerNm /= fit.share;
  session.result["counts_per_nm"] = settings.falcon.countsPerNm;
  try
  {
    settings.falcon.firmware = SettingsOf({ .settings = choices.settings }).falcon.firmware;
    WriteDeviceSettings(choices.settings, settings);
  }
  catch (const std::exception& error)
  {
    throw Failure(ExitCode::WrongUse, error.what());
  }
  if (!session.json)
    std::cout << "countsPerNm is " << settings.falcon.countsPerNm << " from now on\n";
}

void Open(const std::string& address, const DeviceSettings& settings, const Choices& choices,
  Session& session)
{
  session.progress.Wipe();
  DeviceDesk desk(address, settings,
    [&session](const std::string& line)
    { (session.json ? std::cerr : std::cout) << line << std::endl; });
  desk.UntilReady(choices.Pushes());
  session.result["driver"] = ParseDeviceAddress(address).driver; // what is behind it may be a path
  session.result["name"] = desk.Profile().name;
  if (choices.Pushes() && desk.Profile().forceAxes == 0)
    throw Failure(ExitCode::BadInput, "this device has no motors: there is no force to be tested");
  if (choices.calibrate)
    return Calibrate(desk, address, settings, choices, session);
  constexpr double briefS = 0.3, testS = 30.0; // a look; time to feel each axis
  const double watchS = choices.watchS > 0.0 ? choices.watchS : choices.testForce ? testS : briefS;
  if (choices.testForce && !session.json)
    std::cout << "Hold the grip, and its first button for as long as you want to feel the force."
              << std::endl;
  desk.Watch(watchS, { .kind = choices.testForce ? ForceTrial::Kind::Axes : ForceTrial::Kind::None,
                       .newton = choices.newton });
  const DeviceNews news = desk.News();
  const DeviceSample seen = desk.Look().sample;
  const glm::dvec3& at = seen.pose.position;
  session.result["position_mm"] = { at.x, at.y, at.z };
  session.result["buttons"] = seen.buttons;
  session.result["homed"] = news.phase == DevicePhase::Running;
  session.result["exchanges"] = news.exchanges;
  session.result["stale"] = news.stale;
  session.result["lost"] = news.lost;
}

void Run(const Choices& choices, Session& session)
{
  if (choices.udevRules)
  {
    std::cout << UdevRules();
    return;
  }
  const DeviceSettings settings = SettingsOf(choices);
  const std::vector<FoundDevice> found = FindDevices();
  std::string address = choices.device.empty() ? settings.device : choices.device;
  if (address.empty() || address == "none")
  {
    std::vector<FoundDevice> fit = found;
    if (choices.Pushes())
      std::erase_if(fit, [](const FoundDevice& device) { return !device.force; });
    address = FirstUsable(fit);
  }
  address = WithPlace(address, found);
  if (!choices.Opens() || address.empty())
  {
    List(found, session);
    if (found.empty())
      SayNone(session);
    if (!settings.device.empty() && !session.json)
      std::cout << "Your settings name one: "
                << (settings.device == "none" ? "none" : ParseDeviceAddress(settings.device).driver)
                << "\n";
    return;
  }
  Open(address, settings, choices, session);
}

} // namespace

void AddDevicesVerb(CLI::App& app, Session& session)
{
  auto choices = std::make_shared<Choices>();
  choices->settings = DeviceSettingsFile().string();
  CLI::App* verb = app.add_subcommand(
    "devices", "Find haptic devices and 6-DOF mice, try them, calibrate their force");
  verb->add_option("--device", choices->device,
    "Opens this one: falcon, spacemouse, spacenav, inverse3, plugin:FILE.so; more behind a colon");
  verb->add_option("--watch", choices->watchS, "Shows pose and buttons for so many seconds")
    ->check(Within(0.1, 86'400.0));
  CLI::Option* test = verb->add_flag("--test-force", choices->testForce,
    "Pushes along each axis in turn, as long as the device's first button is held");
  verb->add_option("--newton", choices->newton, "The largest force of that; 1")
    ->needs(test)
    ->check(Within(0.1, ForceTrial::mostN));
  verb
    ->add_flag("--calibrate", choices->calibrate,
      "Asks for what a spring scale reads, and keeps the scale of a Falcon's force")
    ->excludes(test);
  verb->add_option(
    "--firmware", choices->firmware, "Your own file of a Falcon's firmware, for this run");
  CLI::Option* file = verb->add_option("--settings", choices->settings,
    "The .json file of your devices; usually hasp/devices.json in your XDG_CONFIG_HOME");
  verb->add_flag("--udev-rules", choices->udevRules,
    "Prints the rules that let whoever sits at this machine use these devices");
  AddCommonOptions(*verb, session);
  verb->footer("Without options: what is plugged in, and whether it can be used.\n"
               "Examples:\n"
               "  hasp devices\n"
               "  hasp devices --test-force --newton 0.5\n"
               "  hasp devices --udev-rules | sudo tee /etc/udev/rules.d/60-hasp-devices.rules\n"
               "Exit codes: 0 done, or there is no device; 1 wrong use, 2 the device cannot be "
               "used, 3 the readings\nof a calibration do not agree.");
  verb->callback(
    [&session, choices, file]
    {
      choices->settingsNamed = file->count() > 0;
      session.run = [&session, choices] { Run(*choices, session); };
    });
}

} // namespace hasp
