#pragma once
#include "vtkHaspRenderingStereoModule.h" // for export macro

#include <string>

namespace hasp
{

/// How two eyes' pictures become what a viewer is shown. `StereoOutput.h` says which pixel is
/// whose.
enum class StereoLayout
{
  Mono,         ///< one eye between the two: no second eye is drawn
  SideBySide,   ///< left eye on the left
  TopBottom,    ///< left eye on top
  Left,         ///< the left eye alone
  Right,        ///< the right eye alone
  Anaglyph,     ///< red from the left eye's luminance, green and blue from the right eye
  Interlaced,   ///< rows by turns; the top row is the left eye's
  Checkerboard, ///< pixels by turns; the top left one is the left eye's
  DualWindow,   ///< two windows, one eye each
  QuadBuffer    ///< the driver's left and right buffers of one window
};

/// "mono", "side-by-side", "top-bottom", "left", "right", "anaglyph", "interlaced", "checkerboard",
/// "dual-window", "quad-buffer".
VTKHASPRENDERINGSTEREO_EXPORT const char* StereoLayoutName(StereoLayout layout);

/// The reverse. Throws std::invalid_argument with the name found and all that are known.
VTKHASPRENDERINGSTEREO_EXPORT StereoLayout StereoLayoutFromName(const std::string& name);

/// Whether the layout draws two eyes.
VTKHASPRENDERINGSTEREO_EXPORT bool NeedsSecondEye(StereoLayout layout);

/// Whether the layout puts two eyes into one picture. Dual windows and quad buffers have two.
VTKHASPRENDERINGSTEREO_EXPORT bool IsOnePicture(StereoLayout layout);

} // namespace hasp
