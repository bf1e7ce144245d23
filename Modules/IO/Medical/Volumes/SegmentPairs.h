#pragma once
#include "Grid/GridGeometry.h"
#include "vtkHaspVolumeFile.h"

#include <string>
#include <vector>

namespace hasp
{

/// Where samples are that are not 0: smallest and largest index of each axis; empty as VTK has it.
struct LabelBox
{
  glm::ivec3 low{ 0 }, high{ -1 };
};

/// Throws std::invalid_argument unless there are segments, their label values are distinct and in
/// [1, largest], their colours in [0, 1] and their names UTF-8 that a header can hold: of control
/// characters and marks that end a line only "\n", which is escaped.
void CheckSegments(const std::vector<Segment>& segments, int largest);

/// The pairs of an NRRD header by which 3D Slicer knows a segmentation of one layer, as
/// vtkMRMLSegmentationStorageNode reads them. Each line ends in "\n".
///
/// box  of all labels. Slicer cuts a layer to the extent of its first segment, so that all segments
///      have the same, that of the layer.
std::string SegmentPairs(
  const std::vector<Segment>& segments, const GridGeometry& geometry, const LabelBox& box);

/// Whether a segment's tags say in SNOMED CT that it is bone.
bool TagsSayBone(const std::string& tags);

} // namespace hasp
