#include "vtkHaspClusteredCellMapper.h"

#include "Isosurface/ActiveCells.h"
#include "vtkHaspClusteredCells.h"
#include "vtkHaspVolumeView.h"

#include "vtkAlgorithm.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkTimeStamp.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <chrono>
#include <limits>
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

  /// Samples changed in place since the last update, if low <= high.
  glm::ivec3 ChangedLow{ std::numeric_limits<int>::max() };
  glm::ivec3 ChangedHigh{ std::numeric_limits<int>::min() };

  hasp::ClusteredCells Cells; ///< of the image
  std::shared_ptr<const hasp::ClusteredCells>
    Finished; ///< drawn in their place where the input is cells
  double CellsIsoValue = 0.0;
  int CellsPrecision = 0;
  vtkTimeStamp CellsTime;
  double CellsMilliseconds = 0.0;

  bool Changed() const { return this->ChangedLow.x <= this->ChangedHigh.x; }
  void ForgetChanges()
  {
    this->ChangedLow = glm::ivec3(std::numeric_limits<int>::max());
    this->ChangedHigh = glm::ivec3(std::numeric_limits<int>::min());
  }

  /// Cells that somebody else made are drawn as they are, and nothing else is kept.
  void Keep(std::shared_ptr<const hasp::ClusteredCells> cells)
  {
    if (cells == this->Finished)
      return;
    this->Cells = {};
    this->Blocks = {};
    this->ForgetChanges();
    this->Image = nullptr;
    this->Finished = std::move(cells);
    this->CellsTime.Modified();
    this->BlocksMilliseconds = this->CellsMilliseconds = 0.0;
  }

  /// Neither blocks nor cells are of this image: make the first, forget the second.
  void NewImage(vtkImageData* image)
  {
    const auto start = std::chrono::steady_clock::now();
    this->Cells = {};
    this->Blocks = {};
    this->ForgetChanges();
    this->Image = nullptr;
    this->Finished = nullptr;
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
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkHaspClusteredCells");
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
    vtkErrorMacro("No input: give it a vtkImageData or a vtkHaspClusteredCells.");
    return false;
  }
  this->GetInputAlgorithm()->Update();
  vtkImageData* image = this->GetImage();
  Internals& in = *this->Internal;
  if (auto* cells = vtkHaspClusteredCells::SafeDownCast(this->GetInputDataObject(0, 0)))
  {
    in.Keep(cells->GetCells());
    return true;
  }
  const bool newImage = !image || image != in.Image || image->GetMTime() != in.ImageTime;
  const bool sameSurface = in.CellsTime.GetMTime() != 0 && in.CellsIsoValue == this->IsoValue &&
                           in.CellsPrecision == this->Precision;
  if (!newImage && sameSurface && !in.Changed())
    return true;
  try
  {
    if (newImage)
      in.NewImage(image);
    const auto start = std::chrono::steady_clock::now();
    const hasp::AnyGridView grid = hasp::ViewImage(image);
    if (in.Changed() && sameSurface)
      UpdateActiveCells(in.Cells, grid, in.Blocks, in.ChangedLow, in.ChangedHigh);
    else
    {
      in.Blocks.Update(grid, in.ChangedLow, in.ChangedHigh);
      in.Cells = ExtractActiveCells(grid, in.Blocks, this->IsoValue,
        this->Precision == Compact ? hasp::CellPrecision::Compact : hasp::CellPrecision::Exact);
    }
    in.ForgetChanges();
    in.CellsIsoValue = this->IsoValue;
    in.CellsPrecision = this->Precision;
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

void vtkHaspClusteredCellMapper::SetRenderer(int renderer)
{
  renderer = std::clamp<int>(renderer, Automatic, Trace);
  if (this->Renderer == renderer)
    return;
  this->Renderer = renderer;
  this->Modified();
}

std::string vtkHaspClusteredCellMapper::GetRendererChoice() const
{
  return "nothing drawn";
}

void vtkHaspClusteredCellMapper::MarkModified(const int extent[6])
{
  Internals& in = *this->Internal;
  vtkImageData* image = this->GetImage();
  if (!image || image != in.Image)
    return; // nothing is kept of it that could be stale
  const int* whole = image->GetExtent();
  for (int a = 0; a < 3; ++a)
  {
    in.ChangedLow[a] = std::min(in.ChangedLow[a], extent[2 * a] - whole[2 * a]);
    in.ChangedHigh[a] = std::max(in.ChangedHigh[a], extent[2 * a + 1] - whole[2 * a]);
  }
  in.ImageTime = image->GetMTime();
  this->Modified();
}

const hasp::ClusteredCells& vtkHaspClusteredCellMapper::GetCells() const
{
  const Internals& in = *this->Internal;
  return in.Finished ? *in.Finished : in.Cells;
}

vtkMTimeType vtkHaspClusteredCellMapper::GetCellsTime() const
{
  return this->Internal->CellsTime.GetMTime();
}

bool vtkHaspClusteredCellMapper::GetCellIndex(vtkIdType cellId, int ijk[3]) const
{
  const hasp::ClusteredCells& cells = this->GetCells();
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
  list.push_back({ "active cells, host", this->GetCells().Bytes(), in.CellsMilliseconds,
    std::to_string(this->GetCells().Count()) + " cells; kept to answer picks" });
}

double* vtkHaspClusteredCellMapper::GetBounds()
{
  vtkMath::UninitializeBounds(this->Bounds);
  if (this->GetNumberOfInputConnections(0) > 0)
  {
    this->GetInputAlgorithm()->Update();
    if (vtkImageData* image = this->GetImage())
      image->GetBounds(this->Bounds);
    else if (auto* cells = vtkHaspClusteredCells::SafeDownCast(this->GetInputDataObject(0, 0)))
      cells->GetBounds(this->Bounds);
  }
  return this->Bounds;
}

void vtkHaspClusteredCellMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IsoValue: " << this->IsoValue << "\n";
  os << indent << "Renderer: " << this->Renderer << " (" << this->GetRendererChoice() << ")\n";
  os << indent << "Precision: " << this->Precision << "\n";
  os << indent << "OcclusionCulling: " << this->OcclusionCulling << "\n";
  os << indent << "Active cells: " << this->GetCells().Count() << "\n";
}
