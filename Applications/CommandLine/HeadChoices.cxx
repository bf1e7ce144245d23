#include "HeadChoices.h"

#include "Devices/MouseHeadPose.h"
#include "Devices/OpentrackHeadPose.h"
#include "Devices/PluginHeadPose.h"
#include "Devices/RecordedHeadPose.h"
#include "Failure.h"
#include "Files.h"
#include "Session.h"

#include <CLI/CLI.hpp>

#include <charconv>
#include <cstdio>
#include <optional>
#include <stdexcept>

namespace hasp
{
namespace
{

constexpr const char* Mouse = "mouse";
constexpr const char* Opentrack = "opentrack";

/// "opentrack", "opentrack:PORT", "opentrack:ADDRESS:PORT". origin: of its coordinates in those
/// that it is to give.
OpentrackSettings OpentrackOf(const std::string& text, const glm::dvec3& origin)
{
  OpentrackSettings settings;
  settings.origin = origin;
  const std::string prefix = Opentrack;
  if (text == prefix)
    return settings;
  const auto colon = text.rfind(':');
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + colon + 1, end, settings.port);
  if (error != std::errc() || stop != end || settings.port == 0)
    throw Failure(ExitCode::WrongUse,
      "--head opentrack takes a port from 1 to 65535: opentrack:4242, opentrack:0.0.0.0:4242");
  if (colon > prefix.size())
    settings.address = text.substr(prefix.size() + 1, colon - prefix.size() - 1);
  return settings;
}

/// "FILE.so", "FILE.so.1.2" or either with ":SETTINGS" behind it: the first that fits.
struct PluginName
{
  std::string file, settings;
};

std::optional<PluginName> PluginOf(const std::string& text)
{
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  for (auto at = text.find(".so"); at != text.npos; at = text.find(".so", at + 1))
  {
    auto end = at + 3;
    while (end + 1 < text.size() && text[end] == '.' && digit(text[end + 1]))
      for (++end; end < text.size() && digit(text[end]);)
        ++end;
    if (end == text.size())
      return PluginName{ text, {} };
    if (text[end] == ':')
      return PluginName{ text.substr(0, end), text.substr(end + 1) };
  }
  return std::nullopt;
}

HeadPath ReadRecording(const std::string& file)
{
  try
  {
    return ReadHeadPath(file);
  }
  catch (const std::exception& error)
  {
    throw Failure(ExitCode::BadInput, std::string("--head: ") + error.what());
  }
}

TrackerCalibration ReadCalibration(const HeadChoices& choices)
{
  if (choices.calibration.empty())
    return {};
  if (choices.source == Mouse)
    throw Failure(ExitCode::WrongUse,
      "--head-calibration: says where a tracker stands, and the mouse is none; leave it out");
  try
  {
    return ReadTrackerCalibration(choices.calibration);
  }
  catch (const std::exception& error)
  {
    throw Failure(ExitCode::BadInput, std::string("--head-calibration: ") + error.what());
  }
}

/// A calibrated source says its own coordinates, as it did when it was measured.
std::unique_ptr<HeadPoseSource> MakeSource(
  const std::string& name, const HeadPose& rest, bool calibrated)
{
  if (name == Mouse)
  {
    MouseHeadSettings settings;
    settings.rest = rest;
    return std::make_unique<MouseHeadPose>(settings);
  }
  if (name == Opentrack || name.starts_with("opentrack:"))
    return std::make_unique<OpentrackHeadPose>(
      OpentrackOf(name, calibrated ? glm::dvec3(0.0) : rest.position));
  if (const auto plugin = PluginOf(name)) // before .csv: its settings may end so
    return std::make_unique<PluginHeadPose>(plugin->file, plugin->settings);
  if (name.ends_with(".csv"))
  {
    PlaybackSettings settings;
    settings.startS = SteadySeconds();
    settings.loop = true;
    return std::make_unique<RecordedHeadPose>(ReadRecording(name), settings);
  }
  throw Failure(ExitCode::WrongUse,
    "--head must be mouse, opentrack, opentrack:PORT, opentrack:ADDRESS:PORT, a .csv file or a "
    "plugin, FILE.so or FILE.so:SETTINGS");
}

const char* StateName(HeadTrackerState state)
{
  switch (state)
  {
    case HeadTrackerState::Waiting:
      return "waiting for";
    case HeadTrackerState::Tracking:
      return "tracking by";
    case HeadTrackerState::Holding:
      return "held, late poses of";
    case HeadTrackerState::Easing:
      return "going to rest, no poses of";
    case HeadTrackerState::Resting:
      return "at rest, no poses of";
    case HeadTrackerState::Returning:
      return "coming back to";
  }
  return "";
}

} // namespace

