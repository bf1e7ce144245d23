#include "vtkHaspRayCachingMapper.h"

#include "FailedUpdate.h"
#include "Isosurface/RayCaster.h"
#include "MappedVolume.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspPickedCell.h"
#include "vtkHaspVolumeView.h"

#include "vtkAlgorithm.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <stdexcept>

vtkAbstractObjectFactoryNewMacro(vtkHaspRayCachingMapper);

vtkHaspRayCachingMapper::vtkHaspRayCachingMapper()
  : Renderer(vtkHaspClusteredCellMapper::Automatic),
    Volume(new MappedVolume),
    Failed(new FailedUpdate)
{
  this->ScalarVisibility = false; // else VTK maps every voxel to a colour
}

vtkHaspRayCachingMapper::~vtkHaspRayCachingMapper() = default;

int vtkHaspRayCachingMapper::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

void vtkHaspRayCachingMapper::SetInputData(vtkImageData* image)
{
  this->SetInputDataInternal(0, image);
}

vtkImageData* vtkHaspRayCachingMapper::GetImage()
{
  if (this->GetNumberOfInputConnections(0) == 0)
    return nullptr;
  return vtkImageData::SafeDownCast(this->GetInputDataObject(0, 0));
}

void vtkHaspRayCachingMapper::SetRenderer(int renderer)
{
  renderer = std::clamp<int>(
    renderer, vtkHaspClusteredCellMapper::Automatic, vtkHaspClusteredCellMapper::Trace);
  if (this->Renderer == renderer)
    return;
  this->Renderer = renderer;
  this->Modified();
}

void vtkHaspRayCachingMapper::SetIsoValue(double value)
{
  if (this->IsoValueIsSet && this->IsoValue == value)
    return;
  this->IsoValueIsSet = true;
  this->IsoValue = value;
  this->Modified();
}

bool vtkHaspRayCachingMapper::UpdateVolume()
{
  if (this->GetNumberOfInputConnections(0) > 0)
    this->GetInputAlgorithm()->Update();
  vtkImageData* image = this->GetImage();
  if (this->Failed->Repeats(this, image))
    return false;
  try
  {
    if (!image)
      throw std::invalid_argument("no input: give it a vtkImageData");
    if (this->Volume->Update(image))
    {
      ++this->VolumeTime;
      if (!this->IsoValueIsSet)
        this->IsoValue = this->Volume->MiddleOfRange();
    }
    return true;
  }
  catch (const std::exception& e)
  {
    this->Volume->Forget();
    ++this->VolumeTime;
    this->Failed->Remember();
    vtkErrorMacro("Cannot draw the isosurface: " << e.what());
    return false;
  }
}

void vtkHaspRayCachingMapper::MarkModified(const int extent[6])
{
  if (this->Volume->Mark(this->GetImage(), extent))
    this->Modified();
}

void vtkHaspRayCachingMapper::SetAmbientOcclusionDistance(double mm)
{
  if (!(mm > 0.0))
    vtkErrorMacro("A distance of ambient occlusion of " << mm << " mm; it must be above 0.");
  else if (this->AmbientOcclusionDistance != mm)
  {
    this->AmbientOcclusionDistance = mm;
    this->Modified();
  }
}

bool vtkHaspRayCachingMapper::PickFirstCell(
  const double from[3], const double to[3], vtkHaspPickedCell* result)
{
  if (!this->UpdateVolume())
    return false;
  vtkImageData* image = this->GetImage();
  MappedVolume& volume = *this->Volume;
  const hasp::AnyGridView grid = hasp::ViewImage(image);
  if (volume.Changed()) // the next frame still has to hear of it
    volume.Blocks.Update(grid, volume.ChangedLow(), volume.ChangedHigh());
  const hasp::RayCaster caster(grid, volume.Blocks, this->IsoValue);
  const glm::dvec3 origin = glm::make_vec3(from);
  const auto hit = caster.Cast(origin, glm::make_vec3(to) - origin, 0.0, 1.0);
  if (!hit || !result)
    return hit.has_value();
  const glm::dvec3 inCell =
    hasp::GeometryOf(grid).WorldToIndex(hit->position) - glm::dvec3(hit->cell);
  const glm::dvec3 normal = -glm::normalize(hit->gradient);
  for (int a = 0; a < 3; ++a)
  {
    result->IJK[a] = hit->cell[a];
    result->PCoords[a] = std::clamp(inCell[a], 0.0, 1.0);
    result->Position[a] = hit->position[a];
    result->Normal[a] = normal[a];
  }
  const glm::ivec3 cells = hasp::GeometryOf(grid).dims - 1;
  result->CellId = (vtkIdType{ hit->cell.z } * cells.y + hit->cell.y) * cells.x + hit->cell.x;
  result->T = hit->t;
  result->Value = this->IsoValue;
  result->Label = 0;
  result->Modified();
  return true;
}

void vtkHaspRayCachingMapper::ListResources(hasp::ResourceList& list) const
{
  list.push_back({ "min-max blocks", this->Volume->Blocks.Bytes(), this->Volume->BlocksMilliseconds,
    "rays skip blocks without surface" });
}

double* vtkHaspRayCachingMapper::GetBounds()
{
  vtkMath::UninitializeBounds(this->Bounds);
  if (this->GetNumberOfInputConnections(0) > 0)
  {
    this->GetInputAlgorithm()->Update();
    if (vtkImageData* image = this->GetImage())
      image->GetBounds(this->Bounds);
  }
  return this->Bounds;
}

void vtkHaspRayCachingMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IsoValue: " << this->IsoValue
     << (this->IsoValueIsSet ? "\n" : " (middle of the range)\n");
  os << indent << "Mode: " << this->Mode << " (" << this->GetModeChoice() << ")\n";
  os << indent << "Renderer: " << this->Renderer << "\n";
  os << indent << "StepSize: " << this->StepSize << "\n";
  os << indent << "RaysPerTile: " << this->RaysPerTile << "\n";
  os << indent << "FrameBudget: " << this->FrameBudget << "\n";
  os << indent << "Prediction: " << this->Prediction << "\n";
  os << indent << "AmbientOcclusion: " << this->AmbientOcclusion << "\n";
  os << indent << "AmbientOcclusionDistance: " << this->AmbientOcclusionDistance << "\n";
  os << indent << "Shadows: " << this->Shadows << "\n";
}
