#pragma once
#include "View/SceneActor.h"

class vtkHaspClusteredCellMapper;

namespace hasp
{

struct ClusteredCells;

/// The box around active cells, in the cells' world, mm, each axis low, high; false if there are
/// none. Exact along the grid's axes. O(clusters).
bool BoundsOfCells(const ClusteredCells& cells, double bounds[6]);

/// An isosurface of an image by its active cells: exact, and what haptics takes as a body.
/// Threads: RENDER. Cells are extracted at the first frame or question.
class CellProp : public SceneActor
{
public:
  CellProp(SceneView& view, vtkImageData* image, double isovalue);

  vtkHaspClusteredCellMapper* Mapper() const;
  vtkImageData* Image() const;
  void ListResources(ResourceList& list) const override;

protected:
  std::optional<DataHit> First(const glm::dvec3& from, const glm::dvec3& to) const override;
  bool DataBounds(double bounds[6]) const override;

private:
  vtkSmartPointer<vtkHaspClusteredCellMapper> Cells;
};

} // namespace hasp
