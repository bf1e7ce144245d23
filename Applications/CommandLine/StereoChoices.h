#pragma once
#include "StereoWindow.h"

#include <array>
#include <optional>
#include <string>

namespace CLI
{
class App;
}

/// What `hasp render` and `hasp view` let their users choose of two eyes.
namespace hasp
{

struct StereoChoices
{
  static constexpr const char* OpenXR = "openxr";
  std::string layout = "mono";     ///< a name of StereoLayout
  std::string resolution = "full"; ///< of an eye: "full" or "half"
  std::string mirror = "none";     ///< "none", "horizontal", "vertical", "both"
  bool swapEyes = false;
  std::string screen;                          ///< its size in mm, "520x320"; empty: none is known
  std::string lens;                            ///< .json file; empty: none
  std::optional<std::array<double, 4>> hmd;    ///< tangents left, right, up, down of the left eye
  std::optional<double> eyeAngle;              ///< degrees; without a screen. Usually 2
  std::optional<double> eyeSeparationMm;       ///< usually 63
  std::optional<std::array<double, 3>> headMm; ///< in the room; usually 0, 0, 600
  bool lifeSize = false;
  std::string sketch; ///< .png file; empty: none

  /// Is there anything to see but what an ordinary window shows?
  bool Any() const;
  /// Is a screen or a head-mounted display given, so that eyes have a place?
  bool InRoom() const;
  /// Is that, a lens or a mirror given?
  bool Placed() const;
};

/// Adds --stereo and all that goes with it.
void AddStereoOptions(CLI::App& verb, StereoChoices& choices);

/// The window as the choices have it: reads the lens. Throws Failure: WrongUse for choices that do
/// not go together or are out of range, BadInput for a file.
StereoWindow MakeStereoWindow(const StereoChoices& choices);

/// The viewer in the room: millimetres, origin in the middle of the screen, x right, y up, z
/// towards the viewer.
StereoHead RoomHead(const StereoChoices& choices);

/// "520x320" as width and height in millimetres, each in [10, 100000]. Throws Failure: WrongUse.
std::array<double, 2> ScreenSize(const std::string& text);

/// Width through height of what one eye sees: of its screen, or of its pixels, `view`.
double EyeAspect(const StereoWindow& window, std::array<int, 2> view);

/// Pixels of the whole picture or window. view: of one eye; with `squarePixels` its width follows
/// the screen's.
std::array<int, 2> WindowPixels(
  const StereoWindow& window, std::array<int, 2> view, bool squarePixels);

} // namespace hasp
