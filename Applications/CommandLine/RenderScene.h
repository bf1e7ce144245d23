#pragma once
#include "StereoLayout.h"
#include "SurfaceScene.h"

#include <memory>

namespace hasp
{

struct RenderOptions : SceneOptions
{
  StereoLayout stereo = StereoLayout::Mono;
  double eyeAngle = 2.0; ///< degrees
};

/// One picture of a scene, without a display. RENDER thread.
class RenderScene
{
public:
  /// As SurfaceScene; throws Failure: CannotDraw without OpenGL besides.
  RenderScene(vtkDataObject* volume, const RenderOptions& options, Session& session);
  ~RenderScene();

  /// The picture as a PNG file. Throws Failure: CannotDraw.
  std::string DrawPng();

private:
  struct Parts;
  std::unique_ptr<Parts> Self;
};

} // namespace hasp
