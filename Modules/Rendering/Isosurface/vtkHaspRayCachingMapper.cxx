#include "vtkHaspRayCachingMapper.h"

#include "FailedUpdate.h"
#include "MappedVolume.h"

#include "vtkAlgorithm.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <stdexcept>

vtkAbstractObjectFactoryNewMacro(vtkHaspRayCachingMapper);

vtkHaspRayCachingMapper::vtkHaspRayCachingMapper()
  : Volume(new MappedVolume),
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
  os << indent << "StepSize: " << this->StepSize << "\n";
  os << indent << "RaysPerTile: " << this->RaysPerTile << "\n";
  os << indent << "FrameBudget: " << this->FrameBudget << "\n";
  os << indent << "Prediction: " << this->Prediction << "\n";
}
