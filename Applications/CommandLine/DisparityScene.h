#pragma once
#include "Pairing.h"
#include "StereoWindow.h"
#include "vtkHaspStereoWindows.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <array>

namespace hasp
{

/// A white ball in the room of a screen, drawn into stereo windows: what the stereo report measures
/// disparities on. What a display of each layout shows is written here from the displays'
/// descriptions, not taken from the code that is measured. RENDER thread.
class DisparityScene
{
public:
  static constexpr int Width = 640, Height = 400;
  static constexpr double RadiusMm = 18.0; ///< 40 to 60 pixels: the middle is known to 0.05

  explicit DisparityScene(const StereoWindow& window);

  /// Places head and ball. Room coordinates, which are the world's here.
  void Place(const StereoHead& head, const glm::dvec3& center);

  /// Disparity of the ball's outline, right eye minus left one, in pixels of the screen. As drawn:
  glm::dvec2 Drawn();
  /// By closed form:
  glm::dvec2 Truth() const;
  /// By VTK's own stereo: a camera at the head that looks at the screen's middle, and the eye angle
  /// of this separation. For windows with a screen.
  glm::dvec2 ByVtk();

  void SetSamples(int samples); ///< a pixel; 4 at first
  Timing TimeOurs();
  /// VTK's stereo in the same layout, where VTK has it (VtkName); else two frames of one eye.
  Timing TimeVtk();
  const char* VtkName() const;

private:
  glm::dvec2 SeenAt(StereoEye eye) const;
  void LookAsVtk();

  StereoWindow Settings;
  StereoHead Head;
  glm::dvec3 Center{ 0.0 };
  vtkNew<vtkRenderer> Renderer;
  std::array<vtkNew<vtkRenderWindow>, 2> Shown; ///< the second one for dual windows
  vtkNew<vtkHaspStereoWindows> Windows;
};

} // namespace hasp
