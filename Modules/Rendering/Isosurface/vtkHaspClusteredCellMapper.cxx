#include "vtkHaspClusteredCellMapper.h"

#include "ClusteredCellAttributes.h"
#include "Isosurface/ActiveCells.h"
#include "vtkHaspClusteredCells.h"
#include "vtkHaspResourceTable.h"
#include "vtkHaspVolumeView.h"

#include "vtkAlgorithm.h"
#include "vtkBoundingBox.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkTimeStamp.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

vtkAbstractObjectFactoryNewMacro(vtkHaspClusteredCellMapper);

namespace
{

/// Each pose may carry cells from anywhere in the bounds: their eight corners go along.
void AddPosedBounds(const hasp::CellLabels& labels, double bounds[6])
{
  vtkBoundingBox box(bounds);
  for (const auto& [n, label] : labels)
    for (int c = 0; label.pose && label.visible && c < 8; ++c)
    {
      const glm::dvec4 corner = *label.pose * glm::dvec4(bounds[c & 1], bounds[2 + (c >> 1 & 1)],
                                                bounds[4 + (c >> 2)], 1.0);
      box.AddPoint(corner.x, corner.y, corner.z);
    }
  box.GetBounds(bounds);
}

} // namespace

struct vtkHaspClusteredCellMapper::Internals
{
  hasp::MinMaxBlocks Blocks;
  vtkWeakPointer<vtkImageData> Image; ///< they were made from, and
  vtkMTimeType ImageTime = 0;         ///< when: images that share their samples share MTimes, too
  glm::ivec3 ImageSize{ 0 };          ///< its samples along each axis, then
  int ImageType = VTK_VOID;           ///< and what they were
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

  /// All that an update depends on.
  struct Causes
  {
    vtkMTimeType mapper, input;
    const vtkDataObject* data;
    bool operator==(const Causes&) const = default;
  };
  std::optional<Causes> Failed; ///< of the last update, if it failed

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
    const hasp::Stopwatch watch;
    this->Cells = {};
    this->CellsTime = {};
    this->Blocks = {};
    this->ForgetChanges();
    this->Image = nullptr;
    this->Finished = nullptr;
    this->Blocks = hasp::MinMaxBlocks(hasp::ViewImage(image));
    this->Image = image;
    this->ImageTime = image->GetMTime();
    image->GetDimensions(&this->ImageSize.x);
    this->ImageType = image->GetPointData()->GetScalars()->GetDataType();
    this->BlocksMilliseconds = watch.Milliseconds();
  }

  /// As many of the same type as the blocks were made from.
  bool SameSamples(vtkImageData* image) const
  {
    glm::ivec3 size;
    image->GetDimensions(&size.x);
    vtkDataArray* scalars = image->GetPointData()->GetScalars();
    return size == this->ImageSize && scalars && scalars->GetDataType() == this->ImageType;
  }

  /// An isovalue that is not a number is never up to date, and refused.
  void UpdateSurface(vtkImageData* image, double isovalue, int precision)
  {
    const bool sameSurface = this->CellsTime.GetMTime() != 0 && this->CellsIsoValue == isovalue &&
                             this->CellsPrecision == precision;
    if (sameSurface && !this->Changed())
      return;
    const hasp::Stopwatch watch;
    const hasp::AnyGridView grid = hasp::ViewImage(image);
    if (sameSurface)
      UpdateActiveCells(this->Cells, grid, this->Blocks, this->ChangedLow, this->ChangedHigh);
    else
    {
      this->Blocks.Update(grid, this->ChangedLow, this->ChangedHigh);
      this->Cells = ExtractActiveCells(grid, this->Blocks, isovalue,
        precision == Compact ? hasp::CellPrecision::Compact : hasp::CellPrecision::Exact);
    }
    this->ForgetChanges();
    this->CellsIsoValue = isovalue;
    this->CellsPrecision = precision;
    this->CellsTime.Modified();
    this->CellsMilliseconds = watch.Milliseconds();
  }

  /// 0 if no sample is a number.
  double MiddleOfRange() const
  {
    const double middle = 0.5 * (double{ this->Blocks.Min() } + double{ this->Blocks.Max() });
    return this->Blocks.Min() <= this->Blocks.Max() && std::isfinite(middle) ? middle : 0.0;
  }
};

vtkHaspClusteredCellMapper::vtkHaspClusteredCellMapper()
  : Internal(new Internals),
    Attribute(new Attributes)
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

void vtkHaspClusteredCellMapper::SetIsoValue(double value)
{
  if (this->IsoValueIsSet && this->IsoValue == value)
    return;
  this->IsoValueIsSet = true;
  this->IsoValue = value;
  this->Modified();
}

