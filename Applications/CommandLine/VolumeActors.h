#pragma once
#include "SurfaceActors.h"

/// VTK's own volume mappers as SurfaceActors. Each holds the samples once more on the GPU, and
/// lists them as "volume, GPU". RENDER thread.
namespace hasp
{

/// The isosurface, a sample each half voxel.
SurfaceActor MakeVolumeActor(vtkImageData* image, double isoValue);

/// The brightest value along each line of sight. It has no surface: no pick, no isovalue.
SurfaceActor MakeBrightestActor(vtkImageData* image, const SurfaceDrawing& drawing);

/// Translucent skin and bone; bone begins at the isovalue, and is what a pick meets.
SurfaceActor MakeTranslucentActor(
  vtkImageData* image, double isoValue, const SurfaceDrawing& drawing);

} // namespace hasp
