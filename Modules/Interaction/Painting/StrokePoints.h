#ifndef StrokePoints_h
#define StrokePoints_h

#include "Planning/SegmentationRecipe.h"

#include "vtkHaspInteractionPaintingModule.h" // for export macro
#include "vtkSmartPointer.h"                  // for return values

#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

class vtkPolyData;

namespace hasp
{

/// The line of a stroke from its point `first` on, no two neighbours farther apart than stepMm (>
/// 0): its own points, and what it takes between them. A stroke without points has none. Any
/// thread.
VTKHASPINTERACTIONPAINTING_EXPORT std::vector<glm::dvec3> PointsAlong(
  const BrushStroke& stroke, double stepMm, std::size_t first = 0);

/// Strokes for pipelines of one's own (tubes, files): a poly-line each, a vertex where a stroke is
/// a single point, in world mm and double precision; cell arrays "Label" (unsigned short) and
/// "RadiusMm" (double). Strokes without points are left out. Any thread.
VTKHASPINTERACTIONPAINTING_EXPORT vtkSmartPointer<vtkPolyData> StrokePolyData(
  const std::vector<BrushStroke>& strokes);

} // namespace hasp

#endif
