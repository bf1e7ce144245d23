#include "vtkHaspClusteredCellMapper.h"

#include "Isosurface/ActiveCells.h"
#include "vtkHaspVolumeView.h"

#include "vtkAlgorithm.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkTimeStamp.h"
#include "vtkWeakPointer.h"

#include <chrono>
#include <stdexcept>

vtkAbstractObjectFactoryNewMacro(vtkHaspClusteredCellMapper);

namespace
{
double MillisecondsSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
    .count();
}
}

struct vtkHaspClusteredCellMapper::Internals
{
  hasp::MinMaxBlocks Blocks;
  vtkWeakPointer<vtkImageData> Image; ///< they were made from, and
  vtkMTimeType ImageTime = 0;         ///< when: images that share their samples share MTimes, too
  double BlocksMilliseconds = 0.0;

  hasp::ClusteredCells Cells;
  double CellsIsoValue = 0.0;
  vtkTimeStamp CellsTime;
  double CellsMilliseconds = 0.0;

  /// Neither blocks nor cells are of this image: make the first, forget the second.
  void NewImage(vtkImageData* image)
  {
    const auto start = std::chrono::steady_clock::now();
    this->Cells = {};
    this->Blocks = {};
    this->Image = nullptr;
    this->Blocks = hasp::MinMaxBlocks(hasp::ViewImage(image));
    this->Image = image;
    this->ImageTime = image->GetMTime();
    this->BlocksMilliseconds = MillisecondsSince(start);
  }
};

vtkHaspClusteredCellMapper::vtkHaspClusteredCellMapper() : Internal(new Internals)
{
  this->ScalarVisibility = false; // else VTK maps every voxel to a colour
}

vtkHaspClusteredCellMapper::~vtkHaspClusteredCellMapper() = default;

int vtkHaspClusteredCellMapper::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

void vtkHaspClusteredCellMapper::SetInputData(vtkImageData* image)
{
  this->SetInputDataInternal(0, image);
}

vtkImageData* vtkHaspClusteredCellMapper::GetImage()
{
  if (this->GetNumberOfInputConnections(0) == 0)
    return nullptr;
  return vtkImageData::SafeDownCast(this->GetInputDataObject(0, 0));
}

bool vtkHaspClusteredCellMapper::UpdateCells()
{
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    vtkErrorMacro("No input: give it a vtkImageData.");
    return false;
  }
  this->GetInputAlgorithm()->Update();
  vtkImageData* image = this->GetImage();
  Internals& in = *this->Internal;
  const bool newImage = !image || image != in.Image || image->GetMTime() != in.ImageTime;
  if (!newImage && in.CellsTime.GetMTime() != 0 && in.CellsIsoValue == this->IsoValue)
    return true;
  try
  {
    if (newImage)
      in.NewImage(image);
    const auto start = std::chrono::steady_clock::now();
    in.Cells = hasp::ExtractActiveCells(hasp::ViewImage(image), in.Blocks, this->IsoValue);
    in.CellsIsoValue = this->IsoValue;
    in.CellsTime.Modified();
    in.CellsMilliseconds = MillisecondsSince(start);
    return true;
  }
  catch (const std::exception& e)
  {
    in.Cells = {};
    in.CellsTime = {};
    vtkErrorMacro("Cannot draw the isosurface: " << e.what());
    return false;
  }
}

const hasp::ClusteredCells& vtkHaspClusteredCellMapper::GetCells() const
{
  return this->Internal->Cells;
}

vtkMTimeType vtkHaspClusteredCellMapper::GetCellsTime() const
{
  return this->Internal->CellsTime.GetMTime();
}

bool vtkHaspClusteredCellMapper::GetCellIndex(vtkIdType cellId, int ijk[3]) const
{
  const hasp::ClusteredCells& cells = this->Internal->Cells;
  if (cellId < 0 || static_cast<std::size_t>(cellId) >= cells.Count())
    return false;
  const glm::ivec3 cell = cells.Cell(static_cast<std::size_t>(cellId));
  for (int a = 0; a < 3; ++a)
    ijk[a] = cell[a];
  return true;
}

void vtkHaspClusteredCellMapper::ListResources(hasp::ResourceList& list) const
{
  const Internals& in = *this->Internal;
  list.push_back({ "min-max blocks", in.Blocks.Bytes(), in.BlocksMilliseconds,
    "coarse phase of extraction; kept for the next isovalue" });
  list.push_back({ "active cells, host", in.Cells.Bytes(), in.CellsMilliseconds,
    std::to_string(in.Cells.Count()) + " cells; kept to answer picks" });
}

double* vtkHaspClusteredCellMapper::GetBounds()
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

void vtkHaspClusteredCellMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IsoValue: " << this->IsoValue << "\n";
  os << indent << "Active cells: " << this->Internal->Cells.Count() << "\n";
}
