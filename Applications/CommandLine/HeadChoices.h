#pragma once
#include "Devices/HeadRecorder.h"
#include "Devices/HeadTracker.h"

#include <memory>
#include <string>

namespace CLI
{
class App;
}

/// Where `hasp view` has the viewer's head from.
namespace hasp
{

struct Session;

struct HeadChoices
{
  std::string source;      ///< empty: the head stays where it is
  std::string calibration; ///< .json file; empty: the tracker says room coordinates
  double predictionMs = 33.0;
  std::string record; ///< .csv file that the poses are written to; empty: none
};

/// Adds --head, --head-calibration, --head-prediction and --record-head.
void AddHeadOptions(CLI::App& verb, HeadChoices& choices);

/// The source that `choices` name: "mouse"; "opentrack", "opentrack:PORT" or
/// "opentrack:ADDRESS:PORT"; a recorded path, .csv; a plugin, "FILE.so", "FILE.so.1" or either with
/// ":SETTINGS" behind it. Null if there is none. rest: where the head is without a pose. Throws
/// Failure: WrongUse for what is none of these, for a mouse with a calibration and for settings
/// that a source refuses; BadInput for a file, a socket or a plugin that cannot be opened.
std::unique_ptr<HeadTracker> MakeHeadTracker(const HeadChoices& choices, const HeadPose& rest);

/// Throws Failure: WrongUse unless --record-head, if it was given, names a file that can be written
/// and is not the one that --head plays.
void RequireRecordable(const HeadChoices& choices);

/// Writes what was recorded to the file of --record-head, if it was given; a warning for each kind
/// of pose that is not in it, and instead of a file where no pose came. Throws Failure as WriteFile
/// does.
void WriteRecording(const HeadChoices& choices, const HeadRecorder& recorder, Session& session);

/// "head: tracking by opentrack, 33 ms (2.0 frames) old, 33 predicted".
std::string HeadText(const TrackedHead& head, const char* source);

} // namespace hasp
