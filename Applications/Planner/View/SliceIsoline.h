#pragma once
#include "vtkNew.h"
#include "vtkType.h"

#include <glm/vec3.hpp>

class vtkActor;
class vtkFlyingEdges2D;
class vtkImageData;
class vtkImageReslice;
class vtkMatrix4x4;
class vtkPolyDataMapper;
class vtkRenderer;

namespace hasp
{

struct SliceFrame;

/// Where a slice is of one grey value: the edge of the bone that the 3D view shows.
/// Threads: RENDER. Cost: the slice once more, at the image's own resolution (1024 values along an
/// axis at most), when slice, image or value change.
class SliceIsoline
{
public:
  explicit SliceIsoline(vtkRenderer* renderer);
  ~SliceIsoline();

  /// The slice through `place` as `frame` shows it.
  void Cut(vtkImageData* image, double value, const SliceFrame& frame, const glm::dvec3& place,
    double lift);
  vtkActor* Actor() const { return this->Line; }

private:
  void Take(vtkImageData* image);

  vtkRenderer* Scene;
  vtkMTimeType Taken = 0;
  glm::dvec3 Middle{ 0.0 }; ///< of the plane that was cut
  vtkNew<vtkImageReslice> Reslice;
  vtkNew<vtkFlyingEdges2D> Edges;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Line;
  vtkNew<vtkMatrix4x4> PlaneToData, PlaneToWorld;
};

} // namespace hasp
