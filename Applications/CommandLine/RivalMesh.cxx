#include "RivalMesh.h"

#include "Grid/ParallelFor.h"
#include "Grid/Trilinear.h"
#include "VtkThreads.h"
#include "vtkHaspVolumeView.h"

#include "vtkCellArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkVersionMacros.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{

RivalMesh::RivalMesh(const CellScene& scene)
  : Scene(scene),
    Threads(UseVtkThreads(ParallelThreads())),
    Contour(vtkSmartPointer<vtkFlyingEdges3D>::New())
{
  this->Contour->SetInputData(scene.image);
  this->Contour->ComputeNormalsOn();
  this->Contour->ComputeScalarsOff();
}

RivalMesh::~RivalMesh() = default;

void RivalMesh::Extract(double isovalue)
{
  this->Contour->SetValue(0, isovalue);
  this->Contour->Modified();
  this->Contour->Update();
}

vtkPolyData* RivalMesh::Mesh() const
{
  return this->Contour->GetOutput();
}

std::string RivalMesh::Name() const
{
  return "VTK " VTK_VERSION " vtkFlyingEdges3D with normals, " + this->Threads;
}

std::size_t RivalMesh::Points() const
{
  return this->Mesh()->GetNumberOfPoints();
}

std::size_t RivalMesh::Triangles() const
{
  return this->Mesh()->GetNumberOfPolys();
}

std::size_t RivalMesh::VtkBytes() const
{
  return std::size_t(1024) * this->Mesh()->GetActualMemorySize();
}

double RivalMesh::ErrorRms() const
{
  const AnyGridView grid = ViewImage(this->Scene.image);
  const GridGeometry& g = GeometryOf(grid);
  double squares = 0.0;
  std::size_t count = 0;
  vtkPolyData* mesh = this->Mesh();
  vtkCellArray* triangles = mesh->GetPolys();
  for (vtkIdType n = 0; n < triangles->GetNumberOfCells(); ++n)
  {
    vtkIdType size;
    const vtkIdType* points;
    triangles->GetCellAtId(n, size, points);
    glm::dvec3 center(0.0);
    for (vtkIdType p = 0; p < 3; ++p)
    {
      const double* x = mesh->GetPoint(points[p]);
      center += glm::dvec3(x[0], x[1], x[2]) / 3.0;
    }
    const auto at = LocateCell(g, g.WorldToIndex(center));
    if (!at)
      continue; // on the border, rounded out of it
    const auto corners =
      std::visit([&](const auto& view) { return CellCorners(view, at->cell); }, grid);
    const double steepness = glm::length(g.GradientToWorld(TrilinearGradient(corners, at->local)));
    if (!(steepness > 0.0))
      continue;
    const double mm = (TrilinearValue(corners, at->local) - this->Scene.isovalue) / steepness;
    squares += mm * mm;
    ++count;
  }
  const double voxel = std::min({ g.spacing.x, g.spacing.y, g.spacing.z });
  return count > 0 ? std::sqrt(squares / double(count)) / voxel : 0.0;
}

} // namespace hasp
