#include "View/SliceImage.h"

#include "vtkImageData.h"
#include "vtkImageProperty.h"
#include "vtkImageResliceMapper.h"
#include "vtkImageSlice.h"
#include "vtkLookupTable.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"

#include <algorithm>

namespace hasp
{

vtkSmartPointer<vtkImageData> StraightImage(vtkImageData* image)
{
  auto straight = vtkSmartPointer<vtkImageData>::New();
  straight->ShallowCopy(image);
  vtkNew<vtkMatrix3x3> identity; // a new one: the copy shares the image's own
  straight->SetDirectionMatrix(identity);
  straight->SetOrigin(0, 0, 0);
  return straight;
}

void FillDataToWorld(vtkImageData* image, vtkMatrix4x4* matrix)
{
  matrix->Identity();
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
      matrix->SetElement(row, column, image->GetDirectionMatrix()->GetElement(row, column));
    matrix->SetElement(row, 3, image->GetOrigin()[row]);
  }
}

SliceImage::SliceImage(Kind kind)
{
  this->Mapper->SetSlicePlane(this->Plane);
  this->Mapper->AutoAdjustImageQualityOff(); // always a value per pixel
  this->Mapper->BorderOn();                  // whole voxels: an image of one slice is seen, too
  this->Slice->SetMapper(this->Mapper);
  this->Slice->SetUserMatrix(this->DataToWorld);
  this->Slice->VisibilityOff();
  this->Slice->PickableOff();
  vtkImageProperty* property = this->Slice->GetProperty();
  property->SetAmbient(1.0); // no light on it
  property->SetDiffuse(0.0);
  if (kind == Kind::Grey)
    property->SetInterpolationTypeToLinear();
  else
  {
    property->SetInterpolationTypeToNearest();
    property->UseLookupTableScalarRangeOn();
    this->Slice->ForceTranslucentOn();
  }
}

SliceImage::~SliceImage() = default;

vtkImageData* SliceImage::Image() const
{
  return this->Source;
}

void SliceImage::SetImage(vtkImageData* image)
{
  this->Source = image;
  this->Taken = 0;
  this->Slice->SetVisibility(image != nullptr);
  if (image)
    this->Follow();
  else
    this->Mapper->SetInputData(nullptr);
}

bool SliceImage::Follow()
{
  if (!this->Source || this->Source->GetMTime() == this->Taken)
    return false;
  this->Taken = this->Source->GetMTime();
  this->Mapper->SetInputData(StraightImage(this->Source));
  this->Place(glm::dvec3(0.0));
  return true;
}

void SliceImage::Place(const glm::dvec3& lift)
{
  FillDataToWorld(this->Source, this->DataToWorld);
  for (int axis = 0; axis < 3; ++axis)
    this->DataToWorld->SetElement(axis, 3, this->DataToWorld->GetElement(axis, 3) + lift[axis]);
}

void SliceImage::SetPlane(const glm::dvec3& point, const glm::dvec3& normal, double lift)
{
  const glm::dvec3 at = point + lift * normal;
  this->Plane->SetOrigin(at.x, at.y, at.z);
  this->Plane->SetNormal(normal.x, normal.y, normal.z);
  if (this->Source)
    this->Place(lift * normal);
}

void SliceImage::SetWindowLevel(double window, double level)
{
  this->Slice->GetProperty()->SetColorWindow(window);
  this->Slice->GetProperty()->SetColorLevel(level);
}

void SliceImage::SetLabelColours(const std::map<int, glm::dvec3>& colours, double opacity)
{
  const int most = colours.empty() ? 1 : std::max(1, colours.rbegin()->first);
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(most + 1);
  table->SetTableRange(0, most);
  for (int label = 0; label <= most; ++label)
    table->SetTableValue(label, 0, 0, 0, 0);
  for (const auto& [label, colour] : colours)
    if (label > 0)
      table->SetTableValue(label, colour.x, colour.y, colour.z, opacity);
  table->SetAboveRangeColor(0, 0, 0, 0);
  table->UseAboveRangeColorOn(); // labels that nobody has named
  this->Slice->GetProperty()->SetLookupTable(table);
}

void SliceImage::DrawInSpace()
{
  this->Mapper->ResampleToScreenPixelsOff();
}

} // namespace hasp
