#pragma once
#include "Grid/ResourceUse.h"
#include "StereoRig.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <array>

namespace hasp
{

/// One small unlit ball in front of a camera, drawn as a mesh or by VTK's GPU ray caster: what the
/// stereo report measures on. RENDER thread.
class BallScene
{
public:
  static constexpr int Width = 600, Height = 400;
  static constexpr double EyeAngle = 8.0;
  enum class Ball
  {
    Mesh,
    Volume
  };

  BallScene();
  void PlaceBall(const glm::dvec3& center, Ball kind);

  /// Where the middle of the ball is in both eyes, pixels: {left, right}. By the rig:
  std::array<glm::dvec2, 2> ByRig();
  /// By VTK's own stereo:
  std::array<glm::dvec2, 2> ByVtk();
  /// By geometry:
  std::array<glm::dvec2, 2> Truth(const glm::dvec3& center) const;

  /// What a mono picture of the same scene skips.
  ResourceList SkippedInMono();

private:
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
};

} // namespace hasp
