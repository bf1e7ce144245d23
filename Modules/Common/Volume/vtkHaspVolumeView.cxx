#include "vtkHaspVolumeView.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{

GridGeometry ImageGeometry(vtkImageData* image)
{
  if (!image)
    throw std::invalid_argument("image: there is none");
  GridGeometry geometry;
  image->GetDimensions(&geometry.dims.x);
  image->GetSpacing(&geometry.spacing.x);
  const vtkMatrix3x3* direction = image->GetDirectionMatrix();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      geometry.direction[column][row] = direction->GetElement(row, column);
  int extent[6];
  image->GetExtent(extent);
  geometry.origin = { 0, 0, 0 };
  image->GetOrigin(&geometry.origin.x);
  geometry.origin = geometry.IndexToWorld({ extent[0], extent[2], extent[4] });
  geometry.Validate();
  return geometry;
}

AnyGridView ViewImage(vtkImageData* image)
{
  if (!image)
    throw std::invalid_argument("image: there is none");
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars)
    throw std::invalid_argument("image: no active point scalars");
  return ViewPointArray(image, scalars);
}

AnyGridView ViewPointArray(vtkImageData* image, vtkDataArray* scalars)
{
  const GridGeometry geometry = ImageGeometry(image);
  if (scalars->GetNumberOfComponents() != 1)
    throw std::invalid_argument("image: scalars have " +
                                std::to_string(scalars->GetNumberOfComponents()) +
                                " components, must have 1");
  if (static_cast<std::size_t>(scalars->GetNumberOfTuples()) != geometry.Size())
    throw std::invalid_argument("image: " + std::to_string(scalars->GetNumberOfTuples()) +
                                " scalars for " + std::to_string(geometry.Size()) +
                                " points, must be the same");
  void* data = scalars->GetVoidPointer(0);
  switch (scalars->GetDataType())
  {
    case VTK_SHORT:
      return GridView<const std::int16_t>{ static_cast<std::int16_t*>(data), geometry };
    case VTK_UNSIGNED_SHORT:
      return GridView<const std::uint16_t>{ static_cast<std::uint16_t*>(data), geometry };
    case VTK_UNSIGNED_CHAR:
      return GridView<const std::uint8_t>{ static_cast<std::uint8_t*>(data), geometry };
    case VTK_FLOAT:
      return GridView<const float>{ static_cast<float*>(data), geometry };
    default:
      throw std::invalid_argument(
        std::string("image: scalars are ") + scalars->GetDataTypeAsString() +
        "; short, unsigned short, unsigned char and float are read (cast with vtkImageCast)");
  }
}

namespace
{
template <typename T>
constexpr int VTKType();
template <>
constexpr int VTKType<std::int16_t>()
{
  return VTK_SHORT;
}
template <>
constexpr int VTKType<std::uint16_t>()
{
  return VTK_UNSIGNED_SHORT;
}
template <>
constexpr int VTKType<std::uint8_t>()
{
  return VTK_UNSIGNED_CHAR;
}
template <>
constexpr int VTKType<float>()
{
  return VTK_FLOAT;
}
}

template <typename T>
vtkSmartPointer<vtkImageData> MakeImage(const GridGeometry& geometry, const std::vector<T>& samples)
{
  geometry.Validate();
  if (samples.size() != geometry.Size())
    throw std::invalid_argument("MakeImage: " + std::to_string(samples.size()) + " samples for " +
                                std::to_string(geometry.Size()) + " grid points");
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(&geometry.dims.x);
  image->SetOrigin(geometry.origin.x, geometry.origin.y, geometry.origin.z);
  image->SetSpacing(geometry.spacing.x, geometry.spacing.y, geometry.spacing.z);
  const glm::dmat3 d = geometry.direction; // column-major
  image->SetDirectionMatrix(
    d[0][0], d[1][0], d[2][0], d[0][1], d[1][1], d[2][1], d[0][2], d[1][2], d[2][2]);
  image->AllocateScalars(VTKType<T>(), 1);
  std::memcpy(image->GetScalarPointer(), samples.data(), samples.size() * sizeof(T));
  return image;
}

template VTKHASPCOMMONVOLUME_EXPORT vtkSmartPointer<vtkImageData> MakeImage(
  const GridGeometry&, const std::vector<std::int16_t>&);
template VTKHASPCOMMONVOLUME_EXPORT vtkSmartPointer<vtkImageData> MakeImage(
  const GridGeometry&, const std::vector<std::uint16_t>&);
template VTKHASPCOMMONVOLUME_EXPORT vtkSmartPointer<vtkImageData> MakeImage(
  const GridGeometry&, const std::vector<std::uint8_t>&);
template VTKHASPCOMMONVOLUME_EXPORT vtkSmartPointer<vtkImageData> MakeImage(
  const GridGeometry&, const std::vector<float>&);

vtkSmartPointer<vtkPolyData> MakePolyData(const TriangleMesh& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.points.size()));
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
    points->SetPoint(static_cast<vtkIdType>(p), &mesh.points[p].x);
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(static_cast<vtkIdType>(mesh.triangles.size()),
    static_cast<vtkIdType>(3 * mesh.triangles.size()));
  for (const glm::uvec3& t : mesh.triangles)
  {
    const vtkIdType corners[3] = { t.x, t.y, t.z };
    triangles->InsertNextCell(3, corners);
  }
  auto polyData = vtkSmartPointer<vtkPolyData>::New();
  polyData->SetPoints(points);
  polyData->SetPolys(triangles);
  return polyData;
}

TriangleMesh MakeTriangleMesh(vtkPolyData* polyData)
{
  if (!polyData)
    throw std::invalid_argument("polydata: there is none");
  if (polyData->GetNumberOfStrips() > 0)
    throw std::invalid_argument("polydata: " + std::to_string(polyData->GetNumberOfStrips()) +
                                " triangle strips; run vtkTriangleFilter first");
  constexpr vtkIdType most = std::numeric_limits<std::uint32_t>::max();
  if (polyData->GetNumberOfPoints() > most)
    throw std::invalid_argument("polydata: " + std::to_string(polyData->GetNumberOfPoints()) +
                                " points, at most " + std::to_string(most) + " can be read");
  TriangleMesh mesh;
  mesh.points.resize(polyData->GetNumberOfPoints());
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
    polyData->GetPoint(static_cast<vtkIdType>(p), &mesh.points[p].x);
  mesh.triangles.reserve(polyData->GetNumberOfPolys());
  auto cell = vtk::TakeSmartPointer(polyData->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType count;
    const vtkIdType* corners;
    cell->GetCurrentCell(count, corners);
    if (count != 3)
      throw std::invalid_argument("polydata: polygon " + std::to_string(cell->GetCurrentCellId()) +
                                  " has " + std::to_string(count) +
                                  " corners; run vtkTriangleFilter first");
    mesh.triangles.emplace_back(corners[0], corners[1], corners[2]);
  }
  return mesh;
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
