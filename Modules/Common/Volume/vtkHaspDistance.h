#ifndef vtkHaspDistance_h
#define vtkHaspDistance_h

#include "Distance/BodyDistance.h"     // for BodyDistance
#include "vtkHaspCommonVolumeModule.h" // for export macro

class vtkImageData;
class vtkPolyData;

namespace hasp
{

/// What contact needs of a body that VTK holds: the signed distance that DistanceMap and PointShell
/// are made of. BodyDistance.h says the method, the error in spacings, the cost and the limits.
///
/// image     inside is value >= isovalue; its active scalars, of a type that ViewImage takes
/// surface   closed; polygons and strips become triangles; lines and vertices are ignored. In the
///           axes of its points: an actor's matrix is not asked
/// Throws std::invalid_argument as BodyDistance.h and vtkHaspVolumeView.h say; Cancelled. Any
/// thread, as long as no other changes the VTK object meanwhile.
VTKHASPCOMMONVOLUME_EXPORT BodyDistance DistanceOfImage(vtkImageData* image, double isovalue,
  const BodyDistanceSettings& settings = {}, const ProgressFunction& progress = {});
VTKHASPCOMMONVOLUME_EXPORT BodyDistance DistanceOfSurface(vtkPolyData* surface,
  const BodyDistanceSettings& settings = {}, const ProgressFunction& progress = {});

/// Triangles of any polydata: strips and polygons of more than three corners are cut up as VTK's
/// cells do. Throws as MakeTriangleMesh, and for null.
VTKHASPCOMMONVOLUME_EXPORT TriangleMesh TrianglesOf(vtkPolyData* surface);

} // namespace hasp

#endif
