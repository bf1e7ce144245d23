#include "View/ScanActor.h"

#include "View/CellProp.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspPickedCell.h"
#include "vtkHaspRayCachingMapper.h"

#include "vtkImageData.h"

namespace hasp
{
namespace
{
constexpr double FrameBudgetMs = 50.0;
}

ScanActor::ScanActor(SceneView& view, vtkImageData* image) : SceneActor(view), Scan(image)
{
  this->Cells->SetInputData(image);
  this->Cells->ScalarVisibilityOff();
}

ScanActor::~ScanActor() = default;

void ScanActor::SetIsovalue(double value, bool moving)
{
  if (!moving)
  {
    this->Cells->SetIsoValue(value);
    this->SetMapper(this->Cells);
    this->Rays = nullptr;
    return;
  }
  if (!this->Rays)
  {
    this->Rays = vtkSmartPointer<vtkHaspRayCachingMapper>::New();
    this->Rays->SetInputData(this->Scan);
    this->Rays->SetFrameBudget(FrameBudgetMs);
  }
  this->Rays->SetIsoValue(value);
  this->SetMapper(this->Rays);
}

bool ScanActor::IsRefining() const
{
  return this->Rays && this->IsVisible() && this->Rays->IsRefining();
}

std::optional<SceneActor::DataHit> ScanActor::First(
  const glm::dvec3& from, const glm::dvec3& to) const
{
  vtkNew<vtkHaspPickedCell> picked;
  const bool hit =
    this->Rays ? this->Rays->PickFirstCell(&from.x, &to.x, picked)
               : this->Cells->UpdateCells() && this->Cells->PickFirstCell(&from.x, &to.x, picked);
  if (!hit)
    return std::nullopt;
  const double* normal = picked->GetNormal();
  return DataHit{ picked->GetT(), { normal[0], normal[1], normal[2] } };
}

/// While the isovalue moves, the whole scan: its cells are not known.
bool ScanActor::DataBounds(double bounds[6]) const
{
  if (!this->Rays)
    return this->Cells->UpdateCells() && BoundsOfCells(this->Cells->GetCells(), bounds);
  this->Scan->GetBounds(bounds);
  return true;
}

void ScanActor::ListResources(ResourceList& list) const
{
  this->Cells->ListResources(list);
  if (this->Rays)
    this->Rays->ListResources(list);
  else
    list.push_back({ "ray cache", 0, 0.0, "the isovalue rests" });
}

} // namespace hasp
