// Labels of vtkHaspClusteredCellMapper.
#include "ClusteredCellAttributes.h"

#include "Isosurface/CellAttributes.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"
#include "vtkLinearTransform.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"

#include <algorithm>
#include <stdexcept>

std::string hasp::PointArrayNames(vtkPointData* data)
{
  std::string names;
  for (int n = 0; n < data->GetNumberOfArrays(); ++n)
    names +=
      (n ? ", " : "") + std::string(data->GetArrayName(n) ? data->GetArrayName(n) : "(no name)");
  return names.empty() ? "none" : names;
}

hasp::CellLabel* vtkHaspClusteredCellMapper::LabelOf(int n)
{
  if (n < 0 || n > 65535)
  {
    vtkErrorMacro("Label " << n << " cannot be: labels are 0 to 65535.");
    return nullptr;
  }
  this->Attribute->LabelsTime.Modified();
  return &this->Attribute->Labels[static_cast<std::uint16_t>(n)];
}

void vtkHaspClusteredCellMapper::SetLabelColor(int n, double r, double g, double b, double a)
{
  const glm::dvec4 color(r, g, b, a);
  for (int c = 0; c < 4; ++c)
    if (!(color[c] >= 0.0 && color[c] <= 1.0))
    {
      vtkErrorMacro(
        "The colour of label " << n << " has the component " << color[c] << "; they are 0 to 1.");
      return;
    }
  if (hasp::CellLabel* label = this->LabelOf(n))
    label->color = glm::vec4(color);
}

void vtkHaspClusteredCellMapper::SetLabelPose(int n, vtkMatrix4x4* matrix)
{
  try
  {
    std::optional<glm::dmat4> pose;
    if (matrix)
      pose = hasp::RigidPose(matrix);
    if (hasp::CellLabel* label = this->LabelOf(n))
      label->pose = pose;
  }
  catch (const std::exception& e)
  {
    vtkErrorMacro("Label " << n << " stays where it was: " << e.what());
  }
}

void vtkHaspClusteredCellMapper::SetLabelPose(int n, vtkLinearTransform* pose)
{
  this->SetLabelPose(n, pose ? pose->GetMatrix() : nullptr);
}

void vtkHaspClusteredCellMapper::SetLabelVisibility(int n, bool visible)
{
  if (hasp::CellLabel* label = this->LabelOf(n))
    label->visible = visible;
}

void vtkHaspClusteredCellMapper::ClearLabels()
{
  this->Attribute->Labels.clear();
  this->Attribute->LabelsTime.Modified();
}

const hasp::CellLabels& vtkHaspClusteredCellMapper::GetLabels() const
{
  return this->Attribute->Labels;
}

vtkMTimeType vtkHaspClusteredCellMapper::GetAttributesTime() const
{
  return this->Attribute->Time.GetMTime();
}

vtkMTimeType vtkHaspClusteredCellMapper::GetLabelsTime() const
{
  return this->Attribute->LabelsTime.GetMTime();
}

const hasp::CellColoring& vtkHaspClusteredCellMapper::GetColoring() const
{
  return this->Attribute->Coloring;
}

vtkMTimeType vtkHaspClusteredCellMapper::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Attribute->LabelsTime.GetMTime());
}

/// Of the name that was given; throws if there is none.
vtkDataArray* vtkHaspClusteredCellMapper::LabelArrayOf(vtkImageData* image) const
{
  vtkPointData* data = image->GetPointData();
  vtkDataArray* labels = data->GetArray(this->LabelArrayName.c_str());
  if (!labels)
    throw std::invalid_argument("the image has no point array " + this->LabelArrayName +
                                " for labels; it has: " + hasp::PointArrayNames(data));
  return labels;
}

bool vtkHaspClusteredCellMapper::GetLastLabelEdit(
  vtkMTimeType since, std::size_t& first, std::size_t& end) const
{
  const Attributes& own = *this->Attribute;
  first = own.EditedCells.first;
  end = own.EditedCells.end;
  return own.EditedTime != 0 && own.EditedTime == own.Time.GetMTime() && since == own.EditedSince &&
         this->GetCellsTime() < own.EditedTime;
}

void vtkHaspClusteredCellMapper::UpdateLabels(hasp::ClusteredCells& cells, vtkImageData* image)
{
  Attributes& own = *this->Attribute;
  const bool same =
    own.LabelledCells == this->GetCellsTime() && own.LabelArray == this->LabelArrayName;
  const glm::ivec3 low = own.MarkedLow, high = own.MarkedHigh;
  const bool edit = same && own.Marked() && !cells.labels.empty();
  own.MarkedLow = glm::ivec3(std::numeric_limits<int>::max());
  own.MarkedHigh = glm::ivec3(std::numeric_limits<int>::min());
  if (same && !edit)
    return;
  if (edit)
  {
    const hasp::Stopwatch watch;
    const hasp::CellRange changed =
      hasp::UpdateLabels(cells, hasp::ViewPointArray(image, this->LabelArrayOf(image)), low, high);
    if (!changed.Empty())
    {
      own.EditedSince = std::max(this->GetCellsTime(), own.Time.GetMTime());
      own.Time.Modified();
      own.EditedTime = own.Time.GetMTime();
      own.EditedCells = changed;
    }
    own.LabelsMilliseconds = watch.Milliseconds();
    return;
  }
  if (!cells.labels.empty())
    own.Time.Modified();
  cells.labels = {};
  own.LabelsMilliseconds = 0.0;
  if (!this->LabelArrayName.empty())
  {
    const hasp::Stopwatch watch;
    hasp::AddLabels(cells, hasp::ViewPointArray(image, this->LabelArrayOf(image)));
    own.Time.Modified();
    own.LabelsMilliseconds = watch.Milliseconds();
  }
  own.LabelledCells = this->GetCellsTime();
  own.LabelArray = this->LabelArrayName;
}
