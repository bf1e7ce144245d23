#pragma once
#include "vtkSmartPointer.h"

class vtkImageData;
class vtkVolume;

namespace hasp
{

/// The isosurface as VTK itself draws it from a volume: vtkOpenGLGPUVolumeRayCastMapper in
/// isosurface blend mode, white, shaded, a sample each `stepVoxels` of the smallest spacing. The
/// isovalue is the first of the property's isosurface values. VTK writes no depth for it and passes
/// by the mapper's errors below that step. RENDER thread.
vtkSmartPointer<vtkVolume> MakeVolumeIsosurface(
  vtkImageData* image, double isovalue, double stepVoxels);

} // namespace hasp
