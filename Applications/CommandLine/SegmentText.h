#pragma once
#include "Segmenter.h"

#include <nlohmann/json_fwd.hpp>

/// What `hasp segment` says of what it made.
namespace hasp
{

/// Of a voxel of the image.
double VoxelMm3(vtkImageData* image);

/// Each label with its voxels and mm3, each step with what came of it. Numbers and no names: those
/// are the user's words.
nlohmann::ordered_json DescribeSegmentation(
  const SegmentationRecipe& recipe, const SegmentedScan& made);

/// The same on standard output, a line each.
void PrintSegmentation(const nlohmann::ordered_json& described);

} // namespace hasp
