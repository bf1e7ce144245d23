#pragma once
#include "StereoChoices.h"
#include "SurfaceScene.h"

#include <memory>

namespace hasp
{

struct RenderOptions : SceneOptions
{
  StereoChoices stereo;
  bool squarePixels = true; ///< the width of `resolution` follows the screen's, where there is one
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
  /// The plan of --sketch likewise.
  std::string SketchPng() const;

private:
  struct Parts;
  std::unique_ptr<Parts> Self;
};

} // namespace hasp
