#pragma once
#include "Distance/ImplicitSolid.h"

#include "vtkImageData.h"
#include "vtkWeakPointer.h"

#include <string>
#include <vector>

class vtkInformation;
class vtkInformationVector;

namespace hasp
{

/// The solids of a filter's input port, which takes vtkHaspSolid, and vtkImageData of signed
/// distances (MakeGridSolid). Images that have not changed since the last call are not read again.
/// One thread at a time.
class SolidInputs
{
public:
  /// What such a port takes: for FillInputPortInformation.
  static void Accept(vtkInformation* port);
  /// One for each connection, in their order. Throws std::invalid_argument, with `name` and the
  /// number of the input, if one has no solid, is an image of other samples than float, of nothing
  /// or everything inside, or is refused by MakeGridSolid.
  std::vector<SolidPointer> Get(vtkInformationVector* inputs, const std::string& name = "input");

private:
  struct Image
  {
    vtkWeakPointer<vtkImageData> image;
    vtkMTimeType time = 0;
    SolidPointer solid;
  };
  SolidPointer SolidOf(vtkImageData* image);

  std::vector<Image> Images;
};

} // namespace hasp
