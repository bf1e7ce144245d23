#ifndef vtkHaspFragmentScan_h
#define vtkHaspFragmentScan_h

#include "FragmentModels.h"                // for FragmentScan
#include "vtkHaspFiltersFragmentsModule.h" // for export macro

class vtkDataArray;
class vtkImageData;

namespace hasp
{

/// What FragmentModels is made of, of what VTK holds; nothing is copied. The arrays are held on to,
/// the images are not: replace samples, or paint labels, in place, and do not give the arrays
/// another size.
///
/// scan    its active scalars, of a type that ViewImage takes
/// labels  of the same grid: the active scalars of an image, or an array with a value for each
/// point
///         of the scan; unsigned short
/// Throws std::invalid_argument for null, as vtkHaspVolumeView.h says, and for labels of another
/// type (names it, and what to do); grids are held against each other by FragmentModels. Any
/// thread, as long as no other changes the VTK objects meanwhile.
VTKHASPFILTERSFRAGMENTS_EXPORT FragmentScan FragmentScanOf(
  vtkImageData* scan, vtkImageData* labels, double isovalue);
VTKHASPFILTERSFRAGMENTS_EXPORT FragmentScan FragmentScanOf(
  vtkImageData* scan, vtkDataArray* labels, double isovalue);

} // namespace hasp

#endif
