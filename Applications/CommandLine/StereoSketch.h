#pragma once
#include "StereoLayout.h"
#include "StereoRig.h"

#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;

namespace hasp
{

/// A set-up of screen, eyes and what is shown, to be held against the desk. All in millimetres of
/// the room.
struct StereoSketch
{
  std::string title; ///< first line of the text
  StereoRig rig;
  StereoLayout layout = StereoLayout::SideBySide; ///< says which eyes there are
  /// Of the box around what is shown; corner n takes the larger x, y, z where bits 0, 1, 2 of n are
  /// set. None: no box.
  std::optional<std::array<glm::dvec3, 8>> content{};
  bool contentIsVolume = false; ///< the box is the whole volume's, air and table too
};

/// An eye that the picture is drawn for.
struct SketchedEye
{
  enum
  {
    Between, ///< mono's
    Left,
    Right
  } which;
  glm::dvec3 position; ///< mm of the room
};

/// Mono, left and right have one.
std::vector<SketchedEye> EyesOf(const StereoSketch& sketch);

/// The set-up from above and from the viewer's left, to one scale, with the figures that a user
/// checks with a ruler: size and angles of the screen, distance and separation of the eyes,
/// where the nearest and farthest part of the content are and, for two eyes, their disparity. Needs
/// OpenGL, and no display after ChooseWindows. Throws std::invalid_argument as ValidateStereoRig,
/// Failure: CannotDraw after an error of VTK. RENDER thread; 0.2 s.
vtkSmartPointer<vtkImageData> DrawStereoSketch(const StereoSketch& sketch);

/// The figures under the drawing, a line each.
std::string StereoSketchText(const StereoSketch& sketch);

} // namespace hasp
