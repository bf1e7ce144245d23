#pragma once
#include "vtkSmartPointer.h"

class vtkImageData;

namespace hasp
{

/// "Labels", unsigned short, on the grid of a scan: 0 everywhere, or a copy of those given. Throws
/// std::invalid_argument if those are of another grid or type. Private to this module.
vtkSmartPointer<vtkImageData> MakeLabelImage(vtkImageData* scan, vtkImageData* given);

/// Whether two images of one grid have the same values, whatever their types. Ends at the first
/// that differs. Private to this module.
bool HaveSameSamples(vtkImageData* a, vtkImageData* b);

} // namespace hasp
