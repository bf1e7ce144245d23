#include "vtkHaspClusteredCellFilter.h"

#include "Isosurface/ActiveCells.h"
#include "Isosurface/CellAttributes.h"
#include "vtkHaspClusteredCells.h"
#include "vtkHaspVolumeView.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkHaspClusteredCellFilter);

namespace
{

struct SampleBox
{
  glm::ivec3 low, high;
};

/// What the kept cells and blocks were made of.
struct Origin
{
  vtkWeakPointer<vtkImageData> image;
  vtkMTimeType time = 0;
  std::size_t type = 0;
  hasp::GridGeometry geometry;

  bool SamePlace(vtkImageData* other, const hasp::AnyGridView& grid) const
  {
    const hasp::GridGeometry &g = this->geometry, &h = hasp::GeometryOf(grid);
    return other == this->image && grid.index() == this->type && g.dims == h.dims &&
           g.origin == h.origin && g.spacing == h.spacing && g.direction == h.direction;
  }
};

} // namespace

struct vtkHaspClusteredCellFilter::Internals
{
  Origin from;
  hasp::MinMaxBlocks blocks;
  std::shared_ptr<hasp::ClusteredCells> cells; ///< null, or of `from`
  double isoValue = 0.0;                       ///< and of these
  bool compact = false;
  std::string labelArray;
  std::optional<SampleBox> marked; ///< in the indices of the input's extent

  void Forget()
  {
    this->from = {};
    this->blocks = {};
    this->cells.reset();
  }

  /// Brings blocks and cells up to date. What it leaves after an exception is to be forgotten.
  void Update(vtkImageData* image, double newIsoValue, bool newCompact,
    const std::string& newLabelArray, const hasp::ProgressFunction& progress)
  {
    const hasp::AnyGridView grid = hasp::ViewImage(image);
    const bool known =
      this->from.SamePlace(image, grid) && (this->from.time == image->GetMTime() || this->marked);
    const bool sameSurface =
      this->cells && this->isoValue == newIsoValue && this->compact == newCompact;
    if (!known)
    {
      this->Forget();
      this->blocks = hasp::MinMaxBlocks(grid);
    }
    const bool sameCells = known && sameSurface && !this->marked;
    if (known && this->marked)
      this->Apply(*this->marked, image, grid, sameSurface);
    if (!known || !sameSurface)
    {
      this->cells.reset();
      const auto precision = newCompact ? hasp::CellPrecision::Compact : hasp::CellPrecision::Exact;
      this->cells = std::make_shared<hasp::ClusteredCells>(
        hasp::ExtractActiveCells(grid, this->blocks, newIsoValue, precision, progress));
    }
    if (!sameCells || newLabelArray != this->labelArray)
      this->AddLabels(newLabelArray, image);
    this->from = { image, image->GetMTime(), grid.index(), hasp::GeometryOf(grid) };
    this->isoValue = newIsoValue;
    this->compact = newCompact;
    this->labelArray = newLabelArray;
    this->marked.reset();
  }

  void Apply(
    const SampleBox& box, vtkImageData* image, const hasp::AnyGridView& grid, bool sameSurface)
  {
    const int* extent = image->GetExtent();
    const glm::ivec3 first(extent[0], extent[2], extent[4]);
    const glm::ivec3 last(extent[1], extent[3], extent[5]);
    // Clamped before they are moved: a mark may reach as far as integers do.
    const glm::ivec3 low = glm::clamp(box.low, first, last + 1) - first;
    const glm::ivec3 high = glm::clamp(box.high, first - 1, last) - first;
    if (!sameSurface)
      return this->blocks.Update(grid, low, high);
    hasp::UpdateActiveCells(this->Own(), grid, this->blocks, low, high);
  }

  /// In place of those there are.
  void AddLabels(const std::string& array, vtkImageData* image)
  {
    if (array.empty() && this->cells->labels.empty())
      return;
    this->Own().labels = {};
    if (array.empty())
      return;
    vtkDataArray* labels = image->GetPointData()->GetArray(array.c_str());
    if (!labels)
      throw std::invalid_argument("the image has no point array " + array + " for labels");
    hasp::AddLabels(*this->cells, hasp::ViewPointArray(image, labels));
  }

  /// The cells, to be changed: a copy if somebody else draws them.
  hasp::ClusteredCells& Own()
  {
    if (this->cells.use_count() > 1)
      this->cells = std::make_shared<hasp::ClusteredCells>(*this->cells);
    return *this->cells;
  }
};

vtkHaspClusteredCellFilter::vtkHaspClusteredCellFilter() : Inside(new Internals) {}
vtkHaspClusteredCellFilter::~vtkHaspClusteredCellFilter() = default;

void vtkHaspClusteredCellFilter::MarkModified(const int extent[6])
{
  const SampleBox box{ { extent[0], extent[2], extent[4] }, { extent[1], extent[3], extent[5] } };
  std::optional<SampleBox>& marked = this->Inside->marked;
  marked =
    marked ? SampleBox{ glm::min(marked->low, box.low), glm::max(marked->high, box.high) } : box;
  this->Modified();
}

int vtkHaspClusteredCellFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkHaspClusteredCellFilter::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkHaspClusteredCells* output = vtkHaspClusteredCells::GetData(outputs);
  output->Initialize();
  const auto progress = [this](double share)
  {
    this->UpdateProgress(share);
    return !this->GetAbortExecute();
  };
  try
  {
    this->Inside->Update(vtkImageData::SafeDownCast(this->GetInputDataObject(0, 0)), this->IsoValue,
      this->Compact, this->LabelArrayName, progress);
    output->SetCells(this->Inside->cells);
    return 1;
  }
  catch (const hasp::Cancelled&)
  {
    this->Inside->Forget();
    return 1; // what was asked for: nothing
  }
  catch (const std::exception& error)
  {
    this->Inside->Forget();
    vtkErrorMacro(<< error.what());
    return 0;
  }
}

void vtkHaspClusteredCellFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IsoValue: " << this->IsoValue << "\n"
     << indent << "Compact: " << (this->Compact ? "on" : "off") << "\n"
     << indent << "LabelArrayName: " << this->LabelArrayName << "\n"
     << indent << "Active cells: " << (this->Inside->cells ? this->Inside->cells->Count() : 0)
     << "\n";
}
