#ifndef vtkHaspDistance_h
#define vtkHaspDistance_h

#include "Distance/BodyDistance.h"           // for BodyDistance
#include "vtkHaspInteractionHapticsModule.h" // for export macro

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
VTKHASPINTERACTIONHAPTICS_EXPORT BodyDistance DistanceOfImage(vtkImageData* image, double isovalue,
  const BodyDistanceSettings& settings = {}, const ProgressFunction& progress = {});
VTKHASPINTERACTIONHAPTICS_EXPORT BodyDistance DistanceOfSurface(vtkPolyData* surface,
  const BodyDistanceSettings& settings = {}, const ProgressFunction& progress = {});

} // namespace hasp

#endif
