#include "LitMeshes.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace
{

/// Triangles of points of the input, and the input's cell of each.
struct Triangles
{
  std::vector<glm::uvec3> corners;
  std::vector<vtkIdType> cells;

  void Add(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType cell)
  {
    this->corners.emplace_back(a, b, c);
    this->cells.push_back(cell);
  }
};

Triangles TrianglesOf(vtkPolyData* data)
{
  Triangles triangles;
  vtkIdType cell = data->GetNumberOfVerts() + data->GetNumberOfLines();
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  const auto each = [&](vtkCellArray* cells, const auto& add)
  {
    const auto next = vtk::TakeSmartPointer(cells->NewIterator());
    for (next->GoToFirstCell(); !next->IsDoneWithTraversal(); next->GoToNextCell(), ++cell)
    {
      next->GetCurrentCell(count, points);
      add();
    }
  };
  each(data->GetPolys(),
    [&]
    {
      for (vtkIdType n = 2; n < count; ++n)
        triangles.Add(points[0], points[n - 1], points[n], cell);
    });
  each(data->GetStrips(),
    [&]
    {
      for (vtkIdType n = 2; n < count; ++n)
        triangles.Add(points[n - 2 + n % 2], points[n - 1 - n % 2], points[n], cell);
    });
  return triangles;
}

glm::vec3 ColorOf(const vtkUnsignedCharArray* colors, vtkIdType n, bool linear)
{
  glm::vec3 color;
  for (int c = 0; c < 3; ++c)
  {
    const double v = const_cast<vtkUnsignedCharArray*>(colors)->GetTypedComponent(n, c) / 255.0;
    color[c] = linear ? LinearOf(v) : static_cast<float>(v);
  }
  return color;
}

bool Finite(const glm::dvec3& p)
{
  return std::isfinite(p.x + p.y + p.z);
}

} // namespace

float LinearOf(double v)
{
  return static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
}

hasp::LitMesh LitMeshOf(vtkPolyDataMapper* mapper, bool smooth, bool linear)
{
  hasp::LitMesh lit;
  vtkPolyData* data = mapper->GetInput();
  if (!data || data->GetNumberOfPoints() == 0)
    return lit;
  const Triangles triangles = TrianglesOf(data);
  vtkDataArray* normals = smooth ? data->GetPointData()->GetNormals() : nullptr;
  int ofCells = 0;
  vtkUnsignedCharArray* colors =
    mapper->GetScalarVisibility() ? mapper->MapScalars(data, 1.0, ofCells) : nullptr;
  if (colors && colors->GetNumberOfTuples() <= 1)
    colors = nullptr; // of the field: one colour, which is the actor's business
  // Where cells have colours each triangle has points of its own.
  const bool own = colors && ofCells != 0;
  const auto add = [&](vtkIdType point, vtkIdType cell)
  {
    double at[3];
    data->GetPoint(point, at);
    lit.mesh.points.emplace_back(at[0], at[1], at[2]);
    if (normals)
    {
      normals->GetTuple(point, at);
      const glm::vec3 normal(at[0], at[1], at[2]);
      lit.normals.push_back(Finite(normal) ? normal : glm::vec3(0.0F));
    }
    if (colors)
      lit.colors.push_back(ColorOf(colors, own ? cell : point, linear));
  };
  if (!own)
    for (vtkIdType n = 0; n < data->GetNumberOfPoints(); ++n)
      add(n, 0);
  for (std::size_t n = 0; n < triangles.corners.size(); ++n)
  {
    glm::uvec3 corners = triangles.corners[n];
    if (own)
    {
      const auto first = static_cast<unsigned>(lit.mesh.points.size());
      for (int c = 0; c < 3; ++c)
        add(corners[c], triangles.cells[n]);
      corners = { first, first + 1, first + 2 };
    }
    const auto& points = lit.mesh.points;
    if (Finite(points[corners.x]) && Finite(points[corners.y]) && Finite(points[corners.z]))
      lit.mesh.triangles.push_back(corners);
  }
  for (glm::dvec3& point : lit.mesh.points)
    if (!Finite(point))
      point = glm::dvec3(0.0); // no triangle has it
  return lit;
}
