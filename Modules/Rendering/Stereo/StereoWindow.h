#pragma once
#include "LensModel.h"
#include "StereoHmd.h"
#include "StereoOutput.h"
#include "StereoRig.h"
#include "vtkHaspRenderingStereoModule.h" // for export macro

#include <glm/mat4x4.hpp>

#include <array>
#include <optional>

/// What one window is in the viewer's room. Room coordinates: millimetres; by custom the origin is
/// the middle of the main screen, x right, y up, z towards the viewer. Plain values and pure
/// functions; any thread.
namespace hasp
{

struct StereoWindow
{
  StereoOutput output{};

  /// The window's rectangle in the room. Its aspect is that of the scene as the viewer sees it,
  /// whatever the window's pixels. None: the eyes stand beside the scene's camera, and the aspect
  /// is that of an eye's pixels (Full) or of the window's (Half).
  std::optional<StereoScreen> screen{};

  /// A head-mounted display instead of a screen: its eyes go with the head.
  std::optional<StereoHmd> hmd{};

  /// Pre-distortion: the window shows what looks right through these lenses.
  std::optional<LensModel> lens{};
};

/// Throws std::invalid_argument, saying what to change: a screen and a display at once, values that
/// their own checks refuse.
VTKHASPRENDERINGSTEREO_EXPORT void ValidateStereoWindow(const StereoWindow& window);

/// The views of a window's left and right eye in the world; mono: both are the eye between.
/// Throws like ViewOfEye, ViewOfHmdEye and TransformStereoRig; std::invalid_argument for a window
/// with neither screen nor display.
VTKHASPRENDERINGSTEREO_EXPORT std::array<EyeView, 2> ViewsOfEyes(
  const StereoWindow& window, StereoHead roomHead, const glm::dmat4& roomToWorld);

} // namespace hasp
