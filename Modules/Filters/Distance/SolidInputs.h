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

/// What the samples of an image of distances say, mm.
struct SampledFacts
{
  int input = 0; ///< its number
  float least = 0.0F, greatest = 0.0F;
  float leastOnBorder = 0.0F; ///< of the outermost samples
};

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
  /// or everything inside, or is refused by MakeGridSolid; it names vtkHaspSignedDistance.
  std::vector<SolidPointer> Get(vtkInformationVector* inputs, const std::string& name = "input");
  /// Of the images among the inputs of the last call of Get.
  std::vector<SampledFacts> Sampled() const;

private:
  struct Image
  {
    vtkWeakPointer<vtkImageData> image;
    vtkMTimeType time = 0;
    SolidPointer solid;
    SampledFacts facts;
  };
  Image Read(vtkImageData* image, int input) const;

  std::vector<Image> Images;
};

} // namespace hasp
