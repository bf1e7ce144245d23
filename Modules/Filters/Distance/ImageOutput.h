#pragma once
#include "Grid/GridGeometry.h"

#include <vector>

class vtkImageData;
class vtkInformation;

namespace hasp
{

/// Float images of filters: what RequestInformation says before, and RequestData gives. They begin
/// at index 0, whatever the extent of the input, at the same place in the world.

/// Of an image that a pipeline is about to give. Throws as ImageGeometry, and if it says nothing:
/// it failed.
GridGeometry PipelineGeometry(vtkInformation* image);
void SayImage(vtkInformation* output, const GridGeometry& geometry);
/// All of an input, whatever part of the output is asked for.
void AskForAll(vtkInformation* input);
/// `samples` as the scalars of `output`, under `name`.
void GiveImage(vtkImageData* output, const GridGeometry& geometry,
  const std::vector<float>& samples, const char* name);

} // namespace hasp
