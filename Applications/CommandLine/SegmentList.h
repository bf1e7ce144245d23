#pragma once
#include "vtkHaspVolumeFile.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

/// What `hasp info` says of the segments of a segmentation.
namespace hasp
{

bool IsSegmentationName(const std::string& path);

/// Of each segment its label, its colour, how many voxels it has and mm3; of labels that no segment
/// stands for the same without a colour. `names`: what segments are called, too, the user's words.
nlohmann::ordered_json DescribeSegments(const LoadedVolume& segmentation, bool names);

/// A line each. What a terminal would obey in names is a question mark.
std::string SegmentsText(const nlohmann::ordered_json& segments);

} // namespace hasp
