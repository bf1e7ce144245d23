#include "Surfaces/TrianglePolyData.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"

#include <algorithm>
#include <cstring>

namespace hasp
{
namespace
{

bool FitFloat32(std::span<const glm::dvec3> points)
{
  return std::all_of(points.begin(), points.end(),
    [](const glm::dvec3& p) { return glm::dvec3(glm::vec3(p)) == p; });
}

} // namespace

vtkSmartPointer<vtkPolyData> TrianglePolyData(
  std::span<const glm::dvec3> points, std::span<const glm::uvec3> triangles)
{
  vtkNew<vtkPoints> places;
  const bool narrow = FitFloat32(points);
  places->SetDataType(narrow ? VTK_FLOAT : VTK_DOUBLE);
  places->SetNumberOfPoints(static_cast<vtkIdType>(points.size()));
  if (narrow)
    std::transform(points.begin(), points.end(), static_cast<glm::vec3*>(places->GetVoidPointer(0)),
      [](const glm::dvec3& p) { return glm::vec3(p); });
  else
    std::memcpy(places->GetVoidPointer(0), points.data(), points.size_bytes());
  vtkNew<vtkTypeInt32Array> offsets, corners;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(triangles.size() + 1));
  for (std::size_t n = 0; n <= triangles.size(); ++n)
    offsets->SetValue(static_cast<vtkIdType>(n), static_cast<int>(3 * n));
  corners->SetNumberOfValues(static_cast<vtkIdType>(3 * triangles.size()));
  std::memcpy(corners->GetVoidPointer(0), triangles.data(), triangles.size_bytes());
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, corners);
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(places);
  surface->SetPolys(cells);
  return surface;
}

std::string CoordinateType(vtkPolyData* surface)
{
  return surface->GetPoints()->GetDataType() == VTK_FLOAT ? "float32" : "float64";
}

} // namespace hasp
