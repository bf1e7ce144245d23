#pragma once
#include "Grid/GridGeometry.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;

namespace hasp
{

/// The volume that `hasp report import` writes to every file: the phantom, obliquely in the
/// patient, with four samples that no other equals in an L of unequal legs, so that any flip, swap
/// or shift moves one of them.
struct ImportSubject
{
  std::string data; ///< "phantom96"
  vtkSmartPointer<vtkImageData> image;
  GridGeometry geometry;
};

/// dims samples a side, >= 10, of about 200 mm.
ImportSubject MakeImportSubject(int dims);

/// Largest distance of a marked sample of `image` from where the subject has it, mm; infinity if
/// one is not to be found.
double PlaceError(vtkImageData* image, const ImportSubject& subject);

} // namespace hasp
