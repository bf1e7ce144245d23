#include "vtkHaspDistance.h"

#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"

namespace hasp
{

BodyDistance DistanceOfImage(vtkImageData* image, double isovalue,
  const BodyDistanceSettings& settings, const ProgressFunction& progress)
{
  return DistanceOfVolume(ViewImage(image), isovalue, settings, progress);
}

BodyDistance DistanceOfSurface(
  vtkPolyData* surface, const BodyDistanceSettings& settings, const ProgressFunction& progress)
{
  return DistanceOfMesh(TrianglesOf(surface), settings, progress);
}

} // namespace hasp