void AddHeadOptions(CLI::App& verb, HeadChoices& choices)
{
  CLI::Option* head = verb.add_option("--head", choices.source,
    "The picture follows the viewer's head. mouse: as if the pointer were it; opentrack: UDP on "
    "this machine's port 4242 (opentrack:PORT, opentrack:ADDRESS:PORT); FILE.csv: a recorded path, "
    "again and again; FILE.so: a plugin for a tracker (FILE.so:SETTINGS, as its maker documents "
    "them)");
  verb
    .add_option("--head-calibration", choices.calibration,
      ".json file of where the tracker stands; hasp calibrate makes one")
    ->needs(head);
  verb
    .add_option("--head-prediction", choices.predictionMs,
      "ms until a frame is seen: the head is drawn where it will be then. 0: where it was")
    ->check(Within(0.0, 200.0))
    ->capture_default_str()
    ->needs(head);
  verb
    .add_option("--record-head", choices.record,
      ".csv file of the poses as they came, written when the window closes; --head plays it again")
    ->needs(head);
}

void RequireRecordable(const HeadChoices& choices)
{
  if (choices.record.empty())
    return;
  RequireWritable(choices.record, { ".csv" });
  if (choices.source.ends_with(".csv"))
    RequireDifferent(choices.record, choices.source, "--record-head and --head");
}

void WriteRecording(const HeadChoices& choices, const HeadRecorder& recorder, Session& session)
{
  if (choices.record.empty())
    return;
  for (const std::string& loss : recorder.Losses())
    SayWarning(session, "--record-head: " + loss);
  if (recorder.Path().empty())
    return SayWarning(session, "--record-head: no pose came; nothing was written");
  WriteFile(choices.record, FormatHeadPath(recorder.Path()));
  session.result["recordedPoses"] = recorder.Path().size();
}

std::unique_ptr<HeadTracker> MakeHeadTracker(const HeadChoices& choices, const HeadPose& rest)
{
  if (choices.source.empty())
    return nullptr;
  HeadTrackerSettings settings;
  settings.rest = rest;
  settings.horizonS = 1e-3 * choices.predictionMs;
  settings.predict = choices.predictionMs > 0.0;
  if (choices.predictionMs > 0.0 && choices.predictionMs < 1.0)
    throw Failure(ExitCode::WrongUse, "--head-prediction must be 0 or from 1 to 200: it is in ms");
  const TrackerCalibration calibration = ReadCalibration(choices);
  try
  {
    return std::make_unique<HeadTracker>(
      MakeSource(choices.source, rest, !choices.calibration.empty()), settings, calibration);
  }
  catch (const Failure&)
  {
    throw;
  }
  catch (const std::invalid_argument& error) // what files hold was checked as they were read
  {
    throw Failure(ExitCode::WrongUse, std::string("--head: ") + error.what());
  }
  catch (const std::exception& error)
  {
    throw Failure(ExitCode::BadInput, std::string("--head: ") + error.what());
  }
}

std::string HeadText(const TrackedHead& head, const char* source)
{
  char text[200];
  if (head.state != HeadTrackerState::Tracking && head.state != HeadTrackerState::Returning)
    std::snprintf(text, sizeof text, "head: %s %s", StateName(head.state), source);
  else
    std::snprintf(text, sizeof text, "head: %s %s, %.0f ms (%.1f frames) old, %.0f predicted",
      StateName(head.state), source, 1e3 * head.latencyS, head.latencyFrames,
      1e3 * head.predictedS);
  return text;
}

} // namespace hasp
