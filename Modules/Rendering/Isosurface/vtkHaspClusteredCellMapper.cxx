#include "vtkHaspClusteredCellMapper.h"

#include "ClusteredCellAttributes.h"
#include "FailedUpdate.h"
#include "Isosurface/ActiveCells.h"
#include "MappedVolume.h"
#include "vtkHaspClusteredCells.h"
#include "vtkHaspResourceTable.h"
#include "vtkHaspVolumeView.h"

#include "vtkAlgorithm.h"
#include "vtkBoundingBox.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkTimeStamp.h"

#include <algorithm>
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
  MappedVolume Volume;

  /// Of the image; never null. Who shares them keeps them as they were.
  std::shared_ptr<hasp::ClusteredCells> Cells = std::make_shared<hasp::ClusteredCells>();
  std::shared_ptr<const hasp::ClusteredCells>
    Finished; ///< drawn in their place where the input is cells
  double CellsIsoValue = 0.0;
  int CellsPrecision = 0;
  vtkTimeStamp CellsTime;
  double CellsMilliseconds = 0.0;

  vtkMTimeType EditedTime = 0; ///< CellsTime before the last update, if it was an edit's
  glm::ivec3 EditLow{ 0 }, EditHigh{ 0 };

  FailedUpdate Failed;

  void ForgetCells() { this->Cells = std::make_shared<hasp::ClusteredCells>(); }

  /// Cells that somebody else made are drawn as they are, and nothing else is kept.
  void Keep(std::shared_ptr<const hasp::ClusteredCells> cells)
  {
    if (cells == this->Finished)
      return;
    this->ForgetCells();
    this->Volume.Forget();
    this->Finished = std::move(cells);
    this->CellsTime.Modified();
    this->CellsMilliseconds = 0.0;
  }

  /// True if it is a new image: then cells of the last one are forgotten.
  bool UpdateVolume(vtkImageData* image)
  {
    if (!this->Volume.Update(image))
      return false;
    this->ForgetCells();
    this->CellsTime = {};
    this->Finished = nullptr;
    return true;
  }

  /// An isovalue that is not a number is never up to date, and refused.
  void UpdateSurface(vtkImageData* image, double isovalue, int precision)
  {
    const bool sameSurface = this->CellsTime.GetMTime() != 0 && this->CellsIsoValue == isovalue &&
                             this->CellsPrecision == precision;
    if (sameSurface && !this->Volume.Changed())
      return;
    const hasp::Stopwatch watch;
    const hasp::AnyGridView grid = hasp::ViewImage(image);
    this->EditedTime = sameSurface ? this->CellsTime.GetMTime() : 0;
    this->EditLow = this->Volume.ChangedLow();
    this->EditHigh = this->Volume.ChangedHigh();
    if (sameSurface && this->Cells.use_count() > 1)
      this->Cells = std::make_shared<hasp::ClusteredCells>(*this->Cells);
    if (sameSurface)
      UpdateActiveCells(*this->Cells, grid, this->Volume.Blocks, this->Volume.ChangedLow(),
        this->Volume.ChangedHigh());
    else
    {
      this->Volume.Blocks.Update(grid, this->Volume.ChangedLow(), this->Volume.ChangedHigh());
      this->Cells = std::make_shared<hasp::ClusteredCells>(
        ExtractActiveCells(grid, this->Volume.Blocks, isovalue,
          precision == Compact ? hasp::CellPrecision::Compact : hasp::CellPrecision::Exact));
    }
    this->Volume.ForgetChanges();
    this->CellsIsoValue = isovalue;
    this->CellsPrecision = precision;
    this->CellsTime.Modified();
    this->CellsMilliseconds = watch.Milliseconds();
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
  if (in.Failed.Repeats(this, input))
    return false;
  if (auto* cells = vtkHaspClusteredCells::SafeDownCast(input))
  {
    in.Keep(cells->GetCells());
    this->UseColorsOf(this->GetCells());
    return true;
  }
  vtkImageData* image = this->GetImage();
  try
  {
    if (!input)
      throw std::invalid_argument("no input: give it a vtkImageData or a vtkHaspClusteredCells");
    if (in.UpdateVolume(image) && !this->IsoValueIsSet)
      this->IsoValue = in.Volume.MiddleOfRange();
    in.UpdateSurface(image, this->IsoValue, this->Precision);
    this->UpdateLabels(*in.Cells, image);
    this->UpdateColors(*in.Cells, image);
    return true;
  }
  catch (const std::exception& e)
  {
    in.ForgetCells();
    in.CellsTime = {};
    in.Failed.Remember();
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
  if (this->Internal->Volume.Mark(this->GetImage(), extent))
    this->Modified();
}

void vtkHaspClusteredCellMapper::MarkLabelsModified(const int extent[6])
{
  Attributes& own = *this->Attribute;
  if (this->Internal->Volume.MarkOther(this->GetImage(), extent, own.MarkedLow, own.MarkedHigh))
    own.LabelsTime.Modified();
}

const hasp::ClusteredCells& vtkHaspClusteredCellMapper::GetCells() const
{
  const Internals& in = *this->Internal;
  return in.Finished ? *in.Finished : *in.Cells;
}

std::shared_ptr<const hasp::ClusteredCells> vtkHaspClusteredCellMapper::ShareCells() const
{
  const Internals& in = *this->Internal;
  return in.Finished ? in.Finished : in.Cells;
}

vtkMTimeType vtkHaspClusteredCellMapper::GetCellsTime() const
{
  return this->Internal->CellsTime.GetMTime();
}

vtkMTimeType vtkHaspClusteredCellMapper::GetLastEdit(int low[3], int high[3]) const
{
  const Internals& in = *this->Internal;
  for (int a = 0; a < 3; ++a)
  {
    low[a] = in.EditLow[a];
    high[a] = in.EditHigh[a];
  }
  return in.EditedTime;
}

void vtkHaspClusteredCellMapper::SetAmbientOcclusionDistance(double mm)
{
  if (!(mm > 0.0))
    vtkErrorMacro("A distance of ambient occlusion of " << mm << " mm; it must be above 0.");
  else if (this->AmbientOcclusionDistance != mm)
  {
    this->AmbientOcclusionDistance = mm;
    this->Modified();
  }
}

void vtkHaspClusteredCellMapper::ListResources(hasp::ResourceList& list) const
{
  const Internals& in = *this->Internal;
  list.push_back({ "min-max blocks", in.Volume.Blocks.Bytes(), in.Volume.BlocksMilliseconds,
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
  os << indent << "AmbientOcclusion: " << this->AmbientOcclusion << " within "
     << this->AmbientOcclusionDistance << " mm\n";
  os << indent << "Shadows: " << this->Shadows << "\n";
  os << indent << "OcclusionCulling: " << this->OcclusionCulling << "\n";
  os << indent << "Active cells: " << this->GetCells().Count() << "\n";
}
