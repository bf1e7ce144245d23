#pragma once
#include "ContourRivals.h"
#include "RivalTransform.h"

namespace hasp
{

/// VTK's own, for `hasp report distance`. What this VTK lacks is absent. RENDER thread.

/// vtkImageEuclideanDistance of the mask, twice: inside and outside.
RivalTransform VtkEuclideanRival();
/// vtkSignedDistance to points with normals of the contour of coverage.
RivalTransform VtkPointsRival();
/// vtkFlyingEdges3D of sampled distances.
PlainContour FlyingEdges();
/// vtkBooleanOperationPolyDataFilter, each tree in a child process with 60 s.
BooleanRival VtkBooleans();

} // namespace hasp
