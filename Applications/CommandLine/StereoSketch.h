#pragma once
#include "StereoRig.h"

#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <string>

class vtkImageData;

namespace hasp
{

/// A set-up of screen, eyes and what is shown, to be held against the desk. All in millimetres of
/// the room.
struct StereoSketch
{
  std::string title; ///< first line of the text
  StereoRig rig;
  /// Of the box around what is shown; corner n takes the larger x, y, z where bits 0, 1, 2 of n are
  /// set. None: no box.
  std::optional<std::array<glm::dvec3, 8>> content{};
};

/// The set-up from above and from the viewer's left, to one scale, with the figures that a user
/// checks with a ruler: size and angles of the screen, distance and separation of the eyes,
/// disparity of the nearest and farthest part of the content. Needs OpenGL, and no display after
/// ChooseWindows. Throws std::invalid_argument as ValidateStereoRig. RENDER thread; 0.2 s.
vtkSmartPointer<vtkImageData> DrawStereoSketch(const StereoSketch& sketch);

/// The figures under the drawing, a line each.
std::string StereoSketchText(const StereoSketch& sketch);

} // namespace hasp
