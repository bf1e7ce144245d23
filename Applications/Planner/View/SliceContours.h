#pragma once
#include "vtkSmartPointer.h"

#include <glm/vec3.hpp>

#include <memory>
#include <vector>

class vtkMatrix4x4;
class vtkPolyData;
class vtkRenderer;

namespace hasp
{

/// A surface whose line in the slices is drawn.
struct SliceContour
{
  vtkSmartPointer<vtkPolyData> surface;
  vtkSmartPointer<vtkMatrix4x4> matrix; ///< of the surface to the world, mm; null: it is there
  glm::dvec3 colour{ 1.0 };             ///< [0, 1]
  double width = 2.0;                   ///< pixels
};

/// The lines in which surfaces meet the plane of a slice. A surface is cut where it is defined: it
/// may move as often as frames are drawn, and is never copied.
/// Threads: RENDER. Cost: nothing for surfaces that the plane does not reach. For the others, when
/// plane, surface or matrix has changed, about 10 ms a million triangles; the first time a third of
/// a second (and a tree of spheres is kept), for a surface that is another again.
class SliceContours
{
public:
  explicit SliceContours(vtkRenderer* renderer);
  ~SliceContours();

  void Set(const std::vector<SliceContour>& contours);
  /// Right before a frame. Unit normal; the lines are drawn `lift` mm above the plane.
  void Cut(const glm::dvec3& point, const glm::dvec3& normal, double lift);
  /// Surfaces that the plane reached at the last Cut.
  int Reached() const;

private:
  struct Line;
  vtkRenderer* Scene;
  std::vector<std::unique_ptr<Line>> Lines;
};

} // namespace hasp
