#include "vtkHaspDistance.h"

#include "vtkHaspVolumeView.h"

#include "vtkCellArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <stdexcept>

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

TriangleMesh TrianglesOf(vtkPolyData* surface)
{
  if (!surface)
    throw std::invalid_argument("surface: there is none");
  const bool triangles =
    surface->GetNumberOfStrips() == 0 && surface->GetPolys()->IsHomogeneous() == 3;
  if (triangles || surface->GetNumberOfCells() == 0)
    return MakeTriangleMesh(surface);
  vtkNew<vtkPolyData> cut;
  cut->SetPoints(surface->GetPoints());
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkGenericCell> cell;
  vtkNew<vtkIdList> corners;
  vtkNew<vtkPoints> places;
  for (vtkIdType id = 0; id < surface->GetNumberOfCells(); ++id)
  {
    surface->GetCell(id, cell);
    if (cell->GetCellDimension() != 2)
      continue;
    cell->Triangulate(0, corners, places);
    for (vtkIdType n = 0; n + 2 < corners->GetNumberOfIds(); n += 3)
      polys->InsertNextCell(3, corners->GetPointer(n));
  }
  cut->SetPolys(polys);
  return MakeTriangleMesh(cut);
}

} // namespace hasp
