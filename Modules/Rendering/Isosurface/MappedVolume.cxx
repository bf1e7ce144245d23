#include "MappedVolume.h"

#include "Grid/Stopwatch.h"
#include "vtkHaspVolumeView.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

bool MappedVolume::Update(vtkImageData* image)
{
  if (image && image == this->Image && image->GetMTime() == this->ImageTime)
    return false;
  this->Forget();
  const hasp::Stopwatch watch;
  this->Blocks = hasp::MinMaxBlocks(hasp::ViewImage(image));
  this->Image = image;
  this->ImageTime = image->GetMTime();
  this->ImagePlace = PlaceOf(image);
  this->BlocksMilliseconds = watch.Milliseconds();
  return true;
}

bool MappedVolume::Mark(vtkImageData* image, const int extent[6])
{
  return this->MarkOther(image, extent, this->Low, this->High);
}

bool MappedVolume::MarkOther(
  vtkImageData* image, const int extent[6], glm::ivec3& low, glm::ivec3& high)
{
  if (!image || image != this->Image || PlaceOf(image) != this->ImagePlace)
    return false; // it is read in whole
  const int* whole = image->GetExtent();
  for (int a = 0; a < 3; ++a)
  {
    // Clamped before they are moved: a mark may reach as far as integers do.
    const int first = whole[2 * a], last = whole[2 * a + 1];
    low[a] = std::min(low[a], std::clamp(extent[2 * a], first, last + 1) - first);
    high[a] = std::max(high[a], std::clamp(extent[2 * a + 1], first - 1, last) - first);
  }
  this->ImageTime = image->GetMTime();
  return true;
}

void MappedVolume::ForgetChanges()
{
  this->Low = glm::ivec3(std::numeric_limits<int>::max());
  this->High = glm::ivec3(std::numeric_limits<int>::min());
}

MappedVolume::Place MappedVolume::PlaceOf(vtkImageData* image)
{
  Place place;
  image->GetExtent(place.extent.data());
  image->GetOrigin(place.geometry.data());
  image->GetSpacing(place.geometry.data() + 3);
  std::copy_n(image->GetDirectionMatrix()->GetData(), 9, place.geometry.data() + 6);
  if (vtkDataArray* scalars = image->GetPointData()->GetScalars())
  {
    place.type = scalars->GetDataType();
    place.samples = scalars->GetVoidPointer(0);
  }
  return place;
}

double MappedVolume::MiddleOfRange() const
{
  const double middle = 0.5 * (double{ this->Blocks.Min() } + double{ this->Blocks.Max() });
  return this->Blocks.Min() <= this->Blocks.Max() && std::isfinite(middle) ? middle : 0.0;
}
