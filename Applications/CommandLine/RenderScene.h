#pragma once
#include "CameraOptions.h"
#include "StereoLayout.h"
#include "SurfaceActors.h"

#include <memory>
#include <string>

class vtkDataObject;

namespace hasp
{

struct Session;

struct RenderOptions
{
  double isoValue = 0.0;
  std::string mapper; ///< a name of SurfaceMappers()
  CellDrawing cells;
  std::array<int, 2> resolution{ 800, 800 };            ///< pixels of one eye
  std::array<double, 3> color{ 0.93, 0.87, 0.76 };      ///< of the isosurface, in [0,1]
  std::array<double, 3> background{ 0.10, 0.11, 0.13 }; ///< in [0,1]
  std::vector<std::string> surfaces;                    ///< files drawn with it
  CameraOptions camera;
  StereoLayout stereo = StereoLayout::Mono;
  double eyeAngle = 2.0; ///< degrees
};

/// One picture of an isosurface and meshes, without a display. RENDER thread.
class RenderScene
{
public:
  /// `volume` is a vtkImageData, or a vtkHaspClusteredCells, which has its own isovalue.
  /// Throws Failure: CannotDraw without OpenGL, BadInput for a surface that cannot be read.
  RenderScene(vtkDataObject* volume, const RenderOptions& options, Session& session);
  ~RenderScene();

  /// The picture as a PNG file. Throws Failure: CannotDraw.
  std::string DrawPng();

private:
  struct Parts;
  std::unique_ptr<Parts> Self;
};

} // namespace hasp
