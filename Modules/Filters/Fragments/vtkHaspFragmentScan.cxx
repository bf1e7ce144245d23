#include "vtkHaspFragmentScan.h"

#include "vtkHaspVolumeView.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
std::shared_ptr<const void> Hold(vtkDataArray* array)
{
  return std::make_shared<const vtkSmartPointer<vtkDataArray>>(array);
}

/// labels: of grid's points.
FragmentScan Join(vtkImageData* scan, vtkImageData* grid, vtkDataArray* labels, double isovalue)
{
  FragmentScan fragments;
  fragments.grey = ViewImage(scan);
  if (!labels)
    throw std::invalid_argument("labels: there are none");
  if (labels->GetDataType() != VTK_UNSIGNED_SHORT)
    throw std::invalid_argument(std::string("labels: they are of type ") +
                                labels->GetDataTypeAsString() +
                                ", must be unsigned short: cast them, with vtkImageCast say");
  fragments.labels = std::get<GridView<const std::uint16_t>>(ViewPointArray(grid, labels));
  fragments.greyOwner = Hold(scan->GetPointData()->GetScalars());
  fragments.labelOwner = Hold(labels);
  fragments.isovalue = isovalue;
  return fragments;
}
} // namespace

FragmentScan FragmentScanOf(vtkImageData* scan, vtkImageData* labels, double isovalue)
{
  if (!labels)
    throw std::invalid_argument("labels: there is no image");
  return Join(scan, labels, labels->GetPointData()->GetScalars(), isovalue);
}

FragmentScan FragmentScanOf(vtkImageData* scan, vtkDataArray* labels, double isovalue)
{
  return Join(scan, scan, labels, isovalue);
}

} // namespace hasp
