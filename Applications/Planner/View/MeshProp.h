#pragma once
#include "View/SceneActor.h"

#include <memory>

class vtkPolyData;
class vtkPolyDataMapper;

namespace hasp
{

class TriangleTree;

/// Triangles in the scene. Picks are exact; the tree that they need is made at the first one (100
/// ms for 100,000 triangles). Threads: RENDER.
class MeshProp : public SceneActor
{
public:
  MeshProp(SceneView& view, vtkPolyData* mesh);
  ~MeshProp() override;

  void ListResources(ResourceList& list) const override;

protected:
  std::optional<DataHit> First(const glm::dvec3& from, const glm::dvec3& to) const override;
  bool DataBounds(double bounds[6]) const override;

private:
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkNew<vtkPolyDataMapper> Triangles;
  mutable std::unique_ptr<TriangleTree> Tree;
};

} // namespace hasp
