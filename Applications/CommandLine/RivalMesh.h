#pragma once
#include "CellScene.h"

#include <cstddef>

class vtkFlyingEdges3D;
class vtkPolyData;

namespace hasp
{

/// The mesh that clustered cells are compared with: vtkFlyingEdges3D with normals, on as many
/// threads as the kernels use. RENDER thread.
class RivalMesh
{
public:
  explicit RivalMesh(const CellScene& scene);
  ~RivalMesh();

  /// Extracts anew, whether anything changed or not.
  void Extract(double isovalue);
  vtkPolyData* Mesh() const;
  /// With version, threads and settings.
  std::string Name() const;

  std::size_t Points() const;
  std::size_t Triangles() const;
  /// 3x16-bit positions and octahedral normals, 8 bytes a point; 32-bit indices, 12 a triangle.
  std::size_t CompactBytes() const { return 8 * this->Points() + 12 * this->Triangles(); }
  /// Float positions and normals, 32-bit indices.
  std::size_t PlainBytes() const { return 24 * this->Points() + 12 * this->Triangles(); }
  /// As VTK holds it: float positions and normals, 64-bit indices and offsets.
  std::size_t VtkBytes() const;
  /// How far the triangles' centres lie from the trilinear surface, voxels (of the smallest
  /// spacing) RMS; to first order, |value - isovalue| / |gradient|.
  double ErrorRms() const;

private:
  const CellScene& Scene;
  std::string Threads;
  vtkSmartPointer<vtkFlyingEdges3D> Contour;
};

} // namespace hasp
