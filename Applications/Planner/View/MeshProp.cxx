#include "View/MeshProp.h"

#include "Evaluation/TriangleTree.h"
#include "vtkHaspVolumeView.h"

#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

namespace hasp
{
namespace
{
constexpr std::size_t TreeBytesOfTriangle = 120;
constexpr std::size_t Kibi = 1024; ///< what VTK counts in
}

MeshProp::MeshProp(SceneView& view, vtkPolyData* mesh) : SceneActor(view), Mesh(mesh)
{
  this->Triangles->SetInputData(mesh);
  this->Triangles->ScalarVisibilityOff();
  this->SetMapper(this->Triangles);
}

MeshProp::~MeshProp() = default;

std::optional<SceneActor::DataHit> MeshProp::First(
  const glm::dvec3& from, const glm::dvec3& to) const
{
  if (!this->Tree)
    this->Tree = std::make_unique<TriangleTree>(TrianglesOf(this->Mesh));
  const auto hit = this->Tree->First(from, to - from, 0.0, 1.0);
  if (!hit)
    return std::nullopt;
  return DataHit{ hit->t, hit->normal };
}

bool MeshProp::DataBounds(double bounds[6]) const
{
  if (this->Mesh->GetNumberOfPoints() == 0)
    return false;
  this->Mesh->GetBounds(bounds);
  return true;
}

void MeshProp::ListResources(ResourceList& list) const
{
  list.push_back({ "mesh", this->Mesh->GetActualMemorySize() * Kibi, 0.0,
    std::to_string(this->Mesh->GetNumberOfPolys()) + " triangles" });
  list.push_back({ "tree of picks",
    this->Tree ? TreeBytesOfTriangle * std::size_t(this->Mesh->GetNumberOfPolys()) : 0, 0.0,
    this->Tree ? "something was picked" : "no pick was asked for" });
}

} // namespace hasp
