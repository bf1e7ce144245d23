#pragma once
#include "vtkSmartPointer.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <utility>

class vtkCamera;
class vtkImageData;

namespace hasp
{

/// What all methods draw: one isosurface, one camera, one picture size.
struct IsosurfaceView
{
  vtkSmartPointer<vtkImageData> image;
  double isovalue = 0.0;
  int width = 400, height = 400;
  glm::dmat4 clipToWorld; ///< of the camera, OpenGL clip coordinates
  vtkSmartPointer<vtkCamera> camera;

  /// A perspective view along `direction` in which the volume fills the picture.
  IsosurfaceView(vtkSmartPointer<vtkImageData> image, double isovalue, int width, int height,
    const glm::dvec3& direction);
  /// After `camera` was changed: brings clipToWorld up to date.
  void CameraMoved();
  /// Pixel x, y at normalised device depth z in [-1,1], in world mm.
  glm::dvec3 Unproject(int x, int y, double z) const;
  /// Origin on the near plane, unit direction.
  std::pair<glm::dvec3, glm::dvec3> Ray(int x, int y) const;
};

} // namespace hasp
