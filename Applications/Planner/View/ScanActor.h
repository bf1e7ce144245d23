#pragma once
#include "View/SceneActor.h"

class vtkHaspClusteredCellMapper;
class vtkHaspRayCachingMapper;

namespace hasp
{

/// The isosurface of a scan, for any isovalue; see ScanSurface. Threads: RENDER.
class ScanActor : public SceneActor
{
public:
  ScanActor(SceneView& view, vtkImageData* image);
  ~ScanActor() override;

  vtkImageData* Image() const { return this->Scan; }
  /// `moving`: other values are about to come.
  void SetIsovalue(double value, bool moving);
  bool IsRefining() const;
  void ListResources(ResourceList& list) const override;

protected:
  std::optional<DataHit> First(const glm::dvec3& from, const glm::dvec3& to) const override;
  bool DataBounds(double bounds[6]) const override;

private:
  vtkSmartPointer<vtkImageData> Scan;
  vtkNew<vtkHaspClusteredCellMapper> Cells;
  vtkSmartPointer<vtkHaspRayCachingMapper> Rays; ///< nullptr: at rest
};

} // namespace hasp
