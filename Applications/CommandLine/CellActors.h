#pragma once
#include "SurfaceActors.h"

class vtkDataObject;

/// The mappers of Hasp as SurfaceActors; of builds that have them. RENDER thread.
namespace hasp
{

/// Active cells. `input` is an image, or cells, whose isovalue is their own. Throws Failure.
SurfaceActor MakeCellActor(vtkDataObject* input, double isoValue, const SurfaceDrawing& drawing);

/// What rays find, frame by frame. Nothing is extracted before the first frame. An interactive one
/// may draw all active cells where that is cheaper, and does where light is asked for.
SurfaceActor MakeCachingActor(vtkImageData* image, double isoValue, const SurfaceDrawing& drawing);

/// A ray a pixel on the GPU, past what has no surface.
SurfaceActor MakeRaycastActor(vtkImageData* image, double isoValue);

/// Where a line first meets the isosurface of that value, whatever draws it. Costs nothing before
/// it is called.
std::function<std::optional<WorldPoint>(
  double isoValue, const WorldPoint& from, const WorldPoint& to)>
IsosurfaceRays(vtkImageData* image);

/// The box around all active cells of that isovalue, none if there are none. Extracts them: some
/// 0.1 s for a CT on many cores, memory as mapper cells.
std::optional<WorldBounds> IsosurfaceBounds(vtkImageData* image, double isoValue);

} // namespace hasp