bool vtkHaspClusteredCellMapper::UpdateCells()
{
  Internals& in = *this->Internal;
  vtkDataObject* input = nullptr;
  if (this->GetNumberOfInputConnections(0) > 0)
  {
    this->GetInputAlgorithm()->Update();
    input = this->GetInputDataObject(0, 0);
  }
  // VTK asks three times a frame: nothing is tried, nor said, again before there is reason to.
  const Internals::Causes causes{ this->GetMTime(), input ? input->GetMTime() : 0, input };
  if (in.Failed == causes)
    return false;
  in.Failed.reset();
  if (auto* cells = vtkHaspClusteredCells::SafeDownCast(input))
  {
    in.Keep(cells->GetCells());
    this->UseColorsOf(this->GetCells());
    return true;
  }
  vtkImageData* image = this->GetImage();
  const bool newImage = !image || image != in.Image || image->GetMTime() != in.ImageTime;
  try
  {
    if (!input)
      throw std::invalid_argument("no input: give it a vtkImageData or a vtkHaspClusteredCells");
    if (newImage)
      in.NewImage(image);
    if (newImage && !this->IsoValueIsSet)
      this->IsoValue = in.MiddleOfRange();
    in.UpdateSurface(image, this->IsoValue, this->Precision);
    this->UpdateLabels(in.Cells, image);
    this->UpdateColors(in.Cells, image);
    return true;
  }
  catch (const std::exception& e)
  {
    in.Cells = {};
    in.CellsTime = {};
    in.Failed = causes;
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
  if (!in.SameSamples(image))
    return; // it is read in whole
  const int* whole = image->GetExtent();
  for (int a = 0; a < 3; ++a)
  {
    // Clamped before they are moved: a mark may reach as far as integers do.
    const int first = whole[2 * a], last = whole[2 * a + 1];
    const int low = std::clamp(extent[2 * a], first, last + 1) - first;
    const int high = std::clamp(extent[2 * a + 1], first - 1, last) - first;
    in.ChangedLow[a] = std::min(in.ChangedLow[a], low);
    in.ChangedHigh[a] = std::max(in.ChangedHigh[a], high);
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

void vtkHaspClusteredCellMapper::ListResources(hasp::ResourceList& list) const
{
  const Internals& in = *this->Internal;
  list.push_back({ "min-max blocks", in.Blocks.Bytes(), in.BlocksMilliseconds,
    in.Finished ? "the input is active cells: nothing is extracted"
                : "coarse phase of extraction; kept for the next isovalue" });
  const auto bytes = [](const auto& values) { return values.size() * sizeof(values[0]); };
  const hasp::ClusteredCells& cells = this->GetCells();
  const std::size_t labels = bytes(cells.labels);
  const std::size_t colors = bytes(cells.colors) + bytes(cells.firstColors);
  list.push_back({ "active cells, host", cells.Bytes() - labels - colors, in.CellsMilliseconds,
    std::to_string(cells.Count()) +
      (in.Finished ? " cells, the input's; read by picks" : " cells; kept to answer picks") });
  const Attributes& own = *this->Attribute;
  list.push_back({ "cell labels, host", labels, own.LabelsMilliseconds,
    in.Finished                    ? labels > 0 ? "the input's" : "the input has none"
    : this->LabelArrayName.empty() ? "no label array was named"
                                   : "from " + this->LabelArrayName });
  list.push_back({ "cell colours, host", colors + bytes(own.Coloring.table), own.ColorsMilliseconds,
    in.Finished               ? colors > 0 ? "the input's" : "the input has none"
    : !this->ScalarVisibility ? "scalar visibility is off"
    : own.Coloring.uniform    ? "one colour: the scalars are the volume's own"
                              : "mapped at the stored corners" });
}

void vtkHaspClusteredCellMapper::ListResources(vtkTable* table) const
{
  hasp::ResourceList list;
  this->ListResources(list);
  FillTable(list, table);
}

bool vtkHaspClusteredCellMapper::HasOpaqueGeometry()
{
  return !this->ScalarVisibility || !this->UpdateCells() || !this->Attribute->Coloring.translucent;
}

bool vtkHaspClusteredCellMapper::HasTranslucentPolygonalGeometry()
{
  const bool labels = AnyTranslucent(this->Attribute->Labels) && this->UpdateCells() &&
                      !this->GetCells().labels.empty();
  return labels || !this->HasOpaqueGeometry();
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
    if (vtkMath::AreBoundsInitialized(this->Bounds))
      AddPosedBounds(this->Attribute->Labels, this->Bounds);
  }
  return this->Bounds;
}

void vtkHaspClusteredCellMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IsoValue: ";
  if (this->Internal->Finished)
    os << this->GetCells().isovalue << " (the input's own)\n";
  else
    os << this->IsoValue << (this->IsoValueIsSet ? "\n" : " (middle of the range)\n");
  os << indent << "LabelArrayName: " << this->LabelArrayName << "\n";
  os << indent << "BlendNormals: " << this->BlendNormals << "\n";
  os << indent << "Renderer: " << this->Renderer << " (" << this->GetRendererChoice() << ")\n";
  os << indent << "Precision: " << this->Precision << "\n";
  os << indent << "OcclusionCulling: " << this->OcclusionCulling << "\n";
  os << indent << "Active cells: " << this->GetCells().Count() << "\n";
}
